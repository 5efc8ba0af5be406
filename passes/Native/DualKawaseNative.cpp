// The two passes of the dual Kawase blur as sums of taps. Stands in for DualKawaseBlur.usf with its bits; as printed,
// the article's form samples points, and is left to the shader.
#include "Blur/DualKawaseBlurShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/TapSumPass.h"

namespace Drydock
{

namespace
{

/** Distances of one tap in tap offsets, and its weight. */
struct FKawaseTap
{
	float X;
	float Y;
	float Weight;
};

// In the order of the shader.
constexpr FKawaseTap DownTaps[] = {
	{0.0f, 0.0f, 4.0f}, {-1.0f, -1.0f, 1.0f}, {1.0f, 1.0f, 1.0f}, {1.0f, -1.0f, 1.0f}, {-1.0f, 1.0f, 1.0f}};
constexpr FKawaseTap UpAxisTaps[] = {{-1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}, {0.0f, -1.0f, 1.0f}, {0.0f, 1.0f, 1.0f}};
constexpr FKawaseTap UpDiagonalTaps[] = {
	{-1.0f, 1.0f, 2.0f}, {1.0f, 1.0f, 2.0f}, {1.0f, -1.0f, 2.0f}, {-1.0f, -1.0f, 2.0f}};

constexpr int32 MostTaps = 8;

void RunKawase(const FNativeKernelArgs& Args, const FKernelTile& Tile, bool bDown)
{
	const FDualKawaseShader::FPermutationDomain Permutation(Args.GetPermutationId());
	if (Permutation.Get<FDualKawaseShader::FAsPrintedDimension>())
	{
		RunShader(Args, Tile);
		return;
	}
	const auto& Parameters = *static_cast<const FDualKawaseParameters*>(Args.GetParameters());
	FTap Taps[MostTaps];
	int32 NumTaps = 0;
	const auto MakeAxis = [&Parameters](float Offset, int Axis)
	{
		return MakeOffsetAxis(
			Parameters.Input, Parameters.InputPerOutput, FVector2f(Parameters.Input.ViewportMin), Offset, Axis);
	};
	const auto Add = [&](const auto& List, float Distance)
	{
		for (const FKawaseTap& Tap : List)
		{
			FTap& Out = Taps[NumTaps++];
			Out.X = MakeAxis(Tap.X * Distance, 0);
			Out.Y = MakeAxis(Tap.Y * Distance, 1);
			for (float& Weight : Out.Weight)
			{
				Weight = Tap.Weight;
			}
		}
	};
	if (bDown)
	{
		Add(DownTaps, Parameters.TapOffset.Y);
	}
	else
	{
		Add(UpAxisTaps, Parameters.TapOffset.X);
		Add(UpDiagonalTaps, Parameters.TapOffset.Y);
	}

	FTapSource Source = MakeTapSource(Args, "Intexture", "Sampler", Parameters.Input);
	Source.Beyond = EBeyondRect::Clamp;
	Source.Taps = Taps;
	Source.NumTaps = NumTaps;
	FTapSum Sum;
	Sum.Sources = &Source;
	Sum.NumSources = 1;
	// The shader's compiler makes a product of the division by a constant.
	Sum.Factor = bDown ? 1.0f / 8.0f : 1.0f / 12.0f;
	const FIntPoint Min = Parameters.Output.ViewportMin;
	SumTapsOrRunShader(
		Sum, Args, Tile, GetComputeTarget(Args, Tile, "OutTexture", Min, Parameters.Output.ViewportMax), Min);
}

void RunKawaseDown(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunKawase(Args, Tile, true);
}

void RunKawaseUp(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunKawase(Args, Tile, false);
}

} // namespace

REGISTER_NATIVE_KERNEL(FDualKawaseDownCS, &RunKawaseDown, "c93cbbe88b4e075f")
REGISTER_NATIVE_KERNEL(FDualKawaseUpCS, &RunKawaseUp, "c93cbbe88b4e075f")

} // namespace Drydock
