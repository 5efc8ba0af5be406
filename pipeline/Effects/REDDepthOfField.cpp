// The RED depth of field: a blur by depth in front of and behind a focus. Source: docs/effects.md (the article).
#include "Effects/REDPlace.h"
#include "Effects/Switches.h"
#include "Lens/REDDepthOfField.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim REDDepthOfFieldSettings[] = {{"REDDof"}};

constexpr FSwitch REDDepthOfFieldSwitches[] = {
	{"REDDofFocalDistance", &FPostProcessSettings::REDDofFocalDistance, 0.0f}};

FEffectDecision DecideREDDepthOfField(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, REDDepthOfFieldSwitches, DescribeREDPlace());
}

FScreenPassTexture AddREDDepthOfFieldEffect(const FEffectPassInputs& Inputs)
{
	FREDDepthOfFieldInputs DepthOfField =
		FREDDepthOfFieldInputs::FromSettings(Inputs.View.FinalPostProcessSettings, Inputs.SceneColor);
	DepthOfField.SceneTextures = Inputs.GetSceneTextures();
	return AddREDDepthOfFieldPasses(Inputs.GraphBuilder, Inputs.View, DepthOfField);
}

} // namespace

const FEffect GREDDepthOfFieldEffect{
	.Id = EEffect::REDDepthOfField,
	.Name = "REDDepthOfField",
	.Doc = "A blur by depth in front of and behind a focus, as RED has it.",
	.Settings = REDDepthOfFieldSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideREDDepthOfField,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return GetREDPlace(0); },
	.AddPasses = &AddREDDepthOfFieldEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
