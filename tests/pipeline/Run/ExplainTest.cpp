// `drydock explain`: whose pass a pass is, what it says of a frame, that plans are what runs do, and the cost model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Run/Explain.h"

#include <algorithm>
#include <map>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

FRunResult RunShipped(const std::string& Config, bool bExecute, bool bNoSkip = false)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/" + Config;
	Options.bExecute = bExecute;
	Options.bPlanLoads = true;
	Options.bNoSkip = bNoSkip;
	return RunConfig(Options);
}

FExplainReport Explain(const std::string& Config)
{
	return MakeExplainReport(RunShipped(Config, false), RunShipped(Config, false, true), FCostModel());
}

std::vector<std::string> GetDecoded(const FRunResult& Result)
{
	std::vector<std::string> Names;
	for (const FSceneChannel& Channel : Result.Channels)
	{
		if (Channel.bDecoded)
		{
			Names.push_back(Channel.Name);
		}
	}
	return Names;
}

/** One pass of Name that writes 100 x 50 texels. */
FRunResult MakeRun(const std::string& Name, double Milliseconds)
{
	FRunResult Result;
	Result.Precision = "float";
	Result.Storage = "native";
	Result.Threads = 2;
	FRDGCompiledResource& Texture = Result.Graph.Resources.emplace_back();
	Texture.Extent = FIntVector(100, 50, 1);
	FRDGCompiledPass& Pass = Result.Graph.Passes.emplace_back();
	Pass.Name = Name;
	FRDGUse& Use = Pass.Uses.emplace_back();
	Use.Resource = 0;
	Use.Access = ERHIAccess::UAVCompute;
	Result.Passes.push_back({0, Milliseconds, {}});
	return Result;
}

double Estimate(const FCostModel& Model, const FRunResult& Result)
{
	return Model.EstimateMilliseconds(Result.Graph, Result.Graph.Passes[0], MakeCostConditions(Result));
}

} // namespace

TEST(EffectOfPass, IsTheInnermostThatAddsIt)
{
	const std::map<std::string, std::string> Expected = {{"HalfResolutionSceneColor", "Bloom"}, {"Tonemap", "Tonemap"},
		{"CombineLUTs", "Tonemap"}, {"ToonBloomMask", "ToonBloom"}, {"BloomSetup", "Bloom"}};
	std::map<std::string, std::string> Found;
	for (const FRDGCompiledPass& Pass : RunShipped("toon_bloom.json", false).Graph.Passes)
	{
		const std::string Short = Pass.Name.substr(0, Pass.Name.find_first_of(" ("));
		if (Expected.count(Short) != 0)
		{
			Found[Short] = Pass.Effect;
		}
	}
	EXPECT_EQ(Expected, Found);
}

TEST(EffectOfPass, EveryPassOfAFrameWithoutExtensionsHasOne)
{
	for (const char* Config : {"frame_full.json", "red_diffusion.json", "bloom_fft.json", "screen_percentage.json"})
	{
		for (const FRDGCompiledPass& Pass : RunShipped(Config, false).Graph.Passes)
		{
			EXPECT_TRUE(Pass.bIsSentinel || FindEffectByName(Pass.Effect) != nullptr) << Config << ": " << Pass.Name;
		}
	}
}

TEST(EffectOfPass, AnEffectsOwnExtensionSaysWhoseItsPassesAre)
{
	int NumPasses = 0;
	for (const FRDGCompiledPass& Pass : RunShipped("kawase_motionblur.json", false).Graph.Passes)
	{
		NumPasses += Pass.Effect == "DualKawaseBlur";
	}
	EXPECT_EQ(6, NumPasses); // three down, three up
}

TEST(EffectOfPass, APassKnowsThePixelsThatItDraws)
{
	for (const FRDGCompiledPass& Pass : RunShipped("toon_bloom.json", false).Graph.Passes)
	{
		if (Pass.Name.starts_with("Tonemap"))
		{
			EXPECT_GT(Pass.Area.X, 0) << Pass.Name;
			EXPECT_NE(
				std::string::npos, Pass.Name.find(std::to_string(Pass.Area.X) + "x" + std::to_string(Pass.Area.Y)));
		}
	}
}

