// Textures that code makes of bytes.
#include <gtest/gtest.h>

#include "Engine/Texture.h"
#include "RHI.h"
#include "TextureResource.h"

#include <memory>

TEST(Texture2D, IsMadeOfItsBytesAndMembers)
{
	const std::unique_ptr<UTexture2D> Texture(UTexture2D::CreateTransient(2, 1));
	EXPECT_EQ(nullptr, Texture->GetResource());
	EXPECT_EQ(2, Texture->GetSizeX());
	FTexture2DMipMap& Mip = Texture->GetPlatformData()->Mips[0];
	EXPECT_EQ(8, Mip.BulkData.GetBulkDataSize());
	FColor* const Texels = static_cast<FColor*>(Mip.BulkData.Lock(LOCK_READ_WRITE));
	Texels[1] = FColor(188, 255, 0, 64);
	Mip.BulkData.Unlock();
	Texture->CompressionSettings = TC_VectorDisplacementmap;
	Texture->MipGenSettings = TMGS_NoMipmaps;
	Texture->LODGroup = TEXTUREGROUP_Pixels2D;
	Texture->Filter = TF_Nearest;
	Texture->AddressX = TA_Clamp;
	Texture->UpdateResource();
	// ((188 / 255 + 0.055) / 1.055)^2.4
	EXPECT_NEAR(0.502886f, Texture->GetResource()->TextureRHI->ReadTexel(1, 0).R, 1e-5f);
	EXPECT_NEAR(64.0f / 255.0f, Texture->GetResource()->TextureRHI->ReadTexel(1, 0).A, 1e-6f);
	EXPECT_EQ(SF_Point, Texture->GetResource()->SamplerStateRHI->GetInitializer().Filter);
	EXPECT_EQ(AM_Clamp, Texture->GetResource()->SamplerStateRHI->GetInitializer().AddressU);
	Texture->SRGB = false;
	Texture->UpdateResource();
	EXPECT_NEAR(188.0f / 255.0f, Texture->GetResource()->TextureRHI->ReadTexel(1, 0).R, 1e-6f);
	EXPECT_EQ(nullptr, UTexture2D::CreateTransient(0, 1));
}

TEST(Texture2D, OfHalfFloatsIsLinear)
{
	const std::unique_ptr<UTexture2D> Texture(UTexture2D::CreateTransient(1, 1, PF_FloatRGBA));
	static_cast<uint16*>(Texture->GetPlatformData()->Mips[0].BulkData.Lock(LOCK_READ_WRITE))[0] = 0x3800;
	Texture->UpdateResource();
	EXPECT_EQ(0.5f, Texture->GetResource()->TextureRHI->ReadTexel(0, 0).R);
}
