// What the scene's content leaves out or confines changes no bit: every frame here is run once as it is and once with
// --no-skip. Scenes are small and made so that each gate has its case: no toon pixel, one in a corner, no mask, a mask
// at the edge, nothing moving, nothing bright.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "EngineProfile.h"
#include "pipeline/EffectTestUtils.h"
#include "Run/Explain.h"
#include "Run/Run.h"
#include "SameBits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <unistd.h>

using namespace Drydock;
using SameBits::AreSameBits;
using testing::HasSubstr;

namespace
{

constexpr int Width = 101;
constexpr int Height = 67;

/** What a scene holds beside noise. */
struct FContent
{
	const char* Name;
	std::vector<FIntRect> Toon;
	std::vector<FIntRect> Mask;
	bool bMoves = false;
	double Brightest = 8.0;
};

void PrintTo(const FContent& Content, std::ostream* Stream)
{
	*Stream << Content.Name;
}

/** Pixels that shaders drew; copies apart. */
uint64_t CountShadedPixels(const FRunResult& Result)
{
	uint64_t Pixels = 0;
	for (const FRunPass& Pass : Result.Passes)
	{
		Pixels += Pass.Counters.Shader.empty() ? 0 : Pass.Counters.Pixels;
	}
	return Pixels;
}

bool IsInAny(const std::vector<FIntRect>& Rects, int X, int Y)
{
	return std::any_of(Rects.begin(), Rects.end(),
		[&](const FIntRect& Rect) { return X >= Rect.Min.X && X < Rect.Max.X && Y >= Rect.Min.Y && Y < Rect.Max.Y; });
}

/** The scene's file. Noise is the same for every content; some values are negative, one is -0. */
std::string WriteScene(const FContent& Content)
{
	std::mt19937 Random(7);
	std::uniform_real_distribution<double> Value(-0.02, 1.0);
	const std::vector<std::string> Names = {"R", "G", "B", "depth.Z", "velocity.X", "velocity.Y", "basecolor.R",
		"basecolor.G", "basecolor.B", "shadingmodel.ID", "custommask.B", "shadow.R", "shadow.G", "normal.X", "normal.Y",
		"normal.Z"};
	FImage Image{Width, Height, static_cast<int>(Names.size()), {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Color = Value(Random);
				Image.Values.push_back(X == 3 && Y == 3 ? -0.0 : static_cast<float>(Color * Content.Brightest));
			}
			const double Shadow = X < Width / 2 ? 1.0 : 0.0;
			const double Moves = Content.bMoves && X > 40 && X < 60 ? 1.0 : 0.0;
			const double Others[] = {4.0, 9.0 * Moves, 3.0 * Moves, 0.5, 0.25, 0.75,
				IsInAny(Content.Toon, X, Y) ? 8.0 : 1.0, IsInAny(Content.Mask, X, Y) ? 1.0 : 0.0, Shadow, Shadow, 0.0,
				0.0, 1.0};
			Image.Values.insert(Image.Values.end(), std::begin(Others), std::end(Others));
		}
	}
	const std::filesystem::path Path = std::filesystem::temp_directory_path() /
									   ("drydock_gates_" + std::to_string(getpid()) + "_" + Content.Name + ".exr");
	WriteExr(Path.string(), Image, Names);
	return Path.string();
}

class FSceneOnDisk
{
public:
	explicit FSceneOnDisk(const FContent& Content)
		: Path(WriteScene(Content))
	{
	}
	~FSceneOnDisk() { std::filesystem::remove(Path); }

