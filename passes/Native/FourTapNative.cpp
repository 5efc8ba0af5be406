// The passes of Kawase's blur and of the pyramid as sums of taps. Stands in for FourTapBlur.usf with its bits.
#include "Blur/FourTapShaders.h"
#include "NativeKernels.h"
#include "Native/TapSumPass.h"

namespace Drydock
{

namespace
{

void RunTaps(const FNativeKernelArgs& Args, const FKernelTile& Tile, int32 NumTaps, float Factor)
{
	const auto& Parameters = *static_cast<const FFourTapParameters*>(Args.GetParameters());
	const float Distance = NumTaps == 1 ? 0.0f : Parameters.TapDistance;
	const auto MakeAxis = [&Parameters](float Offset, int Axis)
	{
		return MakeOffsetAxis(Parameters.Input, Parameters.InputPerOutput, Parameters.InputCorner, Offset, Axis);
	};
	FTap Taps[4];
	for (int32 Index = 0; Index < NumTaps; ++Index)
	{
		Taps[Index].X = MakeAxis(Index % 2 == 0 ? -Distance : Distance, 0);
		Taps[Index].Y = MakeAxis(Index / 2 == 0 ? -Distance : Distance, 1);
	}
	FTapSource Source = MakeTapSource(Args, "Intexture", "Sampler", Parameters.Input);
	Source.Beyond = EBeyondRect::Clamp;
	Source.Taps = Taps;
	Source.NumTaps = NumTaps;
	FTapSum Sum;
	Sum.Sources = &Source;
	Sum.NumSources = 1;
	Sum.Factor = Factor;
	const FIntPoint Min = Parameters.Output.ViewportMin;
	SumTapsOrRunShader(
		Sum, Args, Tile, GetComputeTarget(Args, Tile, "OutTexture", Min, Parameters.Output.ViewportMax), Min);
}

void RunFourTaps(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunTaps(Args, Tile, 4, 0.25f);
}

void RunOneTap(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunTaps(Args, Tile, 1, 1.0f);
}

} // namespace

REGISTER_NATIVE_KERNEL(FFourTapCS, &RunFourTaps, "46f369775fe1135d")
REGISTER_NATIVE_KERNEL(FOneTapCS, &RunOneTap, "46f369775fe1135d")

} // namespace Drydock
