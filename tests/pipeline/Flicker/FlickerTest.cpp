// The figure for flicker: what a sum by hand says of a known jump, 0 where nothing flickers, and the run's messages.
#include "Flicker/FlickerReport.h"
#include "Scenes/JitteredScenes.h"
#include "SequenceTestUtils.h"
#include "Text/Json.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

using namespace Drydock;
using namespace SequenceTest;
using testing::HasSubstr;

namespace
{

FFlickerSignal MakeSignal(const std::function<double(int, int)>& Light)
{
	FFlickerSignal Signal{4, 2, {}};
	for (int Index = 0; Index < 8; ++Index)
	{
		Signal.Light.push_back(Light(Index % 4, Index / 4));
	}
	return Signal;
}

/** Figures of six frames; Truth may be empty. */
FFlickerFigures Measure(
	const std::function<double(int, int, int)>& Light, const std::function<double(int, int, int)>& Truth)
{
	FFlickerMeter Meter;
	for (int Frame = 0; Frame < 6; ++Frame)
	{
		const FFlickerSignal Exact =
			Truth ? MakeSignal([&](int X, int Y) { return Truth(X, Y, Frame); }) : FFlickerSignal();
		Meter.Add(Frame, MakeSignal([&](int X, int Y) { return Light(X, Y, Frame); }), Truth ? &Exact : nullptr);
	}
	return Meter.Get();
}

FFlickerOptions MakeOptions(const Files::path& Folder, const std::string& Scene)
{
	FFlickerOptions Options;
	Options.Run.ConfigFile = (Folder / (Scene + ".json")).string();
	Options.Variants = {{"as it is", {}}, {"without", {"r.AntiAliasingMethod=0"}}};
	return Options;
}

void WriteScene(const Files::path& Folder, const std::string& Name, int NumFrames)
{
	FJitteredSceneOptions Scene;
	Scene.Scene = FindJitteredScene(Name);
	Scene.Size = FIntPoint(48, 27);
	Scene.NumFrames = NumFrames;
	WriteJitteredScene(Scene, Folder.string());
}

std::string ErrorOf(const FFlickerOptions& Options)
{
	try
	{
		MeasureFlicker(Options);
	}
	catch (const FError& Error)
	{
		return Error.GetDiagnostics().at(0).Message;
	}
	return "none";
}

const FFlickerFigures& FindFigures(const FFlickerVariant& Variant, const std::string& Name)
{
	const auto Found = std::ranges::find_if(Variant.Rows, [&](const FFlickerRow& Row) { return Row.Name == Name; });
	EXPECT_NE(Variant.Rows.end(), Found) << Name;
	return Found->Figures;
}

} // namespace

TEST(Flicker, AKnownJumpIsWhatASumByHandSays)
{
	// One of eight pixels goes from 1 to 5 in frame 3 and stays: the mean goes from 1 to 1.5.
	const auto Light = [](int X, int Y, int Frame)
	{
		return X == 2 && Y == 1 && Frame >= 3 ? 5.0 : 1.0;
	};
	const FFlickerFigures Against = Measure(Light, [](int, int, int) { return 1.0; });
	ASSERT_EQ(5u, Against.Frames.size());
	EXPECT_EQ(1, Against.Frames[0].Frame);
	EXPECT_DOUBLE_EQ(50.0, Against.Frames[2].Jump); // of frame 3: 0.5 of the truth's 1
	EXPECT_DOUBLE_EQ(4.0, Against.Frames[2].WorstPixel);
	EXPECT_EQ(FIntPoint(2, 1), Against.Frames[2].WorstPlace);
	EXPECT_DOUBLE_EQ(0.0, *Against.Frames[0].Error);
	EXPECT_DOUBLE_EQ(std::sqrt(16.0 / 8.0), *Against.GetLastError()); // one of eight is off by 4
	EXPECT_DOUBLE_EQ(0.0, Against.Frames[3].Jump);
	EXPECT_DOUBLE_EQ(10.0, Against.GetMeanJump());
	EXPECT_EQ(3, Against.FindWorstJump()->Frame);
	EXPECT_DOUBLE_EQ(4.0, Against.Where.Get(2, 1, 0));
	EXPECT_DOUBLE_EQ(0.0, Against.Where.Get(1, 1, 0));

	// Alone: half of the second difference, in frames 3 and 4.
	const FFlickerFigures Alone = Measure(Light, {});
	ASSERT_EQ(4u, Alone.Frames.size());
	EXPECT_FALSE(Alone.GetLastError());
	EXPECT_DOUBLE_EQ(2.0, Alone.Frames[1].WorstPixel);
	EXPECT_NEAR(100.0 * 0.25 / 1.5, Alone.Frames[1].Jump, 1e-12);
	EXPECT_NEAR(100.0 * 0.25 / 1.5, Alone.Frames[2].Jump, 1e-12);
	EXPECT_DOUBLE_EQ(0.0, Alone.Frames[3].Jump);
}