	/** Settings: members of the volume; More: members of the config beside it. */
	FRunResult Run(const std::string& Settings, const std::vector<std::string>& Variables, bool bNoSkip,
		const std::string& More = "", bool bExecute = true, const std::string& SceneMore = "") const
	{
		FRunOptions Options;
		Options.ConfigFile = "gates.json";
		Options.ConfigText = R"({"scene": {"file": ")" + Path + "\"" + SceneMore +
							 R"(}, "volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]" + More + "}";
		Options.Variables = Variables;
		Options.bNoSkip = bNoSkip;
		Options.bExecute = bExecute;
		Options.bPlanLoads = !bExecute;
		return RunConfig(Options);
	}

	void ExpectSameWithoutSkipping(const std::string& Settings, const std::vector<std::string>& Variables,
		const std::string& More = "", const std::string& SceneMore = "") const
	{
		const FRunResult Frame = Run(Settings, Variables, false, More, true, SceneMore);
		const FRunResult NoSkip = Run(Settings, Variables, true, More, true, SceneMore);
		EXPECT_LE(CountShadedPixels(Frame), CountShadedPixels(NoSkip));
		EXPECT_TRUE(AreSameBits(NoSkip.SceneLinear, Frame.SceneLinear)) << "scene_linear";
		EXPECT_TRUE(AreSameBits(NoSkip.Final, Frame.Final)) << "final";
	}

private:
	std::string Path;
};

/** Of executed passes whose name contains Part: pixels drawn. */
uint64_t CountPixels(const FRunResult& Result, const std::string& Part)
{
	uint64_t Pixels = 0;
	for (const FRunPass& Pass : Result.Passes)
	{
		const bool bNamed = Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name.find(Part) != std::string::npos;
		Pixels += bNamed ? Pass.Counters.Pixels : 0;
	}
	return Pixels;
}

FIntRect Pixel(int X, int Y)
{
	return FIntRect(X, Y, X + 1, Y + 1);
}

/** Everything that content can leave out, called for at once. */
const char* const EverythingCalledFor = R"("BloomThreshold": 1, "BloomToonIntensity": 3, "CharaGlowArea": 3.5,
	"CharaGlowColor": [1, 0.5, 0.25, 0.8], "ToonShadowBlurIntensity": 1, "MotionBlurAmount": 0.5,
	"MotionBlurTargetFPS": 0)";

const std::vector<FContent> Contents = {
	{"nothing", {}, {}},
	{"top_left", {Pixel(0, 0)}, {Pixel(0, 0)}},
	{"top_right", {Pixel(Width - 1, 0)}, {Pixel(Width - 1, 0)}},
	{"bottom_left", {Pixel(0, Height - 1)}, {Pixel(0, Height - 1)}},
	{"bottom_right", {Pixel(Width - 1, Height - 1)}, {Pixel(Width - 1, Height - 1)}},
	{"middle", {Pixel(50, 33)}, {FIntRect(20, 10, 31, 44)}},
	{"two", {FIntRect(5, 6, 8, 9), FIntRect(60, 30, 64, 50)}, {FIntRect(90, 1, Width, 3)}, true},
	{"all", {FIntRect(0, 0, Width, Height)}, {FIntRect(0, 0, Width, Height)}, true},
	{"dark", {}, {}, false, 0.5},
};

const std::vector<std::vector<std::string>> Variables = {
	{},
	{"r.Drydock.Storage=2", "r.Drydock.Precision=1"},
	{"r.PostProcessing.PreferCompute=1"},
	{"r.ToonBloom.AsPrinted=1", "r.RED.AsPrinted=1"},
	{"r.REDPostprocessAfterTranslucency=0", "r.PostProcessing.DownsampleQuality=0"},
	{"r.RDG.ClobberResources=2"},
};

class ContentGatesRun : public testing::TestWithParam<FContent>
{
};

} // namespace

TEST_P(ContentGatesRun, SameBitsWithEverythingCalledFor)
{
	const FSceneOnDisk Scene(GetParam());
	for (const std::vector<std::string>& Set : Variables)
	{
		SCOPED_TRACE(Set.empty() ? "as it is" : Set[0]);
		Scene.ExpectSameWithoutSkipping(EverythingCalledFor, Set);
	}
}

TEST_P(ContentGatesRun, SameBitsOfToonBloomWithoutAThresholdAndByConvolution)
{
	const FSceneOnDisk Scene(GetParam());
	Scene.ExpectSameWithoutSkipping(R"("BloomToonIntensity": 0.25)", {});
	Scene.ExpectSameWithoutSkipping(R"("BloomToonIntensity": 0)", {"r.Drydock.Storage=1"});
	Scene.ExpectSameWithoutSkipping(R"("BloomToonIntensity": 4, "BloomMethod": "BM_FFT")", {});
}

