// Histories are hard cases: what a frame finds of the frame before may be not finite, of another size, from another
// camera, from any number of frames ago. Every picture is finite within two frames, and exposure comes to one value.
#include "Run/Run.h"
#include "Scenes/JitteredScenes.h"
#include "SequenceTestUtils.h"
#include "Sequence/ViewStateFile.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

using namespace Drydock;
using namespace SequenceTest;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int GNumFrames = 6;

/** All that keeps a history: temporal antialiasing, metered exposure with a pre-exposure that follows it, what next
 * frame's reflections see. */
class HistoryHazards : public testing::Test
{
protected:
	HistoryHazards()
	{
		FJitteredSceneOptions Scene;
		Scene.Scene = &GetJitteredScenes().front();
		Scene.Size = FIntPoint(64, 36);
		Scene.NumFrames = GNumFrames;
		WriteJitteredScene(Scene, Temporary.Path.string());
	}

	FRunOptions Ask(const std::string& Scene = "", const std::string& More = "") const
	{
		FRunOptions Options;
		Options.ConfigFile = (Temporary.Path / "test.json").string();
		Options.ConfigText = R"({"scene": {"file": "line.####.exr", "frames": "all")" + Scene +
							 R"(}, "view": {"exposure": "auto", "preExposure": "auto"},
			"passes": [{"type": "GaussianBlur", "at": "SSRInput", "name": "Kept"}],
			"cvars": {"r.AntiAliasingMethod": 2}, "camera": {"Settings": {"AutoExposureSpeedUp": 20,
			"AutoExposureSpeedDown": 20}})" +
							 More + "}";
		Options.Frame = 1;
		return Options;
	}

	/** The history that frame 1 leaves. */
	std::vector<FViewHistory> MakeHistory() const { return FRunSession(Ask()).Run(1, {}).ViewStates; }

	const FTemporaryFolder Temporary{"drydock_history"};
};

/** Copies the textures and buffers of a history, so that they can be changed, by way of its file. */
std::vector<FViewHistory> Copy(const std::vector<FViewHistory>& History)
{
	return UnpackViewStates(PackViewStates(History), "copy");
}

int CountBadValues(const FPicture& Picture)
{
	int Count = 0;
	for (int Index = 0; Index < Picture.Width * Picture.Height * 3; ++Index)
	{
		const double Value = Picture.Get(Index / 3 % Picture.Width, Index / 3 / Picture.Width, Index % 3);
		Count += std::isfinite(Value) ? 0 : 1;
	}
	return Count;
}

void ExpectFinite(const FRunResult& Result, const std::string& What)
{
	EXPECT_EQ(0, CountBadValues(Result.SceneLinear)) << What;
	EXPECT_EQ(0, CountBadValues(Result.Final)) << What;
	EXPECT_TRUE(std::isfinite(Result.ExposureScale) && Result.ExposureScale > 0.0f) << What;
}

double GetExposure(const FRunResult& Result)
{
	return static_cast<double>(Result.ExposureScale);
}

} // namespace

TEST_F(HistoryHazards, WhatIsNotFiniteInAHistoryLeavesWithinTwoFrames)
{
	const std::vector<FViewHistory> History = MakeHistory();
	ASSERT_TRUE(History[0].Textures.contains("TemporalAA.History"));
	ASSERT_TRUE(History[0].Textures.contains(CustomSSRInputName));
	ASSERT_TRUE(History[0].Buffers.contains(EyeAdaptationName));
	for (const double Bad : {NaN, Infinity, -Infinity, 65504.0, -65504.0, 0.0, -1.0})
	{
		std::vector<FViewHistory> Hurt = Copy(History);
		for (auto& [Name, Texture] : Hurt[0].Textures)
		{
			for (int Index = 0; Index < 64 * 36; Index += 5)
			{
				Texture.Target->GetRHI()->WriteTexelDouble(Index % 64, Index / 64, FVector4(Bad, Bad, Bad, Bad));
			}
		}
		const float Scale = static_cast<float>(Bad);
		std::memcpy(Hurt[0].Buffers[EyeAdaptationName]->GetRHI()->GetData(), &Scale, sizeof(Scale));
		FRunSession Session(Ask());
		const FRunResult Second = Session.Run(2, Hurt);
		const FRunResult Third = Session.Run(3, Second.ViewStates);
		ExpectFinite(Third, "of a history with " + std::to_string(Bad));
	}
}

