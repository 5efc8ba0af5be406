// Camera and volumes of a scene's header. Oracle: the weights and distances that the scenes' author wrote beside them.
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "Run/FinalSettings.h"
#include "SceneFile/SceneSuggestions.h"
#include "Text/ConfigErrors.h"

#include <fstream>

using namespace Drydock;

namespace
{

const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";

struct FCompleted
{
	FConfig Config;
	std::vector<FDiagnostic> Diagnostics;
};

FCompleted Complete(const std::string& ConfigText)
{
	FCompleted Result;
	Result.Config = ReadConfig(ConfigText, Scenes + "a.json", Result.Diagnostics);
	EXPECT_FALSE(HasErrors(Result.Diagnostics));
	CompleteFromScene(Result.Config, Result.Diagnostics);
	return Result;
}

std::string FromScene(const std::string& Scene, const std::string& More = "")
{
	return R"({"scene": {"file": ")" + Scene + R"("}, "volumes": "fromScene")" + More + "}";
}

int CodeOfError(const std::string& ConfigText)
{
	try
	{
		const FCompleted Result = Complete(ConfigText);
		return HasErrors(Result.Diagnostics) ? Result.Diagnostics.back().Code : 0;
	}
	catch (const FError& Error)
	{
		return Error.GetDiagnostics().back().Code;
	}
}

} // namespace

TEST(SceneSuggestions, VolumesHaveTheAuthorsDistancesAndWeights)
{
	int NumCompared = 0;
	for (const char* Scene :
		{"toon_character", "toon_character_641x359", "two_boxes", "night_fireflies", "toon_portrait"})
	{
		const nlohmann::json Written = nlohmann::json::parse(std::ifstream(Scenes + Scene + ".json"));
		const FCompleted Result = Complete(FromScene(std::string(Scene) + ".exr"));
		const std::vector<FVolumeAtPlace> Volumes =
			MakeSettingsBlender(Result.Config).FindVolumes(GetViewLocation(Result.Config));
		for (size_t Index = 0; Index < Volumes.size(); ++Index)
		{
			const nlohmann::json& Expected = Written["post_process_volumes"][Index];
			EXPECT_NEAR(Expected["camera_distance_uecm"].get<double>(), Volumes[Index].Distance.value(), 1e-4) << Scene;
			EXPECT_NEAR(Expected["camera_weight"].get<double>(), Volumes[Index].Influence.Weight, 1e-6) << Scene;
			++NumCompared;
		}
	}
	EXPECT_EQ(10, NumCompared);
}

TEST(SceneSuggestions, SettingsBlendWithThoseWeights)
{
	const FCompleted Result = Complete(FromScene("toon_character.exr"));
	// 0.675 + 0.45 * (1.5 - 0.675) = 1.04625; + 0.1333333 * (3 - 1.04625) = 1.30675.
	EXPECT_NEAR(1.30675f, MakeViewSettings(Result.Config).Settings.BloomIntensity, 1e-6f);
}

TEST(SceneSuggestions, VolumesKeepTheirNames)
{
	const FCompleted Result = Complete(FromScene("toon_character.exr"));
	ASSERT_EQ(2u, Result.Config.Volumes.size());
	EXPECT_EQ("Room", GetVolumeName(Result.Config, 0));
	EXPECT_EQ("WindowSide", GetVolumeName(Result.Config, 1));
	EXPECT_EQ(600.0, Result.Config.Volumes[1].BlendRadius);
}

TEST(SceneSuggestions, CameraOfTheSceneIsTheView)
{
	const FVector Location = GetViewLocation(Complete(FromScene("toon_character.exr")).Config);
	EXPECT_NEAR(25.0, Location.X, 1e-3);
	EXPECT_NEAR(470.0, Location.Y, 1e-3);
	EXPECT_NEAR(135.0, Location.Z, 1e-3);
}

TEST(SceneSuggestions, LocationOfTheConfigWins)
{
	const FCompleted Result = Complete(FromScene("toon_character.exr", R"(, "view": {"location": [1, 2, 3]})"));
	EXPECT_EQ(FVector(1, 2, 3), GetViewLocation(Result.Config));
}