// Values that are called neutral, and the numbers beside them. Before 5.4 BloomToonIntensity 1 left out a pass with a
// ramp.
TEST(NeutralValues, SameBitsUnderEveryProfileAndNoJumpAtTheValue)
{
	struct FNeutral
	{
		const char* Name;
		float Value;
		const char* Others = "";
		bool bJumps = false; // the engine's own, or negative light that becomes 0
	};
	const FNeutral Neutrals[] = {{"BloomToonIntensity", 1.0f, R"(, "BloomThreshold": -1)"},
		{"BloomToonIntensity", 1.0f, R"(, "BloomThreshold": 0.5)"}, {"BloomToonIntensity", -1.0f, "", true},
		{"BloomThreshold", -1.0f, R"(, "BloomToonIntensity": 0.5)", true}, {"BloomIntensity", 0.0f},
		{"LocalExposureHighlightContrastScale", 1.0f, "", true}, {"LocalExposureShadowContrastScale", 1.0f, "", true},
		{"LocalExposureDetailStrength", 1.0f, "", true}, {"MotionBlurAmount", 0.0f}, {"CharaGlowArea", 0.0f, "", true},
		{"ToonShadowBlurIntensity", 0.0f, "", true}, {"UnityBloomIntensity", 0.0f, "", true},
		{"DiffusionFilterIntensity", 0.0f, "", true}, {"SoftFocusBlend", 0.0f, "", true},
		{"GlowIntensity", 0.0f, "", true}, {"VignetteIntensity", 0.0f}};
	const FSceneOnDisk Scene({"neutral", {FIntRect(20, 10, 40, 30)}, {FIntRect(20, 10, 40, 30)}, true, 0.5});
	for (const FEngineProfile& Profile : GetEngineProfiles())
	{
		const std::string Engine = R"(, "engine": "5.)" + std::to_string(Profile.Minor) + "\"";
		for (const FNeutral& Neutral : Neutrals)
		{
			std::vector<FImage> Pictures;
			for (const float Value :
				{std::nextafter(Neutral.Value, -10.0f), Neutral.Value, std::nextafter(Neutral.Value, 10.0f)})
			{
				const std::string Text = fmt::format("\"{}\": {}{}", Neutral.Name, Value, Neutral.Others);
				SCOPED_TRACE(Text + Engine);
				Scene.ExpectSameWithoutSkipping(Text, {}, Engine);
				Pictures.push_back(Scene.Run(Text, {}, false, Engine).Final.ToImage());
			}
			for (size_t i = 0; i < Pictures[0].Values.size() && !Neutral.bJumps; ++i)
			{
				ASSERT_NEAR(Pictures[0].Values[i], Pictures[1].Values[i], 1.5 / 255) << Neutral.Name << Engine;
				ASSERT_NEAR(Pictures[1].Values[i], Pictures[2].Values[i], 1.5 / 255) << Neutral.Name << Engine;
			}
		}
	}
}

TEST(ContentGates, BloomOfWhatIsStoredAsInfinityStays)
{
	const FSceneOnDisk Scene({"stored", {}, {}, false, 0.5});
	Scene.ExpectSameWithoutSkipping(R"("BloomThreshold": 10)", {}, R"(, "view": {"preExposure": 1000000})");
	EXPECT_FALSE(FindEffect(Scene.Run(R"("BloomThreshold": 10)", {}, false), "Bloom").bActive);
}

TEST_P(ContentGatesRun, SameBitsOfOneEffectAlone)
{
	const FSceneOnDisk Scene(GetParam());
	for (const char* Settings :
		{R"("CharaGlowArea": 2)", R"("CharaGlowArea": 20, "BloomIntensity": 0)", R"("ToonShadowBlurIntensity": 1)",
			R"("MotionBlurAmount": 1, "MotionBlurTargetFPS": 0)", R"("BloomThreshold": 0.6)", R"("BloomThreshold": 0)"})
	{
		SCOPED_TRACE(Settings);
		Scene.ExpectSameWithoutSkipping(Settings, {});
	}
}

