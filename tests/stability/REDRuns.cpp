// How the rows of the RED post process, CharaGlow and RED depth of field are run, and their formulas.
#include "Runs.h"

#include "Cases.h"

#include "Lens/REDDepthOfField.h"
#include "Lens/REDPostProcess.h"
#include "Toon/CharaGlow.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace Stability
{

namespace
{

FImage RunChain(const FCase& Case, const FREDPostProcessParameters& Parameters)
{
	FFrameRun Run(Case);
	return Run.Execute(AddREDPostProcessPasses(Run.GraphBuilder, Run.View, Run.Input, Parameters));
}

/** Intensity 1, Power 1, luminance threshold 0. Variants: Screen, Max. */
template<bool bAsPrinted>
FImage RunREDDiffusion(const FCase& Case)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	Parameters.LuminancePow = static_cast<float>(Case.Power.value_or(1.0));
	Parameters.DiffusionFilterPower = static_cast<float>(Case.Power.value_or(1.0));
	Parameters.LuminanceThreshold = static_cast<float>(Case.Threshold.value_or(0.0));
	Parameters.DiffusionFilterBlend = Case.Variant == 0 ? EDiffusionFilterBlend::Screen : EDiffusionFilterBlend::Max;
	Parameters.bAsPrinted = bAsPrinted;
	return RunChain(Case, Parameters);
}

FCase WithMaximum(FCase Case)
{
	Case.Variant = 1;
	return Case;
}

FImage RunREDMaximum(const FCase& Case)
{
	return RunREDDiffusion<false>(WithMaximum(Case));
}

/** Area (Sigma) 3.5; Intensity: alpha of the colour, 1. */
template<bool bAsPrinted>
FImage RunCharaGlow(const FCase& Case)
{
	FFrameRun Run(Case);
	FCharaGlowInputs Inputs;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Inputs.SceneColor = Run.Input;
	Inputs.Area = static_cast<float>(Case.Sigma.value_or(3.5));
	Inputs.Color = FLinearColor(1.0f, 1.0f, 1.0f, static_cast<float>(Case.Intensity.value_or(1.0)));
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddCharaGlow(Run.GraphBuilder, Run.View, Inputs));
}

/** In focus at 300 cm; kernel 4 pixels in diameter (Sigma: half of that). */
template<bool bAsPrinted>
FImage RunREDDepthOfField(const FCase& Case)
{
	FFrameRun Run(Case);
	FREDDepthOfFieldInputs Inputs;
	Inputs.SceneTextures = Run.GetSceneTextures();
	Inputs.SceneColor = Run.Input;
	Inputs.FocalDistance = 300.0f;
	Inputs.FocalRegion = 100.0f;
	const double Diameter = 2.0 * Case.Sigma.value_or(2.0);
	Inputs.NearBlurSize = Inputs.FarBlurSize = static_cast<float>(100.0 * Diameter / Case.Image.Width);
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddREDDepthOfFieldPasses(Run.GraphBuilder, Run.View, Inputs));
}

double ScreenValues(double A, double B)
{
	return 1 - (1 - A) * (1 - B);
}

/** On what lies in 0..1; what lies above is added. */
double ScreenOfLight(double A, double B)
{
	A = std::max(A, 0.0);
	B = std::max(B, 0.0);
	return ScreenValues(std::min(A, 1.0), std::min(B, 1.0)) + std::max(A - 1, 0.0) + std::max(B - 1, 0.0);
}

/** The formula for a flat picture, whose blur is the picture. */
FImage REDDiffusionFormula(const FCase& Case)
{
	const FTexel Flat = Case.Image.At(0, 0);
	const double Luma = std::max(0.299 * Flat[0] + 0.587 * Flat[1] + 0.114 * Flat[2], 0.0);
	const double Power = Case.Power.value_or(1.0);
	const double Extract = std::clamp(std::pow(Luma, Power) - Case.Threshold.value_or(0.0), 0.0, 1.0);
	FTexel Result = Flat;
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		const double A = std::max(Flat[Channel], 0.0);
		const double B = std::max(Flat[Channel] * Extract * Case.Intensity.value_or(1.0), 0.0);
		const double InA = std::min(A, 1.0), InB = std::min(B, 1.0);
		Result[Channel] = Case.Variant == 0 ? std::pow(ScreenValues(InA, InB), Power) + (A - InA) + (B - InB)
											: std::pow(std::max(InA, InB), Power) + std::max(std::max(A, B) - 1, 0.0);
	}
	return FImage(Case.Image.Width, Case.Image.Height, Result);
}

