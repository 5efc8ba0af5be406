// Textures that code draws to: they have pixels.
#include <gtest/gtest.h>

#include "Engine/TextureRenderTarget2D.h"
#include "Kismet/KismetRenderingLibrary.h"

#include <memory>

TEST(TextureRenderTarget, HoldsItsClearColorInItsFormat)
{
	UTextureRenderTarget2D Target;
	EXPECT_EQ(nullptr, Target.GetRenderTargetResource());
	Target.ClearColor = FLinearColor(0.25f, 0.5f, 2.0f, 1.0f);
	Target.InitAutoFormat(3, 2);
	FRHITexture* const Texture = Target.GetRenderTargetResource()->GetRenderTargetTexture();
	EXPECT_EQ(PF_FloatRGBA, Texture->GetFormat());
	EXPECT_EQ(FIntPoint(3, 2), Target.GameThread_GetRenderTargetResource()->GetSizeXY());
	TArray<FLinearColor> Pixels;
	FRHICommandListExecutor::GetImmediateCommandList().ReadSurfaceData(
		Texture, FIntRect(0, 0, 3, 2), Pixels, FReadSurfaceDataFlags(RCM_MinMax));
	EXPECT_EQ(Target.ClearColor, Pixels[5]);
	Target.InitCustomFormat(1, 1, PF_B8G8R8A8, false);
	EXPECT_EQ(PF_B8G8R8A8, Target.GetRenderTargetResource()->TextureRHI->GetFormat());
}

TEST(RenderTarget, IsClearedByTheRenderingLibrary)
{
	const std::unique_ptr<UTextureRenderTarget2D> Target(
		UKismetRenderingLibrary::CreateRenderTarget2D(nullptr, 3, 2, RTF_RGBA32f));
	ASSERT_NE(nullptr, Target);
	EXPECT_EQ(3.0f, Target->GetSurfaceWidth());
	EXPECT_EQ(2.0f, Target->GetSurfaceHeight());
	UKismetRenderingLibrary::ClearRenderTarget2D(nullptr, Target.get(), FLinearColor(0.25f, 0.5f, 2.0f, 0.0f));
	TArray<FLinearColor> Pixels;
	FRHICommandListExecutor::GetImmediateCommandList().ReadSurfaceData(
		Target->GetResource()->TextureRHI, FIntRect(0, 0, 3, 2), Pixels, FReadSurfaceDataFlags(RCM_MinMax));
	ASSERT_EQ(6, Pixels.Num());
	for (const FLinearColor& Pixel : Pixels)
	{
		EXPECT_EQ(FLinearColor(0.25f, 0.5f, 2.0f, 0.0f), Pixel);
	}
	EXPECT_EQ(nullptr, UKismetRenderingLibrary::CreateRenderTarget2D(nullptr, 0, 2));
}
