// The engine's Gaussian blur, one direction of it, as a sum of taps. Stands in for FilterPixelShader.usf with its bits;
// the mirror at the edge of a rect, which runs backwards through the texels, is left to the shader.
#include "Blur/FilterShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/TapSumPass.h"

namespace Drydock
{

namespace
{

/** Beyond this a float coordinate may miss a texel's centre, which a black border's shader asks for by name. */
constexpr int32 MostBlackExtent = 8192;

/** Along one axis, before the tap's own offset. */
FTapAxis MakeFilterAxis(const FFilterParameters& Parameters, bool bHeld, int Axis)
{
	const FScreenPassTextureViewportParameters& Filter = Parameters.Filter.Viewport;
	FTapAxis Result;
	Result.Origin = static_cast<float>(Parameters.Output.ViewportMin[Axis]);
	Result.Scale = Parameters.Output.ViewportSizeInverse[Axis];
	Result.Extent = Filter.ViewportSize[Axis];
	Result.Second = static_cast<float>(Filter.ViewportMin[Axis]);
	Result.ToUV = Filter.ExtentInverse[Axis];
	if (bHeld || Parameters.bSnapTaps != 0)
	{
		Result.Steps = Parameters.SampleSteps;
	}
	if (bHeld)
	{
		Result.Min = 0.5f;
		Result.Max = Filter.ViewportSize[Axis] - 0.5f;
	}
	return Result;
}

void RunFilter(const FNativeKernelArgs& Args, const FKernelTile& Tile, const FFilterParameters& Parameters,
	const FTapTarget& Target)
{
	const FFilterPermutation Permutation(Args.GetPermutationId());
	const ERectBorder Border = Permutation.Get<FRectBorderDimension>();
	const FScreenPassTextureViewportParameters& Filter = Parameters.Filter.Viewport;
	const bool bTooFar = Filter.Extent.X > MostBlackExtent || Filter.Extent.Y > MostBlackExtent;
	if (Border == ERectBorder::Mirror || (Border == ERectBorder::Black && bTooFar) || Parameters.SampleCount < 1)
	{
		RunShader(Args, Tile);
		return;
	}

	const bool bHeld = Border != ERectBorder::Sampler;
	FTap Taps[MaxFilterSamples];
	for (int32 Index = 0; Index < Parameters.SampleCount; ++Index)
	{
		const FVector4f& Pair = Parameters.SampleOffsets[Index / 2];
		FTap& Tap = Taps[Index];
		Tap.X = MakeFilterAxis(Parameters, bHeld, 0);
		Tap.Y = MakeFilterAxis(Parameters, bHeld, 1);
		Tap.X.First = Index % 2 == 0 ? Pair.X : Pair.Z;
		Tap.Y.First = Index % 2 == 0 ? Pair.Y : Pair.W;
		for (int Channel = 0; Channel < 4; ++Channel)
		{
			Tap.Weight[Channel] = Parameters.SampleWeights[Index][Channel];
		}
	}

	FTapSource Sources[2];
	Sources[0] = MakeTapSource(Args, "Filter_Texture", "Filter_Sampler", Filter);
	Sources[0].Beyond = Border == ERectBorder::Black   ? EBeyondRect::Black
						: Border == ERectBorder::Clamp ? EBeyondRect::Clamp
													   : EBeyondRect::Sampler;
	Sources[0].bFromZero = true;
	Sources[0].Taps = Taps;
	Sources[0].NumTaps = Parameters.SampleCount;
	FTapSum Sum;
	Sum.Sources = Sources;
	Sum.NumSources = 1;

	FTap Additive;
	if (Permutation.Get<FAdditiveDimension>())
	{
		Additive.X = MakeStretchAxis(Parameters.Output, Parameters.Additive.Viewport, 0);
		Additive.Y = MakeStretchAxis(Parameters.Output, Parameters.Additive.Viewport, 1);
		Sources[1] = MakeTapSource(Args, "Additive_Texture", "Additive_Sampler", Parameters.Additive.Viewport);
		Sources[1].Beyond = EBeyondRect::Clamp;
		Sources[1].Taps = &Additive;
		Sources[1].NumTaps = 1;
		Sum.NumSources = 2;
	}
	SumTapsOrRunShader(Sum, Args, Tile, Target);
}

void RunFilterPixels(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunFilter(Args, Tile, GetNativeParameters<FFilterPS>(Args).Common, GetPixelTarget(Args, Tile));
}

void RunFilterThreads(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FFilterParameters& Parameters = GetNativeParameters<FFilterCS>(Args).Common;
	RunFilter(Args, Tile, Parameters,
		GetComputeTarget(Args, Tile, "RWOutputTexture", Parameters.Output.ViewportMin, Parameters.Output.ViewportMax));
}

} // namespace

REGISTER_NATIVE_KERNEL(FFilterPS, &RunFilterPixels, "21b16b5d01d84762")
REGISTER_NATIVE_KERNEL(FFilterCS, &RunFilterThreads, "21b16b5d01d84762")

} // namespace Drydock
