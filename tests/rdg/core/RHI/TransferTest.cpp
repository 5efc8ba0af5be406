// Copies, clears, uploads, locks and read-backs move the texels they should.
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

/** Texel (x, y) holds x + 10 y. */
FTextureRHIRef MakeRamp(FIntPoint Extent, EPixelFormat Format = PF_R32_FLOAT)
{
	const FTextureRHIRef Texture = MakeTexture(Extent, Format);
	for (int32 Index = 0; Index < Extent.X * Extent.Y; ++Index)
	{
		const int32 X = Index % Extent.X;
		const int32 Y = Index / Extent.X;
		Texture->WriteTexel(X, Y, FLinearColor(float(X + 10 * Y), 0, 0, 0));
	}
	return Texture;
}

FRHICommandListImmediate& GetList()
{
	return FRHICommandListExecutor::GetImmediateCommandList();
}

TArray<FLinearColor> ReadRaw(FRHITexture* Texture, FIntRect Rect)
{
	TArray<FLinearColor> Colors;
	GetList().ReadSurfaceData(Texture, Rect, Colors, FReadSurfaceDataFlags(RCM_MinMax));
	return Colors;
}

} // namespace

TEST(CopyTexture, AllOfIt)
{
	const FTextureRHIRef Source = MakeRamp(FIntPoint(7, 5));
	const FTextureRHIRef Dest = MakeTexture(FIntPoint(7, 5), PF_R32_FLOAT);
	GetList().CopyTexture(Source, Dest, FRHICopyTextureInfo());
	EXPECT_EQ(46.0f, Dest->ReadTexel(6, 4).R);
}

TEST(CopyTexture, ARegionAndNothingElse)
{
	const FTextureRHIRef Source = MakeRamp(FIntPoint(7, 5));
	const FTextureRHIRef Dest = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	FRHICopyTextureInfo Info;
	Info.Size = FIntVector(2, 1, 1);
	Info.SourcePosition = FIntVector(5, 3, 0);
	Info.DestPosition = FIntVector(1, 2, 0);
	GetList().CopyTexture(Source, Dest, Info);
	EXPECT_EQ(35.0f, Dest->ReadTexel(1, 2).R);
	EXPECT_EQ(36.0f, Dest->ReadTexel(2, 2).R);
	EXPECT_EQ(0.0f, Dest->ReadTexel(3, 2).R);
	EXPECT_EQ(0.0f, Dest->ReadTexel(1, 3).R);
}

TEST(CopyTexture, MipsAndSlices)
{
	const FRHITextureDesc Desc = FRHITextureDesc::Create2DArray(
		FIntPoint(8, 8), PF_R32_FLOAT, FClearValueBinding::Black, TexCreate_ShaderResource, 3, 3);
	const FTextureRHIRef Source = MakeTexture(Desc);
	const FTextureRHIRef Dest = MakeTexture(Desc);
	Source->WriteTexel(1, 1, FLinearColor(5, 0, 0, 0), 2, 1);
	FRHICopyTextureInfo Info;
	Info.SourceMipIndex = 1;
	Info.DestMipIndex = 1;
	Info.NumMips = 2;
	Info.SourceSliceIndex = 1;
	Info.DestSliceIndex = 2;
	GetList().CopyTexture(Source, Dest, Info);
	EXPECT_EQ(5.0f, Dest->ReadTexel(1, 1, 2, 2).R);
	EXPECT_EQ(0.0f, Dest->ReadTexel(1, 1, 2, 1).R);
}

TEST(CopyTexture, BetweenFormatsIsChecked)
{
	const FTextureRHIRef Source = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	const FTextureRHIRef Dest = MakeTexture(FIntPoint(4, 4), PF_R32_UINT);
	EXPECT_THROW(GetList().CopyTexture(Source, Dest, FRHICopyTextureInfo()), FCheckFailure);
}

TEST(CopyTexture, BeyondATextureTouchesNothing)
{
	const FTextureRHIRef Source = MakeRamp(FIntPoint(7, 5));
	const FTextureRHIRef Dest = MakeTexture(FIntPoint(4, 4), PF_R32_FLOAT);
	EXPECT_THROW(GetList().CopyTexture(Source, Dest, FRHICopyTextureInfo()), FCheckFailure);
	EXPECT_EQ(0.0f, Dest->ReadTexel(1, 0).R);
}

