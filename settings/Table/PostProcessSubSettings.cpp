// Exports of the lens, film and camera structs, along their lists of pairs. Source: engine Scene.cpp
// (ExportToPostProcessSettings, the check of bloom settings in FPostProcessSettings).
#include "PostProcessSubSettings.h"

#include "PostProcessSettingsReflection.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <string_view>

#define DRYDOCK_EXPORT_VALUE(Field, Value) \
	OutPostProcessSettings->bOverride_##Field = 1; \
	OutPostProcessSettings->Field = Value;
#define DRYDOCK_EXPORT(Member, Field) DRYDOCK_EXPORT_VALUE(Field, Member)

void FGaussianSumBloomSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_GAUSSIAN_SUM_BLOOM_SETTINGS(DRYDOCK_EXPORT)
}

void FConvolutionBloomSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_CONVOLUTION_BLOOM_SETTINGS(DRYDOCK_EXPORT)
}

void FLensBloomSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	GaussianSum.ExportToPostProcessSettings(OutPostProcessSettings);
	Convolution.ExportToPostProcessSettings(OutPostProcessSettings);
	DRYDOCK_EXPORT_VALUE(BloomMethod, Method)
}

void FLensImperfectionSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_LENS_IMPERFECTION_SETTINGS(DRYDOCK_EXPORT)
}

void FLensSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	Bloom.ExportToPostProcessSettings(OutPostProcessSettings);
	Imperfections.ExportToPostProcessSettings(OutPostProcessSettings);
	DRYDOCK_EXPORT_VALUE(SceneFringeIntensity, ChromaticAberration)
}

#define DRYDOCK_EXPORT_RANGE(Range, Suffix) \
	DRYDOCK_EXPORT_VALUE(ColorSaturation##Suffix, Range.Saturation) \
	DRYDOCK_EXPORT_VALUE(ColorContrast##Suffix, Range.Contrast) \
	DRYDOCK_EXPORT_VALUE(ColorGamma##Suffix, Range.Gamma) \
	DRYDOCK_EXPORT_VALUE(ColorGain##Suffix, Range.Gain) \
	DRYDOCK_EXPORT_VALUE(ColorOffset##Suffix, Range.Offset)

void FColorGradingSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_EXPORT_RANGE(Global, )
	DRYDOCK_EXPORT_RANGE(Shadows, Shadows)
	DRYDOCK_EXPORT_RANGE(Midtones, Midtones)
	DRYDOCK_EXPORT_RANGE(Highlights, Highlights)
	DRYDOCK_EXPORT(ShadowsMax, ColorCorrectionShadowsMax)
	DRYDOCK_EXPORT(HighlightsMin, ColorCorrectionHighlightsMin)
	DRYDOCK_EXPORT(HighlightsMax, ColorCorrectionHighlightsMax)
}

#undef DRYDOCK_EXPORT_RANGE

void FFilmStockSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_FILM_STOCK_SETTINGS(DRYDOCK_EXPORT)
}

void FFilmGrainSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	DRYDOCK_FILM_GRAIN_SETTINGS(DRYDOCK_EXPORT)
}

void FCameraExposureSettings::ExportToPostProcessSettings(FPostProcessSettings* OutPostProcessSettings) const
{
	OutPostProcessSettings->bOverride_AutoExposureMethod = 1;
	DRYDOCK_CAMERA_EXPOSURE_SETTINGS(DRYDOCK_EXPORT)
}

#undef DRYDOCK_EXPORT
#undef DRYDOCK_EXPORT_VALUE

namespace Drydock
{

namespace
{

#define DRYDOCK_MEMBER_NAME(Member, Field) #Member,

const std::vector<std::string> GaussianSumAndImperfectionMembers = {DRYDOCK_GAUSSIAN_SUM_BLOOM_SETTINGS(
	DRYDOCK_MEMBER_NAME) DRYDOCK_LENS_IMPERFECTION_SETTINGS(DRYDOCK_MEMBER_NAME) "Method"};

const std::vector<std::string> ConvolutionMembers = {DRYDOCK_CONVOLUTION_BLOOM_SETTINGS(DRYDOCK_MEMBER_NAME)};

#undef DRYDOCK_MEMBER_NAME

bool HasTwin(const std::string& Field)
{
	const bool bConvolution = Field.starts_with("BloomConvolution");
	std::string Twin = Field.substr(std::string(bConvolution ? "BloomConvolution" : "Bloom").size());
	if (!Twin.empty() && IsDigit(Twin[0]))
	{
		Twin = "Filter" + Twin;
	}
	const std::vector<std::string>& Members = bConvolution ? ConvolutionMembers : GaussianSumAndImperfectionMembers;
	return Contains(Members, Twin);
}

} // namespace

const FPostProcessSettings& GetDefaultPostProcessSettings()
{
	static const FPostProcessSettings Defaults;
	return Defaults;
}

std::vector<std::string> FindBloomFieldsWithoutTwin(const std::vector<FSettingField>& Fields)
{
	std::vector<std::string> Missing;
	for (const FSettingField& Field : Fields)
	{
		if (std::string_view(Field.Name).starts_with("Bloom") && !HasTwin(Field.Name))
		{
			Missing.emplace_back(Field.Name);
		}
	}
	return Missing;
}

} // namespace Drydock
