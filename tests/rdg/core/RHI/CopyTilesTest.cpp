// Copies of drawn regions, mips, slices and formats, which tiles share among threads, against texels moved one by one.
#include <cstring>
#include <random>
#include <vector>

#include "PixelFormatConversion.h"
#include "RHICommandList.h"
#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

int32 Pick(std::mt19937& Random, int32 Low, int32 High)
{
	return std::uniform_int_distribution<int32>(Low, High)(Random);
}

/** All bytes of a texture, in the order of f(mip, slice, y). */
template<typename F>
void ForEachRow(FRHITexture& Texture, const F& f)
{
	for (int32 Mip = 0; Mip < Texture.GetDesc().NumMips; ++Mip)
	{
		const FTextureMipLayout& At = Texture.GetMipLayout(Mip);
		const int32 Slices = Texture.GetDesc().IsTexture3D() ? At.SizeZ : Texture.GetDesc().ArraySize;
		for (int32 Slice = 0; Slice < Slices; ++Slice)
		{
			for (int32 Y = 0; Y < At.SizeY; ++Y)
			{
				f(Texture.GetTexel(0, Y, Mip, Slice),
					size_t(At.SizeX) * GetTexelStorageInfo(Texture.GetStorage()).BytesPerTexel);
			}
		}
	}
}

void Fill(FRHITexture& Texture, std::mt19937& Random)
{
	ForEachRow(Texture,
		[&](uint8* Row, size_t Bytes)
		{
			for (size_t i = 0; i < Bytes; ++i)
			{
				Row[i] = uint8(Random());
			}
		});
}

std::vector<uint8> GetBytes(FRHITexture& Texture)
{
	std::vector<uint8> Result;
	ForEachRow(Texture, [&](uint8* Row, size_t Bytes) { Result.insert(Result.end(), Row, Row + Bytes); });
	return Result;
}

/** A texture with the same bytes. */
FTextureRHIRef Clone(FRHITexture& Texture)
{
	const FTextureRHIRef Result = MakeTexture(Texture.GetDesc());
	const std::vector<uint8> Bytes = GetBytes(Texture);
	size_t Offset = 0;
	ForEachRow(*Result,
		[&](uint8* Row, size_t Count)
		{
			std::memcpy(Row, Bytes.data() + Offset, Count);
			Offset += Count;
		});
	return Result;
}

/** Row by row from the top, texel by texel; a row is read before it is written. */
void CopyOneByOne(FRHITexture& Source, FRHITexture& Dest, const FRHICopyTextureInfo& Info)
{
	const size_t Bytes = size_t(GetTexelStorageInfo(Source.GetStorage()).BytesPerTexel);
	const bool bVolume = Source.GetDesc().IsTexture3D();
	for (uint32 Mip = 0; Mip < Info.NumMips; ++Mip)
	{
		const auto AtMip = [Mip](int32 Size)
		{
			return std::max(Size >> Mip, 1);
		};
		const int32 Slices = bVolume ? AtMip(Info.Size.Z) : int32(Info.NumSlices);
		for (int32 Z = 0; Z < Slices; ++Z)
		{
			for (int32 Y = 0; Y < AtMip(Info.Size.Y); ++Y)
			{
				std::vector<uint8> Row;
				for (int32 X = 0; X < AtMip(Info.Size.X); ++X)
				{
					const uint8* const Texel = Source.GetTexel((Info.SourcePosition.X >> Mip) + X,
						(Info.SourcePosition.Y >> Mip) + Y, int32(Info.SourceMipIndex + Mip),
						(bVolume ? Info.SourcePosition.Z >> Mip : int32(Info.SourceSliceIndex)) + Z);
					Row.insert(Row.end(), Texel, Texel + Bytes);
				}
				for (int32 X = 0; X < AtMip(Info.Size.X); ++X)
				{
					std::memcpy(Dest.GetTexel((Info.DestPosition.X >> Mip) + X, (Info.DestPosition.Y >> Mip) + Y,
									int32(Info.DestMipIndex + Mip),
									(bVolume ? Info.DestPosition.Z >> Mip : int32(Info.DestSliceIndex)) + Z),
						Row.data() + size_t(X) * Bytes, Bytes);
				}
			}
		}
	}
}

FRHITextureDesc DrawDesc(std::mt19937& Random, int32 Kind, EPixelFormat Format)
{
	// Several tiles of rows high, or fewer than one.
	const FIntPoint Extent(Pick(Random, 8, 70), Pick(Random, 0, 1) == 0 ? Pick(Random, 8, 60) : Pick(Random, 130, 300));
	constexpr ETextureCreateFlags Flags = TexCreate_ShaderResource;
	switch (Kind)
	{
	case 0:
		return FRHITextureDesc::Create2D(Extent, Format, FClearValueBinding::Black, Flags, 3);
	case 1:
		return FRHITextureDesc::Create2DArray(Extent, Format, FClearValueBinding::Black, Flags, 5, 3);
	default:
		return FRHITextureDesc::Create3D(
			FIntVector(Extent.X, Extent.Y, Pick(Random, 4, 9)), Format, FClearValueBinding::Black, Flags, 2);
	}
}

