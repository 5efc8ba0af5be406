// The settings along a path, against values by hand and against the weights that the moving_camera scene's author
// computed (in configs/scenes/moving_camera.*.json).
#include <nlohmann/json.hpp>

#include <gtest/gtest.h>

#include "Blend/SettingsWalk.h"
#include "Config/ReadConfig.h"
#include "Config/FrameSequence.h"
#include "HAL/ConsoleVariableTools.h"
#include "Run/FinalSettings.h"

#include <fstream>
#include <sstream>

using namespace Drydock;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

/** A box of 1 m around (0, 0, 0) that fades over 1 m. */
const char* const OneBox = R"({"volumes": [
	{"name": "Base", "bUnbound": true, "Settings": {"BloomIntensity": 1}},
	{"name": "Box", "Priority": 1, "BlendRadius": 100, "bounds": {"min": [-50, -50, -50], "max": [50, 50, 50]},
		"Settings": {"BloomIntensity": 3, "BloomThreshold": 0, "BloomMethod": "BM_FFT", "SceneColorTint": [1, 0.5, 0]}}
	]})";

FSettingsWalk WalkOf(const std::string& Json, const std::vector<FPathPoint>& Points, int NumSteps,
	const std::vector<std::string>& Names = {})
{
	std::vector<FDiagnostic> Diagnostics;
	const FConfig Config = ReadConfig(Json, "test.json", Diagnostics);
	std::vector<size_t> Settings;
	for (const std::string& Name : Names)
	{
		Settings.push_back(static_cast<size_t>(FindSettingIndex(Name)));
	}
	return WalkSettings(MakeSettingsBlender(Config), Points, NumSteps, Settings);
}

std::vector<FPathPoint> Line(double From, double To)
{
	return {{FVector(From, 0.0, 0.0), "a"}, {FVector(To, 0.0, 0.0), "b"}};
}

} // namespace

TEST(SettingsWalk, StepsLieEvenlyBetweenPoints)
{
	const FSettingsWalk Walk = WalkOf(OneBox, Line(0.0, 100.0), 3);
	ASSERT_EQ(5u, Walk.Samples.size());
	EXPECT_EQ(25.0, Walk.Samples[1].Distance);
	EXPECT_EQ(FVector(75.0, 0.0, 0.0), Walk.Samples[3].Location);
	EXPECT_EQ(0, Walk.Samples[0].Point);
	EXPECT_EQ(-1, Walk.Samples[2].Point);
	EXPECT_EQ(1, Walk.Samples[4].Point);
}

TEST(SettingsWalk, DistanceIsAlongThePath)
{
	const FSettingsWalk Walk = WalkOf(
		OneBox, {{FVector(0.0, 0.0, 0.0), "1"}, {FVector(30.0, 40.0, 0.0), "2"}, {FVector(30.0, 40.0, 12.0), "3"}}, 0);
	EXPECT_EQ(50.0, Walk.Samples[1].Distance);
	EXPECT_EQ(62.0, Walk.Samples[2].Distance);
}

TEST(SettingsWalk, CsvHoldsWhatBlendsByHand)
{
	// The box ends at x = 50. At 100 half the radius is left: weight 0.5, 1 + (3 - 1) * 0.5 = 2, threshold
	// -1 + (0 + 1) * 0.5 = -0.5; enums are set at any weight. At 150 the radius ends.
	EXPECT_EQ("distance_cm,x,y,z,point,weight:Base,weight:Box,BloomIntensity,BloomThreshold,BloomMethod\n"
			  "0,50,0,0,a,1,1,3,0,BM_FFT\n"
			  "50,100,0,0,,1,0.5,2,-0.5,BM_FFT\n"
			  "100,150,0,0,b,1,0,1,-1,BM_SOG\n",
		MakeWalkCsv(WalkOf(OneBox, Line(50.0, 150.0), 1, {"BloomIntensity", "BloomThreshold", "BloomMethod"})));
}

