// The scene at another resolution than the output: rects, what a pixel covers, and whole runs.
#include <gtest/gtest.h>

#include "Run/Run.h"
#include "SceneFile/SceneResolution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Drydock;

namespace
{

/** A flat picture without bloom or vignette, through the film curve; More: further members. 641 x 359. */
FRunResult RunAt(const std::string& Percentage, const std::string& More = "")
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_641x359.exr")" +
						 (Percentage.empty() ? "" : R"(, "screenPercentage": )" + Percentage) + "}" +
						 (More.empty() ? "" : ", " + More) + "}";
	return RunConfig(Options);
}

const char* const Quiet = R"("camera": {"Settings": {"BloomIntensity": 0, "VignetteIntensity": 0}})";

double MeanOf(const FImage& Image)
{
	return std::accumulate(Image.Values.begin(), Image.Values.end(), 0.0) / static_cast<double>(Image.Values.size());
}

const FRDGCompiledPass* FindPass(const FRDGCompiledGraph& Graph, const std::string& Name)
{
	const auto Found = std::find_if(Graph.Passes.begin(), Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return Pass.Name.find(Name) != std::string::npos; });
	return Found == Graph.Passes.end() ? nullptr : &*Found;
}

} // namespace

TEST(ScaleRect, RoundsEdgesUpAndKeepsNeighboursTouching)
{
	EXPECT_EQ(FIntRect(0, 0, 321, 180), ScaleRect(FIntRect(0, 0, 641, 359), 50));
	EXPECT_EQ(FIntRect(0, 0, 161, 5), ScaleRect(FIntRect(0, 0, 321, 9), 50));
	EXPECT_EQ(FIntRect(161, 0, 321, 5), ScaleRect(FIntRect(321, 0, 641, 9), 50));
}

TEST(ScaleRect, HasOnePixelAtLeastAndStaysInThePicture)
{
	EXPECT_EQ(FIntRect(0, 0, 1, 1), ScaleRect(FIntRect(0, 0, 2, 2), 1));
	EXPECT_EQ(FIntRect(0, 0, 1, 1), ScaleRect(FIntRect(1, 1, 2, 2), 1));
	EXPECT_EQ(FIntRect(59, 1, 86, 2), ScaleRect(FIntRect(212, 4, 310, 5), 27.5));
}

TEST(ScaleRect, PercentagesThatBinaryCannotHoldAreExact)
{
	// 1000 * 0.07 is 70.00000000000001 in double.
	EXPECT_EQ(70, ScaleRect(FIntRect(0, 0, 1000, 10), 7).Max.X);
}

TEST(Coverage, PartsOfAFractionalRatio)
{
	// 5 source pixels to 2: each covers 2.5.
	const FCoverage First = MakeCoverage(5, 2, 0), Second = MakeCoverage(5, 2, 1);
	EXPECT_EQ(0, First.First);
	EXPECT_EQ((std::vector<double>{0.4, 0.4, 0.2}), First.Parts);
	EXPECT_EQ(2, Second.First);
	EXPECT_EQ((std::vector<double>{0.2, 0.4, 0.4}), Second.Parts);
}

TEST(Coverage, OfALargerPictureIsAPartOfAPixel)
{
	EXPECT_EQ((std::vector<double>{1.0}), MakeCoverage(4, 8, 3).Parts);
	EXPECT_EQ(1, MakeCoverage(4, 8, 3).First);
}

TEST(Coverage, PartsSumToOne)
{
	for (int Index = 0; Index < 37; ++Index)
	{
		const FCoverage Coverage = MakeCoverage(101, 37, Index);
		EXPECT_NEAR(1.0, std::accumulate(Coverage.Parts.begin(), Coverage.Parts.end(), 0.0), 1e-12);
	}
}

TEST(CenterPixel, IsTheOneUnderTheCentre)
{
	EXPECT_EQ(1, FindCenterPixel(5, 2, 0)); // centre at 1.25
	EXPECT_EQ(3, FindCenterPixel(5, 2, 1)); // 3.75
	EXPECT_EQ(2, FindCenterPixel(5, 5, 2));
}

TEST(ScreenPercentage, AHundredBuildsNoUpscale)
{
	const FRunResult Result = RunAt("100", Quiet);
	EXPECT_EQ(nullptr, FindPass(Result.Graph, "PrimaryUpscale"));
	EXPECT_EQ(RunAt("", Quiet).Final.ToImage().Values, Result.Final.ToImage().Values);
}

TEST(ScreenPercentage, RendersSmallerAndGivesTheOutputsSize)
{
	const FRunResult Result = RunAt("50", Quiet);
	EXPECT_EQ(321, Result.SceneLinear.Width);
	EXPECT_EQ(180, Result.SceneLinear.Height);
	EXPECT_EQ(641, Result.Final.Width);
	EXPECT_EQ(359, Result.Final.Height);
	ASSERT_NE(nullptr, FindPass(Result.Graph, "PrimaryUpscale"));
	EXPECT_NE(std::string::npos, FindPass(Result.Graph, "PrimaryUpscale")->Name.find("321x180 -> 641x359"));
}