TEST_F(HistoryHazards, AnotherSizeAnotherRateAndFramesThatJumpAreDrawn)
{
	const std::vector<FViewHistory> History = MakeHistory();
	const std::pair<const char*, FRunOptions> Cases[] = {
		{"half the size", Ask(R"(, "screenPercentage": 50)")},
		{"an odd size", Ask(R"(, "screenPercentage": 73)")},
		{"a huge delta time", Ask(R"(, "fps": 0.01)")},
		{"a tiny delta time", Ask(R"(, "fps": 10000)")},
	};
	for (const auto& [Name, Options] : Cases)
	{
		FRunSession Session(Options);
		std::vector<FViewHistory> Last = History;
		for (const int Frame : {3, 6, 2, 2}) // forwards, backwards, the same again
		{
			const FRunResult Result = Session.Run(Frame, Last);
			ExpectFinite(Result, std::string(Name) + ", frame " + std::to_string(Frame));
			Last = Result.ViewStates;
		}
	}
}

TEST_F(HistoryHazards, AHistoryOfAnotherSizeIsScaled)
{
	// A constant picture stays what it is, whatever the size that it had.
	const auto AskPlain = [this](const std::string& Scene)
	{
		FRunOptions Options = Ask(Scene);
		const std::string Auto = R"("preExposure": "auto")";
		Options.ConfigText->replace(Options.ConfigText->find(Auto), Auto.size(), R"("preExposure": 1)");
		return Options;
	};
	FRunSession Small(AskPlain(R"(, "screenPercentage": 50)"));
	const std::vector<FViewHistory> Last = Small.Run(1, {}).ViewStates;
	FRunSession Large(AskPlain(""));
	const FRunResult Result = Large.Run(2, Last);
	const FRunResult Fresh = Large.Run(2, {});
	// Far from the line and the disc there is only the background.
	EXPECT_NEAR(Fresh.SceneLinear.Get(2, 34, 0), Result.SceneLinear.Get(2, 34, 0),
		1e-3 * Fresh.SceneLinear.Get(2, 34, 0) + 1e-4);
}

TEST_F(HistoryHazards, ExposureComesToOneValueFromBothSides)
{
	// Two frames a second for thirty seconds; 20 stops a second at most.
	const std::vector<FViewHistory> History = MakeHistory();
	double Ends[2] = {};
	for (const int Side : {0, 1})
	{
		std::vector<FViewHistory> Last = Copy(History);
		const float Scale = Side == 0 ? 1e-4f : 1e4f;
		std::memcpy(Last[0].Buffers[EyeAdaptationName]->GetRHI()->GetData(), &Scale, sizeof(Scale));
		FRunOptions Options = Ask(R"(, "fps": 2)");
		Options.Variables = {"r.AntiAliasingMethod=0"}; // its history would remember the other exposures
		FRunSession Session(Options);
		for (int Step = 0; Step < 60; ++Step)
		{
			Last[0].FrameNumber = 1; // each step is half a second
			FRunResult Result = Session.Run(2, Last);
			Ends[Side] = GetExposure(Result);
			Last = std::move(Result.ViewStates);
		}
	}
	EXPECT_NEAR(0.0, std::log2(Ends[0] / Ends[1]), 0.005); // EV
	std::printf("exposure from below %.6g, from above %.6g\n", Ends[0], Ends[1]);
}
