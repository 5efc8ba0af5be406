// Textures keep their memory, layout and texels, also in storage that is wider than the format.
#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

struct alignas(64) FBlock
{
	uint8 Bytes[64];
};

} // namespace

TEST(Texture, MemoryComesWithTheFirstTouch)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_FloatRGBA);
	EXPECT_FALSE(Texture->HasMemory());
	Texture->WriteTexel(0, 0, FLinearColor::White);
	EXPECT_TRUE(Texture->HasMemory());
}

TEST(Texture, OwnMemoryIsZero)
{
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), MakeTexture(FIntPoint(4, 4), PF_A32B32G32R32F)->ReadTexel(3, 3));
}

TEST(Texture, RowsAndMipsAreAligned)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(37, 19), PF_FloatRGBA, 4));
	for (int32 Mip = 0; Mip < 4; ++Mip)
	{
		EXPECT_EQ(0u, reinterpret_cast<uintptr_t>(Texture->GetTexel(0, 0, Mip)) % 64) << Mip;
		EXPECT_EQ(0, Texture->GetMipLayout(Mip).RowPitch % 64) << Mip;
	}
}

TEST(Texture, MipsHalveRoundingDownToOne)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(37, 3), PF_R32_FLOAT, 4));
	EXPECT_EQ(FIntVector(18, 1, 1), Texture->GetMipDimensions(1));
	EXPECT_EQ(FIntVector(4, 1, 1), Texture->GetMipDimensions(3));
}

TEST(Texture, MarginsLieInsideItsMemory)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(33, 7), PF_R16F, 3));
	std::vector<FBlock> Memory(Texture->GetSizeInBytes() / 64);
	Texture->PlaceAt(Memory.data());
	const uint8* const First = Texture->GetTexel(0, 0);
	const uint8* const Last = Texture->GetTexel(7, 0, 2) + 2;
	EXPECT_GE(First - Memory[0].Bytes, 64);
	EXPECT_GE(Memory[0].Bytes + Texture->GetSizeInBytes() - Last, 64);
}

TEST(Texture, NoTwoTexelsShareBytes)
{
	const FTextureRHIRef Texture = MakeTexture(
		FRHITextureDesc::Create3D(FIntVector(5, 3, 4), PF_R32_UINT, FClearValueBinding::Black, TexCreate_UAV, 3));
	const auto Code = [](int32 X, int32 Y, int32 Z, int32 Mip)
	{
		return uint32(((Mip * 8 + Z) * 8 + Y) * 8 + X + 1);
	};
	const auto ForEach = [&](auto Body)
	{
		for (int32 Mip = 0; Mip < 3; ++Mip)
		{
			const FIntVector Size = Texture->GetMipDimensions(uint8(Mip));
			for (int32 Index = 0; Index < Size.X * Size.Y * Size.Z; ++Index)
			{
				Body(Index % Size.X, Index / Size.X % Size.Y, Index / Size.X / Size.Y, Mip);
			}
		}
	};
	ForEach([&](int32 X, int32 Y, int32 Z, int32 Mip)
		{ Texture->WriteTexelUint(X, Y, FUintVector4(Code(X, Y, Z, Mip), 0, 0, 0), Mip, Z); });
	ForEach([&](int32 X, int32 Y, int32 Z, int32 Mip)
		{ ASSERT_EQ(Code(X, Y, Z, Mip), Texture->ReadTexelUint(X, Y, Mip, Z).X); });
}

TEST(Texture, PlaceAtUsesTheMemoryAsItIs)
{
	const FTextureRHIRef A = MakeTexture(FIntPoint(4, 4), PF_FloatRGBA);
	const FTextureRHIRef B = MakeTexture(FIntPoint(4, 4), PF_FloatRGBA);
	std::vector<FBlock> Memory(A->GetSizeInBytes() / 64);
	A->PlaceAt(Memory.data());
	A->WriteTexel(2, 1, FLinearColor(1, 2, 3, 4));
	B->PlaceAt(Memory.data());
	EXPECT_EQ(FLinearColor(1, 2, 3, 4), B->ReadTexel(2, 1));
}

TEST(Texture, ViewsFollowPlaceAt)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	const FKernelTexture View = Texture->GetKernelView();
	std::vector<FBlock> Memory(Texture->GetSizeInBytes() / 64);
	Texture->PlaceAt(Memory.data());
	EXPECT_EQ(Texture->GetTexel(0, 0), View.Mips[0].Data);
}

TEST(Texture, PlacementMustBeAligned)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	std::vector<FBlock> Memory(Texture->GetSizeInBytes() / 64 + 1);
	EXPECT_THROW(Texture->PlaceAt(Memory[0].Bytes + 16), FCheckFailure);
}

