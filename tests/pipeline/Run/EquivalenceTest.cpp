// The promise of equal bits: whatever may change how a frame is computed but not what it is (threads, lane width,
// aliasing, skipping, immediate mode, clobbered memory, the place in a texture) leaves every output of every shipped
// config the same. A config joins by lying in configs/, an equivalence by an entry in pipeline/Prove/Equivalence.cpp.
#include <gtest/gtest.h>

#include "LanesScalarCalls.h"
#include "Prove/Prove.h"
#include "Run/Run.h"
#include "SameBits.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>

namespace
{

using namespace Drydock;
using SameBits::AreSameBits;

FRunResult RunPlain(const std::string& ConfigFile)
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFile;
	return RunConfig(Options);
}

/** The plain run, made once per config. */
const FRunResult& GetPlainRun(const std::string& ConfigFile)
{
	static std::map<std::string, FRunResult> Runs;
	const auto Found = Runs.find(ConfigFile);
	return Found != Runs.end() ? Found->second : Runs.emplace(ConfigFile, RunPlain(ConfigFile)).first->second;
}

/** Of the view that both frames of an equivalence show. */
struct FSharedPictures
{
	FPicture SceneLinear;
	FPicture Final;
};

FSharedPictures RunShared(const std::string& ConfigFile, const FEquivalenceRun& Run, const FViewRect& View)
{
	FRunOptions Options;
	Options.ConfigFile = ConfigFile;
	const FRunResult Result = RunEquivalent(Options, Run, View);
	if (Run.Layout == EViewLayout::AsConfigured)
	{
		return {Result.SceneLinear, Result.Final};
	}
	const FViewRect Rect = FindSharedView(Run, View);
	return {FPicture(), Result.Final.Crop(FIntRect(Rect[0], Rect[1], Rect[2], Rect[3]))};
}

/** Most equivalences are from the plain frame. */
FSharedPictures GetBase(const std::string& ConfigFile, const FEquivalence& Equivalence)
{
	const FRunResult& Plain = GetPlainRun(ConfigFile);
	return Equivalence.Base == FEquivalenceRun() ? FSharedPictures{Plain.SceneLinear, Plain.Final}
												 : RunShared(ConfigFile, Equivalence.Base, FindPictureView(Plain));
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

/** Velocities in pixels are stored as shares of the rect of all views, not of the view's own (docs/differences.md). */
bool IsBlurredByMotion(const std::string& ConfigFile)
{
	const std::string Config = std::filesystem::path(ConfigFile).stem().string();
	return Config == "frame_full" || Config == "motion_blur";
}

/** Configs with a pass that compares what is stored with a number, or stores one, as its article prints it: not the
 * same picture under another pre-exposure. The engine's rule for the pre-filter of the FFT bloom is not known. */
const std::map<std::string, std::string> NotPreExposed = {{"bloom_fft", "FFTBloom.PreFilter"},
	{"frame_full", "ToonShadowLighting"}, {"hooks_all", "passes of hooks that store numbers"},
	{"red_diffusion", "RED.DiffusionFilter"}, {"study_storage", "ToonShadowLighting"},
	{"toon_shadow_blur", "ToonShadowLighting"}, {"unity_bloom", "UnityBloom.Extract"}};

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

/** Every eighth pair of config and equivalence, so that each of both has some; all of them with
 * DRYDOCK_EQUIVALENCES=all, as the long test `equivalences` runs them. */
std::vector<std::tuple<std::string, FEquivalence>> MakeCases()
{
	const char* const Wanted = std::getenv("DRYDOCK_EQUIVALENCES");
	const size_t OneIn = Wanted != nullptr && std::string(Wanted) == "all" ? 1 : 8;
	std::vector<std::tuple<std::string, FEquivalence>> Cases;
	const std::vector<std::string> Configs = FindShippedConfigs();
	for (size_t Config = 0; Config < Configs.size(); ++Config)
	{
		for (size_t Promise = 0; Promise < GetEquivalences().size(); ++Promise)
		{
			if ((Config + Promise) % OneIn == 0)
			{
				Cases.emplace_back(Configs[Config], GetEquivalences()[Promise]);
			}
		}
	}
	return Cases;
}

} // namespace

TEST_P(Equivalence, GivesTheSamePicture)
{
	const auto& [ConfigFile, Promise] = GetParam();
	const FRunResult& Plain = GetPlainRun(ConfigFile);
	if (Promise.Base.Layout != EViewLayout::AsConfigured && (Plain.Views.size() > 1 || IsBlurredByMotion(ConfigFile)))
	{
		GTEST_SKIP() << "several views already, or motion blur";
	}
	const FSharedPictures Expected = GetBase(ConfigFile, Promise);
	const FSharedPictures Actual = RunShared(ConfigFile, Promise.Other, FindPictureView(Plain));
	ASSERT_FALSE(Expected.Final.ToImage().Values.empty());
	if (Promise.Alike == EAlike::SameBits)
	{
		EXPECT_TRUE(AreSameBits(Expected.SceneLinear, Actual.SceneLinear)) << "scene_linear";
		EXPECT_TRUE(AreSameBits(Expected.Final, Actual.Final)) << "final";
		return;
	}
	ASSERT_EQ(Expected.Final.Width, Actual.Final.Width);
	ASSERT_EQ(Expected.Final.Height, Actual.Final.Height);
	const bool bDiffers = std::string_view(Promise.Name) == "PreExposure" &&
						  NotPreExposed.contains(std::filesystem::path(ConfigFile).stem().string());
	EXPECT_EQ(bDiffers, ComparePixels(Expected.Final, Actual.Final, Promise.Alike).has_value());
}

INSTANTIATE_TEST_SUITE_P(ShippedConfigs, Equivalence, testing::ValuesIn(MakeCases()), GetTestName);

class ScalarCalls : public testing::TestWithParam<std::string>
{
};

TEST_P(ScalarCalls, NoShippedConfigReadsOrWritesTexelByTexel)
{
	const uint64_t Before = GetScalarCalls();
	RunPlain(GetParam());
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
	EXPECT_EQ(GetPlainRun(ConfigFile).RunJson, RunPlain(ConfigFile).RunJson);
}

TEST(EquivalenceHarness, FindsTheShippedConfigs)
{
	EXPECT_GE(FindShippedConfigs().size(), 4u);
}