TEST(CopyTexture, CountsTexelsAndBytes)
{
	FRHICommandListImmediate List;
	List.CopyTexture(MakeRamp(FIntPoint(7, 5)), MakeTexture(FIntPoint(7, 5), PF_R32_FLOAT), FRHICopyTextureInfo());
	EXPECT_EQ(35u, List.GetCounters().Pixels);
	EXPECT_EQ(140u, List.GetCounters().BytesWritten);
}

TEST(ReadSurfaceData, MinMaxIsRaw)
{
	const FTextureRHIRef Texture = MakeRamp(FIntPoint(7, 5));
	Texture->WriteTexel(2, 1, FLinearColor(-3e9f, 0, 0, 0));
	const TArray<FLinearColor> Colors = ReadRaw(Texture, FIntRect(1, 1, 4, 3));
	EXPECT_EQ(6, Colors.Num());
	EXPECT_EQ(11.0f, Colors[0].R);
	EXPECT_EQ(-3e9f, Colors[1].R);
	EXPECT_EQ(23.0f, Colors[5].R);
}

TEST(ReadSurfaceData, UNormClamps)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_A32B32G32R32F);
	Texture->WriteTexel(0, 0, FLinearColor(-1, 0.5f, 2, std::numeric_limits<float>::quiet_NaN()));
	TArray<FLinearColor> Colors;
	GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 1, 1), Colors, FReadSurfaceDataFlags(RCM_UNorm));
	EXPECT_EQ(FLinearColor(0, 0.5f, 1, 0), Colors[0]);
}

TEST(ReadSurfaceData, MinMaxNormScalesWhatExceedsTheUnitRange)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_A32B32G32R32F);
	Texture->WriteTexel(0, 0, FLinearColor(-1, 0, 1, 3));
	TArray<FLinearColor> Colors;
	GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 1, 1), Colors, FReadSurfaceDataFlags(RCM_MinMaxNorm));
	EXPECT_EQ(FLinearColor(0, 0.25f, 0.5f, 1), Colors[0]);
}

TEST(ReadSurfaceData, FColorOfFloatsIsEncodedWhenAsked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_A32B32G32R32F);
	Texture->WriteTexel(0, 0, FLinearColor(0.5f, 2, -1, 0.5f));
	FReadSurfaceDataFlags Flags(RCM_MinMax);
	TArray<FColor> Colors;
	GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 1, 1), Colors, Flags);
	EXPECT_EQ(FColor(188, 255, 0, 128), Colors[0]);
	Flags.SetLinearToGamma(false);
	GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 1, 1), Colors, Flags);
	EXPECT_EQ(FColor(128, 255, 0, 128), Colors[0]);
}

TEST(ReadSurfaceData, FColorOfEightBitFormatsIsTheirBytes)
{
	for (const ETextureCreateFlags Srgb : {TexCreate_None, TexCreate_SRGB})
	{
		FRHITextureDesc Desc = Make2D(FIntPoint(64, 4), PF_B8G8R8A8);
		Desc.Flags |= Srgb;
		const FTextureRHIRef Texture = MakeTexture(Desc);
		for (int32 Code = 0; Code < 256; ++Code)
		{
			const uint8 Texel[4] = {uint8(Code), uint8(255 - Code), uint8(Code / 2), uint8(Code)};
			std::memcpy(Texture->GetTexel(Code % 64, Code / 64), Texel, 4);
		}
		TArray<FColor> Colors;
		GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 64, 4), Colors, FReadSurfaceDataFlags());
		for (int32 Code = 0; Code < 256; ++Code)
		{
			ASSERT_EQ(FColor(uint8(Code / 2), uint8(255 - Code), uint8(Code), uint8(Code)), Colors[Code]);
		}
	}
}

TEST(ReadSurfaceData, MipsAndSlices)
{
	const FTextureRHIRef Texture = MakeTexture(FRHITextureDesc::Create2DArray(
		FIntPoint(4, 4), PF_R32_FLOAT, FClearValueBinding::Black, TexCreate_ShaderResource, 2, 2));
	Texture->WriteTexel(1, 0, FLinearColor(5, 0, 0, 0), 1, 1);
	FReadSurfaceDataFlags Flags(RCM_MinMax);
	Flags.SetMip(1);
	Flags.SetArrayIndex(1);
	TArray<FLinearColor> Colors;
	GetList().ReadSurfaceData(Texture, FIntRect(0, 0, 2, 2), Colors, Flags);
	EXPECT_EQ(5.0f, Colors[1].R);
}

