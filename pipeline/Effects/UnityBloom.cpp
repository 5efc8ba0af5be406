// Bloom as Unity's tutorials build it, before or after the tonemapper. Source: docs/effects.md (the article).
#include "Bloom/UnityBloom.h"
#include "Effects/Switches.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim Settings[] = {{"UnityBloom"}};

constexpr FSwitch Switches[] = {{"UnityBloomIntensity", &FPostProcessSettings::UnityBloomIntensity, 0.0f}};

FEffectDecision Decide(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(
		Effect, Inputs, Switches, IsUnityBloomAfterTonemap() ? "; after the tonemapper" : "; before the tonemapper");
}

FScreenPassTexture AddPasses(const FEffectPassInputs& Inputs)
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
	.Settings = Settings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &Decide,
	.Ask = nullptr,
	.Gate = nullptr,
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{IsUnityBloomAfterTonemap() ? EChainPlace::AfterTonemap : EChainPlace::BeforeBloom, 1};
		},
	.AddPasses = &AddPasses,
	.Measured = NothingMeasured,
	.Measure = nullptr,
};

} // namespace Drydock
