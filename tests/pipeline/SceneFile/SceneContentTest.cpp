// What is found in a scene's channels before the graph is built.
#include <gtest/gtest.h>

#include "Config/ReadConfig.h"
#include "SceneFile/SceneFile.h"
#include "SceneFile/SceneContent.h"

#include <cmath>
#include <filesystem>
#include <unistd.h>

using namespace Drydock;

namespace
{

constexpr int Width = 12;
constexpr int Height = 8;

using FChannelFunction = std::function<double(int X, int Y)>;

/** A scene file of 12 x 8 with these channels, gone at the end. */
class FSceneOnDisk
{
public:
	explicit FSceneOnDisk(const std::vector<std::pair<std::string, FChannelFunction>>& Channels)
		: Path((std::filesystem::temp_directory_path() / ("drydock_content_" + std::to_string(getpid()) + ".exr"))
				   .string())
	{
		FImage Image{Width, Height, static_cast<int>(Channels.size()), {}};
		std::vector<std::string> Names;
		for (const auto& [Name, Function] : Channels)
		{
			Names.push_back(Name);
		}
		for (int Y = 0; Y < Height; ++Y)
		{
			for (int X = 0; X < Width; ++X)
			{
				for (const auto& [Name, Function] : Channels)
				{
					Image.Values.push_back(Function(X, Y));
				}
			}
		}
		WriteExr(Path, Image, Names);
	}
	~FSceneOnDisk() { std::filesystem::remove(Path); }

	FConfig MakeConfig(const std::string& More = "") const
	{
		std::vector<FDiagnostic> Diagnostics;
		FConfig Config = ReadConfig(R"({"scene": {"file": ")" + Path + "\"" + More + "}}", "a.json", Diagnostics);
		EXPECT_FALSE(HasErrors(Diagnostics));
		return Config;
	}

private:
	std::string Path;
};

FChannelFunction Constant(double Value)
{
	return [Value](int, int)
	{
		return Value;
	};
}

FChannelFunction Within(const FIntRect& Rect, double Inside, double Outside)
{
	return [=](int X, int Y)
	{
		return X >= Rect.Min.X && X < Rect.Max.X && Y >= Rect.Min.Y && Y < Rect.Max.Y ? Inside : Outside;
	};
}

FContentQuestions AskAll()
{
	return {true, true, true, true};
}

FViewContent Measure(const FSceneOnDisk& File, const FIntRect& ViewRect, const std::string& More = "")
{
	const FConfig Config = File.MakeConfig(More);
	FSceneFile Scene(Config);
	return MeasureViewContent(Scene, ViewRect, AskAll());
}

const FIntRect Whole(0, 0, Width, Height);

} // namespace

TEST(FindBounds, OfOnePixelOfTwoFarOnesAndOfNone)
{
	EXPECT_EQ(FIntRect(3, 5, 4, 6), FindBounds(Whole, [](int X, int Y) { return X == 3 && Y == 5; }));
	EXPECT_EQ(FIntRect(1, 2, 12, 8),
		FindBounds(Whole, [](int X, int Y) { return (X == 11 && Y == 2) || (X == 1 && Y == 7); }));
	EXPECT_EQ(Whole, FindBounds(Whole, [](int, int) { return true; }));
	EXPECT_EQ(0, FindBounds(Whole, [](int, int) { return false; }).Area());
}

TEST(FindBounds, LooksNowhereElse)
{
	EXPECT_EQ(
		0, FindBounds(FIntRect(2, 2, 5, 5), [](int X, int Y) { return X < 2 || Y < 2 || X > 4 || Y > 4; }).Area());
}

TEST(MapBounds, MovesFromTheFileToTheViewsCorner)
{
	const FSceneRegion Region{FIntRect(2, 1, 10, 7), FIntRect(6, 5, 14, 11)};
	EXPECT_EQ(FIntRect(1, 2, 3, 3), MapBounds(FIntRect(3, 3, 5, 4), Region));
	EXPECT_EQ(0, MapBounds(FIntRect(2, 1, 2, 1), Region).Area());
}

TEST(MapBounds, AtAnotherResolutionTheWholeViewOrNothing)
{
	const FSceneRegion Region{FIntRect(0, 0, 12, 8), FIntRect(0, 0, 6, 4)};
	EXPECT_EQ(FIntRect(0, 0, 6, 4), MapBounds(FIntRect(3, 3, 5, 4), Region));
	EXPECT_EQ(0, MapBounds(FIntRect(3, 3, 3, 3), Region).Area());
}

