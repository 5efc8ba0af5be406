// The step from the rendered size to the output's. Source: engine PostProcess/PostProcessUpscale.cpp (conditions); the
// wording is drydock's.
#include "Effects/Effect.h"
#include "Screen/PostProcessUpscale.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

FEffectDecision DecideUpscale(const FEffect&, const FEffectInputs& Inputs)
{
	FEffectDecision Decision;
	const double ScreenPercentage = Inputs.Conditions.ScreenPercentage;
	Decision.Reason = "scene.screenPercentage is " + NumberText(static_cast<float>(ScreenPercentage));
	Decision.bConfigured = ScreenPercentage != 100.0;
	Decision.bActive = Decision.bConfigured && Inputs.Conditions.ShowFlags.ScreenPercentage;
	if (Decision.bActive)
	{
		Decision.Reason += ", r.Upscale.Quality " + std::to_string(static_cast<int32>(GetUpscaleMethod()));
	}
	else if (Decision.bConfigured)
	{
		Decision.Reason += ", but ShowFlag.ScreenPercentage is off";
	}
	return Decision;
}

} // namespace

const FEffect GUpscaleEffect{
	.Id = EEffect::Upscale,
	.Name = "Upscale",
	.Doc = "From the rendered size to the output's.",
	.Settings = NoSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideUpscale,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Upscale}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
