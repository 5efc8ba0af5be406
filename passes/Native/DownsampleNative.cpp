// Halving an image as a sum of one tap, low quality, or four. Stands in for PostProcessDownsample.usf with its bits.
#include "NativeKernels.h"
#include "Native/TapSumPass.h"
#include "Screen/DownsampleShaders.h"
#include "Screen/PostProcessDownsample.h"

namespace Drydock
{

namespace
{

void RunDownsample(const FNativeKernelArgs& Args, const FKernelTile& Tile, const FDownsampleParameters& Parameters,
	const FTapTarget& Target)
{
	const FDownsamplePS::FPermutationDomain Permutation(Args.GetPermutationId());
	const bool bHigh = Permutation.Get<FDownsampleQualityDimension>() == static_cast<int32>(EDownsampleQuality::High);
	const int NumTaps = bHigh ? 4 : 1;
	FTap Taps[4];
	for (int Index = 0; Index < NumTaps; ++Index)
	{
		FTap& Tap = Taps[Index];
		Tap.X = MakeStretchAxis(Parameters.Output, Parameters.Input, 0);
		Tap.Y = MakeStretchAxis(Parameters.Output, Parameters.Input, 1);
		Tap.X.Second = bHigh ? Parameters.Input.ExtentInverse.X * (Index % 2 == 0 ? -1.0f : 1.0f) : 0.0f;
		Tap.Y.Second = bHigh ? Parameters.Input.ExtentInverse.Y * (Index / 2 == 0 ? -1.0f : 1.0f) : 0.0f;
	}
	FTapSource Source = MakeTapSource(Args, "InputTexture", "InputSampler", Parameters.Input);
	Source.Beyond = EBeyondRect::Clamp;
	Source.Taps = Taps;
	Source.NumTaps = NumTaps;
	FTapSum Sum;
	Sum.Sources = &Source;
	Sum.NumSources = 1;
	Sum.Factor = bHigh ? 0.25f : 1.0f;
	Sum.bNoNegatives = bHigh;
	SumTapsOrRunShader(Sum, Args, Tile, Target);
}

void RunDownsamplePixels(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunDownsample(Args, Tile, GetNativeParameters<FDownsamplePS>(Args).Common, GetPixelTarget(Args, Tile));
}

void RunDownsampleThreads(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FDownsampleParameters& Parameters = GetNativeParameters<FDownsampleCS>(Args).Common;
	RunDownsample(Args, Tile, Parameters,
		GetComputeTarget(
			Args, Tile, "OutComputeTexture", Parameters.Output.ViewportMin, Parameters.Output.ViewportMax));
}

} // namespace

REGISTER_NATIVE_KERNEL(FDownsamplePS, &RunDownsamplePixels, "87363ea5d27dd4bf")
REGISTER_NATIVE_KERNEL(FDownsampleCS, &RunDownsampleThreads, "87363ea5d27dd4bf")

} // namespace Drydock
