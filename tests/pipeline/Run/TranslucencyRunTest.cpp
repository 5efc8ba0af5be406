// Separate translucency in whole frames: where it is composed, what comes before and after it, that a scene without
// has nothing of it. Scenes are drawn at random (seed 11); expected pictures are per-pixel formulas in double.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pipeline/EffectTestUtils.h"
#include "Run/Run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <unistd.h>

using namespace Drydock;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

namespace
{

constexpr int Width = 24;
constexpr int Height = 14;
using FPixel = std::array<double, 10>;
/** R, G, B, depth, velocity and translucency, in this order. */
const std::vector<std::string> AllChannels = {"R", "G", "B", "depth.Z", "velocity.X", "velocity.Y", "translucency.R",
	"translucency.G", "translucency.B", "translucency.A"};

/** A scene file, gone at the end. */
class FSceneOnDisk
{
public:
	/** The first NumChannels of them. */
	explicit FSceneOnDisk(size_t NumChannels = AllChannels.size())
		: Path((std::filesystem::temp_directory_path() /
				("drydock_translucency_" + std::to_string(getpid()) + "_" + std::to_string(NumChannels) + ".exr"))
				   .string())
	{
		std::mt19937 Random(11);
		std::uniform_real_distribution<float> Unit(0.0f, 1.0f);
		FImage Image{Width, Height, static_cast<int>(NumChannels), {}};
		for (int Index = 0; Index < Width * Height; ++Index)
		{
			FPixel Pixel;
			std::generate(Pixel.begin(), Pixel.end(), [&] { return Unit(Random); });
			Pixel[3] = Index % Width < Width / 2 ? 3.0 : 20.0;
			Pixel[4] = 8.0 * Pixel[4];
			Pixels.push_back(Pixel);
			Image.Values.insert(
				Image.Values.end(), Pixel.begin(), Pixel.begin() + static_cast<std::ptrdiff_t>(NumChannels));
		}
		WriteExr(Path, Image,
			std::vector<std::string>(
				AllChannels.begin(), AllChannels.begin() + static_cast<std::ptrdiff_t>(NumChannels)));
	}
	~FSceneOnDisk() { std::filesystem::remove(Path); }

	/** In 64 bit. Settings: members of the volume; More: members of the config. */
	FRunResult Run(const std::string& Settings, const std::vector<std::string>& Variables = {},
		const std::string& More = "", const std::string& SceneMore = "", bool bNoSkip = false) const
	{
		FRunOptions Options;
		Options.ConfigFile = "translucency.json";
		Options.ConfigText = R"({"scene": {"file": ")" + Path + "\"" + SceneMore +
							 R"(}, "volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]" + More + "}";
		Options.Variables = Variables;
		Options.bDouble = true;
		Options.bNoSkip = bNoSkip;
		return RunConfig(Options);
	}

	std::vector<FPixel> Pixels;

private:
	std::string Path;
};

/** What every pixel must be. */
template<typename TFunction>
void ExpectLinear(const FSceneOnDisk& Scene, const FRunResult& Result, const TFunction& MakeExpected)
{
	ASSERT_EQ(Width, Result.SceneLinear.Width);
	double Largest = 0;
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const std::array<double, 3> Expected =
				MakeExpected(Scene.Pixels[static_cast<size_t>(Y) * Width + static_cast<size_t>(X)]);
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Off =
					std::abs(Expected[static_cast<size_t>(Channel)] - Result.SceneLinear.Get(X, Y, Channel));
				Largest = Off <= Largest ? Largest : Off;
			}
		}
	}
	EXPECT_LE(Largest, 1e-3); // the file is half
}

std::array<double, 3> GetColor(const FPixel& Pixel)
{
	return {Pixel[0], Pixel[1], Pixel[2]};
}

std::array<double, 3> ComposeOver(const FPixel& Pixel, const std::array<double, 3>& Behind)
{
	return {Behind[0] * Pixel[9] + Pixel[6], Behind[1] * Pixel[9] + Pixel[7], Behind[2] * Pixel[9] + Pixel[8]};
}

std::array<double, 3> MakeGrey(const std::array<double, 3>& Color)
{
	const double Luma = 0.299 * Color[0] + 0.587 * Color[1] + 0.114 * Color[2];
	return {Luma, Luma, Luma};
}

int FindPass(const FRunResult& Result, const std::string& Begin)
{
	const auto& Passes = Result.Graph.Passes;
	const auto Found = std::find_if(
		Passes.begin(), Passes.end(), [&](const FRDGCompiledPass& Pass) { return Pass.Name.starts_with(Begin); });
	return Found == Passes.end() ? -1 : static_cast<int>(Found - Passes.begin());
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

/** Every pixel by itself. */
const std::string NoBloom = R"("BloomIntensity": 0)";

/** RED too is then a change of every pixel by itself: to grey. */
const std::string Grey = NoBloom + R"(, "SoftFocusSaturation": 0)";

} // namespace

TEST(TranslucencyRun, IsComposedOverThePicture)
{
	const FSceneOnDisk Scene;
	const FRunResult Result = Scene.Run(NoBloom);
	ExpectLinear(Scene, Result, [](const FPixel& Pixel) { return ComposeOver(Pixel, GetColor(Pixel)); });
	EXPECT_TRUE(FindEffect(Result, "Translucency").bActive);
	EXPECT_THAT(GetDecoded(Result), Contains("translucency.A"));
}

TEST(TranslucencyRun, REDBeforeItLeavesItAlone)
{
	const FSceneOnDisk Scene;
	ExpectLinear(Scene, Scene.Run(Grey, {"r.REDPostprocessAfterTranslucency=0"}),
		[](const FPixel& Pixel) { return ComposeOver(Pixel, MakeGrey(GetColor(Pixel))); });
}