TEST_P(ContentGatesRun, SameBitsInAViewThatIsAPartOfAPaddedScene)
{
	const FSceneOnDisk Scene(GetParam());
	Scene.ExpectSameWithoutSkipping(EverythingCalledFor, {}, R"(, "view": {"rect": [4, 6, 100, 60]})",
		R"(, "padding": {"left": 7, "top": 5, "right": 3, "bottom": 2})");
	Scene.ExpectSameWithoutSkipping(
		EverythingCalledFor, {}, R"(, "views": [{"rect": [0, 0, 50, 67]}, {"rect": [50, 0, 101, 67]}])");
	Scene.ExpectSameWithoutSkipping(EverythingCalledFor, {}, "", R"(, "screenPercentage": 60)");
}

INSTANTIATE_TEST_SUITE_P(Contents, ContentGatesRun, testing::ValuesIn(Contents),
	[](const testing::TestParamInfo<FContent>& Info) { return std::string(Info.param.Name); });

TEST(ContentGatesRun, AFrameWithoutMaskToonOrMovementBuildsNoneOfTheirPasses)
{
	const FSceneOnDisk Scene(Contents[0]);
	const FRunResult Frame = Scene.Run(EverythingCalledFor, {}, false);
	for (const char* Effect : {"ToonBloom", "CharaGlow", "ToonShadowBlur", "MotionBlur"})
	{
		EXPECT_FALSE(FindEffect(Frame, Effect).bActive) << Effect;
	}
	for (const char* Part : {"ToonBloom", "CharaGlow", "ToonShadow", "MotionBlur"})
	{
		for (const FRDGCompiledPass& Pass : Frame.Graph.Passes)
		{
			EXPECT_EQ(std::string::npos, Pass.Name.find(Part)) << Pass.Name;
		}
	}
	// Looked at, and that is all: neither depth nor base colour is decoded.
	std::vector<std::string> Decoded;
	for (const FSceneChannel& Channel : Frame.Channels)
	{
		Decoded.insert(Decoded.end(), Channel.bDecoded, Channel.Name);
	}
	EXPECT_THAT(Decoded,
		testing::UnorderedElementsAre("R", "G", "B", "shadingmodel.ID", "custommask.B", "velocity.X", "velocity.Y"));
}

TEST(ContentGatesRun, NothingBrightBuildsNoBloom)
{
	const FSceneOnDisk Scene(Contents.back());
	const FRunResult Frame = Scene.Run(R"("BloomThreshold": 1)", {}, false);
	EXPECT_THAT(FindEffect(Frame, "Bloom").Reason, HasSubstr("nothing is brighter than BloomThreshold 1"));
	EXPECT_LT(Frame.Passes.size(), 4u); // the tonemapper and its table
	EXPECT_GT(Scene.Run(R"("BloomThreshold": 1)", {}, true).Passes.size(), 10u);
}

// A tile is 64 x 64 at most (TileExecutor); one toon pixel needs a few texels around it.
TEST(ContentGatesRun, OneToonPixelInACornerMakesOnlyItsTileWork)
{
	const FSceneOnDisk Scene(Contents[1]);
	const FRunResult Frame = Scene.Run(R"("BloomToonIntensity": 0.1, "CharaGlowArea": 2)", {}, false);
	const FRunResult NoSkip = Scene.Run(R"("BloomToonIntensity": 0.1, "CharaGlowArea": 2)", {}, true);
	EXPECT_TRUE(FindEffect(Frame, "ToonBloom").bActive);
	for (const char* Pass : {"ToonBloomMask", "CharaGlowRows", "CharaGlow ", "CharaGlowComp "})
	{
		EXPECT_GT(CountPixels(Frame, Pass), 0u) << Pass;
		EXPECT_LT(CountPixels(Frame, Pass), 400u) << Pass;
		EXPECT_EQ(static_cast<uint64_t>(Width * Height), CountPixels(NoSkip, Pass)) << Pass;
	}
	EXPECT_LT(CountPixels(Frame, "ToonBloomHalfResolution("), 200u);
	EXPECT_EQ(51u * 34u, CountPixels(NoSkip, "ToonBloomHalfResolution("));
	EXPECT_TRUE(AreSameBits(NoSkip.Final, Frame.Final));
}

