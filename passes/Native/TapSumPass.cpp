// Between screen passes and sums of taps: targets, sources and axes from a pass's parameters.
#include "Native/TapSumPass.h"

#include "NativeFallback.h"

#include <algorithm>

namespace Drydock
{

FTapTarget GetPixelTarget(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	return {Args.GetArgs().NumTargets > 0 ? &Args.GetArgs().Targets[0].Texture : nullptr, Tile};
}

FTapTarget GetComputeTarget(
	const FNativeKernelArgs& Args, const FKernelTile& Tile, const char* HlslName, FIntPoint Min, FIntPoint Max)
{
	FKernelTile Pixels = Tile;
	Pixels.MinX += Min.X;
	Pixels.MinY += Min.Y;
	Pixels.MaxX = std::min(Tile.MaxX + Min.X, Max.X);
	Pixels.MaxY = std::min(Tile.MaxY + Min.Y, Max.Y);
	return {Args.FindRWTexture(HlslName), Pixels};
}

FTapSource MakeTapSource(const FNativeKernelArgs& Args, const char* Texture, const char* Sampler,
	const FScreenPassTextureViewportParameters& Viewport)
{
	FTapSource Source;
	Source.Texture = Args.FindTexture(Texture);
	Source.Sampler = Args.FindSampler(Sampler);
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Source.RectMin[Axis] = Viewport.ViewportMin[Axis];
		Source.RectMax[Axis] = Viewport.ViewportMax[Axis];
	}
	return Source;
}

FTapAxis MakeStretchAxis(
	const FScreenPassTextureViewportParameters& Output, const FScreenPassTextureViewportParameters& Input, int Axis)
{
	FTapAxis Result;
	Result.Origin = static_cast<float>(Output.ViewportMin[Axis]);
	Result.Scale = Output.ViewportSizeInverse[Axis];
	Result.Extent = Input.UVViewportSize[Axis];
	Result.First = Input.UVViewportMin[Axis];
	Result.MinUV = Input.UVViewportBilinearMin[Axis];
	Result.MaxUV = Input.UVViewportBilinearMax[Axis];
	return Result;
}

FTapAxis MakeOffsetAxis(const FScreenPassTextureViewportParameters& Input, FVector2f InputPerOutput, FVector2f Corner,
	float Offset, int Axis)
{
	FTapAxis Result;
	Result.Extent = InputPerOutput[Axis];
	Result.First = Corner[Axis];
	Result.Second = Offset;
	Result.ToUV = Input.ExtentInverse[Axis];
	Result.MinUV = Input.UVViewportBilinearMin[Axis];
	Result.MaxUV = Input.UVViewportBilinearMax[Axis];
	return Result;
}

namespace
{

bool IsInside(const FTapSource& Source)
{
	if (!Source.Texture || !Source.Sampler)
	{
		return false;
	}
	const FKernelMip& Mip = Source.Texture->Mips[0];
	return Source.RectMin[0] >= 0 && Source.RectMin[1] >= 0 && Source.RectMax[0] <= Mip.SizeX &&
		   Source.RectMax[1] <= Mip.SizeY && Source.RectMin[0] < Source.RectMax[0] &&
		   Source.RectMin[1] < Source.RectMax[1];
}

bool IsInside(const FTapTarget& Target)
{
	if (!Target.Texture)
	{
		return false;
	}
	const FKernelMip& Mip = Target.Texture->Mips[0];
	return Target.Pixels.MinX >= 0 && Target.Pixels.MinY >= 0 && Target.Pixels.MaxX <= Mip.SizeX &&
		   Target.Pixels.MaxY <= Mip.SizeY;
}

} // namespace

void SumTapsOrRunShader(const FTapSum& Sum, const FNativeKernelArgs& Args, const FKernelTile& Tile,
	const FTapTarget& Target, FIntPoint Origin)
{
	FKernelTile Pixels = Target.Pixels;
	Pixels.MinX -= Origin.X;
	Pixels.MaxX -= Origin.X;
	Pixels.MinY -= Origin.Y;
	Pixels.MaxY -= Origin.Y;
	const auto Fits = [](const FTapSource& Source)
	{
		return IsInside(Source);
	};
	if (!StoresPlainly(Args.GetArgs()) || !IsInside(Target) ||
		!std::all_of(Sum.Sources, Sum.Sources + Sum.NumSources, Fits) ||
		!SumTaps(Sum, *Target.Texture, Pixels, Origin.X, Origin.Y))
	{
		RunShader(Args, Tile);
	}
}

} // namespace Drydock
