// How the rows of the combined table, the tonemapper and antialiasing are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Screen/PostProcessAA.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

#include <algorithm>

using namespace Drydock;

namespace Stability
{

namespace
{

void SetGrading(const FCase& Case, FFinalPostProcessSettings& Settings)
{
	if (Case.Intensity)
	{
		Settings.ColorGain = FVector4(1, 1, 1, *Case.Intensity);
	}
	if (Case.Power)
	{
		Settings.ColorGamma = FVector4(1, 1, 1, *Case.Power);
		Settings.ColorContrast = FVector4(1, 1, 1, *Case.Power);
		Settings.ColorOffset = FVector4(0, 0, 0, -0.25); // colours below 0 before the curve
	}
}

enum class EForm
{
	Plain,
	Lens,
	GammaOnly
};

/** Plain is without vignette; its variants: maths for each pixel, combined table. Lens has vignette, fringe,
 * sharpening, grain, and the picture as its own bloom. Grading as in RunCombineLUTs. */
template<EForm Form>
FImage RunTonemap(const FCase& Case)
{
	FFrameRun Run(Case);
	FFinalPostProcessSettings& Settings = Run.View.FinalPostProcessSettings;
	Settings.VignetteIntensity = 0.0f;
	SetGrading(Case, Settings);
	if (Form == EForm::Lens)
	{
		Settings.VignetteIntensity = 0.4f;
		Settings.SceneFringeIntensity = 2.0f;
		Settings.Sharpen = 1.0f;
		Settings.FilmGrainIntensity = 0.5f;
	}
	FTonemapInputs Inputs;
	Inputs.SceneColor = Run.Input;
	if (Form == EForm::Lens)
	{
		Inputs.Bloom = Run.Input;
	}
	if (Case.Variant == 1)
	{
		Inputs.ColorGradingTexture = AddCombineLUTPass(Run.GraphBuilder, Run.View);
	}
	Inputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(Run.GraphBuilder, 1.0f);
	Inputs.OutputFormat = PF_A32B32G32R32F;
	Inputs.bGammaOnly = Form == EForm::GammaOnly;
	return Run.Execute(AddTonemapPass(Run.GraphBuilder, Run.View, Inputs));
}

/** 32 x 32 colours of the table's middle slice. Intensity: the gain; Power: gamma and contrast of the grading, below an
 *  offset of -0.25. Variants: sRGB, the linear device that has the curve. */
FImage RunCombineLUTs(const FCase& Case)
{
	constexpr float LinearWithToneCurve = 9.0f;
	const PassTest::FScopedConsoleVariable Device(
		TEXT("r.HDR.Display.OutputDevice"), Case.Variant == 0 ? 0.0f : LinearWithToneCurve);
	FCase Small = Case;
	Small.Image = FImage(1, 1);
	FFrameRun Run(Small);
	SetGrading(Case, Run.View.FinalPostProcessSettings);
	const FRDGTextureRef Table = AddCombineLUTPass(Run.GraphBuilder, Run.View);
	FImage Slice = Run.Execute(FScreenPassTexture(Table, FIntRect(16 * 32, 0, 17 * 32, 32)));
	for (FTexel& Texel : Slice.Texels)
	{
		for (int Channel = 0; Channel < 3 && Case.Variant == 0; ++Channel)
		{
			Texel[Channel] = std::clamp(Texel[Channel], 0.0, 1.0); // the format ends there; 64-bit storage does not
		}
	}
	return Slice;
}

/** Variants: quality 0 to 5. */
FImage RunFXAA(const FCase& Case)
{
	FFrameRun Run(Case);
	FFXAAInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Quality = static_cast<EFXAAQuality>(Case.Variant);
	Inputs.bLumaInAlpha = false;
	return Run.Execute(AddFXAAPass(Run.GraphBuilder, Run.View, Inputs));
}

const FRunRegistration DisplayRuns({
	{"Combined table: sRGB, linear", {.Run = RunCombineLUTs, .NumVariants = 2}},
	{"Tonemapper: maths, table", {.Run = RunTonemap<EForm::Plain>, .NumVariants = 2}},
	{"Tonemapper with lens and bloom", {.Run = RunTonemap<EForm::Lens>}},
	{"Tonemapper, gamma only", {.Run = RunTonemap<EForm::GammaOnly>}},
	{"FXAA", {.Run = RunFXAA, .NumVariants = 6, .Reach = 24}},
});

} // namespace

} // namespace Stability
