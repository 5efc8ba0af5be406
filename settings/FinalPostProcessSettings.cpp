// Source: engine SceneView.cpp (StartFinalPostprocessSettings, OverridePostProcessSettings,
// EndFinalPostprocessSettings).
#include "FinalPostProcessSettings.h"

#include "BlendSource.h"
#include "HAL/IConsoleManager.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace
{

using namespace Drydock;

TAutoConsoleVariable<int32> CVarDefaultBloom(TEXT("r.DefaultFeature.Bloom"), 1,
	TEXT("0: BloomIntensity is 0 unless a volume or the camera sets it."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarDefaultAutoExposure(TEXT("r.DefaultFeature.AutoExposure"), 1,
	TEXT("0: the eye does not adapt (least and greatest brightness 1) unless a volume or the camera says so."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarDefaultAutoExposureMethod(TEXT("r.DefaultFeature.AutoExposure.Method"), 0,
	TEXT("Default of AutoExposureMethod. 0: histogram (default). 1: basic. 2: manual."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarDefaultExtendLuminanceRange(
	TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"), 0,
	TEXT("1: default brightness and histogram range are -10 to 20, in EV100. 0: 0.03 to 8 in luminance, -8 to 4 in its "
		 "logarithm (default)."),
	ECVF_RenderThreadSafe);

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

/** Variables that belong to passes above this storey; Default where their storey is not there. */
float GetVariableOfPasses(const TCHAR* Name, float Default)
{
	const IConsoleVariable* Variable = IConsoleManager::Get().FindConsoleVariable(Name);
	return Variable != nullptr ? Variable->GetFloat() : Default;
}

/** Who changes settings, by name, and what the entry in the ledger says. */
struct FEdit
{
	EBlendSource Kind;
	const char* Source; // "r.ExposureOffset"
	const char* Rule;   // "Add"
	std::string Reason; // "r.ExposureOffset is added"
};

FEdit ByVariable(const char* Name, const char* Rule, const char* Predicate)
{
	return {EBlendSource::Variable, Name, Rule, std::string(Name) + " " + Predicate};
}

FEdit ByFlag(const char* Name)
{
	return {EBlendSource::ShowFlag, Name, "Assign", std::string(Name) + " is off"};
}

/** Changes settings and writes down what really changed. */
class FSettingsEditor
{
public:
	FSettingsEditor(FFinalPostProcessSettings& InSettings, FBlendLedger* InLedger)
		: Settings(InSettings)
		, Ledger(InLedger)
	{
	}

	/** Value: the member of this name. */
	template<typename T>
	void Assign(const char* Name, T& Value, std::type_identity_t<T> NewValue, const FEdit& Edit)
	{
		if (Value == NewValue)
		{
			return;
		}
		Gates.push_back({Name, Edit.Reason});
		if (Ledger == nullptr)
		{
			Value = NewValue;
			return;
		}
		const size_t Index = static_cast<size_t>(FindSettingIndex(Name));
		const FSettingField& Field = GetSettingFields()[Index];
		const FSettingValue Before = Field.Get(Settings);
		Value = NewValue;
		Ledger->Add(Index, {Edit.Kind, Edit.Source, Edit.Rule, {}, {}, Before, Field.Get(Settings), ""});
	}

	void SwitchOff(bool bOff, const char* Name, float& Value, const FEdit& Edit)
	{
		if (bOff)
		{
			Assign(Name, Value, 0.0f, Edit);
		}
	}

	std::vector<FSettingGate> Gates;

private:
	FFinalPostProcessSettings& Settings;
	FBlendLedger* Ledger;
};

// A member and its name, which cannot differ.
#define DRYDOCK_MEMBER(Name) #Name, Settings.Name

/** Brightness and histogram range, in EV100 where the range is extended. */
void StartExposure(FFinalPostProcessSettings& Settings, FSettingsEditor& Editor)
{
	Editor.Assign(DRYDOCK_MEMBER(AutoExposureBias), CVarDefaultAutoExposureBias.GetValueOnAnyThread(),
		ByVariable("r.DefaultFeature.AutoExposure.Bias", "Assign", "is the default"));
	const bool bExtended = CVarDefaultExtendLuminanceRange.GetValueOnAnyThread() != 0;
	if (bExtended)
	{
		const FEdit Edit =
			ByVariable("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange", "Assign", "is on: EV100");
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMinBrightness), -10.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMaxBrightness), 20.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(HistogramLogMin), -10.0f, Edit);
		Editor.Assign(DRYDOCK_MEMBER(HistogramLogMax), 20.0f, Edit);
	}
	if (CVarDefaultAutoExposure.GetValueOnAnyThread() == 0)
	{
		// Luminance 1 in EV100 is log2(1 / LuminanceMax).
		const float Attenuation = GetVariableOfPasses(TEXT("r.EyeAdaptation.LensAttenuation"), 0.78f);
		const float LuminanceMax = 0.78f / std::max(Attenuation, 0.01f);
		const float Brightness = bExtended ? std::log2(1.0f / LuminanceMax) : 1.0f;
		const FEdit Edit = ByVariable("r.DefaultFeature.AutoExposure", "Assign", "is 0");
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMinBrightness), Brightness, Edit);
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMaxBrightness), Brightness, Edit);
		return;
	}
	const int32 Method = CVarDefaultAutoExposureMethod.GetValueOnAnyThread();
	if (Method >= 0 && Method < AEM_MAX)
	{
		Editor.Assign(DRYDOCK_MEMBER(AutoExposureMethod), static_cast<EAutoExposureMethod>(Method),
			ByVariable("r.DefaultFeature.AutoExposure.Method", "Assign", "is the default"));
	}
}