TEST(ContentGatesRun, WhatIsCompiledIsWhatRuns)
{
	for (const FContent& Content : Contents)
	{
		const FSceneOnDisk Scene(Content);
		for (const bool bNoSkip : {false, true})
		{
			const FRunResult Run = Scene.Run(EverythingCalledFor, {}, bNoSkip);
			const FExplainReport Plan = MakeExplainReport(Scene.Run(EverythingCalledFor, {}, bNoSkip, "", false),
				Scene.Run(EverythingCalledFor, {}, true, "", false), FCostModel());
			EXPECT_EQ(static_cast<int>(Run.Passes.size()), Plan.Cost.NumPasses) << Content.Name;
			EXPECT_EQ(Run.Graph.Memory.TransientPeakBytes, Plan.Cost.TransientBytes) << Content.Name;
			EXPECT_EQ(Run.SceneTextureBytes, Plan.Cost.SceneBytes) << Content.Name;
			EXPECT_EQ(std::count_if(Run.Channels.begin(), Run.Channels.end(),
						  [](const FSceneChannel& Channel) { return Channel.bDecoded; }),
				Plan.Cost.NumChannels)
				<< Content.Name;
		}
	}
}

// Settings and scenes by chance; each seed is one frame.
TEST(ContentGatesRun, SameBitsOfRandomConfigs)
{
	for (unsigned Seed = 1; Seed <= 40; ++Seed)
	{
		std::mt19937 Random(Seed);
		const auto Chance = [&](double Probability)
		{
			return std::bernoulli_distribution(Probability)(Random);
		};
		const auto Number = [&](double From, double To)
		{
			return std::to_string(std::uniform_real_distribution<double>(From, To)(Random));
		};
		const auto Rect = [&]
		{
			const int X = std::uniform_int_distribution<int>(0, Width - 1)(Random);
			const int Y = std::uniform_int_distribution<int>(0, Height - 1)(Random);
			return FIntRect(X, Y, std::min(X + 1 + X % 17, Width), std::min(Y + 1 + Y % 11, Height));
		};
		FContent Content{"random", {}, {}, Chance(0.5), Chance(0.3) ? 0.2 : 20.0};
		Content.Toon.insert(Content.Toon.end(), Chance(0.6), Rect());
		Content.Mask.insert(Content.Mask.end(), Chance(0.6), Rect());
		std::string Settings = R"("BloomThreshold": )" + (Chance(0.5) ? Number(-1, 4) : std::string("-1"));
		const auto Add = [&](const char* Name, const std::string& Value)
		{
			Settings += Chance(0.5) ? ", \"" + std::string(Name) + "\": " + Value : "";
		};
		Add("BloomToonIntensity", Number(0, 5));
		Add("CharaGlowArea", Number(0, 9));
		Add("ToonShadowBlurIntensity", Number(0, 1));
		Add("MotionBlurAmount", Number(0, 1));
		Add("DiffusionFilterIntensity", Number(0, 1));
		Add("UnityBloomIntensity", Number(0, 1));
		Add("DepthOfFieldFocalDistance", Number(0, 900));
		Add("BloomIntensity", Number(0, 3));
		Add("LocalExposureHighlightContrastScale", Number(0.5, 1));
		Add("AutoExposureBias", Number(-3, 3));
		std::vector<std::string> Set;
		Set.insert(Set.end(), Chance(0.2), "r.PostProcessing.PreferCompute=1");
		Set.insert(Set.end(), Chance(0.2), "r.Drydock.Storage=2");
		Set.insert(Set.end(), Chance(0.2), "r.ToonBloom.AsPrinted=1");
		Set.insert(Set.end(), Chance(0.3), "r.REDPostprocessAfterTranslucency=1");
		SCOPED_TRACE("seed " + std::to_string(Seed) + ": " + Settings);
		const FSceneOnDisk Scene(Content);
		Scene.ExpectSameWithoutSkipping(Settings, Set);
	}
}
