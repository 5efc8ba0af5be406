// The last word of console variables and show flags. Source: engine SceneView.cpp (EndFinalPostprocessSettings).
#include "SettingsEditor.h"

#include <algorithm>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarTonemapperQuality(TEXT("r.Tonemapper.Quality"), 5,
	TEXT("Below 2: no vignette. Below 4: no film grain. Default 5."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarSceneColorFringeQuality(TEXT("r.SceneColorFringeQuality"), 1,
	TEXT("0: no colour fringe. Default 1."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarSceneColorFringeMax(TEXT("r.SceneColorFringe.Max"), -1.0f,
	TEXT("0 and above: SceneFringeIntensity is at most this. -1: no limit (default). -2: 5, to test."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarDepthOfFieldQuality(TEXT("r.DepthOfFieldQuality"), 2,
	TEXT("0: no depth of field. Default 2."), ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarLocalExposure(
	TEXT("r.LocalExposure"), 1, TEXT("0: no local exposure. 1: as the settings say (default)."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarExposureOffset(
	TEXT("r.ExposureOffset"), 0.0f, TEXT("Added to AutoExposureBias, in EV."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarMotionBlurScale(TEXT("r.MotionBlur.Scale"), 1.0f,
	TEXT("MotionBlurAmount is multiplied by this, clamped to 0..50."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarMotionBlurAmount(TEXT("r.MotionBlur.Amount"), -1.0f,
	TEXT("0 and above: MotionBlurAmount, whatever the settings say. -1: the settings (default)."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarMotionBlurMax(TEXT("r.MotionBlur.Max"), -1.0f,
	TEXT("0 and above: MotionBlurMax, in percent of the width, whatever the settings say. -1: the settings (default). "
		 "No "
		 "blur is longer than twice the picture's width and height together."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarMotionBlurTargetFPS(TEXT("r.MotionBlur.TargetFPS"), -1,
	TEXT("0 and above: MotionBlurTargetFPS, whatever the settings say. -1: the settings (default)."),
	ECVF_RenderThreadSafe);

/** Switches settings off by show flags; LocalExposure and GlobalIllumination by hand. */
void EndFlags(FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FSettingsEditor& Editor)
{
	SwitchBloomOff(!ShowFlags.Bloom, Settings, Editor, ByFlag("ShowFlag.Bloom"));
	Editor.SwitchOff(!ShowFlags.Vignette, DRYDOCK_MEMBER(VignetteIntensity), ByFlag("ShowFlag.Vignette"));
	Editor.SwitchOff(!ShowFlags.Grain, DRYDOCK_MEMBER(FilmGrainIntensity), ByFlag("ShowFlag.Grain"));
	Editor.SwitchOff(!ShowFlags.ToneCurve, DRYDOCK_MEMBER(ToneCurveAmount), ByFlag("ShowFlag.ToneCurve"));
	Editor.SwitchOff(!ShowFlags.LensFlares, DRYDOCK_MEMBER(LensFlareIntensity), ByFlag("ShowFlag.LensFlares"));
	Editor.SwitchOff(!ShowFlags.DepthOfField, DRYDOCK_MEMBER(DepthOfFieldScale), ByFlag("ShowFlag.DepthOfField"));
	Editor.SwitchOff(
		!ShowFlags.AmbientOcclusion, DRYDOCK_MEMBER(AmbientOcclusionIntensity), ByFlag("ShowFlag.AmbientOcclusion"));
	Editor.SwitchOff(
		!ShowFlags.SceneColorFringe, DRYDOCK_MEMBER(SceneFringeIntensity), ByFlag("ShowFlag.SceneColorFringe"));
	Editor.SwitchOff(
		!ShowFlags.CameraImperfections, DRYDOCK_MEMBER(SceneFringeIntensity), ByFlag("ShowFlag.CameraImperfections"));
	Editor.SwitchOff(
		!ShowFlags.CameraImperfections, DRYDOCK_MEMBER(BloomDirtMaskIntensity), ByFlag("ShowFlag.CameraImperfections"));
	if (!ShowFlags.GlobalIllumination)
	{
		const FSettingsEdit Edit = ByFlag("ShowFlag.GlobalIllumination");
		Editor.Assign(DRYDOCK_MEMBER(IndirectLightingColor), FLinearColor(0.0f, 0.0f, 0.0f, 1.0f), Edit);
		Editor.Assign(DRYDOCK_MEMBER(IndirectLightingIntensity), 0.0f, Edit);
	}
}

/** Switches settings off by qualities of 0 or too low. */
void EndQualities(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor)
{
	const int32 TonemapperQuality = CVarTonemapperQuality.GetValueOnAnyThread();
	SwitchBloomOff(GetVariableOfPasses(TEXT("r.BloomQuality"), 5.0f) <= 0.0f, Settings, Editor,
		ByVariable("r.BloomQuality", "Assign", "is 0"));
	Editor.SwitchOff(TonemapperQuality < 2, DRYDOCK_MEMBER(VignetteIntensity),
		ByVariable("r.Tonemapper.Quality", "Assign", "is below 2"));
	Editor.SwitchOff(TonemapperQuality < 4, DRYDOCK_MEMBER(FilmGrainIntensity),
		ByVariable("r.Tonemapper.Quality", "Assign", "is below 4"));
	Editor.SwitchOff(CVarDepthOfFieldQuality.GetValueOnAnyThread() <= 0, DRYDOCK_MEMBER(DepthOfFieldScale),
		ByVariable("r.DepthOfFieldQuality", "Assign", "is 0"));
	Editor.SwitchOff(CVarSceneColorFringeQuality.GetValueOnAnyThread() <= 0, DRYDOCK_MEMBER(SceneFringeIntensity),
		ByVariable("r.SceneColorFringeQuality", "Assign", "is 0"));
}

void EndFringe(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor)
{
	const float Max = CVarSceneColorFringeMax.GetValueOnAnyThread();
	if (Max == -2.0f)
	{
		Editor.Assign(
			DRYDOCK_MEMBER(SceneFringeIntensity), 5.0f, ByVariable("r.SceneColorFringe.Max", "Assign", "is -2"));
	}
	else if (Max >= 0.0f)
	{
		Editor.Assign(DRYDOCK_MEMBER(SceneFringeIntensity), std::min(Settings.SceneFringeIntensity, Max),
			ByVariable("r.SceneColorFringe.Max", "Limit", "limits it"));
	}
}

void EndLocalExposure(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor, const FSettingsEdit& Edit)
{
	Editor.Assign(DRYDOCK_MEMBER(LocalExposureHighlightContrastScale), 1.0f, Edit);
	Editor.Assign(DRYDOCK_MEMBER(LocalExposureShadowContrastScale), 1.0f, Edit);
	Editor.Assign(DRYDOCK_MEMBER(LocalExposureDetailStrength), 1.0f, Edit);
}

void EndMotionBlur(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor)
{
	const float Scale = CVarMotionBlurScale.GetValueOnAnyThread();
	Editor.Assign(DRYDOCK_MEMBER(MotionBlurAmount), Settings.MotionBlurAmount * std::clamp(Scale, 0.0f, 50.0f),
		ByVariable("r.MotionBlur.Scale", "Scale", "scales it"));
	const float Amount = CVarMotionBlurAmount.GetValueOnAnyThread();
	if (Amount >= 0.0f)
	{
		Editor.Assign(
			DRYDOCK_MEMBER(MotionBlurAmount), Amount, ByVariable("r.MotionBlur.Amount", "Assign", "replaces it"));
	}
	const float Max = CVarMotionBlurMax.GetValueOnAnyThread();
	if (Max >= 0.0f)
	{
		Editor.Assign(DRYDOCK_MEMBER(MotionBlurMax), Max, ByVariable("r.MotionBlur.Max", "Assign", "replaces it"));
	}
	const int32 TargetFPS = CVarMotionBlurTargetFPS.GetValueOnAnyThread();
	if (TargetFPS >= 0)
	{
		Editor.Assign(DRYDOCK_MEMBER(MotionBlurTargetFPS), TargetFPS,
			ByVariable("r.MotionBlur.TargetFPS", "Assign", "replaces it"));
	}
}

} // namespace

std::vector<FSettingGate> ApplyShowFlags(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FBlendLedger* Ledger)
{
	FSettingsEditor Editor(Settings, Ledger);
	EndFlags(Settings, ShowFlags, Editor);
	if (!ShowFlags.LocalExposure)
	{
		EndLocalExposure(Settings, Editor, ByFlag("ShowFlag.LocalExposure"));
	}
	return Editor.Gates;
}

std::vector<FSettingGate> EndFinalPostProcessSettings(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FBlendLedger* Ledger)
{
	FSettingsEditor Editor(Settings, Ledger);
	EndQualities(Settings, Editor);
	if (CVarLocalExposure.GetValueOnAnyThread() <= 0)
	{
		EndLocalExposure(Settings, Editor, ByVariable("r.LocalExposure", "Assign", "is 0"));
	}
	const std::vector<FSettingGate> ByFlags = ApplyShowFlags(Settings, ShowFlags, Ledger);
	Editor.Gates.insert(Editor.Gates.end(), ByFlags.begin(), ByFlags.end());
	EndFringe(Settings, Editor);
	EndMotionBlur(Settings, Editor);
	Editor.Assign(DRYDOCK_MEMBER(AutoExposureBias),
		Settings.AutoExposureBias + CVarExposureOffset.GetValueOnAnyThread(),
		ByVariable("r.ExposureOffset", "Add", "is added"));
	return Editor.Gates;
}

} // namespace Drydock