TEST(Texture, APitchOfWholePagesIsBroken)
{
	EXPECT_EQ(4096 + 64, MakeTexture(FIntPoint(1024, 2), PF_R32_FLOAT)->GetMipLayout(0).RowPitch);
	EXPECT_EQ(4160, MakeTexture(FIntPoint(1040, 2), PF_R32_FLOAT)->GetMipLayout(0).RowPitch);
}

TEST(Texture, TexelsOutsideAreChecked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_FloatRGBA);
	EXPECT_THROW(Texture->ReadTexel(4, 0), FCheckFailure);
	EXPECT_THROW(Texture->ReadTexel(0, -1), FCheckFailure);
	EXPECT_THROW(Texture->ReadTexel(0, 0, 1), FCheckFailure);
	EXPECT_THROW(Texture->ReadTexel(0, 0, 0, 1), FCheckFailure);
}

TEST(Texture, AnInvalidDescriptionIsChecked)
{
	EXPECT_THROW(MakeTexture(FIntPoint(4, 0), PF_FloatRGBA), FCheckFailure);
}

TEST(Texture, TexelsRoundAsTheFormatDoes)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_B8G8R8A8);
	Texture->WriteTexel(0, 0, FLinearColor(0.5f, 2.0f, -1.0f, 0.3f));
	EXPECT_EQ(FLinearColor(128 / 255.0f, 1.0f, 0.0f, 77 / 255.0f), Texture->ReadTexel(0, 0));
}

TEST(Texture, SrgbFlagEncodesEightBitFormats)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(1, 1), PF_R8G8B8A8);
	Desc.Flags |= TexCreate_SRGB;
	const FTextureRHIRef Texture = MakeTexture(Desc);
	Texture->WriteTexel(0, 0, FLinearColor(0.5f, 0.5f, 0.5f, 0.5f));
	EXPECT_EQ(188, Texture->GetTexel(0, 0)[0]);
	EXPECT_EQ(128, Texture->GetTexel(0, 0)[3]);
}

TEST(Texture, SrgbFlagIsIgnoredByOtherFormats)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(1, 1), PF_FloatRGBA);
	Desc.Flags |= TexCreate_SRGB;
	EXPECT_EQ(ETexelStorage::RGBA16_FLOAT, MakeTexture(Desc)->GetStorage());
}

TEST(Texture, FillReachesEveryMipAndSlice)
{
	const FTextureRHIRef Texture = MakeTexture(FRHITextureDesc::Create2DArray(
		FIntPoint(5, 3), PF_R16F, FClearValueBinding::Black, TexCreate_ShaderResource, 3, 2));
	Texture->Fill(FLinearColor(0.25f, 0, 0, 0));
	EXPECT_EQ(0.25f, Texture->ReadTexel(4, 2, 0, 2).R);
	EXPECT_EQ(0.25f, Texture->ReadTexel(0, 0, 0, 0).R);
	EXPECT_EQ(0.25f, Texture->ReadTexel(1, 0, 1, 1).R);
}

TEST(Texture, FillRectTouchesNothingElse)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(6, 5), PF_R32_FLOAT);
	const float One = 1;
	Texture->FillRect(&One, FIntRect(1, 2, 4, 4), 0);
	float Sum = 0;
	for (int32 Index = 0; Index < 30; ++Index)
	{
		Sum += Texture->ReadTexel(Index % 6, Index / 6).R;
	}
	EXPECT_EQ(6.0f, Sum);
	EXPECT_EQ(1.0f, Texture->ReadTexel(1, 2).R);
	EXPECT_EQ(1.0f, Texture->ReadTexel(3, 3).R);
}

TEST(Texture, RowsReadAndWrite)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(5, 2), PF_FloatRGBA);
	const TArray<FLinearColor> Colors = {FLinearColor(1, 2, 3, 4), FLinearColor(5, 6, 7, 8)};
	Texture->WriteRow(3, 1, Colors);
	TArray<FLinearColor> Row;
	Row.SetNum(3);
	Texture->ReadRow(2, 1, Row);
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), Row[0]);
	EXPECT_EQ(FLinearColor(5, 6, 7, 8), Row[2]);
	EXPECT_THROW(Texture->WriteRow(4, 1, Colors), FCheckFailure);
}

TEST(Texture, DoublesRoundOnce)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R16F);
	const double JustAboveTie = 1 + std::ldexp(1.0, -11) + std::ldexp(1.0, -40);
	Texture->WriteTexelDouble(0, 0, FVector4(JustAboveTie, 0, 0, 0));
	EXPECT_EQ(1 + std::ldexp(1.0, -10), Texture->ReadTexelDouble(0, 0).X);
}

