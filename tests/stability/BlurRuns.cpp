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

enum class EEdge
{
	Clamp,
	Mirror,
	Black
};

/** The engine's kernel has a standard deviation of 0.17303 of its radius; radii are of half a texel's size. */
FImage RunGaussian(const FCase& Case, EEdge Edge)
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
	Inputs.UseClampAddressMode = Edge == EEdge::Clamp;
	Inputs.UseMirrorAddressMode = Edge == EEdge::Mirror;
	return Run.Execute(AddGaussianBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

FImage RunDual(const FCase& Case, bool bAsPrinted)
{
	FFrameRun Run(Case);
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Offset = static_cast<float>(Case.Sigma.value_or(1.0));
	Inputs.PassNum = Case.Levels.value_or(2);
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

} // namespace

FImage RunGaussianBlur(const FCase& Case)
{
	return RunGaussian(Case, Case.Variant == 0 ? EEdge::Clamp : EEdge::Mirror);
}

FImage RunGaussianBlurBorder(const FCase& Case)
{
	return RunGaussian(Case, EEdge::Black);
}

FImage RunDualKawase(const FCase& Case)
{
	return RunDual(Case, false);
}

FImage RunDualKawaseAsPrinted(const FCase& Case)
{
	return RunDual(Case, true);
}

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

FImage RunKawase(const FCase& Case)
{
	FFrameRun Run(Case);
	return Run.Execute(AddKawaseBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Case.Sigma.value_or(3.0)));
}

FImage RunPyramid(const FCase& Case)
{
	FFrameRun Run(Case);
	const double Sigma = Case.Levels ? 100.0 : Case.Sigma.value_or(3.0);
	return Run.Execute(AddPyramidBlurPasses(Run.GraphBuilder, Run.View, Run.Input, Sigma));
}

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

} // namespace Stability
