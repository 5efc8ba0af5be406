// Runs in a row that share a cache of passes compute what a change reaches and nothing else, and give the same bits.
#include "DispatchReuse.h"
#include "Run/RunJson.h"
#include "Run/RunTestScene.h"
#include "SameBits.h"

#include <cstdlib>
#include <random>
#include <set>

using namespace RunTest;

namespace
{

const char* const Bloom = R"("camera": {"Settings": {"BloomIntensity": 1.5, "BloomThreshold": 0.5}})";

FRunResult RunWith(
	FRunOptions Options, const std::vector<std::string>& Settings, const std::shared_ptr<FReuseCache>& Cache)
{
	Options.Settings.insert(Options.Settings.end(), Settings.begin(), Settings.end());
	Options.bFingerprints = true;
	Options.ReuseCache = Cache;
	return RunConfig(Options);
}

const FRDGCompiledPass& GetPass(const FRunResult& Result, const FRunPass& Pass)
{
	return Result.Graph.Passes[static_cast<size_t>(Pass.Index)];
}

/** Passes that a change reaches, of those with a shader: the passes of these names, whose parameters it changes, and
 * their readers. */
std::vector<std::string> ListReached(const FRunResult& Result, const std::string& Changed)
{
	std::set<int32_t> Reached;
	std::vector<std::string> Names;
	for (const FRDGCompiledPass& Pass : Result.Graph.Passes)
	{
		const bool bReads =
			std::ranges::any_of(Pass.Producers, [&Reached](int32_t Producer) { return Reached.contains(Producer); });
		if (!Pass.bIsSentinel && (bReads || MatchesPattern(Changed, Pass.Name)))
		{
			Reached.insert(Pass.Index);
		}
	}
	for (const FRunPass& Pass : Result.Passes)
	{
		if (Pass.Counters.Dispatches > 0 && Reached.contains(Pass.Index))
		{
			Names.push_back(GetPass(Result, Pass).Name);
		}
	}
	return Names;
}

/** Names of passes that computed something with a shader. */
std::vector<std::string> ListComputed(const FRunResult& Result)
{
	std::vector<std::string> Names;
	for (const FRunPass& Pass : Result.Passes)
	{
		if (Pass.Counters.Reused < Pass.Counters.Dispatches)
		{
			Names.push_back(GetPass(Result, Pass).Name);
		}
	}
	return Names;
}

/** Runs a frame, changes a setting, which is a parameter of passes of these names, and compares what is computed with
 * what the graph says. Returns the names of what is. */
std::vector<std::string> ExpectOnlyReachedRuns(const std::string& Setting, const std::string& Changed)
{
	const auto Cache = std::make_shared<FReuseCache>();
	const FRunResult Before = RunWith(SmallScene(Bloom), {}, Cache);
	EXPECT_EQ(0, std::ranges::count_if(Before.Passes, &FRunPass::IsReused));
	const FRunResult After = RunWith(SmallScene(Bloom), {Setting}, Cache);
	EXPECT_EQ(Before.Passes.size(), After.Passes.size());
	EXPECT_EQ(ListReached(After, Changed), ListComputed(After));
	for (const FRunPass& Pass : After.Passes)
	{
		EXPECT_EQ("", Pass.Counters.NotReusable) << GetPass(After, Pass).Name;
	}
	EXPECT_FALSE(SameBits::AreSameBits(Before.Final, After.Final));
	EXPECT_TRUE(SameBits::AreSameBits(RunWith(SmallScene(Bloom), {Setting}, nullptr).Final, After.Final));
	return ListComputed(After);
}

/** A frame, or the message of the mistake that kept it from running: an edit may ask for an effect that the scene of a
 * config cannot have. */
struct FOutcome
{
	FRunResult Result;
	std::string Error;
};

FOutcome TryRun(
	const FRunOptions& Options, const std::vector<std::string>& Settings, const std::shared_ptr<FReuseCache>& Cache)
{
	FOutcome Outcome;
	try
	{
		Outcome.Result = RunWith(Options, Settings, Cache);
	}
	catch (const std::exception& Exception)
	{
		Outcome.Error = Exception.what();
	}
	return Outcome;
}

bool HasName(const std::vector<std::string>& Names, const std::string& Part)
{
	return std::ranges::any_of(
		Names, [&Part](const std::string& Name) { return Name.find(Part) != std::string::npos; });
}

} // namespace

