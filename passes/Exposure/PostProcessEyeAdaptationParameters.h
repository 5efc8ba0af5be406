// Turns settings and console variables into the parameters of metering and adapting the exposure, for the shaders of
// PostProcessEyeAdaptation.h and of local exposure. Source: engine file PostProcessEyeAdaptation.h.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettingsEnums.h"
#include "ShaderParameterMacros.h"

class FViewInfo;
struct FFinalPostProcessSettings;

/** Parameters of metering and adaptation. Luminances are in scene units. */
BEGIN_SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, DRYDOCK_API)
	SHADER_PARAMETER(float, ExposureLowPercent)  // 0.01 .. 0.99
	SHADER_PARAMETER(float, ExposureHighPercent) // 0.01 .. 0.99, at least the low one
	SHADER_PARAMETER(float, MinAverageLuminance)
	SHADER_PARAMETER(float, MaxAverageLuminance)
	SHADER_PARAMETER(float, ExposureCompensationSettings) // 2^bias
	SHADER_PARAMETER(float, ExposureCompensationCurve)
	SHADER_PARAMETER(float, DeltaWorldTime)    // s
	SHADER_PARAMETER(float, ExposureSpeedUp)   // EV per second, as the scene gets brighter
	SHADER_PARAMETER(float, ExposureSpeedDown) // as it gets darker
	SHADER_PARAMETER(float, StartDistance)     // EV
	SHADER_PARAMETER(float, ExponentialUpM)
	SHADER_PARAMETER(float, ExponentialDownM)
	SHADER_PARAMETER(float, HistogramScale) // position in the range = log2 luminance * scale + bias
	SHADER_PARAMETER(float, HistogramBias)
	SHADER_PARAMETER(float, LuminanceMin)
	SHADER_PARAMETER(float, BlackHistogramBucketInfluence)
	SHADER_PARAMETER(float, ForceTarget) // 1: no adaptation
END_SHADER_PARAMETER_STRUCT()

/** The method that the settings and r.EyeAdaptation.MethodOverride, r.EyeAdaptationQuality choose. */
DRYDOCK_API EAutoExposureMethod GetAutoExposureMethod(const FFinalPostProcessSettings& Settings);

/** Time is that of View.Family. bForceTarget: there is no last frame to start from. ExposureCompensationCurve is that
 * of the last frame's average luminance, as in the engine; of the camera's, where the method is manual; 1 where there
 * is neither. */
DRYDOCK_API FEyeAdaptationParameters GetEyeAdaptationParameters(
	const FViewInfo& View, EAutoExposureMethod Method, bool bForceTarget);

namespace Drydock
{

/** r.EyeAdaptationQuality is not 0. */
DRYDOCK_API bool IsEyeAdaptationAllowed();

/** EV100 of the camera's settings: log2(f-stop^2 * shutter speed * 100 / ISO); 0 where they are not applied. */
DRYDOCK_API float GetManualExposureEV100(const FFinalPostProcessSettings& Settings);

/** r.EyeAdaptation.LensAttenuation: the luminance at EV100 0, 0.78 / attenuation. */
DRYDOCK_API float GetEyeAdaptationLuminanceMax();

/** The EV100 of a luminance in scene units. */
DRYDOCK_API float LuminanceToEV100(float Luminance);

/** 2 to the power of AutoExposureBiasCurve at the EV100 of an average luminance; 1 where the curve has no keys
 * (CurveKeys.h) or the luminance is not above 0. Above 0 and finite. */
DRYDOCK_API float GetExposureCompensationFromCurve(const FFinalPostProcessSettings& Settings, float AverageLuminance);

/** log2 luminance of both ends of the histogram's range, within -60 .. 60 and x below y by 1 at least, whatever the
 * settings say: where they are an empty or inverted range, y is theirs. Basic metering has -10 and 20. */
DRYDOCK_API FVector2f GetHistogramLogRange(const FFinalPostProcessSettings& Settings, EAutoExposureMethod Method);

} // namespace Drydock