void EndFringe(FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FSettingsEditor& Editor)
{
	Editor.SwitchOff(CVarSceneColorFringeQuality.GetValueOnAnyThread() <= 0, DRYDOCK_MEMBER(SceneFringeIntensity),
		ByVariable("r.SceneColorFringeQuality", "Assign", "is 0"));
	Editor.SwitchOff(
		!ShowFlags.SceneColorFringe, DRYDOCK_MEMBER(SceneFringeIntensity), ByFlag("ShowFlag.SceneColorFringe"));
	Editor.SwitchOff(
		!ShowFlags.CameraImperfections, DRYDOCK_MEMBER(SceneFringeIntensity), ByFlag("ShowFlag.CameraImperfections"));
	Editor.SwitchOff(
		!ShowFlags.CameraImperfections, DRYDOCK_MEMBER(BloomDirtMaskIntensity), ByFlag("ShowFlag.CameraImperfections"));
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

} // namespace

namespace Drydock
{

FFinalPostProcessSettings StartFinalPostProcessSettings(FBlendLedger* Ledger, bool bEngine53)
{
	FFinalPostProcessSettings Settings;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (size_t Index = 0; Ledger != nullptr && Index < Fields.size(); ++Index)
	{
		Ledger->Add(
			Index, {EBlendSource::Default, "default", "", {}, {}, Fields[Index].Default, Fields[Index].Default, ""});
	}
	FSettingsEditor Editor(Settings, Ledger);
	Editor.SwitchOff(CVarDefaultBloom.GetValueOnAnyThread() == 0, DRYDOCK_MEMBER(BloomIntensity),
		ByVariable("r.DefaultFeature.Bloom", "Assign", "is 0"));
	StartExposure(Settings, Editor);
	static_cast<void>(bEngine53);
	return Settings;
}

void OverridePostProcessSettings(FFinalPostProcessSettings& Settings, const FPostProcessSettings& Source, float Weight)
{
	if (!(Weight > 0.0f))
	{
		return;
	}
	constexpr bool bMayOverflow = true;
	for (const uint32 Index : FindOverriddenFields(Source).Fields)
	{
		BlendField(GetSettingFields()[Index], Settings, Source, std::min(Weight, 1.0f), bMayOverflow);
	}
}

std::vector<FSettingGate> EndFinalPostProcessSettings(
	FFinalPostProcessSettings& Settings, const FEngineShowFlags& ShowFlags, FBlendLedger* Ledger)
{
	FSettingsEditor Editor(Settings, Ledger);
	Editor.SwitchOff(GetVariableOfPasses(TEXT("r.BloomQuality"), 5.0f) < 1.0f, DRYDOCK_MEMBER(BloomIntensity),
		ByVariable("r.BloomQuality", "Assign", "is 0"));
	Editor.SwitchOff(!ShowFlags.Bloom, DRYDOCK_MEMBER(BloomIntensity), ByFlag("ShowFlag.Bloom"));

	Editor.SwitchOff(CVarTonemapperQuality.GetValueOnAnyThread() < 2, DRYDOCK_MEMBER(VignetteIntensity),
		ByVariable("r.Tonemapper.Quality", "Assign", "is below 2"));
	Editor.SwitchOff(!ShowFlags.Vignette, DRYDOCK_MEMBER(VignetteIntensity), ByFlag("ShowFlag.Vignette"));
	Editor.SwitchOff(!ShowFlags.ToneCurve, DRYDOCK_MEMBER(ToneCurveAmount), ByFlag("ShowFlag.ToneCurve"));
	EndFringe(Settings, ShowFlags, Editor);
	Editor.Assign(DRYDOCK_MEMBER(AutoExposureBias),
		Settings.AutoExposureBias + CVarExposureOffset.GetValueOnAnyThread(),
		ByVariable("r.ExposureOffset", "Add", "is added"));
	return Editor.Gates;
}

std::vector<FSettingGate> RecordExtensionEdits(const FFinalPostProcessSettings& Before,
	FFinalPostProcessSettings& After, const std::string& Extension, FBlendLedger* Ledger)
{
	std::vector<FSettingGate> Gates;
	const std::vector<FSettingField>& Fields = GetSettingFields();
	for (size_t Index = 0; Index < Fields.size(); ++Index)
	{
		const FSettingValue Old = Fields[Index].Get(Before);
		const FSettingValue New = Fields[Index].Get(After);
		if (Old == New)
		{
			continue;
		}
		const bool bFinite = IsFinite(New);
		if (!bFinite)
		{
			Fields[Index].Set(After, Old);
		}
		Gates.push_back({Fields[Index].Name,
			Extension + (bFinite ? " set it" : " set it to a value that is not finite; it is put back")});
		if (Ledger != nullptr)
		{
			Ledger->Add(Index, {EBlendSource::Extension, Extension, "Assign", {}, {}, Old, bFinite ? New : Old,
								   bFinite ? "" : "the value is not finite"});
		}
	}
	return Gates;
}

#undef DRYDOCK_MEMBER

} // namespace Drydock