TEST(CostModel, LearnsNanosecondsPerTexel)
{
	FCostModel Model;
	// 5000 texels in 0.05 ms: 10 ns each.
	Model.Learn(MakeRun("A", 0.05));
	EXPECT_DOUBLE_EQ(0.05, Estimate(Model, MakeRun("A", 0.0)));
	// A second run of 0.15 ms: the mean of both.
	Model.Learn(MakeRun("A", 0.15));
	EXPECT_DOUBLE_EQ(0.1, Estimate(Model, MakeRun("A", 0.0)));
}

TEST(CostModel, PassesOfOneNameCostAlikeWhateverTheirNumber)
{
	FCostModel Model;
	Model.Learn(MakeRun("Blur 480x270", 0.05));
	EXPECT_TRUE(Model.IsKnown(MakeRun("Blur 96x54", 0.0).Graph.Passes[0], "float native 2"));
	EXPECT_FALSE(Model.IsKnown(MakeRun("Blur 96x54", 0.0).Graph.Passes[0], "double float64 2"));
}

TEST(CostModel, APassOfAPartCostsThePart)
{
	// 5000 texels are declared, 20 x 10 drawn: 0.01 ms are 50 ns each.
	FCostModel Model;
	const auto MakePart = [](FIntPoint Area, double Milliseconds)
	{
		FRunResult Result = MakeRun("CharaGlow", Milliseconds);
		Result.Graph.Passes[0].Area = Area;
		return Result;
	};
	Model.Learn(MakePart({20, 10}, 0.01));
	EXPECT_DOUBLE_EQ(0.25, Estimate(Model, MakePart({100, 50}, 0.0)));
	EXPECT_DOUBLE_EQ(0.25, Estimate(Model, MakePart({1920, 1080}, 0.0))); // no more than there is
	EXPECT_DOUBLE_EQ(0.25, Estimate(Model, MakePart({0, 0}, 0.0)));       // not known: all of it
}

TEST(CostModel, WhatAPassReadsTellsItsPermutationsApart)
{
	const auto MakeReading = [](const char* Texture, double Milliseconds)
	{
		FRunResult Result = MakeRun("Tonemap", Milliseconds);
		Result.Graph.Resources.emplace_back().Name = Texture;
		FRDGUse& Use = Result.Graph.Passes[0].Uses.emplace_back();
		Use.Resource = 1;
		Use.Access = ERHIAccess::SRVGraphics;
		return Result;
	};
	FCostModel Model;
	Model.Learn(MakeReading("SceneColor", 1.0));
	Model.Learn(MakeReading("BilateralGrid", 3.0));
	EXPECT_DOUBLE_EQ(1.0, Estimate(Model, MakeReading("SceneColor", 0.0)));
	EXPECT_DOUBLE_EQ(3.0, Estimate(Model, MakeReading("BilateralGrid", 0.0)));
	EXPECT_DOUBLE_EQ(2.0, Estimate(Model, MakeReading("Another", 0.0))); // the mean of the shader's
}

TEST(CostModel, GuessesWhatItNeverSaw)
{
	// 5000 texels of 2 ns.
	EXPECT_DOUBLE_EQ(0.01, Estimate(FCostModel(), MakeRun("A", 0.0)));
}

TEST(CostModel, ComesBackFromItsFileAndSurvivesABrokenOne)
{
	FCostModel Model;
	Model.Learn(MakeRun("A", 0.05));
	EXPECT_EQ(Model.ToJson(), FCostModel::FromJson(Model.ToJson()).ToJson());
	EXPECT_EQ(FCostModel().ToJson(), FCostModel::FromJson("{\"A\": ").ToJson());
	EXPECT_EQ(FCostModel().ToJson(), FCostModel::FromJson("").ToJson());
}

TEST(Explain, PlansTheChannelsThatARunDecodes)
{
	for (const char* Config : {"toon_bloom.json", "chara_glow.json", "red_depth_of_field.json", "neutral.json"})
	{
		EXPECT_EQ(GetDecoded(RunShipped(Config, true)), GetDecoded(RunShipped(Config, false))) << Config;
		EXPECT_EQ(GetDecoded(RunShipped(Config, true, true)), GetDecoded(RunShipped(Config, false, true))) << Config;
	}
}

