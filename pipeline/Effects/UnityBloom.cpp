// Bloom as Unity's tutorials build it, before or after the tonemapper. Source: docs/effects.md (the article).
#include "Bloom/UnityBloom.h"
#include "Effects/Switches.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim UnityBloomSettings[] = {{"UnityBloom"}};

constexpr FSwitch UnityBloomSwitches[] = {{"UnityBloomIntensity", &FPostProcessSettings::UnityBloomIntensity, 0.0f}};

FEffectDecision DecideUnityBloom(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, UnityBloomSwitches,
		IsUnityBloomAfterTonemap() ? "; after the tonemapper" : "; before the tonemapper");
}

FScreenPassTexture AddUnityBloomEffect(const FEffectPassInputs& Inputs)
{
	FUnityBloomInputs Bloom = FUnityBloomInputs::FromSettings(Inputs.View.FinalPostProcessSettings, Inputs.SceneColor);
	Bloom.OverrideOutput = Inputs.OverrideOutput;
	return AddUnityBloomPasses(Inputs.GraphBuilder, Inputs.View, Bloom);
}

} // namespace

const FEffect GUnityBloomEffect{
	.Id = EEffect::UnityBloom,
	.Name = "UnityBloom",
	.Doc = "Bloom as Unity's tutorials build it.",
	.Settings = UnityBloomSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideUnityBloom,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{IsUnityBloomAfterTonemap() ? EChainPlace::AfterTonemap : EChainPlace::BeforeBloom, 1};
		},
	.AddPasses = &AddUnityBloomEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
