// The largest of a tile's pixels: the longest movement for motion blur, the largest radius for depth of field. Stands
// in for PostProcessMotionBlur.usf and DiaphragmDOF.usf with their bits: rows are decoded once and read in order, where
// a shader's lanes lie a tile apart.
#include "Lens/DiaphragmDOFShaders.h"
#include "Lens/MotionBlurShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"
#include "TexelRows.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Drydock
{

namespace
{

/** Calls Take(Tile, Texel, Best) for the texels of a row of tiles, in the order of the shaders, which keep the first of
 * equals; a texel beyond Size is one of Size that came before. Stores Best, RGBA, for each tile. */
template<typename TakeType>
void RunTiles(const FKernelTexture& Source, FIntPoint Size, int32 TileSize, const FKernelTexture& Target,
	const FKernelTile& Tiles, const TakeType& Take)
{
	constexpr int32 Channels = 4;
	const FKernelMip& From = Source.Mips[0];
	const FKernelMip& To = Target.Mips[0];
	const int32 First = Tiles.MinX * TileSize;
	const int32 Count = std::min(Tiles.MaxX * TileSize, Size.X) - First;
	const int64_t SourceBytes = GetTexelStorageInfo(Source.Storage).BytesPerTexel;
	const int64_t TargetBytes = GetTexelStorageInfo(Target.Storage).BytesPerTexel;
	std::vector<float> Texels(static_cast<size_t>(Count) * Channels);
	std::vector<float> Best;
	for (int32 TileY = Tiles.MinY; TileY < Tiles.MaxY; ++TileY)
	{
		Best.assign(static_cast<size_t>(Tiles.MaxX - Tiles.MinX) * Channels, 0.0f);
		for (int32 Y = TileY * TileSize; Y < std::min((TileY + 1) * TileSize, Size.Y); ++Y)
		{
			DecodeTexelRow(Source.Storage, From.Data + int64_t(Y) * From.RowPitch + First * SourceBytes, Count,
				Channels, Texels.data());
			for (int32 X = 0; X < Count; ++X)
			{
				Take(&Texels[static_cast<size_t>(X) * Channels], &Best[static_cast<size_t>(X / TileSize) * Channels]);
			}
		}
		EncodeTexelRow(Target.Storage, Best.data(), Tiles.MaxX - Tiles.MinX,
			To.Data + int64_t(TileY) * To.RowPitch + Tiles.MinX * TargetBytes, Target.bSaturateStore != 0);
	}
}

/** Tiles: those that hold a texel of Size. */
bool CanRun(const FNativeKernelArgs& Args, const FKernelTexture* Source, FIntPoint Size, int32 TileSize,
	const FTapTarget& Target)
{
	if (!Source || !StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Target.Pixels))
	{
		return false;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Source->Storage);
	const FKernelMip& Mip = Source->Mips[0];
	return Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32 && Size.X <= Mip.SizeX && Size.Y <= Mip.SizeY &&
		   (Target.Pixels.MaxX - 1) * TileSize < Size.X && (Target.Pixels.MaxY - 1) * TileSize < Size.Y;
}

void RunVelocityTileMax(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FIntPoint Size = GetNativeParameters<FMotionBlurVelocityTileMaxPS>(Args).FlatSize;
	const FKernelTexture* const Flat = Args.FindTexture("FlatTexture");
	const FTapTarget Target = GetPixelTarget(Args, Tile);
	if (!CanRun(Args, Flat, Size, GMotionBlurTileSize, Target))
	{
		RunShader(Args, Tile);
		return;
	}
	RunTiles(*Flat, Size, GMotionBlurTileSize, *Target.Texture, Target.Pixels,
		[](const float* Movement, float* Longest)
		{
			const float Length = Movement[0] * Movement[0] + Movement[1] * Movement[1];
			if (Length > Longest[0] * Longest[0] + Longest[1] * Longest[1])
			{
				Longest[0] = Movement[0];
				Longest[1] = Movement[1];
			}
		});
}

void RunDOFTileMax(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FIntPoint Size = GetNativeParameters<FDOFTileMaxPS>(Args).HalfSize;
	const FKernelTexture* const Setup = Args.FindTexture("SetupTexture");
	const FTapTarget Target = GetPixelTarget(Args, Tile);
	if (!CanRun(Args, Setup, Size, GDOFTileSize, Target))
	{
		RunShader(Args, Tile);
		return;
	}
	// NaN is larger than nothing.
	RunTiles(*Setup, Size, GDOFTileSize, *Target.Texture, Target.Pixels,
		[](const float* Color, float* Largest)
		{
			const float Radius = std::fabs(Color[3]);
			*Largest = Radius > *Largest ? Radius : *Largest;
		});
}

} // namespace

REGISTER_NATIVE_KERNEL(FMotionBlurVelocityTileMaxPS, &RunVelocityTileMax, "c8598735be83e15d")
REGISTER_NATIVE_KERNEL(FDOFTileMaxPS, &RunDOFTileMax, "6fbee6e2d05599ce")

} // namespace Drydock
