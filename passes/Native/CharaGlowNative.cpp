// CharaGlow's box by sums that do not grow with the area. Stands in for BoxPS of CharaGlow.usf, within the bound of
// BoxSum.h.
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/BoxSum.h"
#include "Native/NativeLanes.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"
#include "PixelFormatConversion.h"
#include "Toon/CharaGlowShaders.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** False where the shader has to do it. */
bool MakeBoxSum(const FNativeKernelArgs& Args, const FCharaGlowBoxParameters& Parameters, bool bColumns, FBoxSum& Sum)
{
	Sum.Source = Args.FindTexture(bColumns ? "RowsTexture" : "SceneTexturesStruct_GBufferDTexture");
	Sum.Channel = bColumns ? 0 : 2;
	Sum.Axis = bColumns ? 1 : 0;
	Sum.Radius = Parameters.Radius;
	Sum.Fraction = Parameters.Fraction;
	Sum.Scale = Parameters.Scale;
	if (!Sum.Source || Sum.Source->bIs3D || Sum.Radius < 0)
	{
		return false;
	}
	const FTexelStorageInfo& Info = GetTexelStorageInfo(Sum.Source->Storage);
	const FKernelMip& Mip = Sum.Source->Mips[0];
	const int32 Size[2] = {Mip.SizeX, Mip.SizeY};
	bool bInside = Info.Kind != ETexelKind::Uint && Info.BitsPerChannel <= 32;
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Sum.RectMin[Axis] = Parameters.Source.ViewportMin[Axis];
		Sum.RectMax[Axis] = Parameters.Source.ViewportMax[Axis];
		bInside = bInside && Sum.RectMin[Axis] >= 0 && Sum.RectMin[Axis] < Sum.RectMax[Axis] &&
				  Sum.RectMax[Axis] <= Size[Axis];
	}
	return bInside;
}

uint64 RunBox(const FBoxSum& Sum, const FKernelTexture& Target, const FKernelTile& Tile, FIntPoint ToSource)
{
	return WithNativeLanes<TBoxSumLanes>(
		[&](auto Lanes) { return Lanes.Run(Sum, Target, Tile, ToSource.X, ToSource.Y); });
}

void RunCharaGlowBox(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	constexpr int32 MostGroups = 64;
	const FCharaGlowBoxPS::FPermutationDomain Permutation(Args.GetPermutationId());
	const FCharaGlowBoxParameters& Parameters = GetNativeParameters<FCharaGlowBoxPS>(Args);
	const FTapTarget Target = GetPixelTarget(Args, Tile);
	FBoxSum Sum;
	if (!StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Tile) ||
		Tile.MaxY - Tile.MinY > MostGroups * GRowsOfBoxGroup ||
		!MakeBoxSum(Args, Parameters, Permutation.Get<FCharaGlowBoxPS::FColumnsDimension>(), Sum))
	{
		RunShader(Args, Tile);
		return;
	}
	const FIntPoint ToSource = FIntPoint(Sum.RectMin[0], Sum.RectMin[1]) - FIntPoint(Parameters.Output.ViewportMin);
	// Groups that are left are tried again in parts. The parts are the same in tiles of any size.
	const uint64 Left = RunBox(Sum, *Target.Texture, Tile, ToSource);
	for (int32 Y = Tile.MinY, Group = 0; Y < Tile.MaxY && (Left >> Group) != 0; Y += GRowsOfBoxGroup, ++Group)
	{
		for (int32 X = Tile.MinX; X < Tile.MaxX && (Left >> Group & 1) != 0; X += GColumnsOfBoxGroup)
		{
			FKernelTile Part = Tile;
			Part.MinX = X;
			Part.MaxX = std::min(X + GColumnsOfBoxGroup, Tile.MaxX);
			Part.MinY = Y;
			Part.MaxY = std::min(Y + GRowsOfBoxGroup, Tile.MaxY);
			if (RunBox(Sum, *Target.Texture, Part, ToSource) != 0)
			{
				RunShader(Args, Part);
			}
		}
	}
}

} // namespace

REGISTER_NATIVE_KERNEL(FCharaGlowBoxPS, &RunCharaGlowBox, "484574a740135a8b")

} // namespace Drydock
