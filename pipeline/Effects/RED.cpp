// The RED post passes: diffusion filter, soft focus and glow. Source: docs/effects.md (the article).
#include "Effects/REDPlace.h"
#include "Effects/Switches.h"
#include "Lens/REDPostProcess.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim REDSettings[] = {{"DiffusionFilter"}, {"SoftFocus"}, {"Glow"}};

constexpr FSwitch REDSwitches[] = {
	{"DiffusionFilterIntensity", &FPostProcessSettings::DiffusionFilterIntensity, 0.0f},
	{"SoftFocusBlend", &FPostProcessSettings::SoftFocusBlend, 0.0f},
	{"SoftFocusSaturation", &FPostProcessSettings::SoftFocusSaturation, 1.0f},
	{"GlowIntensity", &FPostProcessSettings::GlowIntensity, 0.0f},
};

FEffectDecision DecideRED(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, REDSwitches, DescribeREDPlace());
}

FScreenPassTexture AddREDEffect(const FEffectPassInputs& Inputs)
{
	return AddREDPostProcessPasses(Inputs.GraphBuilder, Inputs.View, Inputs.SceneColor,
		FREDPostProcessParameters::FromSettings(Inputs.View.FinalPostProcessSettings));
}

} // namespace

const FEffect GREDEffect{
	.Id = EEffect::RED,
	.Name = "RED",
	.Doc = "Diffusion filter, soft focus and glow of the RED post passes.",
	.Settings = REDSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideRED,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return GetREDPlace(1); },
	.AddPasses = &AddREDEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
