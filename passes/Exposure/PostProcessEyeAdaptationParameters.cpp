// Settings and console variables of metering and adaptation. Source: engine file PostProcessEyeAdaptation.cpp.
#include "Exposure/PostProcessEyeAdaptationParameters.h"

#include "CurveKeys.h"
#include "HAL/IConsoleManager.h"
#include "SceneRendering.h"
#include "SceneViewState.h"

#include <cmath>
#include <cstring>
#include <optional>

namespace
{

TAutoConsoleVariable<int32> CVarEyeAdaptationQuality(TEXT("r.EyeAdaptationQuality"), 2,
	TEXT("Metering while view.exposure is \"auto\". 0: exposure scale 1. 1: basic metering in place of the histogram. "
		 "2: as the settings say (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarMethodOverride(TEXT("r.EyeAdaptation.MethodOverride"), -1,
	TEXT("-1: AutoExposureMethod (default). 1: histogram. 2: basic. 3: manual."), ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarLensAttenuation(TEXT("r.EyeAdaptation.LensAttenuation"), 0.78f,
	TEXT("Part of the light that the lens lets through: EV100 0 is luminance 0.78 over this (default 0.78)."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarExponentialTransitionDistance(TEXT("r.EyeAdaptation.ExponentialTransitionDistance"),
	1.5f, TEXT("Nearer to its target than this, in EV, adaptation slows down exponentially (default 1.5)."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarBlackHistogramBucketInfluence(TEXT("r.EyeAdaptation.BlackHistogramBucketInfluence"),
	0.0f, TEXT("Weight of the histogram's lowest bucket: 0 leaves black out (default), 1 counts it."),
	ECVF_RenderThreadSafe);

/** Exponents up to this keep 2^x and its reciprocal normal floats. */
constexpr float LargestExponent = 60.0f;

float ClampedExp2(float Exponent)
{
	return std::exp2(FMath::Clamp(Exponent, -LargestExponent, LargestExponent));
}

/** Brightness settings and the histogram's range are EV100. */
bool IsLuminanceRangeExtended()
{
	const IConsoleVariable* const Variable =
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.DefaultFeature.AutoExposure.ExtendDefaultLuminanceRange"));
	return Variable != nullptr && Variable->GetInt() != 0;
}

/** Makes the exponential speed equal the linear one at the distance where it begins, for a frame of 1/60 s. */
float ComputeExponentialM(float Speed, float StartDistance)
{
	constexpr float FrameTime = 1.0f / 60.0f;
	const float Positive = FMath::Max(Speed, 0.001f);
	return FrameTime / ((1.0f - std::exp2(-FrameTime * Positive)) * (StartDistance / Positive));
}

/** The last frame's average, in scene units; 0 without a last frame. */
float GetLastAverageLuminance(const FViewInfo& View)
{
	if (View.ViewState == nullptr)
	{
		return 0.0f;
	}
	const auto& Buffers = View.ViewState->GetLast().Buffers;
	const auto Found = Buffers.find(Drydock::EyeAdaptationName);
	if (Found == Buffers.end())
	{
		return 0.0f;
	}
	FVector4f Entry;
	std::memcpy(&Entry, Found->second->GetRHI()->GetData(), sizeof(Entry));
	return Entry.Z;
}

} // namespace

EAutoExposureMethod GetAutoExposureMethod(const FFinalPostProcessSettings& Settings)
{
	EAutoExposureMethod Method = Settings.AutoExposureMethod;
	switch (CVarMethodOverride.GetValueOnAnyThread())
	{
	case 1:
		Method = AEM_Histogram;
		break;
	case 2:
		Method = AEM_Basic;
		break;
	case 3:
		Method = AEM_Manual;
		break;
	default:
		break;
	}
	return Method == AEM_Histogram && CVarEyeAdaptationQuality.GetValueOnAnyThread() == 1 ? AEM_Basic : Method;
}

namespace Drydock
{

bool IsEyeAdaptationAllowed()
{
	return CVarEyeAdaptationQuality.GetValueOnAnyThread() > 0;
}

float GetManualExposureEV100(const FFinalPostProcessSettings& Settings)
{
	if (!Settings.AutoExposureApplyPhysicalCameraExposure)
	{
		return 0.0f;
	}
	const float Fstop = Settings.DepthOfFieldFstop;
	const float Light = Fstop * Fstop * Settings.CameraShutterSpeed * 100.0f / FMath::Max(1.0f, Settings.CameraISO);
	return std::log2(FMath::Max(Light, 1.0e-10f));
}

float GetEyeAdaptationLuminanceMax()
{
	return 0.78f / FMath::Max(CVarLensAttenuation.GetValueOnAnyThread(), 0.01f);
}

float LuminanceToEV100(float Luminance)
{
	return std::log2(Luminance / GetEyeAdaptationLuminanceMax());
}

float GetExposureCompensationFromCurve(const FFinalPostProcessSettings& Settings, float AverageLuminance)
{
	const std::optional<FRichCurve> Curve = FindCurveKeys(Settings.AutoExposureBiasCurve);
	if (!Curve || !(AverageLuminance > 0.0f))
	{
		return 1.0f;
	}
	// Together with the bias still far from where a scale of 10^4 times it is infinite.
	return std::exp2(FMath::Clamp(Curve->Eval(LuminanceToEV100(AverageLuminance)), -30.0f, 30.0f));
}

FVector2f GetHistogramLogRange(const FFinalPostProcessSettings& Settings, EAutoExposureMethod Method)
{
	if (Method == AEM_Basic)
	{
		return FVector2f(-10.0f, 20.0f);
	}
	const float Shift = IsLuminanceRangeExtended() ? std::log2(GetEyeAdaptationLuminanceMax()) : 0.0f;
	const float Max = Settings.HistogramLogMax;
	const float Low = FMath::Min(Settings.HistogramLogMin, Max - 1.0f) + Shift;
	// Far out a float and the one below by 1 are the same, and the range would be none.
	const float High = FMath::Clamp(Max + Shift, 1.0f - LargestExponent, LargestExponent);
	return FVector2f(FMath::Clamp(Low, -LargestExponent, High - 1.0f), High);
}

} // namespace Drydock

FEyeAdaptationParameters GetEyeAdaptationParameters(
	const FViewInfo& View, EAutoExposureMethod Method, bool bForceTarget)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const bool bExtended = IsLuminanceRangeExtended();
	const float LuminanceMax = bExtended ? Drydock::GetEyeAdaptationLuminanceMax() : 1.0f;

	FEyeAdaptationParameters Parameters;
	const float LowPercent = FMath::Clamp(Settings.AutoExposureLowPercent, 1.0f, 99.0f);
	const float HighPercent = FMath::Clamp(Settings.AutoExposureHighPercent, LowPercent, 99.0f);
	Parameters.ExposureLowPercent = LowPercent * 0.01f;
	Parameters.ExposureHighPercent = HighPercent * 0.01f;

	float MinWhite = FMath::Max(Settings.AutoExposureMinBrightness, 0.0f);
	float MaxWhite = FMath::Max(Settings.AutoExposureMaxBrightness, 0.0f);
	if (Method == AEM_Manual)
	{
		MinWhite = MaxWhite = LuminanceMax * ClampedExp2(Drydock::GetManualExposureEV100(Settings));
	}
	else if (bExtended)
	{
		MinWhite = LuminanceMax * ClampedExp2(Settings.AutoExposureMinBrightness);
		MaxWhite = LuminanceMax * ClampedExp2(Settings.AutoExposureMaxBrightness);
	}
	const bool bNoRange = !(MinWhite < MaxWhite);
	Parameters.MinAverageLuminance = MinWhite * 0.18f;
	Parameters.MaxAverageLuminance = (bNoRange ? MinWhite : MaxWhite) * 0.18f;
	Parameters.ExposureCompensationSettings = ClampedExp2(Settings.AutoExposureBias);
	Parameters.ExposureCompensationCurve = Drydock::GetExposureCompensationFromCurve(
		Settings, Method == AEM_Manual ? Parameters.MinAverageLuminance : GetLastAverageLuminance(View));

	Parameters.DeltaWorldTime =
		View.Family != nullptr ? FMath::Max(View.Family->Time.GetDeltaWorldTimeSeconds(), 0.0f) : 0.0f;
	Parameters.ExposureSpeedUp = Settings.AutoExposureSpeedUp;
	Parameters.ExposureSpeedDown = Settings.AutoExposureSpeedDown;
	Parameters.StartDistance = FMath::Max(CVarExponentialTransitionDistance.GetValueOnRenderThread(), 0.001f);
	Parameters.ExponentialUpM = ComputeExponentialM(Settings.AutoExposureSpeedUp, Parameters.StartDistance);
	Parameters.ExponentialDownM = ComputeExponentialM(Settings.AutoExposureSpeedDown, Parameters.StartDistance);

	const FVector2f Range = Drydock::GetHistogramLogRange(Settings, Method);
	Parameters.HistogramScale = 1.0f / (Range.Y - Range.X);
	Parameters.HistogramBias = -Range.X * Parameters.HistogramScale;
	Parameters.LuminanceMin = Method == AEM_Basic ? 1.0e-4f : ClampedExp2(Range.X);
	Parameters.BlackHistogramBucketInfluence =
		FMath::Clamp(CVarBlackHistogramBucketInfluence.GetValueOnRenderThread(), 0.0f, 1.0f);

	const bool bNegativeSpeed = Settings.AutoExposureSpeedUp < 0.0f || Settings.AutoExposureSpeedDown < 0.0f;
	const bool bSnap = bForceTarget || View.bCameraCut || Method == AEM_Manual || bNoRange || bNegativeSpeed;
	Parameters.ForceTarget = bSnap ? 1.0f : 0.0f;
	return Parameters;
}