TEST(ScreenPercentage, ColourIsTheMeanOfTheAreaAPixelCovers)
{
	const FRunResult Whole = RunAt("100", Quiet), Half = RunAt("50", Quiet);
	EXPECT_NEAR(MeanOf(Whole.SceneLinear.ToImage()), MeanOf(Half.SceneLinear.ToImage()),
		2e-3 * MeanOf(Whole.SceneLinear.ToImage()));
	// Pixel 1, 0 covers columns 641/321 to 1282/321 and rows 0 to 359/180.
	const FCoverage Columns = MakeCoverage(641, 321, 1), Rows = MakeCoverage(359, 180, 0);
	double Sum = 0;
	for (size_t J = 0; J < Rows.Parts.size(); ++J)
	{
		for (size_t I = 0; I < Columns.Parts.size(); ++I)
		{
			Sum += Columns.Parts[I] * Rows.Parts[J] *
				   Whole.SceneLinear.Get(Columns.First + static_cast<int>(I), static_cast<int>(J), 1);
		}
	}
	EXPECT_NEAR(Sum, Half.SceneLinear.Get(1, 0, 1), 1e-3 * Sum); // stored as half float
}

TEST(ScreenPercentage, ThePictureStaysWhereItIs)
{
	// Upscaled again the picture differs at edges only: nothing is shifted or in a corner.
	for (const char* Percentage : {"50", "67", "200"})
	{
		const FRunResult Whole = RunAt("100", Quiet), Scaled = RunAt(Percentage, Quiet);
		ASSERT_EQ(Whole.Final.ToImage().Values.size(), Scaled.Final.ToImage().Values.size());
		double Sum = 0;
		const FImage WholeFinal = Whole.Final.ToImage();
		const FImage ScaledFinal = Scaled.Final.ToImage();
		for (size_t Index = 0; Index < WholeFinal.Values.size(); ++Index)
		{
			Sum += std::fabs(WholeFinal.Values[Index] - ScaledFinal.Values[Index]);
		}
		EXPECT_LT(Sum / static_cast<double>(Whole.Final.ToImage().Values.size()), 0.015) << Percentage;
	}
}

TEST(ScreenPercentage, PaddingMovesTheSceneNotThePicture)
{
	const FRunResult Plain = RunAt("50", Quiet);
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText =
		std::string(
			R"({"scene": {"file": "scenes/toon_character_641x359.exr", "screenPercentage": 50, "padding": [9, 5, 3, 7]}, )") +
		Quiet + "}";
	const FRunResult Padded = RunConfig(Options);
	EXPECT_EQ(FIntPoint(321 + 12, 180 + 12), Padded.SceneExtent);
	ASSERT_EQ(Plain.Final.ToImage().Values.size(), Padded.Final.ToImage().Values.size());
	double Largest = 0;
	const FImage PlainFinal = Plain.Final.ToImage();
	const FImage PaddedFinal = Padded.Final.ToImage();
	for (size_t Index = 0; Index < PlainFinal.Values.size(); ++Index)
	{
		Largest = std::max(Largest, std::fabs(PlainFinal.Values[Index] - PaddedFinal.Values[Index]));
	}
	EXPECT_LE(Largest, 1.01 / 255); // texture coordinates over another extent
}

TEST(ScreenPercentage, EachOfTwoViewsFillsItsRect)
{
	const std::string Views = R"("views": [{"rect": [0, 0, 321, 359]}, {"rect": [321, 0, 641, 359]}], )";
	const FRunResult Result = RunAt("50", Views + Quiet);
	EXPECT_EQ(641, Result.Final.Width);
	EXPECT_EQ(321, Result.SceneLinear.Width);
	const FRunResult Whole = RunAt("100", Views + Quiet);
	double Sum = 0;
	const FImage WholeFinal = Whole.Final.ToImage();
	const FImage ResultFinal = Result.Final.ToImage();
	for (size_t Index = 0; Index < WholeFinal.Values.size(); ++Index)
	{
		Sum += std::fabs(WholeFinal.Values[Index] - ResultFinal.Values[Index]);
	}
	EXPECT_LT(Sum / static_cast<double>(Whole.Final.ToImage().Values.size()), 0.015);
}

TEST(ScreenPercentage, HooksSeeTheScenesSize)
{
	const FRunResult Result = RunAt("50", Quiet);
	for (const FHookPoint& Point : Result.HookPoints)
	{
		if (Point.Point == "Tonemap")
		{
			EXPECT_EQ(321, Point.Width);
			EXPECT_EQ(180, Point.Height);
		}
	}
}

TEST(ScreenPercentage, AGraphMayNeedTheGBufferToo)
{
	const FRunResult Result = RunAt("50", R"("camera": {"Settings": {"BloomToonIntensity": 0.1}})");
	EXPECT_EQ(641, Result.Final.Width);
}

TEST(ScreenPercentage, TheShowFlagSwitchesItOff)
{
	const FRunResult Result = RunAt("50", std::string(R"("showFlags": {"ScreenPercentage": false}, )") + Quiet);
	EXPECT_EQ(RunAt("100", Quiet).Final.ToImage().Values, Result.Final.ToImage().Values);
}
