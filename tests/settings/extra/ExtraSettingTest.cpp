// Adding a setting is one line: this program is built from the settings and the config reader with a table that has one
// line more (ExtraSettings.inl), and no other source knows of it.
#include <gtest/gtest.h>

#include "BlendSettings.h"
#include "Config/ReadConfig.h"
#include "Text/ConfigErrors.h"
#include "Config/ConfigSchema.h"
#include "Engine/PostProcessUtils.h"
#include "FinalPostProcessSettings.h"
#include "Text/Json.h"
#include "PostProcessSettingsReflection.h"
#include "PostProcessSettingsText.h"
#include "Config/SettingList.h"

#include <algorithm>

using namespace Drydock;

namespace
{

const FSettingField& Glimmer()
{
	return *FindSettingField("TestGlimmer");
}

FConfig Read(const std::string& Settings, std::vector<FDiagnostic>& Diagnostics)
{
	const FConfig Config = ReadConfig("{\"camera\": {\"Settings\": {" + Settings + "}}}", "a.json", Diagnostics);
	std::erase_if(Diagnostics, [](const FDiagnostic& Each) { return Each.Code == WarnNotBuilt; });
	return Config;
}

FPostProcessSettings GlimmerOf(float Value)
{
	FPostProcessSettings Settings;
	Settings.bOverride_TestGlimmer = true;
	Settings.TestGlimmer = Value;
	return Settings;
}

} // namespace

TEST(ExtraSetting, IsAMemberWithABit)
{
	const FPostProcessSettings Settings;
	EXPECT_EQ(0.25f, Settings.TestGlimmer);
	EXPECT_FALSE(Settings.bOverride_TestGlimmer);
}

TEST(ExtraSetting, IsAFieldThatSetsMemberAndBit)
{
	FPostProcessSettings Settings;
	Glimmer().Set(Settings, {ESettingType::Float, {1.5}});
	Glimmer().SetOverridden(Settings, true);
	EXPECT_EQ(1.5f, Settings.TestGlimmer);
	EXPECT_TRUE(Settings.bOverride_TestGlimmer);
	EXPECT_STREQ("bOverride_TestGlimmer", Glimmer().OverrideName);
}

TEST(ExtraSetting, IsReadFromAConfig)
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = Read("\"TestGlimmer\": 1.25", Diagnostics);
	EXPECT_TRUE(Diagnostics.empty());
	EXPECT_EQ(1.25f, Config.Camera.Settings.Settings.TestGlimmer);
	EXPECT_TRUE(Config.Camera.Settings.Settings.bOverride_TestGlimmer);
}

TEST(ExtraSetting, ItsMistakesAreNamed)
{
	std::vector<FDiagnostic> Diagnostics;
	Read("\"TestGlimer\": 1, \"TestGlimmer\": \"much\"", Diagnostics);
	ASSERT_EQ(2u, Diagnostics.size());
	EXPECT_EQ("unknown setting; did you mean TestGlimmer?", Diagnostics[0].Message);
	EXPECT_EQ("TestGlimmer must be a number", Diagnostics[1].Message);
}

TEST(ExtraSetting, ItsRangeWarns)
{
	std::vector<FDiagnostic> Diagnostics;
	Read("\"TestGlimmer\": 3", Diagnostics);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ("TestGlimmer is outside its range, 0 to 2; it is used as it is", Diagnostics[0].Message);
}

TEST(ExtraSetting, IsSetFromTheCommandLine)
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
	AddSettingArgument(Config, "TestGlimmer=0.5", Diagnostics);
	EXPECT_EQ(0.5f, Config.CommandLine.Settings.TestGlimmer);
}

TEST(ExtraSetting, IsInTheSchema)
{
	EXPECT_NE(std::string::npos, MakeConfigSchema().find("\"TestGlimmer\""));
	EXPECT_NE(std::string::npos, MakeConfigSchema().find("\"bOverride_TestGlimmer\""));
}

TEST(ExtraSetting, IsBlended)
{
	// From 0.25 a quarter of the way to 1.25.
	FFinalPostProcessSettings Settings = StartFinalPostProcessSettings();
	OverridePostProcessSettings(Settings, GlimmerOf(1.25f), 0.25f);
	EXPECT_EQ(0.5f, Settings.TestGlimmer);
	EXPECT_TRUE(Settings.bOverride_TestGlimmer);
}

TEST(ExtraSetting, IsBlendedWithoutAView)
{
	FPostProcessSettings Settings;
	FPostProcessUtils::BlendPostProcessSettings(Settings, GlimmerOf(1.25f), 0.5f);
	EXPECT_EQ(0.75f, Settings.TestGlimmer);
}

TEST(ExtraSetting, HasALedger)
{
	FBlendInputs Inputs;
	Inputs.Camera = GlimmerOf(1.25f);
	FBlendLedger Ledger;
	FSettingsBlender(Inputs).At(FVector(), &Ledger);
	ASSERT_EQ(2u, Ledger.GetEntries("TestGlimmer").size());
	EXPECT_EQ(1.25, Ledger.GetEntries("TestGlimmer")[1].After.Components[0]);
}

TEST(ExtraSetting, IsPastedAndCopied)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::string Text = "(bOverride_TestGlimmer=True,TestGlimmer=1.250000)";
	const FSettingsText Read = ReadSettingsText(Text, "paste.txt", Diagnostics);
	EXPECT_EQ(1.25f, Read.Settings.TestGlimmer);
	EXPECT_EQ(Text, WriteSettingsText(Read, ESettingsTextForm::Delta, Diagnostics));
	EXPECT_TRUE(Diagnostics.empty());
}

TEST(ExtraSetting, IsListed)
{
	EXPECT_EQ("Test|Extra\n"
			  "  TestGlimmer: float = 0.25, 0 .. 2, lux, Lerp\n"
			  "    A setting for this test alone.\n",
		FormatSettings(FindSettingFields("glimmer")));
}