TEST(SceneContent, ToonIsWhatIsShadedAsCloth)
{
	const FIntRect Toon(4, 2, 7, 3);
	const FSceneOnDisk File({{"shadingmodel.ID", Within(Toon, 8.0, 1.0)}});
	EXPECT_EQ(Toon, Measure(File, Whole).Toon);
	EXPECT_EQ(FIntRect(2, 1, 5, 2), Measure(File, FIntRect(2, 1, 12, 8)).Toon); // from the view's corner
	EXPECT_EQ(0, Measure(File, FIntRect(0, 3, 12, 8)).Toon->Area());            // beside the toon
	EXPECT_FALSE(Measure(File, Whole).GlowMask);                                // the file does not say
}

TEST(SceneContent, AnIdIsRoundedAndItsUpperBitsAreNoModel)
{
	// 24 is 8 with a bit of the selective output mask; NaN is packed as 0.
	EXPECT_EQ(Whole, Measure(FSceneOnDisk({{"shadingmodel.ID", Constant(24.2)}}), Whole).Toon);
	EXPECT_EQ(0, Measure(FSceneOnDisk({{"shadingmodel.ID", Constant(std::nan(""))}}), Whole).Toon->Area());
}

TEST(SceneContent, PaddingIsNoPartOfTheView)
{
	const FSceneOnDisk File({{"shadingmodel.ID", Within(FIntRect(0, 0, 1, 1), 8.0, 1.0)}});
	EXPECT_EQ(
		FIntRect(0, 0, 1, 1), Measure(File, Whole + FIntPoint(5, 3), R"(, "padding": {"left": 5, "top": 3})").Toon);
}

TEST(SceneContent, ADefaultCountsAsAChannel)
{
	const FSceneOnDisk File({{"R", Constant(0.0)}});
	const std::string Toon = R"(, "defaults": {"shadingmodel.ID": 8})";
	EXPECT_EQ(Whole, Measure(File, Whole, Toon).Toon);
}

TEST(SceneContent, GlowMaskIsWhatIsNotZero)
{
	const FIntRect Mask(9, 6, 12, 8);
	EXPECT_EQ(Mask, Measure(FSceneOnDisk({{"custommask.B", Within(Mask, 0.5, 0.0)}}), Whole).GlowMask);
	EXPECT_EQ(0, Measure(FSceneOnDisk({{"custommask.B", Constant(0.0)}}), Whole).GlowMask->Area());
	// Sums of what is tiny, or not finite, are not exact: nothing is promised about where they end.
	EXPECT_EQ(Whole, Measure(FSceneOnDisk({{"custommask.B", Within(Mask, 1e-30, 0.0)}}), Whole).GlowMask);
	EXPECT_EQ(Whole, Measure(FSceneOnDisk({{"custommask.B", Within(Mask, std::nan(""), 0.0)}}), Whole).GlowMask);
}

TEST(SceneContent, StillMeansNoVelocityAtAll)
{
	const auto Measured = [](double X, double Y)
	{
		return Measure(FSceneOnDisk({{"velocity.X", Constant(X)}, {"velocity.Y", Constant(Y)}}), Whole).bStill;
	};
	EXPECT_EQ(true, Measured(0.0, -0.0));
	EXPECT_EQ(false, Measured(0.0, 1e-3));
	EXPECT_EQ(false, Measured(std::nan(""), 0.0));
}

TEST(SceneContent, BrightestIsTheLargestComponentAndUnknownWithoutAnEnd)
{
	const FIntRect Lamp(5, 5, 6, 6);
	const auto Measured = [&](double Lit)
	{
		return Measure(
			FSceneOnDisk({{"R", Constant(0.25)}, {"G", Within(Lamp, Lit, 0.5)}, {"B", Constant(-2.0)}}), Whole)
			.Brightest;
	};
	EXPECT_EQ(96.0, Measured(96.0));
	EXPECT_FALSE(Measured(INFINITY));
	EXPECT_FALSE(Measured(std::nan("")));
}

TEST(SceneContent, ReadsOnlyWhatIsAskedAndOnce)
{
	const FSceneOnDisk File({{"R", Constant(1.0)}, {"G", Constant(1.0)}, {"B", Constant(1.0)},
		{"custommask.B", Constant(0.0)}, {"shadingmodel.ID", Constant(8.0)}});
	const FConfig Config = File.MakeConfig();
	FSceneFile Scene(Config);
	FContentQuestions Questions;
	Questions.bGlowMask = true;
	const FViewContent Content = MeasureViewContent(Scene, Whole, Questions);
	EXPECT_TRUE(Content.GlowMask);
	EXPECT_FALSE(Content.Toon);
	for (const FSceneChannel& Channel : Scene.GetChannels())
	{
		EXPECT_EQ(Channel.Name == "custommask.B", Channel.bDecoded) << Channel.Name;
	}
}
