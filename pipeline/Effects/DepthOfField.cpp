// Depth of field by gathered bokehs, a simplification of the engine's. Source: engine PostProcess/DiaphragmDOF.cpp
// (conditions); the wording is drydock's.
#include "Effects/Effect.h"
#include "Lens/DiaphragmDOF.h"
#include "SceneRendering.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim DepthOfFieldSettings[] = {
	{"DepthOfFieldFocalDistance"},
	{"DepthOfFieldFstop"},
	{"DepthOfFieldMinFstop"},
	{"DepthOfFieldBladeCount"},
	{"DepthOfFieldSensorWidth"},
	{"DepthOfFieldDepthBlur"},
};

FEffectDecision DecideDepthOfField(const FEffect&, const FEffectInputs& Inputs)
{
	const FFinalPostProcessSettings& Values = Inputs.Settings;
	FEffectDecision Decision;
	Decision.bConfigured = Inputs.IsNamed("DepthOfField");
	Decision.Reason = Inputs.FindShowFlagOff(Inputs.Conditions.ShowFlags.DepthOfField, "DepthOfField");
	if (Decision.Reason.empty())
	{
		Decision.bActive = DiaphragmDOF::IsEnabled(Values);
		Decision.bConfigured = Decision.bConfigured || Decision.bActive;
		Decision.Reason = "DepthOfFieldFocalDistance is " + NumberText(Values.DepthOfFieldFocalDistance) +
						  ", DepthOfFieldFstop " + NumberText(Values.DepthOfFieldFstop) +
						  (Decision.bActive ? "; a simplification of the engine's" : ": nothing is focused");
	}
	return Decision;
}

FScreenPassTexture AddDepthOfFieldEffect(const FEffectPassInputs& Inputs)
{
	const FViewInfo& View = Inputs.View;
	const auto Model = DiaphragmDOF::FPhysicalCocModel::Compile(View.FinalPostProcessSettings,
		Inputs.SceneColor.ViewRect.Width(), static_cast<float>(View.UniformParameters.ViewToClip.M[0][0]));
	const auto Bokeh = DiaphragmDOF::FBokehModel::Compile(View.FinalPostProcessSettings);
	return DiaphragmDOF::AddPasses(
		Inputs.GraphBuilder, View, Inputs.GetSceneTextures(), Inputs.SceneColor, Model, Bokeh);
}

} // namespace

const FEffect GDepthOfFieldEffect{
	.Id = EEffect::DepthOfField,
	.Name = "DepthOfField",
	.Doc = "Blur of what is out of focus.",
	.Settings = DepthOfFieldSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideDepthOfField,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::DepthOfField}; },
	.AddPasses = &AddDepthOfFieldEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
