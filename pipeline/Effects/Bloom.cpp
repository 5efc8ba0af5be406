// Bloom as the engine adds it to the picture, by the Gaussian sum unless FFTBloom makes it. Source: engine
// PostProcess/PostProcessing.cpp (conditions); the wording and the gate are drydock's.
#include "Effects/Bloom.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr FSettingClaim BloomSettings[] = {{"Bloom"}};

FEffectDecision DecideBloom(const FEffect&, const FEffectInputs& Inputs)
{
	FEffectDecision Bloom;
	const FFinalPostProcessSettings& Values = Inputs.Settings;
	Bloom.Reason = FindNoBloomReason(Inputs);
	Bloom.bActive = Bloom.Reason.empty();
	if (Bloom.bActive)
	{
		Bloom.Reason = "BloomIntensity is " + NumberText(Values.BloomIntensity) + ", BloomThreshold " +
					   NumberText(Values.BloomThreshold);
	}
	Bloom.bConfigured = Bloom.bActive || (Values.bOverride_BloomIntensity && !(Values.BloomIntensity > 0.0f) &&
											 !Inputs.DescribeGate("BloomIntensity").empty());
	return Bloom;
}

/** Why bloom adds nothing: no pixel is bright enough for its threshold. Empty: it may. Only where bloom sees the scene
 * as it came (no effect before it brightens pixels), exposure is a number, and no value is NaN or infinite, in the file
 * or as it is stored: the setup pass reads infinity where a value leaves the half's range. Exposed
 * luminance is at most that of the brightest component; a tenth more covers what formats and filters round. The setup
 * pass then gives 0 everywhere, and so does every sum of it. */
std::string FindNothingBright(const FGateInputs& Gate, std::optional<double> Brightest)
{
	constexpr double Rounding = 1.1;
	constexpr double MaxHalf = 65504.0;
	const FEffectInputs& Inputs = Gate.Inputs;
	const double Threshold = static_cast<double>(Inputs.Settings.BloomThreshold);
	if (!Brightest || !(Threshold >= 0.0) || Inputs.Conditions.bAutoExposure || Inputs.Settings.BloomMethod == BM_FFT)
	{
		return "";
	}
	const double Exposed = *Brightest * static_cast<double>(Inputs.Conditions.ExposureScale);
	const bool bBrightened = std::any_of(Gate.Decided.begin(), Gate.Decided.end(),
		[](const FEffectDecision& Effect) { return Effect.bActive && *Effect.Effect->bMayBrightenBeforeBloom; });
	const bool bStoredFinite = *Brightest * static_cast<double>(Inputs.Conditions.PreExposure) <= MaxHalf;
	if (!(Exposed * Rounding <= Threshold) || bBrightened || !bStoredFinite)
	{
		return "";
	}
	return "nothing is brighter than BloomThreshold " + NumberText(Inputs.Settings.BloomThreshold) +
		   ": the scene's brightest value is " + NumberText(static_cast<float>(Exposed)) + ", exposed";
}

/** Worth a look where a black scene would leave it out. */
FContentQuestions AskBloom(const FGateInputs& Gate, const FEffectDecision&)
{
	return {.bBrightest = !FindNothingBright(Gate, 0.0).empty()};
}

void GateBloom(const FGateInputs& Gate, FEffectDecision& Bloom)
{
	if (const std::string Dark = FindNothingBright(Gate, Gate.Content.Brightest); !Dark.empty())
	{
		Bloom.bActive = false;
		Bloom.bConfigured = true;
		Bloom.bNothingToDo = true;
		Bloom.Reason = Dark;
	}
}

/** How it is made, and why not by convolution where that is asked for. */
std::string DescribeBloomMethod(const FFinalPostProcessSettings& Values)
{
	if (Values.BloomMethod != BM_FFT)
	{
		return "";
	}
	const std::string Obstacle = GetFFTBloomObstacle(Values, true);
	if (!Obstacle.empty())
	{
		return "; BM_FFT is asked for, but " + Obstacle + ": the Gaussian sum runs";
	}
	return "; by convolution (BM_FFT), BloomConvolutionScatterDispersion " +
		   NumberText(Values.BloomConvolutionScatterDispersion) +
		   (Values.BloomThreshold > -1.0f ? "; it reads no threshold" : "");
}

std::string CompleteBloom(const FEffectInputs& Inputs, const std::vector<FEffectDecision>& Effects)
{
	std::string Text;
	if (!(Inputs.Settings.BloomThreshold > -1.0f))
	{
		const bool bLocalExposure = IsEffectActive(Effects, EEffect::LocalExposure) && IsLocalExposureAppliedToBloom();
		Text = IsEffectActive(Effects, EEffect::ToonBloom) ? ": the setup pass is there for the toon's factor"
			   : bLocalExposure                            ? ": the setup pass is there for local exposure"
														   : ": the setup pass is not needed";
	}
	return Text + DescribeBloomMethod(Inputs.Settings);
}

} // namespace

bool HasRampWithoutThreshold(const FEffectInputs& Inputs)
{
	return Inputs.Conditions.Engine.bBloomRampWithoutThreshold && !(Inputs.Settings.BloomThreshold > -1.0f);
}

std::string FindNoBloomReason(const FEffectInputs& Inputs)
{
	const float Intensity = Inputs.Settings.BloomIntensity;
	return !Inputs.Conditions.ShowFlags.PostProcessing ? "ShowFlag.PostProcessing is off"
		   : !(Intensity > 0.0f) ? "BloomIntensity is " + NumberText(Intensity) + Inputs.DescribeGate("BloomIntensity")
		   : IsToonBloomMaskVisualized() ? "r.ToonBloom.VisualizeMask shows the mask in its place"
										 : "";
}

const FEffect GBloomEffect{
	.Id = EEffect::Bloom,
	.Name = "Bloom",
	.Doc = "Light of bright pixels spread over their surroundings.",
	.Settings = BloomSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideBloom,
	.Content = FContentGate{&AskBloom, &GateBloom},
	.Complete = &CompleteBloom,
	.GetPlace = [] { return FChainPlace{EChainPlace::Bloom}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