TEST(Flicker, StillnessAFadeAndAPanOfTheTruthAreNone)
{
	const auto Still = [](int X, int Y, int)
	{
		return X + 0.5 * Y;
	};
	const auto Fade = [](int X, int Y, int Frame)
	{
		return (X + Y) * (1.0 + 0.25 * Frame);
	};
	const auto Pan = [](int X, int, int Frame)
	{
		return (X + Frame) % 4 == 0 ? 8.0 : 1.0;
	};
	for (const FFlickerFigures& Figures :
		{Measure(Still, {}), Measure(Still, Still), Measure(Fade, {}), Measure(Fade, Fade), Measure(Pan, Pan)})
	{
		EXPECT_EQ(0.0, Figures.GetMeanJump());
		EXPECT_EQ(0.0, Figures.FindWorstPixel()->WorstPixel);
	}
	EXPECT_GT(Measure(Pan, {}).FindWorstPixel()->WorstPixel, 0.0);
}

TEST(Flicker, AntialiasingOverFramesCalmsAThinBrightLine)
{
	const FTemporaryFolder Temporary("drydock_flicker");
	WriteScene(Temporary.Path, "line", 10);
	const FFlickerResult Result = MeasureFlicker(MakeOptions(Temporary.Path, "line"));
	EXPECT_EQ("line.truth.####.exr", Result.Truth);
	ASSERT_EQ(2u, Result.Variants.size());
	for (const char* const Name : {"picture", "Bloom"})
	{
		const double With = FindFigures(Result.Variants[0], Name).GetMeanJump();
		const double Without = FindFigures(Result.Variants[1], Name).GetMeanJump();
		EXPECT_GT(Without, 0.0) << Name;
		EXPECT_LT(With, Without) << Name;
	}
	EXPECT_THAT(Result.Unmeasured, testing::ElementsAre("TemporalAA"));
	EXPECT_THAT(MakeFlickerTable(Result, 0), HasSubstr("not measured: TemporalAA"));
	EXPECT_EQ(MakeFlickerJson(Result), MakeFlickerJson(MeasureFlicker(MakeOptions(Temporary.Path, "line"))));
	EXPECT_THAT(WriteFlickerPictures(Result, Temporary.Path.string()),
		testing::IsSupersetOf({"where.picture.png", "where.picture.2.png"}));
}

TEST(Flicker, MistakesNameWhatIsMissing)
{
	const FTemporaryFolder Temporary("drydock_flicker_mistakes");
	WriteScene(Temporary.Path, "still", 4);
	FFlickerOptions Options = MakeOptions(Temporary.Path, "still");
	Options.Frames = "2";
	EXPECT_THAT(ErrorOf(Options), HasSubstr("flicker needs 2 frames at least, and there is 1"));
	Options.Frames.clear();
	Files::remove(Temporary.Path / "still.truth.0003.exr");
	EXPECT_THAT(ErrorOf(Options), HasSubstr("the truth has no frame 3: still.truth.####.exr"));
	Options.Truth = "other.####.exr";
	EXPECT_THAT(ErrorOf(Options), HasSubstr("the truth has no frame 1: other.####.exr"));
	Options.Truth.clear();
	Options.Run.ConfigText = R"({"scene": {"file": "still.0001.exr"}})";
	EXPECT_THAT(ErrorOf(Options), HasSubstr("the scene is not a sequence"));
}