/** A region that lies in both places, in the mip that it begins in and, halved, in the next. */
FRHICopyTextureInfo DrawRegion(std::mt19937& Random, const FRHITexture& Texture)
{
	const FRHITextureDesc& Desc = Texture.GetDesc();
	const bool bVolume = Desc.IsTexture3D();
	FRHICopyTextureInfo Info;
	Info.SourceMipIndex = Info.DestMipIndex = uint32(Pick(Random, 0, Desc.NumMips - 1));
	Info.NumMips = uint32(Pick(Random, 1, Desc.NumMips - int32(Info.SourceMipIndex)));
	const FTextureMipLayout& At = Texture.GetMipLayout(int32(Info.SourceMipIndex));
	// Whole multiples of what the mips halve to: odd places and sizes where only one mip is copied.
	const int32 Step = 1 << (Info.NumMips - 1);
	const auto DrawAxis = [&](int32 Whole, int32& Size, int32& From, int32& To)
	{
		Size = Step * Pick(Random, 1, std::max(Whole / Step, 1));
		From = Step * Pick(Random, 0, std::max((Whole - Size) / Step, 0));
		To = Step * Pick(Random, 0, std::max((Whole - Size) / Step, 0));
	};
	DrawAxis(At.SizeX, Info.Size.X, Info.SourcePosition.X, Info.DestPosition.X);
	DrawAxis(At.SizeY, Info.Size.Y, Info.SourcePosition.Y, Info.DestPosition.Y);
	Info.Size.Z = 1;
	if (bVolume)
	{
		DrawAxis(At.SizeZ, Info.Size.Z, Info.SourcePosition.Z, Info.DestPosition.Z);
	}
	else
	{
		Info.NumSlices = uint32(Pick(Random, 1, Desc.ArraySize));
		Info.SourceSliceIndex = uint32(Pick(Random, 0, Desc.ArraySize - int32(Info.NumSlices)));
		Info.DestSliceIndex = uint32(Pick(Random, 0, Desc.ArraySize - int32(Info.NumSlices)));
	}
	return Info;
}

} // namespace

TEST(CopyTiles, RegionsMipsSlicesAndFormatsForAnyThreads)
{
	constexpr EPixelFormat Formats[] = {PF_A32B32G32R32F, PF_FloatRGBA, PF_B8G8R8A8, PF_R16F, PF_G8, PF_R32_UINT};
	std::mt19937 Random(19);
	for (int32 Case = 0; Case < 90; ++Case)
	{
		const FRHITextureDesc Desc = DrawDesc(Random, Case % 3, Formats[size_t(Case) % std::size(Formats)]);
		const FTextureRHIRef Source = MakeTexture(Desc);
		const FTextureRHIRef Before = MakeTexture(Desc);
		Fill(*Source, Random);
		Fill(*Before, Random);
		const FRHICopyTextureInfo Info = DrawRegion(Random, *Source);
		const FTextureRHIRef Expected = Clone(*Before);
		CopyOneByOne(*Source, *Expected, Info);
		for (const int32 Threads : {1, 2, 5})
		{
			const FScopedCVar Scope(TEXT("r.Drydock.Threads"), Threads);
			const FTextureRHIRef Dest = Clone(*Before);
			FRHICommandListExecutor::GetImmediateCommandList().CopyTexture(Source, Dest, Info);
			EXPECT_EQ(GetBytes(*Expected), GetBytes(*Dest)) << "case " << Case << ", " << Threads << " threads";
		}
	}
}

TEST(CopyTiles, WithinOneTextureRowsGoFromTheTopWhereTheyOverlap)
{
	std::mt19937 Random(4);
	for (int32 Case = 0; Case < 30; ++Case)
	{
		const FTextureRHIRef Before = MakeTexture(DrawDesc(Random, Case % 3, PF_FloatRGBA));
		Fill(*Before, Random);
		FRHICopyTextureInfo Info = DrawRegion(Random, *Before);
		Info.DestSliceIndex = Info.SourceSliceIndex;
		const FTextureRHIRef Expected = Clone(*Before);
		CopyOneByOne(*Expected, *Expected, Info);
		for (const int32 Threads : {1, 3})
		{
			const FScopedCVar Scope(TEXT("r.Drydock.Threads"), Threads);
			const FTextureRHIRef Texture = Clone(*Before);
			FRHICommandListExecutor::GetImmediateCommandList().CopyTexture(Texture, Texture, Info);
			EXPECT_EQ(GetBytes(*Expected), GetBytes(*Texture)) << "case " << Case << ", " << Threads << " threads";
		}
	}
}
