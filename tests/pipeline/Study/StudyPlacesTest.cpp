// Studies of a plugin's own class: fields of "objects" as axes, errors from the plugin's formula, the cost of its pass
// alone (tests/plugins/Tuned).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Objects/ObjectErrors.h"
#include "Picture/ImageFile.h"
#include "Run/Run.h"
#include "Study/StudyReport.h"
#include "Study/StudyRun.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <filesystem>
#include <unistd.h>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

namespace Files = std::filesystem;

class StudyPlaces : public testing::Test
{
protected:
	StudyPlaces()
		: Scene(Files::temp_directory_path() / ("drydock_places_" + std::to_string(getpid()) + ".exr"))
	{
		FImage Image{16, 8, 3, {}};
		for (int Pixel = 0; Pixel < 16 * 8; ++Pixel)
		{
			Image.Values.insert(Image.Values.end(), {Pixel % 16 / 16.0, 0.5, 0.25});
		}
		WriteExr(Scene.string(), Image, {"R", "G", "B"});
	}
	~StudyPlaces() override { Files::remove(Scene); }

	FRunOptions MakeOptions(const std::string& Study, const std::string& More = "") const
	{
		FRunOptions Options;
		Options.ConfigFile = Scene.string() + ".json";
		Options.ConfigText = R"({"scene": {"file": ")" + Scene.string() + R"("}, "showFlags": {"Bloom": false},
			"plugins": [")" DRYDOCK_TEST_BINARY_DIR R"(/lib/libTuned.so"],
			"objects": {"UTunedSettings": {"Steps": 2}},
			"study": {"repetitions": 1, "measure": "sceneLinear", )" +
							 Study + "}" + More + "}";
		return Options;
	}

	std::string ErrorOf(const std::string& Study) const
	{
		try
		{
			RunStudy(MakeOptions(Study));
		}
		catch (const FError& Error)
		{
			const FDiagnostic& First = Error.GetDiagnostics().front();
			return std::to_string(First.Code) + " " + First.Where + ": " + First.Message;
		}
		return "";
	}

	const Files::path Scene;
};

// Red is multiplied by Tint.R, Weights.Scale and Steps: 0.5 * 2 * Steps. The greatest red is 15/16.
TEST_F(StudyPlaces, AFieldOfAPluginsClassIsAnAxis)
{
	const FStudyResult Result = RunStudy(MakeOptions(R"("axes": [
		{"name": "/objects/UTunedSettings/Steps", "values": [1, 2, 4]}],
		"reference": {"/objects/UTunedSettings/Steps": 4}, "passes": "Tuned")"));
	ASSERT_EQ(3u, Result.Variants.size());
	EXPECT_EQ("Steps 1", Result.Variants[0].Label);
	EXPECT_NEAR(3.0 * 15.0 / 16.0, Result.Variants[0].Error.Max, 0.004);
	EXPECT_NEAR(2.0 * 15.0 / 16.0, Result.Variants[1].Error.Max, 0.004);
	EXPECT_EQ(0.0, Result.Variants[2].Error.Max);
	EXPECT_FALSE(Result.Variants[0].bCurrent);
	EXPECT_TRUE(Result.Variants[1].bCurrent);
	EXPECT_EQ(2.0, Result.Variants[0].Taps); // of the plugin's pass: the scene and the mask, each read once a pixel
}

// A tint takes the red of the right half, which is 15/16 at most before the plugin.
TEST_F(StudyPlaces, AParameterOfAPassIsAnAxis)
{
	const FRunOptions Options = MakeOptions(R"("axes": [{"name": "/passes/0/parameters/Left", "values": [0.5, 1]}],
		"reference": {"/passes/0/parameters/Left": 1}, "passes": "Tint")",
		R"(, "passes": [{"type": "Tint", "at": "MotionBlur", "parameters": {"Color": [0, 1, 1]}}])");
	const FStudyResult Result = RunStudy(Options);
	EXPECT_GT(Result.Variants[0].Error.Max, 0.9); // a red of 15/16 or more is gone
	EXPECT_EQ(0.0, Result.Variants[1].Error.Max);
	EXPECT_EQ(1.0, Result.Variants[0].Taps);
}

TEST_F(StudyPlaces, WithoutPassesTheWholeFrameCounts)
{
	const FStudyResult Result =
		RunStudy(MakeOptions(R"("axes": [{"name": "/objects/UTunedSettings/bInvert", "values": [true, false]}])"));
	EXPECT_GT(Result.Variants[0].Taps, 1.0);
	EXPECT_EQ("true", Result.Variants[0].Label);
}

TEST_F(StudyPlaces, ABudgetKeepsTheConfigsOwnValue)
{
	const Files::path Folder = Scene.string() + ".study";
	Files::create_directories(Folder);
	const FRunOptions Options = MakeOptions(R"("axes": [{"name": "/objects/UTunedSettings/Steps", "values": [2, 4]}])",
		R"(, "budget": {"study": ")" + Folder.string() + R"(", "max": 100})");
	const FStudyResult Result = RunStudy(Options);
	WriteTextFile((Folder / "study.json").string(), MakeStudyJson(Result));
	WriteTextFile((Folder / "study_timing.json").string(), MakeStudyTimingJson(Result));
	const FRunResult Run = RunConfig(Options);
	Files::remove_all(Folder);
	ASSERT_EQ(1u, Run.Diagnostics.size());
	EXPECT_EQ(NoteBudgetWithoutChoice, Run.Diagnostics[0].Code);
	EXPECT_THAT(Run.Diagnostics[0].Message, HasSubstr("recommends Steps "));
	EXPECT_NEAR(2.0 * 15.0 / 16.0 + 0.5, Run.SceneLinear.Get(15, 0, 0), 0.004); // 2 steps, and the plugin's Secret
}

TEST_F(StudyPlaces, MistakesAreNamedBeforeAnythingRuns)
{
	EXPECT_EQ("2121 /objects/UTunedSettings/Step: UTunedSettings has no UPROPERTY Step; did you mean Steps?",
		ErrorOf(R"("axes": [{"name": "/objects/UTunedSettings/Step", "values": [1]}])"));
	EXPECT_THAT(ErrorOf(R"("axes": [{"name": "/objects/UTunedSettings/Mode", "values": ["Off", "Multipl"]}])"),
		HasSubstr("2122 /objects/UTunedSettings/Mode: UTunedSettings::Mode (ETunedMode): expected one of Off, "
				  "Multiply, Add, found \"Multipl\"; did you mean Multiply?"));
	EXPECT_EQ("1007 /passes/0/parameters/Left: the config has no /passes",
		ErrorOf(R"("axes": [{"name": "/passes/0/parameters/Left", "values": [0.5]}])"));
	EXPECT_EQ("1007 /study/passes: \"Tunned\" fits no pass of this frame",
		ErrorOf(R"("axes": [{"name": "/objects/UTunedSettings/Steps", "values": [1]}], "passes": "Tunned")"));
}

} // namespace
