// Toon shading lit by a blurred shadow. Source: docs/effects.md (the article); the gate and the figures are drydock's.
#include "Effects/Banding.h"
#include "Effects/ContentGate.h"
#include "Effects/Switches.h"
#include "Effects/ToonShadowExact.h"
#include "Picture/Picture.h"
#include "SceneRendering.h"
#include "Screen/TextureAssets.h"
#include "Toon/ToonShadowBlur.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim ToonShadowBlurSettings[] = {{"ToonShadowBlur"}};
constexpr const char* ToonShadowBlurMeasured[] = {"BlurredToonShadow"};

constexpr FSwitch ToonShadowBlurSwitches[] = {
	{"ToonShadowBlurIntensity", &FPostProcessSettings::ToonShadowBlurIntensity, 0.0f}};

FEffectDecision DecideToonShadowBlur(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, ToonShadowBlurSwitches, "");
}

FContentQuestions AskToonShadowBlur(const FGateInputs&, const FEffectDecision&)
{
	return {.bToon = true};
}

/** It lights pixels of the toon model. */
void GateToonShadowBlur(const FGateInputs& Gate, FEffectDecision& Blur)
{
	if (HasNone(Gate.Content.Toon))
	{
		Skip(Blur, "no pixel of the view is shaded as toon");
	}
}

FScreenPassTexture AddToonShadowBlurEffect(const FEffectPassInputs& Inputs)
{
	const FViewInfo& View = Inputs.View;
	if (View.SceneTextures == nullptr || !View.SceneTextures->ToonShadow)
	{
		return Inputs.SceneColor; // the frame has no such shadow and stays as it is lit
	}
	const FFinalPostProcessSettings& Values = View.FinalPostProcessSettings;
	const FToonShadowBlurInputs Blur =
		FToonShadowBlurInputs::FromSettings(Values, FScreenPassTexture(View.SceneTextures->ToonShadow, View.ViewRect));
	const FScreenPassTexture Blurred = AddToonShadowBlurPasses(Inputs.GraphBuilder, View, Blur);
	Inputs.Kept["BlurredToonShadow"] = Blurred;

	FToonShadowLightingInputs Lighting;
	Lighting.SceneColor = Inputs.SceneColor;
	Lighting.ToonShadow = Blurred;
	Lighting.SceneTextures = Inputs.GetSceneTextures();
	Lighting.LightColor = Inputs.LightColor;
	Lighting.Intensity = Values.ToonShadowBlurIntensity;
	Lighting.Blend = Values.ToonShadowBlurBlend;
	Lighting.Ramp = FindTexturePixels(Values.ToonShadowBlurRamp.Get());
	Lighting.Store = Blur.Store;
	Lighting.bAsPrinted = Blur.bAsPrinted;
	return AddToonShadowLightingPass(Inputs.GraphBuilder, View, Lighting);
}

/** How smooth the blurred shadow is as it is stored, and how far it is from what it would be without rounding. */
FEffectFigures MeasureToonShadowBlur(const FMeasureInputs& Inputs)
{
	constexpr int Blurred = 3;
	const FKeptTexture& Kept = Inputs.Textures.at("BlurredToonShadow");
	FImage Shadow = FPicture(Kept.Texture, Kept.Rect).ToImage();
	FImage Alone{Shadow.Width, Shadow.Height, 1, {}};
	for (size_t Index = Blurred; Index < Shadow.Values.size(); Index += 4)
	{
		Shadow.Values[Index] = static_cast<double>(
			DecodeToonShadowBlur(static_cast<float>(Shadow.Values[Index]), Inputs.Settings.ToonShadowBlurStore));
		Alone.Values.push_back(Shadow.Values[Index]);
	}
	const FBandingFigures Banding = MeasureBanding(Shadow, Blurred);
	const FDarkDeviation Deviation =
		MeasureDarkDeviation(Shadow, BlurToonShadowExactly(Shadow, Inputs.Settings), Blurred);
	FEffectFigures Figures;
	Figures.Groups = {
		{"banding",
			{{"uniqueLevels", Banding.UniqueLevels}, {"darkLevels", Banding.DarkLevels},
				{"longestFlatRun", static_cast<uint64_t>(Banding.LongestFlatRun)},
				{"stepHistogram", std::vector<uint64_t>(Banding.StepHistogram.begin(), Banding.StepHistogram.end())}}},
		{"darkDeviation", {{"rms", Deviation.Rms}, {"largest", Deviation.Largest}, {"texels", Deviation.Texels}}},
	};
	Figures.Pictures.push_back({"toonShadowBlurred", "toon_shadow_blurred", std::move(Alone), true});
	Figures.Pictures.push_back({"toonShadowBanding", "toon_shadow_banding", MakeBandingMap(Shadow, Blurred), false});
	return Figures;
}

} // namespace

const FEffect GToonShadowBlurEffect{
	.Id = EEffect::ToonShadowBlur,
	.Name = "ToonShadowBlur",
	.Doc = "Toon shading lit by a blurred shadow.",
	.Settings = ToonShadowBlurSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideToonShadowBlur,
	.Content = FContentGate{&AskToonShadowBlur, &GateToonShadowBlur},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Lighting}; },
	.AddPasses = &AddToonShadowBlurEffect,
	.Measurement = FMeasurement{ToonShadowBlurMeasured, &MeasureToonShadowBlur},
};

} // namespace Drydock
