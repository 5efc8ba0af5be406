// The settings of cameras, lenses and film as structs of their own, which export themselves to FPostProcessSettings.
// Each struct is a list of pairs, own member and field of the table: members have the field's type and default, and the
// export copies along the pairs. Source: engine Engine/Scene.h.
#pragma once

#include "PostProcessSettings.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Defaults, for members that are twins of a field. */
DRYDOCK_API const FPostProcessSettings& GetDefaultPostProcessSettings();

} // namespace Drydock

#define DRYDOCK_SUB_SETTING(Member, Field) \
	decltype(FPostProcessSettings::Field) Member = Drydock::GetDefaultPostProcessSettings().Field;

#define DRYDOCK_GAUSSIAN_SUM_BLOOM_SETTINGS(Each) \
	Each(Intensity, BloomIntensity) Each(Threshold, BloomThreshold) Each(SizeScale, BloomSizeScale) \
		Each(Filter1Size, Bloom1Size) Each(Filter2Size, Bloom2Size) Each(Filter3Size, Bloom3Size) \
			Each(Filter4Size, Bloom4Size) Each(Filter5Size, Bloom5Size) Each(Filter6Size, Bloom6Size) \
				Each(Filter1Tint, Bloom1Tint) Each(Filter2Tint, Bloom2Tint) Each(Filter3Tint, Bloom3Tint) \
					Each(Filter4Tint, Bloom4Tint) Each(Filter5Tint, Bloom5Tint) Each(Filter6Tint, Bloom6Tint) \
						Each(ToonIntensity, BloomToonIntensity)

#define DRYDOCK_CONVOLUTION_BLOOM_SETTINGS(Each) \
	Each(Intensity, BloomConvolutionIntensity) Each(Texture, BloomConvolutionTexture) \
		Each(ScatterDispersion, BloomConvolutionScatterDispersion) Each(Size, BloomConvolutionSize) \
			Each(CenterUV, BloomConvolutionCenterUV) Each(PreFilterMin, BloomConvolutionPreFilterMin) \
				Each(PreFilterMax, BloomConvolutionPreFilterMax) Each(PreFilterMult, BloomConvolutionPreFilterMult) \
					Each(BufferScale, BloomConvolutionBufferScale)

#define DRYDOCK_LENS_IMPERFECTION_SETTINGS(Each) \
	Each(DirtMask, BloomDirtMask) Each(DirtMaskIntensity, BloomDirtMaskIntensity) Each(DirtMaskTint, BloomDirtMaskTint)

#define DRYDOCK_FILM_STOCK_SETTINGS(Each) \
	Each(Slope, FilmSlope) Each(Toe, FilmToe) Each(Shoulder, FilmShoulder) Each(BlackClip, FilmBlackClip) \
		Each(WhiteClip, FilmWhiteClip)

#define DRYDOCK_FILM_GRAIN_SETTINGS(Each) \
	Each(Intensity, FilmGrainIntensity) Each(IntensityShadows, FilmGrainIntensityShadows) \
		Each(IntensityMidtones, FilmGrainIntensityMidtones) Each(IntensityHighlights, FilmGrainIntensityHighlights) \
			Each(ShadowsMax, FilmGrainShadowsMax) Each(HighlightsMin, FilmGrainHighlightsMin) \
				Each(HighlightsMax, FilmGrainHighlightsMax) Each(TexelSize, FilmGrainTexelSize) \
					Each(Texture, FilmGrainTexture)