FImage REDMaximumFormula(const FCase& Case)
{
	return REDDiffusionFormula(WithMaximum(Case));
}

/** Intensity: the blend, 1; saturation 1. Variants: kernels of the corrected form. */
FImage RunREDSoftFocus(const FCase& Case)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = 0.0f;
	Parameters.SoftFocusBlend = static_cast<float>(Case.Intensity.value_or(1.0));
	Parameters.Kernel = static_cast<EREDBlurKernel>(Case.Variant);
	return RunChain(Case, Parameters);
}

/** Intensity: 1. Threshold: of the luma, -1. */
FImage RunREDGlow(const FCase& Case)
{
	FREDPostProcessParameters Parameters;
	Parameters.DiffusionFilterIntensity = 0.0f;
	Parameters.GlowIntensity = static_cast<float>(Case.Intensity.value_or(1.0));
	Parameters.GlowLuminanceThreshold = static_cast<float>(Case.Threshold.value_or(-1.0));
	return RunChain(Case, Parameters);
}

/** The formula for a flat picture. */
FImage REDGlowFormula(const FCase& Case)
{
	FTexel Result = Case.Image.At(0, 0);
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Result[Channel] = ScreenOfLight(Result[Channel], Result[Channel] * Case.Intensity.value_or(1.0));
	}
	return FImage(Case.Image.Width, Case.Image.Height, Result);
}

FImage CharaGlowFormula(const FCase& Case)
{
	const int Width = Case.Image.Width, Height = Case.Image.Height;
	const double Area = std::min(Case.Sigma.value_or(3.5), 128.0);
	const int Radius = static_cast<int>(Area);
	const auto Weight = [&](int Tap)
	{
		return std::abs(Tap) > Radius ? Area - Radius : 1.0;
	};
	// The mask is a product of a row's and a column's, and so is its mean.
	const auto Mean = [&](int Center, int Size, const std::function<double(int)>& Mask)
	{
		double Sum = 0, Weights = 0;
		for (int Tap = -Radius - 1; Tap <= Radius + 1; ++Tap)
		{
			Sum += Weight(Tap) * Mask(std::clamp(Center + Tap, 0, Size - 1));
			Weights += Weight(Tap);
		}
		return Sum / Weights;
	};
	std::vector<double> Columns, Rows;
	for (int X = 0; X < Width; ++X)
	{
		Columns.push_back(Mean(X, Width, [](int At) { return FFrameRun::GetMask(At, 16); }));
	}
	for (int Y = 0; Y < Height; ++Y)
	{
		Rows.push_back(Mean(Y, Height, [](int At) { return FFrameRun::GetMask(20, At); }));
	}
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			const double Glow =
				std::clamp(Columns[X] * Rows[Y] - FFrameRun::GetMask(X, Y), 0.0, 1.0) * Case.Intensity.value_or(1.0);
			const FTexel& Color = Case.Image.At(X, Y);
			return FTexel{Color[0] + Glow, Color[1] + Glow, Color[2] + Glow, Color[3]};
		});
}

const FRunRegistration REDRuns({
	{"RED diffusion filter", {.Run = RunREDDiffusion<false>, .Formula = REDDiffusionFormula, .Reach = 12, .Gain = 2}},
	{"RED diffusion filter by maximum", {.Run = RunREDMaximum, .Formula = REDMaximumFormula, .Reach = 12}},
	{"RED diffusion filter as printed", {.Run = RunREDDiffusion<true>, .Reach = 18}},
	{"RED soft focus: seven taps, thirteen texels, nine taps", {.Run = RunREDSoftFocus, .NumVariants = 3, .Reach = 18}},
	{"RED glow", {.Run = RunREDGlow, .Formula = REDGlowFormula, .Reach = 12, .Gain = 2}},
	{"CharaGlow", {.Run = RunCharaGlow<false>, .Formula = CharaGlowFormula}},
	{"CharaGlow as printed", {.Run = RunCharaGlow<true>}},
	{"RED depth of field", {.Run = RunREDDepthOfField<false>, .Reach = 10}},
	{"RED depth of field as printed", {.Run = RunREDDepthOfField<true>, .Reach = 10, .Gain = 1.9952 * 1.9952}},
});

} // namespace

} // namespace Stability