TEST(Reuse, TheSameFrameComputesNothing)
{
	const auto Cache = std::make_shared<FReuseCache>();
	const FRunResult Before = RunWith(SmallScene(Bloom), {}, Cache);
	const FRunResult After = RunWith(SmallScene(Bloom), {}, Cache);
	EXPECT_EQ((std::vector<std::string>()), ListComputed(After));
	EXPECT_GT(std::ranges::count_if(After.Passes, &FRunPass::IsReused), 10);
	EXPECT_EQ(Before.RunJson, After.RunJson);
}

TEST(Reuse, TheTonemappersGammaDoesNotRunTheBloom)
{
	const std::vector<std::string> Computed = ExpectOnlyReachedRuns("ColorGamma=(1.2,1.1,1.0,1.0)", "CombineLUTs*");
	EXPECT_TRUE(HasName(Computed, "Tonemap"));
	EXPECT_FALSE(HasName(Computed, "Bloom"));
	EXPECT_EQ(2u, Computed.size()) << "the table of colours, and its reader";
}

TEST(Reuse, TheBloomsIntensityRunsTheSumsAndNotTheSetup)
{
	// It is in the weights of each level's second direction.
	const std::vector<std::string> Computed = ExpectOnlyReachedRuns("BloomIntensity=2", "Bloom?Y*");
	EXPECT_TRUE(HasName(Computed, "Bloom1Y"));
	EXPECT_FALSE(HasName(Computed, "Setup"));
	EXPECT_FALSE(HasName(Computed, "Bloom1X"));
}

TEST(Reuse, TheBloomsThresholdRunsTheBloom)
{
	const std::vector<std::string> Computed = ExpectOnlyReachedRuns("BloomThreshold=1", "BloomSetup*");
	EXPECT_TRUE(HasName(Computed, "Bloom1X"));
	EXPECT_TRUE(HasName(Computed, "Tonemap"));
}

/** Each frame reads what lives on of the one before. */
TEST(Reuse, FramesOfASequenceHaveTheSameBits)
{
	FRunOptions Options;
	Options.ConfigFile = Root + "configs/sequence.json";
	Options.bFingerprints = true;
	const auto RunFrames = [&Options](const std::shared_ptr<FReuseCache>& Cache)
	{
		Options.ReuseCache = Cache;
		FRunSession Session(Options);
		std::vector<FViewHistory> Last;
		std::vector<std::string> Reports;
		for (int Frame = 1; Frame <= 3; ++Frame)
		{
			FRunResult Result = Session.Run(Frame, Last);
			Last = Result.ViewStates;
			Reports.push_back(Result.RunJson);
		}
		return Reports;
	};
	const std::vector<std::string> Own = RunFrames(nullptr);
	const auto Cache = std::make_shared<FReuseCache>();
	EXPECT_EQ(Own, RunFrames(Cache));
	EXPECT_EQ(Own, RunFrames(Cache));
}

TEST(Reuse, LittleMemoryIsSlowerAndTheSame)
{
	const auto Cache = std::make_shared<FReuseCache>(1 << 20);
	const FRunResult Before = RunWith(SmallScene(Bloom), {}, Cache);
	const FRunResult After = RunWith(SmallScene(Bloom), {}, Cache);
	EXPECT_LE(Cache->GetBytes(), uint64(1) << 20);
	EXPECT_FALSE(ListComputed(After).empty());
	EXPECT_TRUE(SameBits::AreSameBits(Before.Final, After.Final));
}