TEST(TranslucencyRun, REDAfterItTakesItIn)
{
	const FSceneOnDisk Scene;
	for (const char* Place : {"1", "2"})
	{
		ExpectLinear(Scene, Scene.Run(Grey, {std::string("r.REDPostprocessAfterTranslucency=") + Place}),
			[](const FPixel& Pixel) { return MakeGrey(ComposeOver(Pixel, GetColor(Pixel))); });
	}
}

TEST(TranslucencyRun, PlacesOfREDAreOneWithoutIt)
{
	const FSceneOnDisk Scene(6);
	const FRunResult Before = Scene.Run(Grey, {"r.REDPostprocessAfterTranslucency=0"});
	const FRunResult After = Scene.Run(Grey, {"r.REDPostprocessAfterTranslucency=1"});
	EXPECT_EQ(Before.SceneLinear.ToImage().Values, After.SceneLinear.ToImage().Values);
	EXPECT_EQ(-1, FindPass(Before, "ComposeSeparateTranslucency"));
	const FEffectDecision& Decision = FindEffect(Before, "Translucency");
	EXPECT_FALSE(Decision.bActive);
	EXPECT_FALSE(Decision.bConfigured);
	EXPECT_EQ("the scene has no separate translucency", Decision.Reason);
}

TEST(TranslucencyRun, ItComesAfterDepthOfFieldAndBeforeMotionBlurAndBloom)
{
	const FSceneOnDisk Scene;
	const FRunResult Result = Scene.Run(R"("DepthOfFieldFocalDistance": 300, "DepthOfFieldFstop": 1,
		"REDDofFocalDistance": 300, "MotionBlurAmount": 0.5, "BloomIntensity": 1)");
	const int Composition = FindPass(Result, "ComposeSeparateTranslucency");
	ASSERT_GE(Composition, 0);
	for (const char* Name : {"DOF", "REDDepthOfField"})
	{
		ASSERT_GE(FindPass(Result, Name), 0) << Name;
		EXPECT_LT(FindPass(Result, Name), Composition) << Name;
	}
	for (const char* Name : {"MotionBlur", "Bloom1", "Tonemap"})
	{
		EXPECT_GT(FindPass(Result, Name), Composition) << Name;
	}
}

TEST(TranslucencyRun, ShowFlagLeavesItOut)
{
	const FSceneOnDisk Scene;
	const FRunResult Result = Scene.Run(NoBloom, {}, R"(, "showFlags": {"Translucency": false})");
	ExpectLinear(Scene, Result, &GetColor);
	EXPECT_EQ("ShowFlag.Translucency is off", FindEffect(Result, "Translucency").Reason);
	EXPECT_THAT(GetDecoded(Result), Not(Contains("translucency.A")));
}

TEST(TranslucencyRun, ItNeedsNoPostProcessing)
{
	const FSceneOnDisk Scene;
	ExpectLinear(Scene, Scene.Run(NoBloom, {}, R"(, "showFlags": {"PostProcessing": false})"),
		[](const FPixel& Pixel) { return ComposeOver(Pixel, GetColor(Pixel)); });
}

TEST(TranslucencyRun, ItIsPreExposedAsThePictureIs)
{
	const FSceneOnDisk Scene;
	ExpectLinear(Scene, Scene.Run(NoBloom, {}, R"(, "view": {"preExposure": 0.5})"),
		[](const FPixel& Pixel)
		{
			std::array<double, 3> Color = ComposeOver(Pixel, GetColor(Pixel));
			std::transform(Color.begin(), Color.end(), Color.begin(), [](double Value) { return Value / 2; });
			return Color;
		});
}

TEST(TranslucencyRun, MissingChannelIsNamed)
{
	const FSceneOnDisk Scene(9); // all but the transmittance
	try
	{
		Scene.Run(NoBloom);
		FAIL() << "it ran";
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		EXPECT_THAT(Error.GetDiagnostics()[0].Message, HasSubstr("\"translucency.A\""));
		EXPECT_THAT(Error.GetDiagnostics()[0].Message, HasSubstr("ComposeSeparateTranslucency"));
	}
	ExpectLinear(Scene, Scene.Run(NoBloom, {}, "", R"(, "defaults": {"translucency.A": 1})"),
		[](FPixel Pixel)
		{
			Pixel[9] = 1;
			return ComposeOver(Pixel, GetColor(Pixel));
		});
}

TEST(TranslucencyRun, AtAnotherResolutionItIsTheMeanOfAnAreaAsColourIs)
{
	const FSceneOnDisk Scene;
	const FRunResult Result = Scene.Run(NoBloom, {}, "", R"(, "screenPercentage": 50)");
	ASSERT_EQ(Width / 2, Result.SceneLinear.Width);
	std::array<double, 4> Color = {}, Over = {};
	for (const int Index : {0, 1, Width, Width + 1})
	{
		const FPixel& Pixel = Scene.Pixels[static_cast<size_t>(Index)];
		Color[0] += Pixel[0] / 4;
		Over[0] += Pixel[6] / 4;
		Over[3] += Pixel[9] / 4;
	}
	EXPECT_NEAR(Color[0] * Over[3] + Over[0], Result.SceneLinear.Get(0, 0, 0), 1e-3);
}

TEST(TranslucencyRun, WithoutSkippingTheBitsAreTheSame)
{
	for (const size_t NumChannels : {size_t(6), AllChannels.size()})
	{
		const FSceneOnDisk Scene(NumChannels);
		EXPECT_EQ(Scene.Run(Grey).SceneLinear.ToImage().Values,
			Scene.Run(Grey, {}, "", "", true).SceneLinear.ToImage().Values);
	}
}
