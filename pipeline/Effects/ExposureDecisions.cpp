// Source: drydock.
#include "Effects/ExposureDecisions.h"

#include "Exposure/PostProcessEyeAdaptation.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "Screen/TextureAssets.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Why a config's "auto" is not followed, or nothing. */
std::string GetObstacle(const FChainSettings& Chain)
{
	if (!Chain.ShowFlags.PostProcessing)
	{
		return "ShowFlag.PostProcessing is off";
	}
	if (!Chain.ShowFlags.EyeAdaptation)
	{
		return "ShowFlag.EyeAdaptation is off";
	}
	return IsEyeAdaptationAllowed() ? "" : "r.EyeAdaptationQuality is 0";
}

/** What a mask that is asked for does not do, or nothing. */
std::string DescribeMask(const FFinalPostProcessSettings& Settings)
{
	const UTexture* const Mask = Settings.AutoExposureMeterMask;
	const bool bMissing = Mask != nullptr && !FindTexturePixels(Mask);
	return bMissing ? "; AutoExposureMeterMask is no image file and has no pixels here" : "";
}

std::string DescribeMethod(const FFinalPostProcessSettings& Settings)
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

/** ": r.LocalExposure is 0", or nothing. */
std::string FindGate(const FChainSettings& Chain)
{
	for (const FSettingGate& Gate : Chain.Gates)
	{
		if (Gate.Setting.rfind("LocalExposure", 0) == 0)
		{
			return ": " + Gate.Reason;
		}
	}
	return "";
}

} // namespace

std::string GetAutoExposureMethodName(EAutoExposureMethod Method)
{
	switch (Method)
	{
	case AEM_Basic:
		return "AEM_Basic";
	case AEM_Manual:
		return "AEM_Manual";
	default:
		return "AEM_Histogram";
	}
}

bool IsAutoExposureActive(const FChainSettings& Chain)
{
	return Chain.bAutoExposure && GetObstacle(Chain).empty();
}

FEffectDecision DecideExposure(const FChainSettings& Chain)
{
	if (IsAutoExposureActive(Chain))
	{
		return {"Exposure", true, true, DescribeMethod(Chain.Settings)};
	}
	FEffectDecision Fixed{"Exposure", true, true, "scale " + NumberText(Chain.ExposureScale)};
	if (Chain.bAutoExposure)
	{
		Fixed.Reason += ", not \"auto\": " + GetObstacle(Chain);
	}
	else if (!Chain.ShowFlags.EyeAdaptation)
	{
		Fixed.Reason += ": ShowFlag.EyeAdaptation is off";
	}
	return Fixed;
}

FEffectDecision DecideLocalExposure(const FChainSettings& Chain)
{
	const FFinalPostProcessSettings& Settings = Chain.Settings;
	const bool bNamed = std::any_of(Chain.NamedSettings.begin(), Chain.NamedSettings.end(),
		[](const std::string& Name) { return Name.rfind("LocalExposure", 0) == 0; });
	FEffectDecision Decision{"LocalExposure", false, bNamed, ""};
	if (!Chain.ShowFlags.PostProcessing)
	{
		Decision.Reason = "ShowFlag.PostProcessing is off";
		return Decision;
	}
	if (!IsLocalExposureEnabled(Settings) && !(Chain.bNoSkip && bNamed))
	{
		Decision.Reason = "its contrast scales and detail strength are 1" + FindGate(Chain);
		return Decision;
	}
	Decision.bActive = Decision.bConfigured = true;
	Decision.Reason = "contrast of highlights " + NumberText(Settings.LocalExposureHighlightContrastScale) +
					  ", of shadows " + NumberText(Settings.LocalExposureShadowContrastScale) + ", detail " +
					  NumberText(Settings.LocalExposureDetailStrength);
	if (Settings.LocalExposureMethod != ELocalExposureMethod::Bilateral)
	{
		Decision.Reason += "; fusion is not built, the bilateral grid runs";
	}
	return Decision;
}

} // namespace Drydock
