// Sets the values that a view's settings begin with. Source: engine SceneView.cpp (StartFinalPostprocessSettings).
#include "SettingsEditor.h"

#include <algorithm>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarBloom(TEXT("r.DefaultFeature.Bloom"), 1,
	TEXT("0: BloomIntensity and BloomToonIntensity are 0 unless a volume or the camera sets them."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarAmbientOcclusion(TEXT("r.DefaultFeature.AmbientOcclusion"), 1,
	TEXT("0: AmbientOcclusionIntensity is 0 unless a volume or the camera sets it."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarAmbientOcclusionStaticFraction(TEXT("r.DefaultFeature.AmbientOcclusionStaticFraction"),
	1, TEXT("0: AmbientOcclusionStaticFraction is 0 unless a volume or the camera sets it."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarAutoExposure(TEXT("r.DefaultFeature.AutoExposure"), 1,
	TEXT("0: the eye does not adapt (least and greatest brightness 1) unless a volume or the camera sets it."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarAutoExposureMethod(TEXT("r.DefaultFeature.AutoExposure.Method"), 0,
	TEXT("Default of AutoExposureMethod. 0: histogram (default). 1: basic. 2: manual."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarAutoExposureBias(TEXT("r.DefaultFeature.AutoExposure.Bias"), 1.0f,
	TEXT("Default of AutoExposureBias, and the bias at which the exposure scale is the scene's own."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarExtendLuminanceRange(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"),
	0,
	TEXT("1: default brightness and histogram range are -10 to 20, in EV100. 0: 0.03 to 8 in luminance, -8 to 4 in its "
		 "logarithm (default)."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarHighlightContrastScale(TEXT("r.DefaultFeature.LocalExposure.HighlightContrastScale"),
	1.0f, TEXT("Default of LocalExposureHighlightContrastScale."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarShadowContrastScale(TEXT("r.DefaultFeature.LocalExposure.ShadowContrastScale"), 1.0f,
	TEXT("Default of LocalExposureShadowContrastScale."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarMotionBlur(TEXT("r.DefaultFeature.MotionBlur"), 1,
	TEXT("0: MotionBlurAmount is 0 unless a volume or the camera sets it."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarLensFlare(TEXT("r.DefaultFeature.LensFlare"), 0,
	TEXT("0: LensFlareIntensity is 0 unless a volume or the camera sets it (default)."), ECVF_RenderThreadSafe);

/** Brightness and histogram range; in EV100 where the range is extended. */
void StartExposure(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor)
{
	Editor.Assign(DRYDOCK_MEMBER(AutoExposureBias), CVarAutoExposureBias.GetValueOnAnyThread(),
		ByVariable("r.DefaultFeature.AutoExposure.Bias", "Assign", "is the default"));
	const bool bExtended = CVarExtendLuminanceRange.GetValueOnAnyThread() != 0;
	if (bExtended)
	{
		const FSettingsEdit Edit =
			ByVariable("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange", "Assign", "is on: EV100");
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMinBrightness), -10.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMaxBrightness), 20.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(HistogramLogMin), -10.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(HistogramLogMax), 20.0f, Edit);
	}
	if (CVarAutoExposure.GetValueOnAnyThread() == 0)
	{
		// Luminance 1 in EV100 is log2(1 / LuminanceMax).
		const float Attenuation = GetVariableOfPasses(TEXT("r.EyeAdaptation.LensAttenuation"), 0.78f);
		const float LuminanceMax = 0.78f / std::max(Attenuation, 0.01f);
		const float Brightness = bExtended ? std::log2(1.0f / LuminanceMax) : 1.0f;
		const FSettingsEdit Edit = ByVariable("r.DefaultFeature.AutoExposure", "Assign", "is 0");
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMinBrightness), Brightness, Edit);
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMaxBrightness), Brightness, Edit);
		return;
	}
	const int32 Method = CVarAutoExposureMethod.GetValueOnAnyThread();
	if (Method >= 0 && Method < AEM_MAX)
	{
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMethod), static_cast<EAutoExposureMethod>(Method),
			ByVariable("r.DefaultFeature.AutoExposure.Method", "Assign", "is the default"));
	}
}

void StartLocalExposure(FFinalPostProcessSettings& Settings, const FEngineProfile& Engine, FSettingsEditor& Editor)
{
	const char* const Highlights = "r.DefaultFeature.LocalExposure.HighlightContrastScale";
	const char* const Shadows = "r.DefaultFeature.LocalExposure.ShadowContrastScale";
	Editor.Assign(DRYDOCK_MEMBER(LocalExposureHighlightContrastScale), CVarHighlightContrastScale.GetValueOnAnyThread(),
		ByVariable(Highlights, "Assign", "is the default"));
	const bool bOfHighlights = Engine.bShadowContrastOfHighlights;
	Editor.Assign(DRYDOCK_MEMBER(LocalExposureShadowContrastScale),
		(bOfHighlights ? CVarHighlightContrastScale : CVarShadowContrastScale).GetValueOnAnyThread(),
		ByVariable(bOfHighlights ? Highlights : Shadows, "Assign", "is the default"));
}

} // namespace

FFinalPostProcessSettings StartFinalPostProcessSettings(FBlendLedger* Ledger, const FEngineProfile& Engine)
{
	FFinalPostProcessSettings Settings;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	StartWithDefaults(Settings);
	for (size_t Index = 0; Ledger != nullptr && Index < Fields.size(); ++Index)
	{
		const FSettingValue& Default = Fields[Index].Default;
		Ledger->Add(Index, {EBlendSource::Default, "default", "", {}, {}, Default, Default, "", ""});
	}
	FSettingsEditor Editor(Settings, Ledger);
	const auto SwitchOff =
		[&](const TAutoConsoleVariable<int32>& Variable, const char* Name, float& Value, const char* VariableName)
	{
		Editor.SwitchOff(Variable.GetValueOnAnyThread() == 0, Name, Value, ByVariable(VariableName, "Assign", "is 0"));
	};
	SwitchBloomOff(
		CVarBloom.GetValueOnAnyThread() == 0, Settings, Editor, ByVariable("r.DefaultFeature.Bloom", "Assign", "is 0"));
	SwitchOff(CVarAmbientOcclusion, DRYDOCK_MEMBER(AmbientOcclusionIntensity), "r.DefaultFeature.AmbientOcclusion");
	SwitchOff(CVarAmbientOcclusionStaticFraction, DRYDOCK_MEMBER(AmbientOcclusionStaticFraction),
		"r.DefaultFeature.AmbientOcclusionStaticFraction");
	SwitchOff(CVarMotionBlur, DRYDOCK_MEMBER(MotionBlurAmount), "r.DefaultFeature.MotionBlur");
	SwitchOff(CVarLensFlare, DRYDOCK_MEMBER(LensFlareIntensity), "r.DefaultFeature.LensFlare");
	StartExposure(Settings, Editor);
	StartLocalExposure(Settings, Engine, Editor);
	return Settings;
}

} // namespace Drydock
