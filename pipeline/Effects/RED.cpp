// The RED post passes: diffusion filter, soft focus and glow. Source: docs/effects.md (the article).
#include "Effects/REDPlace.h"
#include "Effects/Switches.h"
#include "Lens/REDPostProcess.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim Settings[] = {{"DiffusionFilter"}, {"SoftFocus"}, {"Glow"}};

constexpr FSwitch Switches[] = {
	{"DiffusionFilterIntensity", &FPostProcessSettings::DiffusionFilterIntensity, 0.0f},
	{"SoftFocusBlend", &FPostProcessSettings::SoftFocusBlend, 0.0f},
	{"SoftFocusSaturation", &FPostProcessSettings::SoftFocusSaturation, 1.0f},
	{"GlowIntensity", &FPostProcessSettings::GlowIntensity, 0.0f},
};

FEffectDecision Decide(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, Switches, DescribeREDPlace());
}

FScreenPassTexture AddPasses(const FEffectPassInputs& Inputs)
{
	return AddREDPostProcessPasses(Inputs.GraphBuilder, Inputs.View, Inputs.SceneColor,
		FREDPostProcessParameters::FromSettings(Inputs.View.FinalPostProcessSettings));
}

} // namespace

const FEffect GREDEffect{
	.Id = EEffect::RED,
	.Name = "RED",
	.Doc = "Diffusion filter, soft focus and glow of the RED post passes.",
	.Settings = Settings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &Decide,
	.Ask = nullptr,
	.Gate = nullptr,
	.Complete = nullptr,
	.GetPlace = [] { return GetREDPlace(1); },
	.AddPasses = &AddPasses,
	.Measured = NothingMeasured,
	.Measure = nullptr,
};

} // namespace Drydock
