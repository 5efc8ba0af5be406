// Local exposure: contrast of highlights and shadows around the local luminance, by a bilateral grid. Source: engine
// PostProcess/PostProcessing.cpp (conditions); the wording is drydock's.
#include "Effects/Effect.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

constexpr const char* Curve = "its keys are read, and no pass evaluates them: it counts as a curve of no effect";
constexpr FSettingClaim LocalExposureSettings[] = {
	{"LocalExposure"},
	{"LocalExposureHighlightContrastCurve", Curve},
	{"LocalExposureShadowContrastCurve", Curve},
};

FEffectDecision DecideLocalExposure(const FEffect&, const FEffectInputs& Inputs)
{
	const FFinalPostProcessSettings& Values = Inputs.Settings;
	const bool bNamed = Inputs.IsNamed("LocalExposure");
	FEffectDecision Decision;
	Decision.bConfigured = bNamed;
	if (!Inputs.Conditions.ShowFlags.PostProcessing)
	{
		Decision.Reason = "ShowFlag.PostProcessing is off";
		return Decision;
	}
	// At 1 the engine has none. To run it all the same changes no bit.
	const bool bForced = Inputs.Conditions.bNoSkip && bNamed;
	if (!IsLocalExposureEnabled(Values) && !bForced)
	{
		Decision.Reason = "its contrast scales and detail strength are 1" + Inputs.DescribeGate("LocalExposure");
		return Decision;
	}
	Decision.bActive = Decision.bConfigured = true;
	Decision.Reason = "contrast of highlights " + NumberText(Values.LocalExposureHighlightContrastScale) +
					  ", of shadows " + NumberText(Values.LocalExposureShadowContrastScale) + ", detail " +
					  NumberText(Values.LocalExposureDetailStrength);
	if (Values.LocalExposureMethod != ELocalExposureMethod::Bilateral)
	{
		Decision.Reason += "; fusion is not built, the bilateral grid runs";
	}
	return Decision;
}

} // namespace

const FEffect GLocalExposureEffect{
	.Id = EEffect::LocalExposure,
	.Name = "LocalExposure",
	.Doc = "Contrast of highlights and shadows around the local luminance.",
	.Settings = LocalExposureSettings,
	.bMayBrightenBeforeBloom = true, // bloom's setup pass applies it
	.Decide = &DecideLocalExposure,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{EChainPlace::Exposure, 1};
		},
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