TEST(SettingsWalk, ColorsHaveAColumnForEachComponent)
{
	// Half of white and (1, 0.5, 0).
	EXPECT_EQ("distance_cm,x,y,z,point,weight:Base,weight:Box,SceneColorTint.R,SceneColorTint.G,SceneColorTint.B,"
			  "SceneColorTint.A\n"
			  "0,100,0,0,a,1,0.5,1,0.75,0.5,1\n"
			  "50,150,0,0,b,1,0,1,1,1,1\n",
		MakeWalkCsv(WalkOf(OneBox, Line(100.0, 150.0), 0, {"SceneColorTint"})));
}

TEST(SettingsWalk, ByDefaultTheSettingsThatChange)
{
	std::vector<std::string> Names;
	for (const size_t Index : WalkOf(OneBox, Line(0.0, 150.0), 10).Settings)
	{
		Names.emplace_back(GetSettingFields()[Index].Name);
	}
	std::sort(Names.begin(), Names.end());
	EXPECT_EQ((std::vector<std::string>{"BloomIntensity", "BloomMethod", "BloomThreshold", "SceneColorTint"}), Names);
	EXPECT_TRUE(WalkOf(OneBox, Line(0.0, 10.0), 10).Settings.empty());
}

TEST(SettingsWalk, DefaultStepsMakeSomeTwoHundredAndFortySamples)
{
	EXPECT_EQ(240, GetDefaultNumSteps(2));
	EXPECT_EQ(35, GetDefaultNumSteps(8)); // 7 segments
	EXPECT_EQ(1, GetDefaultNumSteps(1000));
}

TEST(SettingsWalk, WeightsOfTheSampleAreThoseOfTheScenesAuthor)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfig Config = LoadConfig(Configs + "volumes_walk.json", Diagnostics);
	EXPECT_TRUE(Diagnostics.empty());
	ChooseSceneFrame(Config, std::nullopt);
	const std::vector<FPathPoint> Points = ReadScenePath(Config);
	ASSERT_EQ(8u, Points.size());
	const FSettingsWalk Walk = WalkSettings(MakeSettingsBlender(Config), Points, 0, {});
	ASSERT_EQ((std::vector<std::string>{"Base", "RoomA_warm", "RoomB_cold"}), Walk.Volumes);
	for (size_t Frame = 0; Frame < Walk.Samples.size(); ++Frame)
	{
		std::ifstream Stream(Configs + "scenes/moving_camera.000" + std::to_string(Frame + 1) + ".json");
		const nlohmann::json Volumes = nlohmann::json::parse(Stream)["post_process_volumes"];
		for (size_t Volume = 0; Volume < 2; ++Volume)
		{
			// The author rounds to six digits.
			EXPECT_NEAR(Volumes[Volume]["camera_weight"].get<double>(), Walk.Samples[Frame].Weights[1 + Volume], 2e-6)
				<< "frame " << Frame + 1 << ", volume " << Volume;
		}
	}
}

TEST(SettingsWalk, SettingsOfTheSampleFollowFromTheAuthorsWeights)
{
	std::vector<FDiagnostic> Diagnostics;
	FConfig Config = LoadConfig(Configs + "volumes_walk.json", Diagnostics);
	ChooseSceneFrame(Config, std::nullopt);
	const size_t Bloom = static_cast<size_t>(FindSettingIndex("BloomIntensity"));
	const FSettingsWalk Walk = WalkSettings(MakeSettingsBlender(Config), ReadScenePath(Config), 0, {Bloom});
	// Both rooms give BloomIntensity, A 0.675, then B 2.5; the base 0.3. Weights (A, B) as in the scene's table:
	// frame 1 (1, 0): A. 3 (1, 0.335714): 0.675 + 1.825 * 0.335714. 5 and 8 (any, 1): B.
	EXPECT_EQ(0.675f, Walk.Samples[0].Values[0].Components[0]);
	EXPECT_NEAR(0.675 + 1.825 * 0.335714, Walk.Samples[2].Values[0].Components[0], 1e-5);
	EXPECT_NEAR(0.675 + 1.825 * 0.678571, Walk.Samples[3].Values[0].Components[0], 1e-5);
	EXPECT_EQ(2.5, Walk.Samples[4].Values[0].Components[0]);
	EXPECT_EQ(2.5, Walk.Samples[7].Values[0].Components[0]);
}