TEST(Reuse, TimingJsonNamesThePassesThatWereReused)
{
	const auto Cache = std::make_shared<FReuseCache>();
	RunWith(SmallScene(Bloom), {}, Cache);
	const FRunResult After = RunWith(SmallScene(Bloom), {"ColorGamma=(1.2,1.1,1.0,1.0)"}, Cache);
	const std::string Text = MakeTimingJson(After, 0.0, "");
	size_t NumReused = 0;
	for (size_t At = Text.find("\"reused\": true"); At != std::string::npos; At = Text.find("\"reused\": true", At + 1))
	{
		++NumReused;
	}
	EXPECT_EQ(size_t(std::ranges::count_if(After.Passes, &FRunPass::IsReused)), NumReused);
	EXPECT_GT(NumReused, 0u);
	EXPECT_NE(std::string::npos, Text.find("\"reused\": false"));
}

/** Every shipped config, with random edits one after the other: each pass writes the bits that it writes in a run of
 * its own, and run.json has the same bytes. */
TEST(Reuse, RandomEditsOfShippedConfigsGiveTheBitsOfRunsOfTheirOwn)
{
	const std::pair<const char*, double> Settings[] = {{"BloomIntensity", 2}, {"BloomThreshold", 2},
		{"VignetteIntensity", 1}, {"AutoExposureBias", 2}, {"FilmSlope", 1}, {"FilmToe", 1},
		{"SceneFringeIntensity", 3}, {"LensFlareIntensity", 1}, {"MotionBlurAmount", 1}, {"WhiteTemp", 9000},
		{"DepthOfFieldFocalDistance", 600}, {"Sharpen", 2}, {"FilmGrainIntensity", 1}, {"BloomSizeScale", 6}};
	const std::pair<const char*, int> Variables[] = {{"r.BloomQuality", 6}, {"r.Tonemapper.Quality", 6},
		{"r.MotionBlurQuality", 5}, {"r.DepthOfFieldQuality", 3}, {"r.Upscale.Quality", 4}};
	std::mt19937 Random(414);
	const auto Below = [&Random](size_t End)
	{
		return Random() % End;
	};
	const char* const Wanted = std::getenv("DRYDOCK_EQUIVALENCES");
	const size_t OneIn = Wanted != nullptr && std::string(Wanted) == "all" ? 1 : 4;
	std::vector<std::string> Configs;
	for (const auto& Entry : std::filesystem::directory_iterator(Root + "configs"))
	{
		if (Entry.path().extension() == ".json")
		{
			Configs.push_back(Entry.path().string());
		}
	}
	std::ranges::sort(Configs);
	uint64_t NumReused = 0;
	size_t NumRefused = 0;
	for (size_t Config = 0; Config < Configs.size(); Config += OneIn)
	{
		FRunOptions Options;
		Options.ConfigFile = Configs[Config];
		const auto Cache = std::make_shared<FReuseCache>();
		for (int Edit = 0; Edit < 3; ++Edit)
		{
			std::vector<std::string> Edited;
			const auto& [Setting, Most] = Settings[Below(std::size(Settings))];
			if (Edit > 0)
			{
				Edited.push_back(std::string(Setting) + "=" + std::to_string(Most * double(Below(100)) / 100.0));
				const auto& [Variable, End] = Variables[Below(std::size(Variables))];
				Options.Variables = {std::string(Variable) + "=" + std::to_string(Below(size_t(End)))};
			}
			SCOPED_TRACE(Options.ConfigFile + ", edit " + std::to_string(Edit) + " " +
						 (Edited.empty() ? "" : Edited[0] + " " + Options.Variables[0]));
			const FOutcome Own = TryRun(Options, Edited, nullptr);
			const FOutcome Reused = TryRun(Options, Edited, Cache);
			EXPECT_EQ(Own.Error, Reused.Error);
			NumRefused += Own.Error.empty() ? 0 : 1;
			EXPECT_EQ(Own.Result.RunJson, Reused.Result.RunJson);
			EXPECT_TRUE(SameBits::AreSameBits(Own.Result.Final, Reused.Result.Final));
			NumReused += uint64_t(std::ranges::count_if(Reused.Result.Passes, &FRunPass::IsReused));
		}
	}
	EXPECT_GT(NumReused, 50u);
	EXPECT_LT(NumRefused, Configs.size() / OneIn / 4) << "too few edits were compared";
}
