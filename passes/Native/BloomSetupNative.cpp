// The bloom setup in lanes. Stands in for PostProcessBloom.usf and ToonBloomSetup.usf with their bits; toon bloom as
// printed, which reads ids, is left to the shader.
#include "Bloom/ToonBloomSetupShaders.h"
#include "NativeFallback.h"
#include "NativeKernels.h"
#include "Native/BloomSetupLanes.h"
#include "Native/NativeLanes.h"
#include "Native/SampledTexturePass.h"
#include "Native/TapSumPass.h"

namespace Drydock
{

namespace
{

/** The texture sampled by a transform of the pixels' centres. */
FSampledTexture MakeTransformedTexture(
	const FNativeKernelArgs& Args, const char* Texture, const FScreenTransform& Transform)
{
	FSampledTexture Result = MakeUnheldTexture(Args, Texture, "InputSampler");
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		Result.Axes[Axis].Size = Transform.Scale[Axis];
		Result.Axes[Axis].First = Transform.Bias[Axis];
	}
	return Result;
}

/** False where the shader has to do it. */
bool MakeBloomSetupJob(const FNativeKernelArgs& Args, const FBloomSetupPS::FPermutationDomain& Permutation,
	const FBloomSetupParameters& Parameters, FBloomSetupJob& Job)
{
	Job.bThreshold = Permutation.Get<FThresholdDimension>();
	Job.bLocalExposure = Permutation.Get<FLocalExposureDimension>();
	SetViewport(Parameters.Input, Job.LocalExposureViewport);
	for (FViewportAxis& Axis : Job.LocalExposureViewport)
	{
		Axis.Origin += 0.5f; // the shader counts from the pixels' corners here
	}
	Job.Input = MakeTransformedTexture(Args, "InputTexture", Parameters.SvPositionToInputTextureUV);
	if (!CanSampleInLanes(Job.Input.Texture, Job.Input.Sampler))
	{
		return false;
	}
	float EyeAdaptation[4];
	ReadEyeAdaptation(Args, "EyeAdaptationBuffer", EyeAdaptation);
	const auto* const View = static_cast<const FViewUniformShaderParameters*>(Parameters.View->GetContents());
	Job.OneOverPreExposure = View->OneOverPreExposure;
	Job.PreExposure = View->PreExposure;
	Job.Threshold = Parameters.BloomThreshold;
	Job.ExposureScale = EyeAdaptation[0];
	return !Job.bLocalExposure ||
		   MakeLocalExposureJob(Args, Parameters, EyeAdaptation, Job.OneOverPreExposure, Job.LocalExposure);
}

/** Ids are left to the shader, and so is a picture that needs no arithmetic. */
bool MakeToonJob(const FNativeKernelArgs& Args, const FToonBloomSetupPermutation& Permutation,
	const FToonBloomSetupParameters& Parameters, FBloomSetupJob& Job)
{
	if (Permutation.Get<FToonAsPrintedDimension>() ||
		!MakeBloomSetupJob(Args, Permutation.Get<FBloomSetupPS::FPermutationDomain>(), Parameters.BloomSetup, Job) ||
		(!Job.bThreshold && !Job.bLocalExposure))
	{
		return false;
	}
	Job.bToon = true;
	Job.Toon = MakeTransformedTexture(Args, "ToonTexture", Parameters.SvPositionToToonTextureUV);
	Job.ToonIntensity = Parameters.ToonIntensity;
	return CanSampleInLanes(Job.Toon.Texture, Job.Toon.Sampler);
}

bool MakeJob(const FNativeKernelArgs& Args, const FBloomSetupParameters& Parameters, FBloomSetupJob& Job)
{
	return MakeBloomSetupJob(Args, FBloomSetupPS::FPermutationDomain(Args.GetPermutationId()), Parameters, Job);
}

bool MakeJob(const FNativeKernelArgs& Args, const FToonBloomSetupParameters& Parameters, FBloomSetupJob& Job)
{
	return MakeToonJob(Args, FToonBloomSetupPermutation(Args.GetPermutationId()), Parameters, Job);
}

bool RunBloomSetupLanes(const FBloomSetupJob& Job, const FTapTarget& Target)
{
	return WithNativeLanes<TBloomSetupLanes>(
		[&](auto Lanes) { return Lanes.Run(Job, *Target.Texture, Target.Pixels); });
}

template<typename FCommonParameters>
void RunBloomSetup(const FNativeKernelArgs& Args, const FKernelTile& Tile, const FCommonParameters& Parameters,
	const FTapTarget& Target)
{
	const FKernelTile& Pixels = Target.Pixels;
	if (Pixels.MaxX <= Pixels.MinX || Pixels.MaxY <= Pixels.MinY)
	{
		return;
	}
	FBloomSetupJob Job;
	if (!StoresPlainly(Args.GetArgs()) || !IsInsideTarget(Target.Texture, Pixels) || !MakeJob(Args, Parameters, Job) ||
		!RunBloomSetupLanes(Job, Target))
	{
		RunShader(Args, Tile);
	}
}

template<typename FPixelShader>
void RunBloomSetupPixels(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	RunBloomSetup(Args, Tile, GetNativeParameters<FPixelShader>(Args).Common, GetPixelTarget(Args, Tile));
}

const FBloomSetupParameters& GetBloomSetup(const FBloomSetupParameters& Parameters)
{
	return Parameters;
}

const FBloomSetupParameters& GetBloomSetup(const FToonBloomSetupParameters& Parameters)
{
	return Parameters.BloomSetup;
}

template<typename FComputeShader>
void RunBloomSetupThreads(const FNativeKernelArgs& Args, const FKernelTile& Tile)
{
	const auto& Parameters = GetNativeParameters<FComputeShader>(Args).Common;
	const FScreenPassTextureViewportParameters& Input = GetBloomSetup(Parameters).Input;
	RunBloomSetup(
		Args, Tile, Parameters, GetComputeTarget(Args, Tile, "BloomOutput", Input.ViewportMin, Input.ViewportMax));
}

} // namespace

REGISTER_NATIVE_KERNEL(FBloomSetupPS, &RunBloomSetupPixels<FBloomSetupPS>, "fc13b7aa3fcdec08")
REGISTER_NATIVE_KERNEL(FBloomSetupCS, &RunBloomSetupThreads<FBloomSetupCS>, "fc13b7aa3fcdec08")
REGISTER_NATIVE_KERNEL(FToonBloomSetupPS, &RunBloomSetupPixels<FToonBloomSetupPS>, "7f511491e400d272")
REGISTER_NATIVE_KERNEL(FToonBloomSetupCS, &RunBloomSetupThreads<FToonBloomSetupCS>, "7f511491e400d272")

} // namespace Drydock
