// Settings of lenses, film and cameras: their exports, and the self-check of bloom's twins.
#include <gtest/gtest.h>

#include "Engine/Scene.h"
#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"

#include <algorithm>
#include <set>

using namespace Drydock;

namespace
{

std::set<std::string> GetOverridden(const FPostProcessSettings& Settings)
{
	std::set<std::string> Names;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (Field.IsOverridden(Settings))
		{
			Names.insert(Field.Name);
		}
	}
	return Names;
}

template<typename T>
FPostProcessSettings Export(const T& Struct)
{
	FPostProcessSettings Settings;
	Struct.ExportToPostProcessSettings(&Settings);
	return Settings;
}

/** Overridden fields are those whose names begin with Prefix, without the ones listed. */
void ExpectOverriddenAreThoseOf(const FPostProcessSettings& Settings, const std::string& Prefix,
	const std::set<std::string>& Except, const std::set<std::string>& Also = {})
{
	std::set<std::string> Expected = Also;
	for (const FSettingField& Field : GetSettingFields())
	{
		if (std::string(Field.Name).starts_with(Prefix) && Except.count(Field.Name) == 0)
		{
			Expected.insert(Field.Name);
		}
	}
	EXPECT_EQ(Expected, GetOverridden(Settings));
}

template<typename T>
void ExpectDefaultsAreTheTables(const T& Struct)
{
	const FPostProcessSettings Settings = Export(Struct);
	for (const FSettingField& Field : GetSettingFields())
	{
		EXPECT_EQ(Field.Default, Field.Get(Settings)) << Field.Name;
	}
}

} // namespace

TEST(SubSettings, DefaultsAreTheTables)
{
	ExpectDefaultsAreTheTables(FLensSettings());
	ExpectDefaultsAreTheTables(FColorGradingSettings());
	ExpectDefaultsAreTheTables(FFilmStockSettings());
	ExpectDefaultsAreTheTables(FFilmGrainSettings());
	ExpectDefaultsAreTheTables(FCameraExposureSettings());
}

TEST(SubSettings, GaussianSumExportsItself)
{
	FGaussianSumBloomSettings Bloom;
	Bloom.Intensity = 2.0f;
	Bloom.Threshold = 0.5f;
	Bloom.SizeScale = 3.0f;
	Bloom.Filter1Size = 1.5f;
	Bloom.Filter6Size = 6.5f;
	Bloom.Filter2Tint = FLinearColor(1.0f, 2.0f, 3.0f, 4.0f);
	const FPostProcessSettings Settings = Export(Bloom);
	EXPECT_EQ(2.0f, Settings.BloomIntensity);
	EXPECT_EQ(0.5f, Settings.BloomThreshold);
	EXPECT_EQ(3.0f, Settings.BloomSizeScale);
	EXPECT_EQ(1.5f, Settings.Bloom1Size);
	EXPECT_EQ(6.5f, Settings.Bloom6Size);
	EXPECT_EQ(FLinearColor(1.0f, 2.0f, 3.0f, 4.0f), Settings.Bloom2Tint);
}

TEST(SubSettings, ToonIntensityIsTheTwinOfBloomToonIntensity)
{
	FGaussianSumBloomSettings Bloom;
	EXPECT_EQ(0.675f, Bloom.ToonIntensity);
	Bloom.ToonIntensity = 0.25f;
	EXPECT_EQ(0.25f, Export(Bloom).BloomToonIntensity);
	EXPECT_TRUE(Export(Bloom).bOverride_BloomToonIntensity);
}

