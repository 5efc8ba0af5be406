// Finds values of the blended settings that have no effect in this run.
#include "Run/IneffectiveValues.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Config/ConfigReader.h"
#include "CurveKeys.h"
#include "HAL/IConsoleManager.h"
#include "SceneView.h"
#include "Screen/TextureAssets.h"
#include "SettingObjects.h"
#include "Tonemap/TonemapLens.h"

namespace Drydock
{

namespace
{

/** Pictures that the tonemapper would read, but that are names of engine assets. */
void WarnOfMissingPictures(const FFinalPostProcessSettings& Settings, FConfigMessages& Messages)
{
	const auto Check = [&](const char* Setting, const UTexture* Texture)
	{
		if (Texture != nullptr && !FindTexturePixels(Texture))
		{
			Messages.Warn(WarnIneffectiveValue, FConfigPlace(),
				std::string(Setting) + " " + GetObjectPath(Texture) +
					" has no pixels here and is ignored: name an image file, relative to the config");
		}
	};
	if (Settings.BloomDirtMaskIntensity > 0.0f)
	{
		Check("BloomDirtMask", Settings.BloomDirtMask.Get());
	}
	if (HasFilmGrain(Settings))
	{
		Check("FilmGrainTexture", Settings.FilmGrainTexture.Get());
	}
	for (const FFinalPostProcessSettings::FLUTEntry& Entry : Settings.ContributingLUTs)
	{
		Check("ColorGradingLUT", Entry.LUT.Get());
	}
	if (Settings.ToonShadowBlurIntensity > 0.0f && Settings.ToonShadowBlurBlend == EToonShadowBlurBlend::Max)
	{
		Check("ToonShadowBlurRamp", Settings.ToonShadowBlurRamp.Get());
	}
}

/** A curve that would act, but that is the name of an engine asset. */
void WarnOfMissingKeys(const FViewSettings& View, FConfigMessages& Messages)
{
	const UCurveFloat* const Curve = View.Settings.AutoExposureBiasCurve;
	if (View.bAutoExposure && Curve != nullptr && !FindCurveKeys(Curve))
	{
		Messages.Warn(WarnIneffectiveValue, FConfigPlace(),
			"AutoExposureBiasCurve " + GetObjectPath(Curve) +
				" has no keys here and is ignored: give the keys, {\"keys\": [[EV100, EV], ...]}");
	}
}

} // namespace

void WarnOfIneffectiveValues(const FConfig& Config, const FViewSettings& View, std::vector<FDiagnostic>& Diagnostics)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	const FConfigPlace Nowhere;
	const int32 AntiAliasing = IConsoleManager::Get().FindConsoleVariable(TEXT("r.AntiAliasingMethod"))->GetInt();
	if (AntiAliasing == AAM_TSR)
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere,
			"r.AntiAliasingMethod 4 (TSR) is not simulated: temporal antialiasing stands in for it");
	}
	else if (AntiAliasing < AAM_None || AntiAliasing > AAM_TemporalAA)
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere,
			"r.AntiAliasingMethod " + std::to_string(AntiAliasing) + " is not simulated: no antialiasing runs");
	}
	const std::string Obstacle = View.Settings.BloomMethod == BM_FFT && View.Settings.BloomIntensity > 0.0f
									 ? GetFFTBloomObstacle(View.Settings, true)
									 : std::string();
	if (!Obstacle.empty())
	{
		Messages.Warn(WarnIneffectiveValue, Nowhere, "BloomMethod BM_FFT: " + Obstacle + ", so the Gaussian sum runs");
	}
	if (View.Settings.ToonShadowBlurRamp != nullptr && View.Settings.ToonShadowBlurIntensity > 0.0f &&
		View.Settings.ToonShadowBlurBlend != EToonShadowBlurBlend::Max)
	{
		Messages.Warn(
			WarnIneffectiveValue, Nowhere, "ToonShadowBlurRamp is ignored: only ToonShadowBlurBlend Max reads it");
	}
	WarnOfMissingPictures(View.Settings, Messages);
	WarnOfMissingKeys(View, Messages);
}

void WarnOfIdleTemporalAA(const FConfig& Config, const std::optional<FSceneCamera>& Camera,
	const std::vector<FEffectDecision>& Effects, std::vector<FDiagnostic>& Diagnostics)
{
	if (!IsEffectActive(Effects, EEffect::TemporalAA))
	{
		return;
	}
	FConfigMessages Messages(Config.File, Diagnostics);
	if (!Config.Scene.Frame)
	{
		Messages.Warn(WarnIneffectiveValue, Config.Scene.File.Place,
			"TemporalAA averages frames, and this scene is one frame: it is only filtered. Name a sequence, such as "
			"NAME.####.exr with \"frames\"; drydock scene writes one");
	}
	else if (!Camera || !Camera->Jitter)
	{
		Messages.Warn(WarnIneffectiveValue, Config.Scene.File.Place,
			"TemporalAA averages jittered frames, and the header of this scene has no jitter: edges gain nothing. "
			"Write "
			"\"jitter_px\": [X, Y] into drydock:camera_json; drydock scene writes frames that have it");
	}
}

} // namespace Drydock
