// Separate translucency, which the scene brings and no setting switches. Source: engine PostProcess/PostProcessing.cpp
// (its place, and that it is composed without post-processing too); the wording is drydock's.
#include "Effects/Effect.h"

namespace Drydock
{

namespace
{

FEffectDecision DecideTranslucency(const FEffect&, const FEffectInputs& Inputs)
{
	const FViewConditions& Conditions = Inputs.Conditions;
	FEffectDecision Decision;
	Decision.bConfigured = Conditions.bSeparateTranslucency;
	Decision.bActive = Conditions.bSeparateTranslucency && Conditions.ShowFlags.Translucency;
	Decision.Reason = !Conditions.bSeparateTranslucency ? "the scene has no separate translucency"
					  : Decision.bActive ? "the scene has separate translucency; composed after depth of field"
										 : "ShowFlag.Translucency is off";
	return Decision;
}

} // namespace

const FEffect GTranslucencyEffect{
	.Id = EEffect::Translucency,
	.Name = "Translucency",
	.Doc = "The scene's separate translucency over the picture.",
	.Settings = NoSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideTranslucency,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Translucency}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