TEST(ReadSurfaceData, BeyondTheTextureIsChecked)
{
	TArray<FLinearColor> Colors;
	EXPECT_THROW(
		GetList().ReadSurfaceData(MakeRamp(FIntPoint(4, 4)), FIntRect(0, 0, 5, 4), Colors, FReadSurfaceDataFlags()),
		FCheckFailure);
}

TEST(ReadSurfaceData, AnEmptyRectIsEmpty)
{
	EXPECT_EQ(0, ReadRaw(MakeRamp(FIntPoint(4, 4)), FIntRect(2, 2, 2, 4)).Num());
}

TEST(ClearUAV, FloatStoresAsTheFormatDoes)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(3, 2), PF_FloatR11G11B10);
	GetList().ClearUAVFloat(RHICreateUnorderedAccessView(Texture), FVector4f(-1, 1e9f, 1 + 1 / 128.0f, 0));
	EXPECT_EQ(FLinearColor(0, 65024, 1, 1), Texture->ReadTexel(2, 1));
}

TEST(ClearUAV, TouchesOnlyItsMip)
{
	const FTextureRHIRef Texture = MakeTexture(Make2D(FIntPoint(4, 4), PF_R32_FLOAT, 3));
	GetList().ClearUAVFloat(RHICreateUnorderedAccessView(Texture, 1), FVector4f(3, 0, 0, 0));
	EXPECT_EQ(0.0f, Texture->ReadTexel(0, 0, 0).R);
	EXPECT_EQ(3.0f, Texture->ReadTexel(1, 1, 1).R);
	EXPECT_EQ(0.0f, Texture->ReadTexel(0, 0, 2).R);
}

TEST(ClearUAV, ReachesEveryDepthSlice)
{
	const FTextureRHIRef Texture = MakeTexture(
		FRHITextureDesc::Create3D(FIntVector(3, 3, 3), PF_R32_FLOAT, FClearValueBinding::Black, TexCreate_UAV));
	GetList().ClearUAVFloat(RHICreateUnorderedAccessView(Texture), FVector4f(3, 0, 0, 0));
	for (int32 Index = 0; Index < 27; ++Index)
	{
		EXPECT_EQ(3.0f, Texture->ReadTexel(Index % 3, Index / 3 % 3, 0, Index / 9).R) << Index;
	}
}

TEST(ClearUAV, UintIsVerbatimInIntegersAndBitsInFloats)
{
	const FTextureRHIRef Integers = MakeTexture(FIntPoint(2, 2), PF_R32_UINT);
	const FTextureRHIRef Floats = MakeTexture(FIntPoint(2, 2), PF_R32_FLOAT);
	GetList().ClearUAVUint(RHICreateUnorderedAccessView(Integers), FUintVector4(0xfeedfaceu, 0, 0, 0));
	GetList().ClearUAVUint(RHICreateUnorderedAccessView(Floats), FUintVector4(0x40490fdbu, 0, 0, 0));
	EXPECT_EQ(0xfeedfaceu, Integers->ReadTexelUint(1, 1).X);
	EXPECT_EQ(std::bit_cast<float>(0x40490fdbu), Floats->ReadTexel(1, 1).R);
}

TEST(ClearUAV, UintOfHalfIsRefused)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(2, 2), PF_FloatRGBA);
	EXPECT_THROW(
		GetList().ClearUAVUint(RHICreateUnorderedAccessView(Texture), FUintVector4(1, 1, 1, 1)), FCheckFailure);
}

TEST(ClearUAV, StructuredBuffersAreFilledWithTheFirstWord)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(8, 24, BUF_UnorderedAccess, TEXT("Test"));
	GetList().ClearUAVUint(RHICreateUnorderedAccessView(Buffer), FUintVector4(7, 8, 9, 10));
	uint32 Words[6];
	std::memcpy(Words, Buffer->GetData(), 24);
	EXPECT_EQ(7u, Words[0]);
	EXPECT_EQ(7u, Words[5]);
}

