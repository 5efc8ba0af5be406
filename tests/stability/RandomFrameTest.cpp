// Random frames run in several ways that promise the same bits. A number of seeds runs with all tests;
// DRYDOCK_RANDOM_FRAMES="FIRST COUNT" chooses others (`./dev soak chains gates`); DRYDOCK_RANDOM_KEEP=1 leaves their
// configs in the folder of temporary files, for `drydock run` and `drydock prove`.
#include <gtest/gtest.h>

#include "RandomFrame.h"
#include "pipeline/SameBits.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

using namespace Drydock;

namespace Stability
{

namespace
{

/** How a frame is run. */
struct FWay
{
	const char* Name;
	std::vector<std::string> Variables = {};
	bool bNoSkip = false;
};

struct FSeeds
{
	uint32_t First = 0;
	uint32_t Count = 0;
};

FSeeds GetSeeds(uint32_t CountByDefault)
{
	const char* const Wanted = std::getenv("DRYDOCK_RANDOM_FRAMES");
	FSeeds Seeds{1, CountByDefault};
	if (Wanted != nullptr && std::sscanf(Wanted, "%u %u", &Seeds.First, &Seeds.Count) != 2)
	{
		throw std::runtime_error("DRYDOCK_RANDOM_FRAMES is \"FIRST COUNT\"");
	}
	return Seeds;
}

/** The two pictures of a run, or the message that it ends with. */
struct FOutcome
{
	FPicture SceneLinear;
	FPicture Final;
	bool bGateShut = false; // an effect was left out because of what the scene holds
	std::string Message;    // empty: it has run
};

FOutcome RunOnce(const FRandomScene& Scene, const FWay& Way)
{
	try
	{
		FRunResult Result = Scene.Run(Way.Variables, Way.bNoSkip);
		const bool bGateShut = std::any_of(Result.Effects.begin(), Result.Effects.end(),
			[](const FEffectDecision& Effect) { return Effect.bNothingToDo || Effect.Region.has_value(); });
		return {std::move(Result.SceneLinear), std::move(Result.Final), bGateShut, {}};
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode()) << Error.what();
		return {{}, {}, false, std::string("refused: ") + Error.what()};
	}
}

/** The same bits; one NaN is as good as another, whose sign no shader defines. */
testing::AssertionResult AreSameOrNaN(const FPicture& Base, const FPicture& Other)
{
	const auto Unsigned = [](FImage Image)
	{
		std::replace_if(
			Image.Values.begin(), Image.Values.end(), [](double Value) { return Value != Value; }, NAN);
		return Image;
	};
	return SameBits::AreSameBits(Unsigned(Base.ToImage()), Unsigned(Other.ToImage()));
}

testing::AssertionResult AreSame(const FOutcome& Base, const FOutcome& Other)
{
	if (Base.Message != Other.Message)
	{
		return testing::AssertionFailure() << "'" << Other.Message << "', expected '" << Base.Message << "'";
	}
	if (!Base.Message.empty())
	{
		return testing::AssertionSuccess();
	}
	const testing::AssertionResult Linear = AreSameOrNaN(Base.SceneLinear, Other.SceneLinear);
	return Linear ? AreSameOrNaN(Base.Final, Other.Final)
				  : testing::AssertionFailure() << "scene linear: " << Linear.message();
}

/** Runs every seed's frame as Base says and in the other ways; prints the seed and the config of what differs. Gives
 * the number of frames in which a gate is shut. */
uint32_t CheckFrames(const char* Kind, FSeeds Seeds, FRandomFrame (*Make)(uint32_t Seed), const FWay& Base,
	const std::vector<FWay>& Ways)
{
	uint32_t NumRefused = 0, NumShut = 0;
	std::printf("%s: seeds %u to %u\n", Kind, Seeds.First, Seeds.First + Seeds.Count - 1);
	for (uint32_t Seed = Seeds.First; Seed < Seeds.First + Seeds.Count; ++Seed)
	{
		const FRandomScene Scene(Make(Seed));
		const FOutcome Expected = RunOnce(Scene, Base);
		NumRefused += Expected.Message.empty() ? 0 : 1;
		NumShut += Expected.bGateShut ? 1 : 0;
		for (const FWay& Way : Ways)
		{
			EXPECT_TRUE(AreSame(Expected, RunOnce(Scene, Way)))
				<< Kind << " " << Seed << ", " << Way.Name << ", " << Scene.Frame.Picture.Width << "x"
				<< Scene.Frame.Picture.Height << ": " << Scene.Frame.Config;
		}
		std::printf("%s %u ends %s\n", Kind, Seed, Expected.Message.c_str());
		std::fflush(stdout);
	}
	EXPECT_LE(NumRefused * 10, Seeds.Count) << "so many frames are refused: the others say little";
	std::printf("%s: %u frames, %u of them refused, %u with a gate shut\n", Kind, Seeds.Count, NumRefused, NumShut);
	return NumShut;
}

} // namespace

TEST(RandomFrames, ChainsGiveTheSameBitsInEveryWay)
{
	CheckFrames("chain", GetSeeds(100), MakeRandomChain, {"two threads", {"r.Drydock.Threads=2"}},
		{{"one thread, unwritten memory is 1000", {"r.Drydock.Threads=1", "r.RDG.ClobberResources=1"}},
			{"nothing skipped, unwritten memory is NaN", {"r.Drydock.Threads=2", "r.RDG.ClobberResources=2"}, true},
			{"no native kernels, unwritten memory is infinite",
				{"r.Drydock.Threads=2", "r.Drydock.NativeKernels=0", "r.RDG.ClobberResources=3"}}});
}

TEST(RandomFrames, GatesAreNotFooled)
{
	const FSeeds Seeds = GetSeeds(60);
	const uint32_t NumShut =
		CheckFrames("gate", Seeds, MakeFoolingFrame, {"as it is"}, {{"nothing skipped", {}, true}});
	EXPECT_GT(NumShut * 4, Seeds.Count) << "a gate that never shuts is not tested";
}

} // namespace Stability