TEST(Explain, CountsWhatRunsAndWhatIsSaved)
{
	const FRunResult Frame = RunShipped("bloom_threshold.json", true);
	const FRunResult NoSkip = RunShipped("bloom_threshold.json", true, true);
	const FExplainReport Report = Explain("bloom_threshold.json");
	EXPECT_EQ(static_cast<int>(Frame.Passes.size()), Report.Cost.NumPasses);
	EXPECT_EQ(static_cast<int>(NoSkip.Passes.size()), Report.WithoutSkipping.NumPasses);
	EXPECT_GT(Report.WithoutSkipping.NumPasses, Report.Cost.NumPasses); // the scene's own downsample chain
	EXPECT_EQ(NoSkip.Graph.Memory.TransientPeakBytes, Report.WithoutSkipping.TransientBytes);
}

TEST(Explain, SaysWhyTheSetupPassIsNotThere)
{
	// No threshold, and nothing masks: bloom starts from the scene's own chain.
	EXPECT_THAT(MakeExplainText(Explain("two_views.json"), false), HasSubstr("the setup pass is not needed"));
	EXPECT_THAT(
		MakeEffectText(Explain("neutral.json"), "ToonBloom"), HasSubstr("ToonBloom does not run: not called for"));
}

TEST(Explain, OfAPassSaysWhoReadsItAndWhyItIsCulled)
{
	const FExplainReport Report = Explain("bloom_threshold.json");
	EXPECT_THAT(MakePassText(Report, "BloomSetup"), HasSubstr("reads    HalfResolutionSceneColor"));
	EXPECT_THAT(MakePassText(Report, "SceneDownsample"), HasSubstr("runs     no: no reader"));
}

TEST(Explain, UnknownNamesAreAnswered)
{
	const FExplainReport Report = Explain("bloom_threshold.json");
	try
	{
		MakeEffectText(Report, "Blom");
		FAIL();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_THAT(Error.GetDiagnostics()[0].Message, HasSubstr("did you mean Bloom?"));
	}
	EXPECT_THROW(MakePassText(Report, "BloomSetp"), FError);
}

TEST(Explain, MeasuredTimesTakeTheEstimatesPlace)
{
	const FRunResult Frame = RunShipped("bloom_threshold.json", false);
	FMeasuredPasses Measured;
	for (const FRDGCompiledPass& Pass : Frame.Graph.Passes)
	{
		Measured.push_back({Pass.Index, 3.0});
	}
	const FExplainReport Report = MakeExplainReport(Frame, Frame, FCostModel(), &Measured, &Measured);
	EXPECT_DOUBLE_EQ(3.0 * Report.Cost.NumPasses, Report.Cost.Milliseconds);
	EXPECT_EQ(0, Report.NumUnknown);
	EXPECT_THAT(MakeExplainText(Report, false),
		HasSubstr(
			"saved    0 passes, 0.0 million texels, 0.0 million taps, 0.0 MB read and written, 0.0 MB of memory, 0 "
			"channels; about 0.0 ms on this machine, against"));
}

TEST(Explain, WhatIsCountedIsTheSameInEveryRun)
{
	const auto Measure = []
	{
		FRunOptions Options;
		Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/called_for.json";
		const FRunResult Frame = RunConfig(Options);
		Options.bNoSkip = true;
		const FMeasuredPasses None;
		return MakeExplainReport(Frame, RunConfig(Options), FCostModel(), &None, &None);
	};
	const FExplainReport A = Measure(), B = Measure();
	EXPECT_GT(A.WithoutSkipping.Taps, A.Cost.Taps);
	EXPECT_GT(A.WithoutSkipping.BytesMoved, A.Cost.BytesMoved);
	EXPECT_GT(A.WithoutSkipping.Texels, A.Cost.Texels);
	EXPECT_EQ(A.Cost.Taps, B.Cost.Taps);
	EXPECT_EQ(A.Cost.BytesMoved, B.Cost.BytesMoved);
	EXPECT_EQ(MakeExplainText(A, false), MakeExplainText(B, false));
}

TEST(Explain, ASavingIsGivenWithItsSpread)
{
	const FRunResult Frame = RunShipped("bloom_threshold.json", false);
	FExplainReport Report = MakeExplainReport(Frame, Frame, FCostModel());
	Report.Saved = MakeMeasuredSaving({3.0, 1.0, 2.0});
	EXPECT_THAT(MakeExplainText(Report, false),
		HasSubstr("; 2.0 ms (1.0 to 3.0 in 3 pairs of runs), against the same frame with --no-skip\n"));
}