TEST(SubSettings, LensExportsAllBloomAndTheFringe)
{
	FLensSettings Lens;
	Lens.Bloom.Method = BM_FFT;
	Lens.Bloom.Convolution.CenterUV = FVector2D(0.25, 0.75);
	Lens.Bloom.Convolution.Texture = FindOrAddTexture("/Game/Kernel.Kernel");
	Lens.Imperfections.DirtMask = FindOrAddTexture("/Game/Dirt.Dirt");
	Lens.ChromaticAberration = 2.5f;
	const FPostProcessSettings Settings = Export(Lens);
	EXPECT_EQ(BM_FFT, Settings.BloomMethod);
	EXPECT_EQ(FVector2D(0.25, 0.75), Settings.BloomConvolutionCenterUV);
	EXPECT_EQ(FindOrAddTexture("/Game/Kernel.Kernel"), Settings.BloomConvolutionTexture);
	EXPECT_EQ(FindOrAddTexture("/Game/Dirt.Dirt"), Settings.BloomDirtMask);
	EXPECT_EQ(2.5f, Settings.SceneFringeIntensity);
	ExpectOverriddenAreThoseOf(Settings, "Bloom", {}, {"SceneFringeIntensity"});
}

TEST(SubSettings, ColorGradingExportsRanges)
{
	FColorGradingSettings Grading;
	Grading.Global.Saturation = FVector4(1.0, 2.0, 3.0, 4.0);
	Grading.Shadows.Contrast = FVector4(2.0, 2.0, 3.0, 4.0);
	Grading.Midtones.Gamma = FVector4(3.0, 2.0, 3.0, 4.0);
	Grading.Highlights.Offset = FVector4(4.0, 2.0, 3.0, 4.0);
	Grading.HighlightsMax = 7.0f;
	const FPostProcessSettings Settings = Export(Grading);
	EXPECT_EQ(1.0, Settings.ColorSaturation.X);
	EXPECT_EQ(2.0, Settings.ColorContrastShadows.X);
	EXPECT_EQ(3.0, Settings.ColorGammaMidtones.X);
	EXPECT_EQ(4.0, Settings.ColorOffsetHighlights.X);
	EXPECT_EQ(7.0f, Settings.ColorCorrectionHighlightsMax);
	ExpectOverriddenAreThoseOf(Settings, "Color", {"ColorGradingIntensity", "ColorGradingLUT"});
}

TEST(SubSettings, FilmStockAndGrainExportTheirOwn)
{
	FFilmStockSettings Film;
	Film.Slope = 0.5f;
	FFilmGrainSettings Grain;
	Grain.Intensity = 0.75f;
	EXPECT_EQ(0.5f, Export(Film).FilmSlope);
	EXPECT_EQ(0.75f, Export(Grain).FilmGrainIntensity);
	EXPECT_EQ(5u, GetOverridden(Export(Film)).size());
	ExpectOverriddenAreThoseOf(Export(Grain), "FilmGrain", {});
}

TEST(SubSettings, ExposureOverridesTheMethodWithoutCopyingIt)
{
	FCameraExposureSettings Exposure;
	Exposure.Method = AEM_Manual;
	Exposure.Bias = -2.0f;
	Exposure.ApplyPhysicalCameraExposure = false;
	const FPostProcessSettings Settings = Export(Exposure);
	EXPECT_TRUE(Settings.bOverride_AutoExposureMethod);
	EXPECT_EQ(AEM_Histogram, Settings.AutoExposureMethod);
	EXPECT_EQ(-2.0f, Settings.AutoExposureBias);
	EXPECT_FALSE(Settings.AutoExposureApplyPhysicalCameraExposure);
	ExpectOverriddenAreThoseOf(
		Settings, "AutoExposure", {"AutoExposureBiasBackup"}, {"HistogramLogMin", "HistogramLogMax"});
}

TEST(BloomTwins, EveryBloomFieldHasOne)
{
	EXPECT_EQ(std::vector<std::string>(), FindBloomFieldsWithoutTwin(GetSettingFields()));
}

TEST(BloomTwins, FieldsWithoutOneAreNamed)
{
	std::vector<FSettingField> Fields = {*FindSettingField("BloomIntensity"), *FindSettingField("Bloom1Size"),
		*FindSettingField("BloomConvolutionSize"), *FindSettingField("FilmSlope")};
	Fields[0].Name = "BloomHalo";
	Fields[1].Name = "Bloom7Size";
	Fields[2].Name = "BloomConvolutionThreshold";
	EXPECT_EQ((std::vector<std::string>{"BloomHalo", "Bloom7Size", "BloomConvolutionThreshold"}),
		FindBloomFieldsWithoutTwin(Fields));
}
