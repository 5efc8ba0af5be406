// Names of settings as the engine's editor shows them.
#include <gtest/gtest.h>

#include "PostProcessSettingsReflection.h"
#include "SettingDisplayNames.h"

using namespace Drydock;

TEST(SettingDisplayNames, AreThoseOfTheEditorElseTheWordsOfTheMember)
{
	const std::pair<const char*, const char*> Expected[] = {{"BloomIntensity", "Intensity"}, {"Bloom1Size", "#1 Size"},
		{"ColorGain", "Gain"}, {"ColorGainShadows", "Gain"}, {"ColorCorrectionShadowsMax", "ShadowsMax"},
		{"DepthOfFieldFstop", "Aperture (F-stop)"}, {"AutoExposureBias", "Exposure Compensation"},
		{"SceneFringeIntensity", "Intensity"}, {"WhiteTemp", "Temp"}, {"FilmSlope", "Slope"},
		{"ColorGradingLUT", "Color Grading LUT"}, {"VignetteIntensity", "Vignette Intensity"},
		{"BloomToonIntensity", "Bloom Toon Intensity"}, {"ToonShadowBlur1Size", "Toon Shadow Blur 1 Size"},
		{"bMegaLights", "Mega Lights"}};
	for (const auto& [Name, Display] : Expected)
	{
		const FSettingField* const Field = FindSettingField(Name);
		ASSERT_NE(nullptr, Field) << Name;
		EXPECT_EQ(Display, GetDisplayName(*Field)) << Name;
	}
}
