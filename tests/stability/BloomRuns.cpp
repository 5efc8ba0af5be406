// How the bloom's rows are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Bloom/FFTConvolution.h"
#include "Bloom/PostProcessBloomSetup.h"
#include "Bloom/PostProcessGaussianBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Bloom/ToonBloomSetup.h"
#include "Bloom/UnityBloom.h"
#include "PostProcess/PostProcessFFTBloom.h"
#include "RenderGraphUtils.h"

using namespace Drydock;

namespace Stability
{

namespace
{

/** Threshold: -1, none. Variants: pixel shader, compute. */
FImage RunBloomSetup(const FCase& Case)
{
	FFrameRun Run(Case);
	Run.View.bUseComputePasses = Case.Variant == 1;
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.Threshold = static_cast<float>(Case.Threshold.value_or(-1.0));
	return Run.Execute(AddBloomSetupPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage BloomSetupFormula(const FCase& Case)
{
	return FImage::Make(Case.Image.Width, Case.Image.Height,
		[&](int X, int Y)
		{ return PassReference::BloomSetup(Case.Image.At(X, Y), Case.Threshold.value_or(-1.0), 1.0, 1.0); });
}

/** Intensity: of the toon, 1. Threshold: -1, none. Variants: pixel shader, compute. */
FImage RunToonBloomSetup(const FCase& Case)
{
	FFrameRun Run(Case);
	Run.View.bUseComputePasses = Case.Variant == 1;
	FBloomSetupInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.Threshold = static_cast<float>(Case.Threshold.value_or(-1.0));
	FToonBloomInputs Toon;
	Toon.SceneTextures = Run.GetSceneTextures();
	Toon.SceneColor = Run.Input;
	Toon.ToonIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	return Run.Execute(Drydock::AddToonBloomSetupPass(Run.GraphBuilder, Run.View, Inputs, Toon));
}

FImage ToonBloomSetupFormula(const FCase& Case)
{
	return FImage::Make(Case.Image.Width, Case.Image.Height,
		[&](int X, int Y)
		{
			return PassReference::BloomSetup(Case.Image.At(X, Y), Case.Threshold.value_or(-1.0), 1.0, 1.0) *
				   (FFrameRun::IsCloth(X) ? Case.Intensity.value_or(1.0) : 1.0);
		});
}

/** Intensity: of the toon, 1. Variants: pixel shader, compute. */
FImage RunToonBloomMask(const FCase& Case)
{
	FFrameRun Run(Case);
	FToonBloomInputs Inputs;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Run.View.bUseComputePasses = Case.Variant == 1;
	Inputs.SceneColor = Run.Input;
	Inputs.ToonIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	return Run.Execute(AddToonBloomMaskPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage ToonBloomMaskFormula(const FCase& Case)
{
	return FImage::Make(Case.Image.Width, Case.Image.Height,
		[&](int X, int Y)
		{ return Case.Image.At(X, Y) * (FFrameRun::IsCloth(X) ? Case.Intensity.value_or(1.0) : 1.0); });
}

/** Intensity: of the bloom, 1. Sigma: half of every stage's size. The default stages. */
FImage RunGaussianBloom(const FCase& Case)
{
	FFrameRun Run(Case);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.BloomIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	if (Case.Sigma)
	{
		Settings.BloomSizeScale = static_cast<float>(*Case.Sigma);
	}
	FTextureDownsampleChain Chain;
	Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High);
	const FScreenPassTexture Bloom = AddGaussianBloomPasses(Run.GraphBuilder, Run.View, &Chain);
	if (Bloom.IsValid())
	{
		return Run.Execute(Bloom);
	}
	Run.GraphBuilder.Execute();
	return FImage(Case.Image.Width, Case.Image.Height);
}

/** Intensity: 1. The built-in kernel, half a picture wide. */
FImage RunFFTBloom(const FCase& Case)
{
	const PassTest::FScopedConsoleVariable FullResolution(TEXT("r.Bloom.ScreenPercentage"), 100.0f);
	FFrameRun Run(Case);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.BloomMethod = BM_FFT;
	Settings.BloomIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	Settings.BloomConvolutionSize = static_cast<float>(Case.Sigma.value_or(0.5));
	Settings.BloomConvolutionPreFilterMin = static_cast<float>(Case.Threshold.value_or(0.0));
	Settings.BloomConvolutionPreFilterMax = Case.Threshold ? 1e6f : 0.0f;
	Settings.BloomConvolutionPreFilterMult = 2.0f;
	Settings.BloomConvolutionBufferScale = 0.0f;
	FFFTBloomInputs Inputs;
	Inputs.SceneColor = Run.Input;
	return Run.Execute(AddFFTBloomPass(Run.GraphBuilder, Run.View, Inputs).BloomTexture);
}

FImage RunFFTConvolution(const FCase& Case)
{
	FCase Stored = Case;
	Stored.Format = PF_A32B32G32R32F;
	FFrameRun Run(Stored);
	const FIntPoint Size(Case.Image.Width, Case.Image.Height);
	const Drydock::FFFTDomain Domain = Drydock::FFFTDomain::Make(Size, Size);
	// A kernel of four texels that sum to 1.
	const FScreenPassTexture Kernel =
		Run.AddInput(FImage(2, 2, {0.25, 0.25, 0.25, 0}), PF_A32B32G32R32F, TEXT("Kernel"));
	const float Factor = static_cast<float>(Case.Intensity.value_or(1.0));
	const FVector4f Scale(Factor, Factor, Factor, Factor);
	const FRDGBufferRef Parameters =
		CreateStructuredBuffer(Run.GraphBuilder, TEXT("Factor"), sizeof(Scale), 1, &Scale, sizeof(Scale));
	const FRDGTextureRef Product = Drydock::AddMultiplySpectraPass(Run.GraphBuilder, Run.View, Domain,
		Drydock::AddForwardFFTPasses(Run.GraphBuilder, Domain, Run.Input, TEXT("ImageSpectrum")),
		Drydock::AddForwardFFTPasses(Run.GraphBuilder, Domain, Kernel, TEXT("KernelSpectrum")), Parameters);
	const FScreenPassTexture Output(
		Run.GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Domain.FrequencySize, PF_A32B32G32R32F,
										   FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
			TEXT("Output")));
	Drydock::AddInverseFFTPasses(Run.GraphBuilder, Domain, Product, Output);
	return Run.Execute(Output);
}

/** Threshold -1, two iterations, spread (Sigma) 0.6, small target (Levels) half, intensity 1. Variants: sharp, soft
 *  knee. */
template<bool bAsPrinted>
FImage RunUnityBloom(const FCase& Case)
{
	FFrameRun Run(Case);
	FUnityBloomInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Threshold = static_cast<float>(Case.Threshold.value_or(-1.0));
	Inputs.SoftKnee = Case.Variant == 0 ? 0.0f : 0.5f;
	Inputs.Iterations = 2;
	Inputs.Spread = static_cast<float>(Case.Sigma.value_or(0.6));
	Inputs.DownSample = Case.Levels ? 64 : 2;
	Inputs.Intensity = static_cast<float>(Case.Intensity.value_or(1.0));
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddUnityBloomPasses(Run.GraphBuilder, Run.View, Inputs));
}

const FRunRegistration BloomRuns({
	{"Bloom setup", {.Run = RunBloomSetup, .Formula = BloomSetupFormula, .NumVariants = 2}},
	{"Toon bloom setup", {.Run = RunToonBloomSetup, .Formula = ToonBloomSetupFormula, .NumVariants = 2}},
	{"Toon bloom mask", {.Run = RunToonBloomMask, .Formula = ToonBloomMaskFormula, .NumVariants = 2}},
	{"Bloom, sum of Gaussians", {.Run = RunGaussianBloom, .Gain = 0.7951 / 6}},
	{"Bloom, FFT", {.Run = RunFFTBloom}},
	{"FFT convolution", {.Run = RunFFTConvolution}},
	{"Unity bloom", {.Run = RunUnityBloom<false>, .NumVariants = 2, .Reach = 18, .Gain = 2}},
	{"Unity bloom as printed", {.Run = RunUnityBloom<true>, .Reach = 18, .Gain = 2}},
});

} // namespace

} // namespace Stability