TEST(Texture, IntegersAreKeptAndOthersRefused)
{
	const FTextureRHIRef Integers = MakeTexture(FIntPoint(1, 1), PF_R32_UINT);
	Integers->WriteTexelUint(0, 0, FUintVector4(0xfffffff1u, 0, 0, 0));
	EXPECT_EQ(0xfffffff1u, Integers->ReadTexelUint(0, 0).X);
	EXPECT_THROW(MakeTexture(FIntPoint(1, 1), PF_R32_FLOAT)->ReadTexelUint(0, 0), FCheckFailure);
}

TEST(Texture, DepthStencilHasAStencilPlane)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_DepthStencil);
	EXPECT_EQ(2, Texture->GetNumPlanes());
	EXPECT_EQ(ETexelStorage::R32_FLOAT, Texture->GetKernelView().Storage);
	EXPECT_EQ(ETexelStorage::R8_UINT, Texture->GetKernelView(0, 1, -1, 1).Storage);
	EXPECT_NE(Texture->GetTexel(0, 0), Texture->GetTexel(0, 0, 0, 0, 1));
}

TEST(Texture, OtherFormatsHaveNoStencil)
{
	EXPECT_THROW(MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT)->GetKernelView(0, 1, -1, 1), FCheckFailure);
}

TEST(Storage, Float32WidensFloatAndUnorm)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 1);
	EXPECT_EQ(ETexelStorage::RGB32_FLOAT, MakeTexture(FIntPoint(1, 1), PF_FloatRGB)->GetStorage());
	EXPECT_EQ(ETexelStorage::RGBA32_FLOAT, MakeTexture(FIntPoint(1, 1), PF_B8G8R8A8)->GetStorage());
	EXPECT_EQ(ETexelStorage::R32_FLOAT, MakeTexture(FIntPoint(1, 1), PF_G8)->GetStorage());
}

TEST(Storage, Float64WidensFloat32Too)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	EXPECT_EQ(ETexelStorage::RGBA64_FLOAT, MakeTexture(FIntPoint(1, 1), PF_A32B32G32R32F)->GetStorage());
	EXPECT_EQ(ETexelStorage::RG64_FLOAT, MakeTexture(FIntPoint(1, 1), PF_G16R16F)->GetStorage());
}

TEST(Storage, IntegerAndDepthNeverWiden)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	EXPECT_EQ(ETexelStorage::R8_UINT, MakeTexture(FIntPoint(1, 1), PF_R8_UINT)->GetStorage());
	EXPECT_EQ(ETexelStorage::R32_FLOAT, MakeTexture(FIntPoint(1, 1), PF_DepthStencil)->GetStorage());
}

TEST(Storage, WidenedTexelsAreNeitherRoundedNorClamped)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_FloatRGB);
	Texture->WriteTexelDouble(0, 0, FVector4(-0.1, 1e5, 1.0 / 3, 0.5));
	EXPECT_EQ(-0.1, Texture->ReadTexelDouble(0, 0).X);
	EXPECT_EQ(1e5, Texture->ReadTexelDouble(0, 0).Y);
	EXPECT_EQ(1.0 / 3, Texture->ReadTexelDouble(0, 0).Z);
	EXPECT_EQ(1.0, Texture->ReadTexelDouble(0, 0).W);
}

TEST(Storage, AWidenedSrgbTextureHoldsLinearValues)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 1);
	FRHITextureDesc Desc = Make2D(FIntPoint(1, 1), PF_R8G8B8A8);
	Desc.Flags |= TexCreate_SRGB;
	const FTextureRHIRef Texture = MakeTexture(Desc);
	Texture->WriteTexel(0, 0, FLinearColor(0.3f, 5.0f, 0, 1));
	EXPECT_EQ(FLinearColor(0.3f, 5.0f, 0, 1), Texture->ReadTexel(0, 0));
}

TEST(Storage, ATextureKeepsTheStorageItWasMadeWith)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R16F);
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	EXPECT_EQ(ETexelStorage::R16_FLOAT, Texture->GetKernelView().Storage);
	EXPECT_FALSE(Texture->IsWidened());
}

TEST(Storage, OverflowIsInfiniteUnlessSaturated)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_R16F);
	Texture->WriteTexel(0, 0, FLinearColor(1e6f, 0, 0, 0));
	EXPECT_EQ(std::numeric_limits<float>::infinity(), Texture->ReadTexel(0, 0).R);
	const FScopedCVar Saturate(TEXT("r.Drydock.StoreOverflow"), 1);
	Texture->WriteTexel(0, 0, FLinearColor(1e6f, 0, 0, 0));
	EXPECT_EQ(65504.0f, Texture->ReadTexel(0, 0).R);
	EXPECT_EQ(1, Texture->GetKernelView().bSaturateStore);
}
