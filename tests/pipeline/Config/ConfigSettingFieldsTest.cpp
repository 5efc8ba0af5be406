// Every field of the settings table as a config gives it, each as a test of its own name.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "PostProcessSettingsReflection.h"
#include "Text/ConfigErrors.h"
#include "settings/SettingSamples.h"

#include <cmath>

using namespace Drydock;

namespace
{

class ConfigSettingField : public testing::TestWithParam<const FSettingField*>
{
protected:
	const FSettingField& Field = *GetParam();
	std::vector<FDiagnostic> Diagnostics;

	/** The settings of a volume that has these members; what is only not built yet is no matter here. */
	FPostProcessSettings Read(const std::string& Members)
	{
		const std::string Text = "{\"volumes\": [{\"bUnbound\": true, \"Settings\": {" + Members + "}}]}";
		const FConfig Config = ReadConfig(Text, "a.json", Diagnostics);
		std::erase_if(Diagnostics, [](const FDiagnostic& Each) { return Each.Code == WarnNotBuilt; });
		return Config.Volumes.empty() ? FPostProcessSettings() : Config.Volumes[0].Settings.Settings;
	}

	FPostProcessSettings ReadValue(const std::string& Json) { return Read(Quote(Field.Name) + ": " + Json); }

	static std::string Quote(const std::string& Text) { return "\"" + Text + "\""; }

	/** The code of the only message. */
	int Code() const { return Diagnostics.size() == 1 ? Diagnostics[0].Code : 0; }
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Each, ConfigSettingField, AllSettingFields(), FNameOfSetting());

TEST_P(ConfigSettingField, IsReadAsItIsWritten)
{
	for (const FSettingValue& Value : {Field.Default, MakeOtherValue(Field), FSettingValue{Field.Type}})
	{
		const FPostProcessSettings Settings = ReadValue(SettingToJson(Field, Value));
		EXPECT_EQ(Value, Field.Get(Settings));
		EXPECT_TRUE(Field.IsOverridden(Settings));
		EXPECT_FALSE(HasErrors(Diagnostics));
	}
}

TEST_P(ConfigSettingField, OverrideOffKeepsTheValueInert)
{
	const FSettingValue Other = MakeOtherValue(Field);
	const FPostProcessSettings Settings =
		Read(Quote(Field.Name) + ": " + SettingToJson(Field, Other) + ", " + Quote(Field.OverrideName) + ": false");
	EXPECT_EQ(Other, Field.Get(Settings));
	EXPECT_FALSE(Field.IsOverridden(Settings));
	EXPECT_FALSE(HasErrors(Diagnostics));
}

TEST_P(ConfigSettingField, WrongTypeIsAnError)
{
	const bool bCurve = std::string_view(Field.ObjectClass) == "CurveFloat"; // may be an object, of keys
	const FPostProcessSettings Settings = ReadValue(bCurve ? "1" : "{\"a\": 1}");
	EXPECT_EQ(ErrorWrongType, Code());
	EXPECT_FALSE(Field.IsOverridden(Settings));
	EXPECT_EQ(0u, Diagnostics[0].Message.find(std::string(Field.Name) + " must be "));
}

TEST_P(ConfigSettingField, NaNIsAnError)
{
	const FPostProcessSettings Settings = ReadValue("NaN");
	EXPECT_EQ(ErrorNumberNotFinite, Code());
	EXPECT_FALSE(Field.IsOverridden(Settings));
}

TEST_P(ConfigSettingField, OutOfRangeWarnsAndIsUsed)
{
	if (!std::isfinite(Field.Range.ClampMin))
	{
		return;
	}
	FSettingValue Below = Field.Default;
	Below.Components[0] = Field.Range.ClampMin - 1.0;
	const FPostProcessSettings Settings = ReadValue(SettingToJson(Field, Below));
	EXPECT_EQ(WarnOutOfRange, Code());
	EXPECT_FLOAT_EQ(static_cast<float>(Below.Components[0]), static_cast<float>(Field.Get(Settings).Components[0]));
}

TEST_P(ConfigSettingField, MisspelledNameFindsIt)
{
	std::string Name = Field.Name;
	Name.insert(Name.size() / 2, "_");
	Read(Quote(Name) + ": 1");
	EXPECT_EQ(ErrorUnknownSetting, Code());
	EXPECT_NE(std::string::npos, Diagnostics[0].Message.find(std::string("did you mean ") + Field.Name + "?"));
}

TEST(ConfigSettings, ObjectsArePathsOrNull)
{
	const FSettingField& Field = *FindSettingField("BloomDirtMask");
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(
		R"({"camera": {"Settings": {"BloomDirtMask": "/Game/Dirt.Dirt", "FilmGrainTexture": null,
		"LensFlareBokehShape": "None"}}})",
		"a.json", Diagnostics);
	const FPostProcessSettings& Settings = Config.Camera.Settings.Settings;
	EXPECT_EQ("/Game/Dirt.Dirt", SettingToText(Field, Field.Get(Settings)));
	EXPECT_TRUE(Settings.FilmGrainTexture == nullptr);
	EXPECT_TRUE(Settings.bOverride_FilmGrainTexture);
	EXPECT_TRUE(Settings.LensFlareBokehShape == nullptr);
	EXPECT_FALSE(HasErrors(Diagnostics));
}

TEST(ConfigSettings, WrongValuesSayWhatIsExpected)
{
	std::vector<FDiagnostic> Diagnostics;
	ReadConfig(R"({"camera": {"Settings": {"BloomDirtMask": 1, "LensFlareTints": [[1, 1, 1]],
		"ColorGain": [1, 1, 1], "MotionBlurTargetFPS": 29.5}}})",
		"a.json", Diagnostics);
	std::erase_if(Diagnostics, [](const FDiagnostic& Each) { return Each.Code == WarnNotBuilt; });
	ASSERT_EQ(4u, Diagnostics.size());
	EXPECT_EQ("BloomDirtMask must be the path of a Texture, such as \"/Game/Folder/Name.Name\", or null",
		Diagnostics[0].Message);
	EXPECT_EQ("LensFlareTints must be eight colours: [[R, G, B, A], ...]", Diagnostics[1].Message);
	EXPECT_EQ("ColorGain must be four numbers: [X, Y, Z, W] or {\"X\": .., \"Y\": .., \"Z\": .., \"W\": ..}",
		Diagnostics[2].Message);
	EXPECT_EQ("MotionBlurTargetFPS must be a whole number", Diagnostics[3].Message);
}
