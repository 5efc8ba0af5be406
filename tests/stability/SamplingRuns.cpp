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

FImage RunDownsample(const FCase& Case, EDownsampleQuality Quality)
{
	FFrameRun Run(Case);
	Run.View.bUseComputePasses = Case.Variant == 1;
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("Downsample");
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = Quality;
	return Run.Execute(AddDownsamplePass(Run.GraphBuilder, Run.View, Inputs));
}

FImage RunUpscale(const FCase& Case, EUpscaleMethod Method)
{
	FFrameRun Run(Case);
	FUpscaleInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.OutputSize = FIntPoint(2 * Case.Image.Width, 2 * Case.Image.Height);
	Inputs.Method = Method;
	return Run.Execute(AddUpscalePass(Run.GraphBuilder, Run.View, Inputs));
}

} // namespace

FImage RunDownsampleLow(const FCase& Case)
{
	return RunDownsample(Case, EDownsampleQuality::Low);
}

FImage RunDownsampleHigh(const FCase& Case)
{
	return RunDownsample(Case, EDownsampleQuality::High);
}

FImage RunDownsampleChain(const FCase& Case)
{
	FFrameRun Run(Case);
	FTextureDownsampleChain Chain;
	Chain.Init(Run.GraphBuilder, Run.View, Run.Input, EDownsampleQuality::High, TEXT("Chain"),
		static_cast<uint32>(Case.Levels.value_or(3)));
	return Run.Execute(Chain.GetLastTexture());
}

FImage RunUpscaleBilinear(const FCase& Case)
{
	return RunUpscale(Case, Case.Variant == 0 ? EUpscaleMethod::Nearest : EUpscaleMethod::Bilinear);
}

FImage RunUpscaleLobes(const FCase& Case)
{
	return RunUpscale(Case, Case.Variant == 0 ? EUpscaleMethod::CatmullRom : EUpscaleMethod::Lanczos);
}

FImage RunUpscaleSharpened(const FCase& Case)
{
	return RunUpscale(Case, Case.Variant == 0 ? EUpscaleMethod::Directional : EUpscaleMethod::Gaussian);
}

FImage RunTint(const FCase& Case)
{
	FFrameRun Run(Case);
	FTintInputs Inputs;
	Inputs.SceneColor = Run.Input;
	const float Factor = static_cast<float>(Case.Intensity.value_or(1.0));
	Inputs.Color = FLinearColor(Factor, Factor, Factor, 1.0f);
	return Run.Execute(AddTintPass(Run.GraphBuilder, Run.View, Inputs));
}

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

} // namespace Stability
