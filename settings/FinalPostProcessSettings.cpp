// Source: engine SceneView.cpp (OverridePostProcessSettings, EndFinalPostprocessSettings).
#include "FinalPostProcessSettings.h"

#include "HAL/IConsoleManager.h"
#include "PostProcessSettingsReflection.h"

#include <algorithm>

namespace
{

TAutoConsoleVariable<int32> CVarDefaultBloom(TEXT("r.DefaultFeature.Bloom"), 1,
	TEXT("0: BloomIntensity is 0 unless a volume or the camera sets it."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarDefaultAutoExposureBias(TEXT("r.DefaultFeature.AutoExposure.Bias"), 1.0f,
	TEXT("Default of AutoExposureBias, and the bias at which the exposure scale is the scene's own."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarTonemapperQuality(TEXT("r.Tonemapper.Quality"), 5,
	TEXT("Below 2: no vignette. Below 4: no film grain. Default 5."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarSceneColorFringeQuality(TEXT("r.SceneColorFringeQuality"), 1,
	TEXT("0: no colour fringe. Default 1."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarSceneColorFringeMax(TEXT("r.SceneColorFringe.Max"), -1.0f,
	TEXT("0 and above: SceneFringeIntensity is at most this. -1: no limit (default). -2: 5, to test."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarExposureOffset(
	TEXT("r.ExposureOffset"), 0.0f, TEXT("Added to AutoExposureBias, in EV."), ECVF_RenderThreadSafe);

/** r.BloomQuality belongs to the bloom passes above this storey. */
int32 GetBloomQualityVariable()
{
	const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(TEXT("r.BloomQuality"));
	return Variable ? Variable->GetInt() : 5;
}

} // namespace

namespace Drydock
{

FFinalPostProcessSettings StartFinalPostProcessSettings()
{
	FFinalPostProcessSettings Settings;
	Settings.AutoExposureBias = CVarDefaultAutoExposureBias.GetValueOnAnyThread();
	if (CVarDefaultBloom.GetValueOnAnyThread() == 0)
	{
		Settings.BloomIntensity = 0.0f;
	}
	return Settings;
}

void OverridePostProcessSettings(FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
{
	if (!(Weight > 0.0f))
	{
		return;
	}
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Field.IsOverridden(Source))
		{
			Field.BlendFrom(Settings, Source, std::min(Weight, 1.0f));
			Field.SetOverridden(Settings, true);
		}
	}
}

std::vector<FSettingGate> EndFinalPostProcessSettings(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags)
{
	std::vector<FSettingGate> Gates;
	const auto Assign = [&](const char* Name, float& Value, float NewValue, const char* Reason)
	{
		if (Value != NewValue)
		{
			Value = NewValue;
			Gates.push_back({Name, Reason});
		}
	};
	const auto SwitchOff = [&](bool bOff, const char* Name, float& Value, const char* Reason)
	{
		if (bOff)
		{
			Assign(Name, Value, 0.0f, Reason);
		}
	};

	SwitchOff(GetBloomQualityVariable() <= 0, "BloomIntensity", Settings.BloomIntensity, "r.BloomQuality is 0");
	SwitchOff(!ShowFlags.Bloom, "BloomIntensity", Settings.BloomIntensity, "ShowFlag.Bloom is off");

	SwitchOff(CVarTonemapperQuality.GetValueOnAnyThread() < 2, "VignetteIntensity", Settings.VignetteIntensity,
		"r.Tonemapper.Quality is below 2");
	SwitchOff(!ShowFlags.Vignette, "VignetteIntensity", Settings.VignetteIntensity, "ShowFlag.Vignette is off");
	SwitchOff(!ShowFlags.ToneCurve, "ToneCurveAmount", Settings.ToneCurveAmount, "ShowFlag.ToneCurve is off");

	SwitchOff(CVarSceneColorFringeQuality.GetValueOnAnyThread() <= 0, "SceneFringeIntensity",
		Settings.SceneFringeIntensity, "r.SceneColorFringeQuality is 0");
	SwitchOff(!ShowFlags.SceneColorFringe, "SceneFringeIntensity", Settings.SceneFringeIntensity,
		"ShowFlag.SceneColorFringe is off");
	SwitchOff(!ShowFlags.CameraImperfections, "SceneFringeIntensity", Settings.SceneFringeIntensity,
		"ShowFlag.CameraImperfections is off");
	SwitchOff(!ShowFlags.CameraImperfections, "BloomDirtMaskIntensity", Settings.BloomDirtMaskIntensity,
		"ShowFlag.CameraImperfections is off");
	const float FringeMax = CVarSceneColorFringeMax.GetValueOnAnyThread();
	if (FringeMax == -2.0f)
	{
		Assign("SceneFringeIntensity", Settings.SceneFringeIntensity, 5.0f, "r.SceneColorFringe.Max is -2");
	}
	else if (FringeMax >= 0.0f && Settings.SceneFringeIntensity > FringeMax)
	{
		Assign("SceneFringeIntensity", Settings.SceneFringeIntensity, FringeMax, "r.SceneColorFringe.Max limits it");
	}

	const float ExposureOffset = CVarExposureOffset.GetValueOnAnyThread();
	if (ExposureOffset != 0.0f)
	{
		Assign("AutoExposureBias", Settings.AutoExposureBias, Settings.AutoExposureBias + ExposureOffset,
			"r.ExposureOffset is added");
	}
	return Gates;
}

} // namespace Drydock