/** All but the method, whose export is the engine's exception. */
#define DRYDOCK_CAMERA_EXPOSURE_SETTINGS(Each) \
	Each(LowPercent, AutoExposureLowPercent) Each(HighPercent, AutoExposureHighPercent) \
		Each(MinBrightness, AutoExposureMinBrightness) Each(MaxBrightness, AutoExposureMaxBrightness) \
			Each(SpeedUp, AutoExposureSpeedUp) Each(SpeedDown, AutoExposureSpeedDown) Each(Bias, AutoExposureBias) \
				Each(BiasCurve, AutoExposureBiasCurve) Each(MeterMask, AutoExposureMeterMask) \
					Each(HistogramLogMin, HistogramLogMin) Each(HistogramLogMax, HistogramLogMax) \
						Each(CalibrationConstant, AutoExposureCalibrationConstant) \
							Each(ApplyPhysicalCameraExposure, AutoExposureApplyPhysicalCameraExposure)

/** Bloom as a sum of Gaussians. ToonIntensity is the project's. */
struct DRYDOCK_API FGaussianSumBloomSettings
{
	DRYDOCK_GAUSSIAN_SUM_BLOOM_SETTINGS(DRYDOCK_SUB_SETTING)

	/** Sets every field that has a twin here, and its override bit. */
	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

/** Bloom by convolution with a picture. */
struct DRYDOCK_API FConvolutionBloomSettings
{
	DRYDOCK_CONVOLUTION_BLOOM_SETTINGS(DRYDOCK_SUB_SETTING)

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FLensBloomSettings
{
	FGaussianSumBloomSettings GaussianSum;
	FConvolutionBloomSettings Convolution;
	EBloomMethod Method = BM_SOG;

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FLensImperfectionSettings
{
	DRYDOCK_LENS_IMPERFECTION_SETTINGS(DRYDOCK_SUB_SETTING)

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FLensSettings
{
	FLensBloomSettings Bloom;
	FLensImperfectionSettings Imperfections;
	float ChromaticAberration = 0.0f; // %, exported as SceneFringeIntensity

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

/** Grading of one range of luminance: X, Y, Z per channel, W for all of them. */
struct FColorGradePerRangeSettings
{
	FVector4 Saturation = FVector4(1.0, 1.0, 1.0, 1.0);
	FVector4 Contrast = FVector4(1.0, 1.0, 1.0, 1.0);
	FVector4 Gamma = FVector4(1.0, 1.0, 1.0, 1.0);
	FVector4 Gain = FVector4(1.0, 1.0, 1.0, 1.0);
	FVector4 Offset = FVector4(0.0, 0.0, 0.0, 0.0);
};

struct DRYDOCK_API FColorGradingSettings
{
	FColorGradePerRangeSettings Global;
	FColorGradePerRangeSettings Shadows;
	FColorGradePerRangeSettings Midtones;
	FColorGradePerRangeSettings Highlights;
	DRYDOCK_SUB_SETTING(ShadowsMax, ColorCorrectionShadowsMax)
	DRYDOCK_SUB_SETTING(HighlightsMin, ColorCorrectionHighlightsMin)
	DRYDOCK_SUB_SETTING(HighlightsMax, ColorCorrectionHighlightsMax)

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FFilmStockSettings
{
	DRYDOCK_FILM_STOCK_SETTINGS(DRYDOCK_SUB_SETTING)

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FFilmGrainSettings
{
	DRYDOCK_FILM_GRAIN_SETTINGS(DRYDOCK_SUB_SETTING)

	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

struct DRYDOCK_API FCameraExposureSettings
{
	EAutoExposureMethod Method = AEM_Histogram;
	DRYDOCK_CAMERA_EXPOSURE_SETTINGS(DRYDOCK_SUB_SETTING)

	/** As in the engine, the override bit of AutoExposureMethod is set, but Method is not copied. */
	void ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const;
};

#undef DRYDOCK_SUB_SETTING

namespace Drydock
{

struct FSettingField;

/** The engine's self-check at its first start: every field Bloom... of the table has a twin in the bloom structs, named
 * without the prefix (Bloom1Size: Filter1Size). Names the fields that have none; the engine stops instead. */
DRYDOCK_API std::vector<std::string> FindBloomFieldsWithoutTwin(const std::vector<FSettingField>& Fields);

} // namespace Drydock
