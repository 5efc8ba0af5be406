// How the rows of downsampling, upscaling, the tint and separate translucency are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Screen/PostProcessDownsample.h"
#include "Screen/PostProcessUpscale.h"
#include "Screen/SeparateTranslucencyComposition.h"
#include "Screen/Tint.h"

using namespace Drydock;

namespace Stability
{

namespace
{

/** Variants: pixel shader, compute. */
template<EDownsampleQuality Quality>
FImage RunDownsample(const FCase& Case)
{
	FFrameRun Run(Case);
	Run.View.bUseComputePasses = Case.Variant == 1;
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = Quality;
	return Run.Execute(AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs));
}

/** To twice the size. Variants: both methods. */
template<EUpscaleMethod First, EUpscaleMethod Second>
FImage RunUpscale(const FCase& Case)
{
	FFrameRun Run(Case);
	FUpscaleInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.OutputSize = FIntPoint(2 * Case.Image.Width, 2 * Case.Image.Height);
	Inputs.Method = Case.Variant == 0 ? First : Second;
	return Run.Execute(AddUpscalePass(Run.GraphBuilder, Run.View, Inputs));
}

/** Levels: 3, that is a quarter of the size. */
FImage RunDownsampleChain(const FCase& Case)
{
	FFrameRun Run(Case);
	FTextureDownsampleChain Chain;
	Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High, TEXT("Chain"),
		static_cast<uint32>(Case.Levels.value_or(3)));
	return Run.Execute(Chain.GetLastTexture());
}

/** Intensity: the factor, 1. */
FImage RunTint(const FCase& Case)
{
	FFrameRun Run(Case);
	FTintInputs Inputs;
	Inputs.SceneColor = Run.Input;
	const float Factor = static_cast<float>(Case.Intensity.value_or(1.0));
	Inputs.Color = FLinearColor(Factor, Factor, Factor, 1.0f);
	return Run.Execute(AddTintPass(Run.GraphBuilder, Run.View, Inputs));
}

/** Translucency everywhere: radiance (0.25, 0.5, 0.125), transmittance 0.5. */
FImage RunSeparateTranslucency(const FCase& Case)
{
	FFrameRun Run(Case);
	const FScreenPassTexture Translucency = Run.AddInput(
		FImage(Case.Image.Width, Case.Image.Height, {0.25, 0.5, 0.125, 0.5}), PF_FloatRGBA, TEXT("Translucency"));
	return Run.Execute(AddSeparateTranslucencyCompositionPass(Run.GraphBuilder, Run.View, Run.Input, Translucency));
}

FImage SeparateTranslucencyFormula(const FCase& Case)
{
	return FImage::Make(Case.Image.Width, Case.Image.Height,
		[&](int X, int Y)
		{
			const FTexel& Color = Case.Image.At(X, Y);
			return FTexel{Color[0] * 0.5 + 0.25, Color[1] * 0.5 + 0.5, Color[2] * 0.5 + 0.125, Color[3]};
		});
}

using EQuality = EDownsampleQuality;
using EMethod = EUpscaleMethod;

const FRunRegistration SamplingRuns({
	{"Downsample, low quality", {.Run = RunDownsample<EQuality::Low>, .NumVariants = 2, .Shrink = 2}},
	{"Downsample, high quality", {.Run = RunDownsample<EQuality::High>, .NumVariants = 2, .Shrink = 2, .Reach = 1}},
	{"Downsample chain", {.Run = RunDownsampleChain, .Shrink = 4, .Reach = 3}},
	{"Upscale: nearest, bilinear",
		{.Run = RunUpscale<EMethod::Nearest, EMethod::Bilinear>, .NumVariants = 2, .Shrink = 0.5, .Reach = 1}},
	{"Upscale: Catmull-Rom, Lanczos",
		{.Run = RunUpscale<EMethod::CatmullRom, EMethod::Lanczos>, .NumVariants = 2, .Shrink = 0.5, .Reach = 3}},
	{"Upscale: directional, Gaussian",
		{.Run = RunUpscale<EMethod::Directional, EMethod::Gaussian>, .NumVariants = 2, .Shrink = 0.5, .Reach = 3}},
	{"Tint", {.Run = RunTint}},
	{"Separate translucency", {.Run = RunSeparateTranslucency, .Formula = SeparateTranslucencyFormula}},
});

} // namespace

} // namespace Stability
