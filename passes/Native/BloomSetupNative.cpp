// The bloom setup in lanes. Stands in for PostProcessBloom.usf with its bits; the patch as printed, which reads ids, is
// left to the shader.
#include "Bloom/BloomSetupShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/BloomSetupLanes.h"
#include "Native/NativeLanes.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"

#include <limits>

namespace Drydock
{

namespace
{

/** As the shader samples its inputs, which it does not hold inside their viewports. */
FSampledTexture MakeUnheldTexture(
	const FNativeKernelArgs& Args, const char* Texture, const FScreenPassTextureViewportParameters& Viewport)
{
	FSampledTexture Result = MakeSampledTexture(Args, Texture, "InputSampler", Viewport);
	for (FSampledAxis& Axis : Result.Axes)
	{
		Axis.Min = -std::numeric_limits<float>::infinity();
		Axis.Max = std::numeric_limits<float>::infinity();
	}
	return Result;
}

/** False where the shader has to do it. */
bool MakeBloomSetupJob(const FNativeKernelArgs& Args, const FBloomSetupPermutation& Permutation,
	const FBloomSetupParameters& Parameters, FBloomSetupJob& Job)
{
	const EToonBloom ToonBloom = Permutation.Get<FToonBloomDimension>();
	SetViewport(Parameters.Output, Job.Viewport);
	Job.bToon = ToonBloom == EToonBloom::Corrected;
	Job.bThreshold = Permutation.Get<FThresholdDimension>();
	Job.bLocalExposure = Permutation.Get<FLocalExposureDimension>();
	const bool bReadsInput = !Job.bToon || Job.bThreshold || Job.bLocalExposure;
	if (ToonBloom == EToonBloom::AsPrinted || !bReadsInput)
	{
		return false;
	}
	Job.Input = MakeUnheldTexture(Args, "InputTexture", Parameters.Input);
	if (!CanSampleInLanes(Job.Input.Texture, Job.Input.Sampler))
	{
		return false;
	}
	if (Job.bToon)
	{
		Job.Toon = MakeUnheldTexture(Args, "ToonTexture", Parameters.Toon);
		if (!CanSampleInLanes(Job.Toon.Texture, Job.Toon.Sampler))
		{
			return false;
		}
	}
	float EyeAdaptation[4];
	ReadEyeAdaptation(Args, "EyeAdaptationBuffer", EyeAdaptation);
	const auto* const View = static_cast<const FViewUniformShaderParameters*>(Parameters.View->GetContents());
	Job.OneOverPreExposure = View->OneOverPreExposure;
	Job.PreExposure = View->PreExposure;
	Job.ToonIntensity = Parameters.ToonIntensity;
	Job.Threshold = Parameters.BloomThreshold;
	Job.ExposureScale = EyeAdaptation[0];
	return !Job.bLocalExposure || MakeLocalExposureJob(Args, Parameters.LocalExposure, EyeAdaptation,
									  Job.OneOverPreExposure, Job.LocalExposure);
}

bool RunBloomSetupLanes(const FBloomSetupJob& Job, const FTapTarget& Target)
{
	return WithNativeLanes<TBloomSetupLanes>(
		[&](auto Lanes) { return Lanes.Run(Job, *Target.Texture, Target.Pixels); });
}

void RunBloomSetup(const FNativeKernelArgs& Args, const FKernelTile& Tile, const FBloomSetupParameters& Parameters,
	const FTapTarget& Target)
{
	const FBloomSetupPermutation Permutation(Args.GetPermutationId());
	const FKernelTile& Pixels = Target.Pixels;
	if (Pixels.MaxX <= Pixels.MinX || Pixels.MaxY <= Pixels.MinY)
	{
		return;
	}
	FBloomSetupJob Job;
	if (!StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Pixels) ||
		!MakeBloomSetupJob(Args, Permutation, Parameters, Job) || !RunBloomSetupLanes(Job, Target))
	{
		RunShader(Args, Tile);
	}
}

void RunBloomSetupPixels(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunBloomSetup(Args, Tile, GetNativeParameters<FBloomSetupPS>(Args).Common, GetPixelTarget(Args, Tile));
}

void RunBloomSetupThreads(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const FBloomSetupParameters& Parameters = GetNativeParameters<FBloomSetupCS>(Args).Common;
	RunBloomSetup(Args, Tile, Parameters,
		GetComputeTarget(Args, Tile, "BloomOutput", Parameters.Output.ViewportMin, Parameters.Output.ViewportMax));
}

} // namespace

REGISTER_NATIVE_KERNEL(FBloomSetupPS, &RunBloomSetupPixels, "9b1e0d0cd9b16b86")
REGISTER_NATIVE_KERNEL(FBloomSetupCS, &RunBloomSetupThreads, "9b1e0d0cd9b16b86")

} // namespace Drydock