TEST(ClearUAV, TypedBuffersConvert)
{
	const FBufferRHIRef Buffer = RHICreateVertexBuffer(16, BUF_UnorderedAccess, TEXT("Test"));
	GetList().ClearUAVFloat(RHICreateUnorderedAccessView(Buffer, PF_FloatRGBA), FVector4f(1, 2, 0.5f, 1e6f));
	uint16 Halves[8];
	std::memcpy(Halves, Buffer->GetData(), 16);
	EXPECT_EQ(0x3c00, Halves[4]);
	EXPECT_EQ(0x4000, Halves[5]);
	EXPECT_EQ(0x3800, Halves[6]);
	EXPECT_EQ(0x7c00, Halves[7]);
}

TEST(CopyBuffer, RegionsAndBounds)
{
	const FBufferRHIRef Source = RHICreateStructuredBuffer(1, 16, BUF_None, TEXT("Source"));
	const FBufferRHIRef Dest = RHICreateStructuredBuffer(1, 8, BUF_None, TEXT("Dest"));
	Source->GetData()[10] = 42;
	GetList().CopyBufferRegion(Dest, 3, Source, 10, 2);
	EXPECT_EQ(42, Dest->GetData()[3]);
	EXPECT_THROW(GetList().CopyBufferRegion(Dest, 7, Source, 0, 2), FCheckFailure);
	EXPECT_THROW(GetList().CopyBufferRegion(Dest, 0, Source, 15, 2), FCheckFailure);
}

TEST(UpdateTexture, WritesARegionFromPitchedRows)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(4, 4), PF_R8_UINT);
	const uint8 Rows[] = {1, 2, 99, 3, 4, 99};
	RHIUpdateTexture2D(Texture, 0, FUpdateTextureRegion2D(1, 2, 0, 0, 2, 2), 3, Rows);
	EXPECT_EQ(1u, Texture->ReadTexelUint(1, 2).X);
	EXPECT_EQ(4u, Texture->ReadTexelUint(2, 3).X);
	EXPECT_EQ(0u, Texture->ReadTexelUint(3, 3).X);
}

TEST(UpdateTexture, AWidenedTextureDecodesItsFormat)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 1);
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(1, 1), PF_B8G8R8A8);
	const uint8 Bgra[4] = {51, 102, 255, 0};
	RHIUpdateTexture2D(Texture, 0, FUpdateTextureRegion2D(0, 0, 0, 0, 1, 1), 4, Bgra);
	EXPECT_EQ(FLinearColor(1.0f, 0.4f, 0.2f, 0.0f), Texture->ReadTexel(0, 0));
}

TEST(LockTexture, GivesTheTexelsInPlace)
{
	const FTextureRHIRef Texture = MakeRamp(FIntPoint(4, 4));
	uint32 Stride;
	float* const Data = static_cast<float*>(RHILockTexture2D(Texture, 0, RLM_WriteOnly, Stride, false));
	EXPECT_EQ(32.0f, Data[3 * Stride / 4 + 2]);
	Data[Stride / 4] = 77;
	RHIUnlockTexture2D(Texture, 0, false);
	EXPECT_EQ(77.0f, Texture->ReadTexel(0, 1).R);
}

TEST(LockTexture, AWidenedTextureTakesWhatWasWrittenInItsFormat)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(2, 2), PF_R16F);
	uint32 Stride;
	uint16* const Data = static_cast<uint16*>(RHILockTexture2D(Texture, 0, RLM_WriteOnly, Stride, false));
	EXPECT_EQ(4u, Stride);
	Data[3] = 0x3800;
	RHIUnlockTexture2D(Texture, 0, false);
	EXPECT_EQ(0.5f, Texture->ReadTexel(1, 1).R);
}

TEST(LockTexture, TwiceIsChecked)
{
	const FTextureRHIRef Texture = MakeRamp(FIntPoint(4, 4));
	uint32 Stride;
	RHILockTexture2D(Texture, 0, RLM_ReadOnly, Stride, false);
	EXPECT_THROW(RHILockTexture2D(Texture, 0, RLM_ReadOnly, Stride, false), FCheckFailure);
	RHIUnlockTexture2D(Texture, 0, false);
	EXPECT_THROW(RHIUnlockTexture2D(Texture, 0, false), FCheckFailure);
}
