// Temporal antialiasing over the frames of analytic scenes: how fast it comes to the truth, what it leaves of what has
// gone, cuts, pre-exposure that follows exposure, and what a run says of it.
#include "Run/Run.h"
#include "Scenes/JitteredScenes.h"
#include "SequenceTestUtils.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

using namespace Drydock;
using namespace SequenceTest;
using testing::HasSubstr;

namespace
{

constexpr FIntPoint GSize(80, 45);

/** The light of a picture, before the tonemapper. */
using FLight = std::vector<double>;

FLight GetLight(const FPicture& Picture)
{
	FLight Light;
	for (int Y = 0; Y < GSize.Y; ++Y)
	{
		for (int X = 0; X < GSize.X; ++X)
		{
			Light.push_back(static_cast<double>(Picture.Get(X, Y, 1)));
		}
	}
	return Light;
}

double GetRms(const FLight& A, const FLight& B)
{
	double Sum = 0.0;
	for (size_t Index = 0; Index < A.size(); ++Index)
	{
		Sum += (A[Index] - B[Index]) * (A[Index] - B[Index]);
	}
	return std::sqrt(Sum / static_cast<double>(A.size()));
}

/** The light that a camera with this jitter sees in each pixel. */
FLight Sample(const FAnalyticFrame& Frame, FVector2D Jitter)
{
	const FAnalyticPicture Picture(Frame);
	FLight Light;
	for (int Y = 0; Y < GSize.Y; ++Y)
	{
		for (int X = 0; X < GSize.X; ++X)
		{
			Light.push_back(static_cast<double>(Picture.FindShape(FVector2D(X + 0.5, Y + 0.5) - Jitter).Color.G));
		}
	}
	return Light;
}

FLight GetTruth(const FAnalyticFrame& Frame)
{
	const FAnalyticPicture Picture(Frame);
	FLight Light;
	for (int Y = 0; Y < GSize.Y; ++Y)
	{
		for (int X = 0; X < GSize.X; ++X)
		{
			Light.push_back(static_cast<double>(Picture.ComputeMean(X, Y).G));
		}
	}
	return Light;
}

/** Runs the frames of an analytic scene, one after another. More: of the config, before its end. */
class FSceneRun
{
public:
	FSceneRun(const std::string& Name, int NumFrames, int NumSamples, const std::string& More = "", bool bTruth = false)
		: Temporary("drydock_taa_" + Name)
	{
		FJitteredSceneOptions Scene;
		Scene.Scene = FindJitteredScene(Name);
		Scene.Size = GSize;
		Scene.NumFrames = NumFrames;
		Scene.NumSamples = NumSamples;
		WriteJitteredScene(Scene, Temporary.Path.string());
		Options.ConfigFile = (Temporary.Path / "test.json").string();
		Options.ConfigText =
			R"({"scene": {"file": ")" + Name + (bTruth ? ".truth" : "") + R"(.####.exr", "frames": "all"}, )" +
			(More.empty() ? R"("cvars": {"r.AntiAliasingMethod": 2, "r.Drydock.Storage": 1})" : More) + "}";
		Options.Frame = 1;
	}

	/** Calls Look with each frame's number, from 0 on, and result. */
	void Run(int NumFrames, const std::function<void(int, const FRunResult&)>& Look) const
	{
		FRunSession Session(Options);
		std::vector<FViewHistory> Last;
		for (int Frame = 0; Frame < NumFrames; ++Frame)
		{
			FRunResult Result = Session.Run(Frame + 1, Last);
			Last = Result.ViewStates;
			Look(Frame, Result);
		}
	}

	FRunOptions Options;

private:
	FTemporaryFolder Temporary;
};

/** Exposure so low that all colours weigh the same, and the middle sample alone: what is averaged is plain. */
const std::string PlainAverage = R"("view": {"exposure": 1e-6}, "cvars": {"r.AntiAliasingMethod": 2,
	"r.TemporalAAFilterSize": 0, "r.TemporalAACurrentFrameWeight": 0, "r.Drydock.Storage": 1})";

} // namespace

TEST(TemporalAARun, AStillSceneConvergesToTheTruthAsAPlainAverageDoes)
{
	constexpr int NumFrames = 64;
	const FAnalyticFrame Frame = FindJitteredScene("still")->MakeFrame(GSize, 0);
	const FLight Truth = GetTruth(Frame);
	FLight Sum(Truth.size(), 0.0);
	const FSceneRun Scene("still", NumFrames, NumFrames, PlainAverage);
	std::string Figures;
	Scene.Run(NumFrames,
		[&](int Number, const FRunResult& Result)
		{
			const FLight Seen = Sample(Frame, GetHaltonJitter(Number, NumFrames));
			FLight Average = Sum;
			for (size_t Index = 0; Index < Sum.size(); ++Index)
			{
				Sum[Index] += Seen[Index];
				Average[Index] = Sum[Index] / (Number + 1);
			}
			const double Error = GetRms(GetLight(Result.SceneLinear), Truth);
			const double PlainError = GetRms(Average, Truth);
			EXPECT_LE(Error, 1.2 * PlainError) << "after " << Number + 1 << " frames";
			if (((Number + 1) & Number) == 0)
			{
				Figures += " " + std::to_string(Number + 1) + ": " + std::to_string(Error) + " of " +
						   std::to_string(PlainError);
			}
		});
	RecordProperty("error_to_truth", Figures);
	std::printf("error to the truth after frames, and that of the plain average:%s\n", Figures.c_str());
}

