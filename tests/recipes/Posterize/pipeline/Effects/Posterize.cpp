// The picture in few levels: an effect with a setting, as small as one can be.
#include "Effects/Switches.h"
#include "Lens/Posterize.h"
#include "SceneRendering.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim PosterizeSettings[] = {{"Posterize"}};

constexpr FSwitch PosterizeSwitches[] = {{"PosterizeLevels", &FPostProcessSettings::PosterizeLevels, 0.0f}};

FEffectDecision DecidePosterize(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, PosterizeSwitches, "; before bloom");
}

FScreenPassTexture AddPosterizeEffect(const FEffectPassInputs& Inputs)
{
	return AddPosterizePass(
		Inputs.GraphBuilder, Inputs.View, Inputs.SceneColor, Inputs.View.FinalPostProcessSettings.PosterizeLevels);
}

} // namespace

const FEffect GPosterizeEffect{
	.Id = EEffect::Posterize,
	.Name = "Posterize",
	.Doc = "The picture in few levels.",
	.Settings = PosterizeSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecidePosterize,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{EChainPlace::BeforeBloom, 2};
		},
	.AddPasses = &AddPosterizeEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
