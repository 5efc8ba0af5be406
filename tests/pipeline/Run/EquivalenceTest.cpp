// The promise of equal bits: whatever may change how a frame is computed but not what it is (threads, lane width,
// aliasing, skipping, immediate mode, clobbered memory) leaves every output of every shipped config bit for bit the
// same. A config joins by lying in configs/, an equivalence by a line in GEquivalences.
#include <gtest/gtest.h>

#include "LanesScalarCalls.h"
#include "Run/Run.h"
#include "SameBits.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace
{

using namespace Drydock;
using SameBits::AreSameBits;

struct FEquivalence
{
	const char* Name;
	std::vector<std::string> Variables;
	bool bNoSkip = false;
};

// TransientAllocator 0 puts every texture into memory of its own; ExtendResourceLifetimes keeps the heap, unshared.
const std::vector<FEquivalence> GEquivalences = {
	{"OneThread", {"r.Drydock.Threads=1"}},
	{"TwoThreads", {"r.Drydock.Threads=2"}},
	{"SevenThreads", {"r.Drydock.Threads=7"}},
	{"FourLanes", {"r.Drydock.LaneWidth=4"}},
	{"EightLanes", {"r.Drydock.LaneWidth=8"}},
	{"ShadersOnly", {"r.Drydock.NativeKernels=0"}},
	{"NoTransientHeap", {"r.RDG.TransientAllocator=0"}},
	{"NoAliasing", {"r.RDG.Debug.ExtendResourceLifetimes=1"}},
	{"NoSkip", {}, true},
	{"ImmediateMode", {"r.RDG.ImmediateMode=1"}},
	{"Clobbered1000", {"r.RDG.ClobberResources=1"}},
	{"ClobberedNaN", {"r.RDG.ClobberResources=2"}},
	{"ClobberedInf", {"r.RDG.ClobberResources=3"}},
};

FRunResult RunWith(const std::string& ConfigFile, const std::vector<std::string>& Variables, bool bNoSkip = false)
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFile;
	Options.Variables = Variables;
	Options.bNoSkip = bNoSkip;
	return RunConfig(Options);
}

/** The plain run, made once per config. */
const FRunResult& GetPlainRun(const std::string& ConfigFile)
{
	static std::map<std::string, FRunResult> Runs;
	const auto Found = Runs.find(ConfigFile);
	return Found != Runs.end() ? Found->second : Runs.emplace(ConfigFile, RunWith(ConfigFile, {})).first->second;
}

std::vector<std::string> FindShippedConfigs()
{
	std::vector<std::string> Configs;
	for (const auto& Entry : std::filesystem::directory_iterator(DRYDOCK_TEST_SOURCE_DIR "/configs"))
	{
		if (Entry.path().extension() == ".json")
		{
			Configs.push_back(Entry.path().string());
		}
	}
	std::sort(Configs.begin(), Configs.end());
	return Configs;
}

class Equivalence : public testing::TestWithParam<std::tuple<std::string, FEquivalence>>
{
};

std::string GetTestName(const testing::TestParamInfo<Equivalence::ParamType>& Info)
{
	std::string Name = std::filesystem::path(std::get<0>(Info.param)).stem().string();
	std::replace_if(
		Name.begin(), Name.end(), [](char Letter) { return !std::isalnum(static_cast<unsigned char>(Letter)); }, '_');
	return Name + "_" + std::get<1>(Info.param).Name;
}

} // namespace

TEST_P(Equivalence, GivesTheSameBits)
{
	const auto& [ConfigFile, Mode] = GetParam();
	const FRunResult& Expected = GetPlainRun(ConfigFile);
	const FRunResult Actual = RunWith(ConfigFile, Mode.Variables, Mode.bNoSkip);
	ASSERT_FALSE(Expected.Final.ToImage().Values.empty());
	EXPECT_TRUE(AreSameBits(Expected.SceneLinear, Actual.SceneLinear)) << "scene_linear";
	EXPECT_TRUE(AreSameBits(Expected.Final, Actual.Final)) << "final";
}

INSTANTIATE_TEST_SUITE_P(ShippedConfigs, Equivalence,
	testing::Combine(testing::ValuesIn(FindShippedConfigs()), testing::ValuesIn(GEquivalences)), GetTestName);

class ScalarCalls : public testing::TestWithParam<std::string>
{
};

TEST_P(ScalarCalls, NoShippedConfigReadsOrWritesTexelByTexel)
{
	const uint64_t Before = GetScalarCalls();
	RunWith(GetParam(), {});
	EXPECT_EQ(Before, GetScalarCalls());
}

INSTANTIATE_TEST_SUITE_P(ShippedConfigs, ScalarCalls, testing::ValuesIn(FindShippedConfigs()),
	[](const testing::TestParamInfo<std::string>& Info) { return std::filesystem::path(Info.param).stem().string(); });

TEST(EquivalenceHarness, NoticesASingleBit)
{
	const FImage Black{2, 1, 1, {0.0, 0.0}};
	EXPECT_TRUE(AreSameBits(Black, Black));
	EXPECT_FALSE(AreSameBits(Black, FImage{2, 1, 1, {0.0, -0.0}}));
}

TEST(EquivalenceHarness, RunsTwiceAlikeDownToTheReport)
{
	const std::string ConfigFile = FindShippedConfigs().at(0);
	EXPECT_EQ(GetPlainRun(ConfigFile).RunJson, RunWith(ConfigFile, {}).RunJson);
}

TEST(EquivalenceHarness, FindsTheShippedConfigs)
{
	EXPECT_GE(FindShippedConfigs().size(), 4u);
}