TEST(TemporalAARun, WhatMovedAwayLeavesNoGhost)
{
	constexpr int NumFrames = 16;
	constexpr double BarLight = static_cast<double>(0.01f);
	const FJitteredScene& Occluder = *FindJitteredScene("occluder");
	const FSceneRun Scene("occluder", NumFrames, 8, R"("cvars": {"r.AntiAliasingMethod": 2, "r.BloomQuality": 0})");
	const FSceneRun Exact("occluder", NumFrames, 8, R"("cvars": {"r.BloomQuality": 0})", true);
	std::vector<FLight> Truth;
	Exact.Run(NumFrames, [&](int, const FRunResult& Result) { Truth.push_back(GetLight(Result.Final)); });
	const auto SampleAll = [&](int Frame)
	{
		return Sample(Occluder.MakeFrame(GSize, Frame), FVector2D(0.0, 0.0));
	};
	double Worst = 0.0;
	int NumPixels = 0;
	const auto Compare = [&](int Number, const FRunResult& Result)
	{
		const FLight Final = GetLight(Result.Final);
		const FLight Now = SampleAll(Number);
		const FLight Before = SampleAll(Number - 4);
		const auto GetIndex = [](int X, int Y)
		{
			return static_cast<size_t>(Y * GSize.X + X);
		};
		for (int Y = 2; Number >= 8 && Y < GSize.Y - 2; Y += 3)
		{
			for (int X = 2; X < GSize.X - 2; ++X)
			{
				// Covered four frames ago, and now one colour all around, so that no edge explains a difference.
				const double Own = Now[GetIndex(X, Y)];
				bool bPlain = Own != BarLight && Before[GetIndex(X, Y)] == BarLight;
				for (int Index = 0; Index < 25 && bPlain; ++Index)
				{
					bPlain = Now[GetIndex(X + Index % 5 - 2, Y + Index / 5 - 2)] == Own;
				}
				if (bPlain)
				{
					const size_t Index = GetIndex(X, Y);
					Worst = std::max(Worst, 255.0 * std::abs(Final[Index] - Truth[static_cast<size_t>(Number)][Index]));
					++NumPixels;
				}
			}
		}
	};
	Scene.Run(NumFrames, Compare);
	EXPECT_GT(NumPixels, 100);
	EXPECT_LE(Worst, 2.0);
	std::printf("ghost after four frames: %.3f codes at the most, of %d pixels\n", Worst, NumPixels);
}

TEST(TemporalAARun, ACutForgetsWhatWasBefore)
{
	const FSceneRun Scene("cut", 10, 8);
	Scene.Run(10,
		[&](int Number, const FRunResult& Result)
		{
			if (Number == FindJitteredScene("cut")->CutFrame)
			{
				// As a first frame: the same frame alone, without history.
				FRunSession Alone(Scene.Options);
				EXPECT_EQ(GetLight(Alone.Run(Number + 1, {}).SceneLinear), GetLight(Result.SceneLinear));
			}
		});
}

TEST(TemporalAARun, PreExposureThatFollowsExposureDrawsTheSamePicture)
{
	const std::string Exposure = R"("view": {"exposure": "auto", "preExposure": )";
	const std::string Variables = R"(}, "cvars": {"r.AntiAliasingMethod": 2, "r.Drydock.Storage": 1})";
	const FSceneRun On("line", 8, 8, Exposure + R"("auto")" + Variables);
	const FSceneRun Off("line", 8, 8, Exposure + "1" + Variables);
	std::vector<FLight> Pictures;
	std::vector<float> Scales;
	On.Run(8,
		[&](int, const FRunResult& Result)
		{
			Pictures.push_back(GetLight(Result.Final));
			Scales.push_back(Result.ExposureScale);
		});
	// A sample's place in the table of colours is rounded to 1/256 texel, so that single pixels part by more.
	double Worst = 0.0;
	double WorstRms = 0.0;
	Off.Run(8,
		[&](int Number, const FRunResult& Result)
		{
			const FLight Final = GetLight(Result.Final);
			EXPECT_NEAR(1.0f, Result.ExposureScale / Scales[static_cast<size_t>(Number)], 1e-4f) << Number;
			WorstRms = std::max(WorstRms, GetRms(Final, Pictures[static_cast<size_t>(Number)]));
			for (size_t Index = 0; Index < Final.size(); ++Index)
			{
				Worst = std::max(Worst, std::abs(Final[Index] - Pictures[size_t(Number)][Index]));
			}
		});
	EXPECT_LE(Worst, 5e-4);
	EXPECT_LE(WorstRms, 1e-5);
	std::printf("pre-exposure on and off differ by %.2e of the display's range at most, rms %.2e\n", Worst, WorstRms);
}

TEST(TemporalAARun, AFrameAloneAndFramesWithoutJitterAreSaid)
{
	const auto Says = [](const FRunResult& Result)
	{
		std::string All;
		for (const FDiagnostic& Diagnostic : Result.Diagnostics)
		{
			All += Diagnostic.Message + "\n";
		}
		return All;
	};
	FRunOptions Options;
	Options.ConfigFile = "test.json";
	const std::string Scenes = DRYDOCK_TEST_SOURCE_DIR "/configs/scenes/";
	Options.ConfigText =
		R"({"scene": {"file": ")" + Scenes + R"(moving_camera.0001.exr"}, "cvars": {"r.AntiAliasingMethod": 2}})";
	EXPECT_THAT(Says(RunConfig(Options)), HasSubstr("this scene is one frame"));
	Options.ConfigText =
		R"({"scene": {"file": ")" + Scenes + R"(moving_camera.####.exr"}, "cvars": {"r.AntiAliasingMethod": 2}})";
	Options.Frame = 2;
	EXPECT_THAT(Says(RunConfig(Options)), HasSubstr("has no jitter"));
	const FSceneRun Jittered("still", 1, 8);
	Jittered.Run(
		1, [&](int, const FRunResult& Result) { EXPECT_THAT(Says(Result), testing::Not(HasSubstr("TemporalAA"))); });
}
