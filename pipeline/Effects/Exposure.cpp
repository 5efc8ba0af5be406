// Exposure: the scale that scene colour is multiplied by, a number or metered from the picture. Source: engine
// PostProcess/PostProcessing.cpp (conditions); the wording is drydock's.
#include "Effects/Exposure.h"

#include "Exposure/PostProcessEyeAdaptation.h"
#include "Screen/TextureAssets.h"
#include "Text/TextFormat.h"

#include <cmath>

namespace Drydock
{

namespace
{

constexpr FSettingClaim ExposureSettings[] = {
	{"AutoExposure"},
	{"AutoExposureBiasBackup", NoPassReadsIt},
	{"AutoExposureCalibrationConstant", NoPassReadsIt},
	{"Histogram"},
	{"Camera"},
};

/** Why a config's "auto" is not followed, or nothing. */
std::string GetObstacle(const FViewConditions& Conditions)
{
	return !Conditions.ShowFlags.PostProcessing  ? "ShowFlag.PostProcessing is off"
		   : !Conditions.ShowFlags.EyeAdaptation ? "ShowFlag.EyeAdaptation is off"
		   : IsEyeAdaptationAllowed()            ? ""
												 : "r.EyeAdaptationQuality is 0";
}

/** The reason why a requested mask has no effect, or nothing. */
std::string DescribeMask(const FFinalPostProcessSettings& Settings)
{
	const UTexture* const Mask = Settings.AutoExposureMeterMask;
	const bool bMissing = Mask != nullptr && !FindTexturePixels(Mask);
	return bMissing ? "; AutoExposureMeterMask is not an image file and has no pixels here" : "";
}

std::string DescribeExposureMethod(const FFinalPostProcessSettings& Settings)
{
	const EAutoExposureMethod Method = GetAutoExposureMethod(Settings);
	std::string Text = GetAutoExposureMethodName(Method);
	if (Method != Settings.AutoExposureMethod)
	{
		Text += " in place of " + GetAutoExposureMethodName(Settings.AutoExposureMethod) + " (console variables)";
	}
	if (Method == AEM_Manual)
	{
		const float EV100 = std::round(GetManualExposureEV100(Settings) * 100.0f) / 100.0f;
		return Text + ": EV100 " + NumberText(EV100) +
			   (Settings.AutoExposureApplyPhysicalCameraExposure ? " by the camera's settings"
																 : ", the camera's settings are not applied");
	}
	return Text + ": AutoExposureMinBrightness " + NumberText(Settings.AutoExposureMinBrightness) + ", MaxBrightness " +
		   NumberText(Settings.AutoExposureMaxBrightness) + ", AutoExposureBias " +
		   NumberText(Settings.AutoExposureBias) + DescribeMask(Settings);
}

FEffectDecision DecideExposure(const FEffect&, const FEffectInputs& Inputs)
{
	const FViewConditions& Conditions = Inputs.Conditions;
	FEffectDecision Decision;
	Decision.bActive = Decision.bConfigured = true;
	if (IsAutoExposureActive(Conditions))
	{
		Decision.Reason = DescribeExposureMethod(Inputs.Settings);
		return Decision;
	}
	Decision.Reason = "scale " + NumberText(Conditions.ExposureScale);
	if (Conditions.bAutoExposure)
	{
		Decision.Reason += ", not \"auto\": " + GetObstacle(Conditions);
	}
	else if (!Conditions.ShowFlags.EyeAdaptation)
	{
		Decision.Reason += ": ShowFlag.EyeAdaptation is off";
	}
	return Decision;
}

} // namespace

std::string GetAutoExposureMethodName(EAutoExposureMethod Method)
{
	return Method == AEM_Basic ? "AEM_Basic" : Method == AEM_Manual ? "AEM_Manual" : "AEM_Histogram";
}

bool IsAutoExposureActive(const FViewConditions& Conditions)
{
	return Conditions.bAutoExposure && GetObstacle(Conditions).empty();
}

bool IsMeteringSetting(std::string_view Name)
{
	return (Name.starts_with("AutoExposure") && (!Name.starts_with("AutoExposureBias") || Name.ends_with("Curve"))) ||
		   Name.starts_with("Histogram") || Name.starts_with("Camera");
}

const FEffect GExposureEffect{
	.Id = EEffect::Exposure,
	.Name = "Exposure",
	.Doc = "The scale of scene colour: a number, or metered from the picture.",
	.Settings = ExposureSettings,
	.bMayBrightenBeforeBloom = false, // the gate of bloom knows the scale, or that it is not known
	.Decide = &DecideExposure,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::Exposure}; },
	.AddPasses = nullptr,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
