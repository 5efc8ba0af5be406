// How the blurs' rows are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Blur/DualKawaseBlurPass.h"
#include "Blur/FourTapBlur.h"
#include "Blur/GaussianSum.h"
#include "Blur/MatchedGaussianBlur.h"
#include "Blur/PostProcessWeightedSampleSum.h"

#include <algorithm>

using namespace Drydock;

namespace Stability
{

namespace
{

/** Sigma: 1, a radius of 6. Intensity: the tint. The engine's kernel has a standard deviation of 0.17303 of its radius;
 *  radii are of half a texel's size. Variants: without a border clamp, mirror. */
template<bool bBorder>
FImage RunGaussianBlur(const FCase& Case)
{
	FFrameRun Run(Case);
	FGaussianBlurInputs Inputs;
	Inputs.NameX = TEXT("BlurX");
	Inputs.NameY = TEXT("BlurY");
	Inputs.Filter = Run.Input;
	const double Radius = Case.Sigma ? *Case.Sigma / 0.17303 : 6.0;
	Inputs.KernelSizePercent = static_cast<float>(200.0 * Radius / Case.Image.Width);
	const float Tint = static_cast<float>(Case.Intensity.value_or(1.0));
	Inputs.TintColor = FLinearColor(Tint, Tint, Tint, Tint);
	Inputs.UseClampAddressMode = !bBorder && Case.Variant == 0;
	Inputs.UseMirrorAddressMode = !bBorder && Case.Variant == 1;
	return Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

/** Levels: 2. Sigma: the offset, 1. */
template<bool bAsPrinted>
FImage RunDualKawase(const FCase& Case)
{
	FFrameRun Run(Case);
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Offset = static_cast<float>(Case.Sigma.value_or(1.0));
	Inputs.PassNum = Case.Levels.value_or(2);
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

/** Sigma: 2. Variants: separable, direct. */
FImage RunDualKawaseGaussian(const FCase& Case)
{
	FFrameRun Run(Case);
	FMatchedGaussianBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.StandardDeviation = Case.Sigma ? std::clamp(*Case.Sigma, 0.5, 200.0) : 2.0;
	// The direct form of a huge one would take hours.
	Inputs.bSeparable = Case.Variant == 0 || Case.Sigma.value_or(0.0) > 8.0;
	return Run.Execute(AddMatchedGaussianBlurPasses(Run.GraphBuilder, Run.View, Inputs));
}

/** Sigma: 3. */
FImage RunKawase(const FCase& Case)
{
	FFrameRun Run(Case);
	return Run.Execute(AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Case.Sigma.value_or(3.0)));
}

/** Sigma: 3. */
FImage RunPyramid(const FCase& Case)
{
	FFrameRun Run(Case);
	const double Sigma = Case.Levels ? 100.0 : Case.Sigma.value_or(3.0);
	return Run.Execute(AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma));
}

/** Two stages, clamp addressing. Sigma: half the stages' size. */
FImage RunTextureBlur(const FCase& Case)
{
	FFrameRun Run(Case);
	const float Size = static_cast<float>(Case.Sigma.value_or(8.0));
	FGaussianSumInputs Inputs;
	const auto AddStage = [&](const TCHAR* NameX, const TCHAR* NameY, float StageSize)
	{
		Inputs.Stages.Add({NameX, NameY, StageSize, FLinearColor(1, 1, 1, 1)});
	};
	const int Levels = Case.Levels.value_or(2);
	for (int Stage = 0; Stage < Levels; ++Stage)
	{
		AddStage(TEXT("X"), TEXT("Y"), Size);
	}
	Inputs.StageCount = static_cast<uint32>(Levels);
	Inputs.bClampAddressing = true;
	Inputs.TintScale = GetNormalizingTintScale(Inputs);
	const FScreenPassTexture Blurred =
		AddTextureGaussianSumPasses(Run.GraphBuilder, Run.View, Run.Input, Case.Format, TEXT("Blur"), Inputs);
	if (Blurred.IsValid())
	{
		return Run.Execute(Blurred);
	}
	Run.GraphBuilder.Execute();
	return FImage((Case.Image.Width + 1) / 2, (Case.Image.Height + 1) / 2);
}

const FRunRegistration BlurRuns({
	{"Gaussian blur: clamp, mirror", {.Run = RunGaussianBlur<false>, .NumVariants = 2, .Reach = 6}},
	{"Gaussian blur: black border", {.Run = RunGaussianBlur<true>, .Reach = 6}},
	{"Dual Kawase blur", {.Run = RunDualKawase<false>, .Reach = 16}},
	{"Dual Kawase blur as printed", {.Run = RunDualKawase<true>}},
	{"Gaussian of dual Kawase", {.Run = RunDualKawaseGaussian, .NumVariants = 2, .Reach = 6}},
	{"Kawase blur", {.Run = RunKawase, .Reach = 7}},
	{"Pyramid blur", {.Run = RunPyramid, .Reach = 18}},
	{"Texture blur", {.Run = RunTextureBlur, .Shrink = 2, .Reach = 18}},
});

} // namespace

} // namespace Stability