TEST(SceneSuggestions, BoundedVolumesOfTheConfigAskForTheCamera)
{
	const FCompleted Result = Complete(R"({"scene": {"file": "toon_character.exr"},
		"volumes": [{"bounds": {"type": "sphere", "center": [25, 470, 135], "radius": 1}}]})");
	EXPECT_NEAR(470.0, GetViewLocation(Result.Config).Y, 1e-3);
	EXPECT_TRUE(Result.Diagnostics.empty());
}

TEST(SceneSuggestions, HeaderIsNotReadWithoutNeed)
{
	// The file does not exist, and nobody asks for it.
	EXPECT_EQ(0, CodeOfError(R"({"scene": {"file": "no.exr"}, "volumes": [{"bUnbound": true}]})"));
	EXPECT_EQ(0, CodeOfError(R"({"scene": {"file": "no.exr"}, "view": {"location": [0, 0, 0]},
		"volumes": [{"bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}]})"));
	EXPECT_EQ(ErrorFileMissing, CodeOfError(R"({"scene": {"file": "no.exr"},
		"volumes": [{"bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}]})"));
}

TEST(SceneSuggestions, WithoutASceneThereIsNothingToSuggest)
{
	EXPECT_EQ(ErrorNothingFromScene, CodeOfError(R"({"volumes": "fromScene"})"));
}

TEST(SceneSuggestions, WithoutALocationBoundedVolumesWarn)
{
	const FCompleted Result =
		Complete(R"({"volumes": [{"bounds": {"type": "sphere", "center": [0, 0, 0], "radius": 1}}]})");
	ASSERT_EQ(1u, Result.Diagnostics.size());
	EXPECT_EQ(WarnNoLocation, Result.Diagnostics[0].Code);
	EXPECT_EQ(FVector(0, 0, 0), GetViewLocation(Result.Config));
}

TEST(SceneSuggestions, UnknownSettingIsLeftOutWithAWarning)
{
	std::vector<FDiagnostic> Diagnostics;
	const std::vector<FConfigVolume> Volumes = ReadSuggestedVolumes(
		R"({"post_process_volumes": [{"name": "Pit", "settings": {"BloomIntensty": 1, "BloomSizeScale": 8}}]})",
		"a.exr", Diagnostics);
	ASSERT_EQ(1u, Volumes.size());
	EXPECT_EQ(8.0f, Volumes[0].Settings.Settings.BloomSizeScale);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(WarnSuggestionLeftOut, Diagnostics[0].Code);
	EXPECT_EQ(ESeverity::Warning, Diagnostics[0].Severity);
}

TEST(SceneSuggestions, VolumeWithoutBoundsIsUnbound)
{
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_TRUE(
		ReadSuggestedVolumes(R"({"post_process_volumes": [{"name": "All"}]})", "a.exr", Diagnostics)[0].bUnbound);
}

TEST(SceneSuggestions, BrokenTextSuggestsNothing)
{
	std::vector<FDiagnostic> Diagnostics;
	EXPECT_TRUE(ReadSuggestedVolumes("{", "a.exr", Diagnostics).empty());
	EXPECT_FALSE(ReadSuggestedLocation("").has_value());
}

TEST(SceneSuggestions, VolumesAreAsManyAsAConfigHas)
{
	std::string Volumes;
	for (int Index = 0; Index < 10001; ++Index)
	{
		Volumes += Index == 0 ? "{}" : ",{}";
	}
	std::vector<Drydock::FDiagnostic> Diagnostics;
	EXPECT_EQ(10000u,
		Drydock::ReadSuggestedVolumes("{\"post_process_volumes\": [" + Volumes + "]}", "a.exr", Diagnostics).size());
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ("a.exr:1:30027: warning DD1043 at /post_process_volumes/10000: more than 10000 volumes; no more are read",
		Diagnostics[0].ToString());
}
