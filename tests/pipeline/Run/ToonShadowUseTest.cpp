// The uses of the blurred shadow in lighting, in the sample's frame: each pixel computed again from the scene file, the
// formulas of docs/effects.md and the blurred shadow that the run kept; and that the sample shows what it is for.
#include <gtest/gtest.h>

#include "Run/Run.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

using namespace Drydock;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

using FColor3 = std::array<double, 3>;

std::string ReadSample()
{
	std::ostringstream Text;
	Text << std::ifstream(Configs + "toon_shadow_blur.json").rdbuf();
	return Text.str();
}

std::string ReadSampleWithoutRamp()
{
	return std::regex_replace(ReadSample(), std::regex(R"re("ToonShadowBlurRamp": "[^"]*",)re"), "");
}

FRunResult RunSample(const std::vector<std::string>& Settings, const std::string& Text = ReadSample())
{
	FRunOptions Options;
	Options.ConfigFile = Configs + "toon_shadow_blur.json";
	Options.ConfigText = Text;
	Options.Settings = Settings;
	Options.Dump = {"ToonShadowCombine"};
	return RunConfig(Options);
}

/** What the scene's file holds, by pixel. */
class FPortrait
{
public:
	FPortrait()
		: File(Configs + "scenes/toon_portrait.exr")
		, Planes(File.Read({Find("R"), Find("G"), Find("B"), Find("basecolor.R"), Find("basecolor.G"),
			  Find("basecolor.B"), Find("shadingmodel.ID"), Find("shadow.R"), Find("shadow.G"), Find("translucency.R"),
			  Find("translucency.G"), Find("translucency.B"), Find("translucency.A")}))
	{
	}

	size_t GetNumPixels() const { return Planes[0].size(); }
	FColor3 GetColor(size_t Pixel) const { return GetThree(0, Pixel); }
	FColor3 GetBaseColor(size_t Pixel) const { return GetThree(3, Pixel); }
	FColor3 GetTranslucency(size_t Pixel) const { return GetThree(9, Pixel); }
	double GetTransmittance(size_t Pixel) const { return static_cast<double>(Planes[12][Pixel]); }
	bool IsToon(size_t Pixel) const { return Planes[6][Pixel] == 8.0f; }
	double GetShadow(size_t Pixel) const { return static_cast<double>(std::min(Planes[7][Pixel], Planes[8][Pixel])); }
	/** The scene's own words: skin has the base colour (0.95, 0.72, 0.6). */
	bool IsSkin(size_t Pixel) const
	{
		const FColor3 Base = GetBaseColor(Pixel);
		return IsToon(Pixel) && std::abs(Base[0] - 0.95) < 0.01 && std::abs(Base[1] - 0.72) < 0.01 &&
			   std::abs(Base[2] - 0.6) < 0.01;
	}

private:
	int Find(const char* Name) const { return File.FindChannel(Name); }
	FColor3 GetThree(size_t First, size_t Pixel) const
	{
		return {static_cast<double>(Planes[First][Pixel]), static_cast<double>(Planes[First + 1][Pixel]),
			static_cast<double>(Planes[First + 2][Pixel])};
	}

	FImageFile File;
	std::vector<std::vector<float>> Planes;
};

const FPortrait& GetPortrait()
{
	static const FPortrait Portrait;
	return Portrait;
}

/** As an 8-bit sRGB target keeps it. */
double RoundAsSrgb(double Linear)
{
	const double Code = Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1 / 2.4) - 0.055;
	const double Stored = std::round(Code * 255) / 255;
	return Stored <= 0.04045 ? Stored / 12.92 : std::pow((Stored + 0.055) / 1.055, 2.4);
}

/** The sample's ramp between its texels. */
FColor3 LookUpRamp(double Shadow)
{
	static const std::vector<std::vector<float>> Planes = []
	{
		FImageFile File(Configs + "textures/skin_ramp.png");
		return File.Read({0, 1, 2});
	}();
	const size_t Last = Planes[0].size() - 1;
	const double At = Shadow * static_cast<double>(Last);
	const size_t Left = static_cast<size_t>(At), Right = std::min(Left + 1, Last);
	FColor3 Color{};
	for (size_t Channel = 0; Channel < 3; ++Channel)
	{
		const double A = static_cast<double>(Planes[Channel][Left]), B = static_cast<double>(Planes[Channel][Right]);
		Color[Channel] = A + (At - static_cast<double>(Left)) * (B - A);
	}
	return Color;
}

/** Light: what the sun adds at full strength. */
using FUse = double (*)(double Lit, double Shadow, double Blurred, double Light, size_t Channel);

double Add(double Lit, double, double Blurred, double Light, size_t)
{
	return Lit + Blurred * Light;
}

double Screen(double Lit, double, double Blurred, double Light, size_t)
{
	return 1 - (1 - std::min(Lit, 1.0)) * (1 - Blurred * Light) + std::max(Lit - 1, 0.0);
}

double Max(double Lit, double Shadow, double Blurred, double Light, size_t)
{
	return Lit + (std::max(Shadow, Blurred) - Shadow) * Light;
}

double MaxWithRamp(double Lit, double Shadow, double Blurred, double Light, size_t Channel)
{
	return Lit + (LookUpRamp(std::max(Shadow, Blurred))[Channel] - LookUpRamp(Shadow)[Channel]) * Light;
}

double GetLargestError(const FRunResult& Result, FUse Use)
{
	// The scene's light as its JSON gives it, relative to the largest component.
	const FColor3 Sun = {1.0, 4.250919 / 4.671339, 3.737071 / 4.671339};
	constexpr double Intensity = 0.85;
	const FPortrait& Portrait = GetPortrait();
	const FImage Buffer = Result.Dumps.at(0).Image.ToImage();
	double Largest = 0.0;
	const FImage ResultSceneLinear = Result.SceneLinear.ToImage();
	for (size_t Pixel = 0; Pixel < Portrait.GetNumPixels(); ++Pixel)
	{
		const double Root = Buffer.Values[4 * Pixel + 3];
		for (size_t Channel = 0; Channel < 3; ++Channel)
		{
			const double Lit = Portrait.GetColor(Pixel)[Channel];
			const double Light = Intensity * Sun[Channel] * RoundAsSrgb(Portrait.GetBaseColor(Pixel)[Channel]);
			const double Used =
				Portrait.IsToon(Pixel) ? Use(Lit, Portrait.GetShadow(Pixel), Root * Root, Light, Channel) : Lit;
			// The glass pane comes after the lighting.
			const double Expected = Used * Portrait.GetTransmittance(Pixel) + Portrait.GetTranslucency(Pixel)[Channel];
			const double Value = ResultSceneLinear.Values[4 * Pixel + Channel];
			// Where the pane is, half floats round twice.
			const double Roundings = Portrait.GetTransmittance(Pixel) < 1.0 ? 2.0 : 1.0;
			Largest = std::max(Largest, std::abs(Value - Expected) / (Roundings * std::max(1.0, Expected)));
		}
	}
	return Largest;
}

} // namespace

// Half floats below 1 are 2^-12 off at most; shadows of the file lie within 0.07/255 of the 8-bit level they become.
constexpr double HalfStep = 3e-4 + 0.07 / 255;

TEST(ToonShadowUse, AddInTheWholeFrame)
{
	EXPECT_LE(GetLargestError(RunSample({"ToonShadowBlurBlend=Add"}), &Add), HalfStep);
}

TEST(ToonShadowUse, ScreenInTheWholeFrame)
{
	EXPECT_LE(GetLargestError(RunSample({"ToonShadowBlurBlend=Screen"}), &Screen), HalfStep);
}

TEST(ToonShadowUse, MaxInTheWholeFrame)
{
	EXPECT_LE(GetLargestError(RunSample({}, ReadSampleWithoutRamp()), &Max), HalfStep);
}

TEST(ToonShadowUse, MaxWithTheRampInTheWholeFrame)
{
	// The ramp is steeper than its argument, and a sampler steps by 1/256 of its 256 texels.
	EXPECT_LE(GetLargestError(RunSample({}), &MaxWithRamp), 4 * HalfStep);
}

TEST(ToonShadowUse, RampThatMaxDoesNotReadIsWarnedOf)
{
	const auto Warns = [](const std::string& Setting)
	{
		const FRunResult Result = RunSample({Setting});
		return std::any_of(Result.Diagnostics.begin(), Result.Diagnostics.end(),
			[](const FDiagnostic& Diagnostic)
			{ return Diagnostic.Message.find("ToonShadowBlurRamp") != std::string::npos; });
	};
	EXPECT_TRUE(Warns("ToonShadowBlurBlend=Add"));
	EXPECT_TRUE(Warns("ToonShadowBlurRamp=/Game/Toon/Ramp.Ramp")); // has no pixels here
	EXPECT_FALSE(Warns("ToonShadowBlurBlend=Max"));
	EXPECT_FALSE(Warns("ToonShadowBlurIntensity=0"));
}

// What the article is about, as the eye has it: beside the border of the shadow the dark skin turns warm, and the lit
// skin stays as it is.
TEST(ToonShadowUse, SampleShowsAColoredFringeOnDarkSkin)
{
	const FRunResult With = RunSample({}), Without = RunSample({"ToonShadowBlurIntensity=0"});
	const FPortrait& Portrait = GetPortrait();
	size_t NumDark = 0, NumFringe = 0, NumLit = 0;
	double Warmer = 0.0;
	const FImage WithoutFinal = Without.Final.ToImage();
	const FImage WithFinal = With.Final.ToImage();
	const FImage WithoutSceneLinear = Without.SceneLinear.ToImage();
	const FImage WithSceneLinear = With.SceneLinear.ToImage();
	for (size_t Pixel = 0; Pixel < Portrait.GetNumPixels(); ++Pixel)
	{
		const double* const A = &WithoutFinal.Values[4 * Pixel];
		const double* const B = &WithFinal.Values[4 * Pixel];
		if (!Portrait.IsSkin(Pixel))
		{
			continue;
		}
		if (Portrait.GetShadow(Pixel) > 0.99)
		{
			++NumLit;
			for (size_t Channel = 0; Channel < 3; ++Channel)
			{
				ASSERT_EQ(WithoutSceneLinear.Values[4 * Pixel + Channel], WithSceneLinear.Values[4 * Pixel + Channel]);
			}
		}
		else if (Portrait.GetShadow(Pixel) < 0.01)
		{
			++NumDark;
			const bool bFringe = B[0] - A[0] > 0.1; // 25 steps of the display: nobody overlooks that
			NumFringe += bFringe ? 1 : 0;
			Warmer += bFringe ? (B[0] - B[2]) - (A[0] - A[2]) : 0.0;
		}
	}
	EXPECT_GT(NumLit, 5000u);
	EXPECT_GT(NumDark, 5000u);
	EXPECT_GT(static_cast<double>(NumFringe), 0.2 * static_cast<double>(NumDark));
	EXPECT_LT(static_cast<double>(NumFringe), 0.8 * static_cast<double>(NumDark)); // a fringe, not another light
	EXPECT_GT(Warmer / static_cast<double>(NumFringe), 0.1);                       // red less blue, of the display
}

namespace
{

/** Cells of the page's table row that begins so. */
std::vector<std::string> ReadRow(const std::string& Begin)
{
	std::ifstream Page(DRYDOCK_TEST_SOURCE_DIR "/docs/effects.md");
	for (std::string Line; std::getline(Page, Line);)
	{
		if (Line.starts_with(Begin))
		{
			std::istringstream Text(Line.substr(2));
			std::vector<std::string> Cells;
			for (std::string Cell; std::getline(Text, Cell, '|');)
			{
				Cells.push_back(Cell.substr(Cell.find_first_not_of(' ') == 0 ? 0 : 1));
			}
			return Cells;
		}
	}
	ADD_FAILURE() << "no row " << Begin;
	return std::vector<std::string>(8, "0");
}

} // namespace

TEST(ToonShadowUse, PageHasTheDarkLevelsOfTheStores)
{
	for (const char* Store : {"EightBit", "SixteenBit", "SqrtEightBit"})
	{
		FRunOptions Options;
		Options.ConfigFile = Configs + "study_storage.json";
		Options.Settings = {std::string("ToonShadowBlurStore=") + Store};
		Options.Dump = {"ToonShadowCombine"};
		const FRunResult Result = RunConfig(Options);
		const FImage Buffer = Result.Dumps.at(0).Image.ToImage();
		std::set<double> Levels;
		for (size_t Index = 3; Index < Buffer.Values.size(); Index += 4)
		{
			const double Stored = Buffer.Values[Index];
			const double Blurred = std::string(Store) == "SqrtEightBit" ? Stored * Stored : Stored;
			if (Blurred < 0.05)
			{
				Levels.insert(Stored);
			}
		}
		EXPECT_EQ(std::stoul(ReadRow(std::string("| ") + Store + " |")[3]), Levels.size()) << Store;
	}
}

TEST(ToonShadowUse, PageHasTheCostOfTheSample)
{
	const FRunResult Result = RunSample({});
	size_t NumPasses = 0;
	double Taps = 0.0, Bytes = 0.0;
	for (const FRunPass& Pass : Result.Passes)
	{
		if (Result.Graph.Passes[static_cast<size_t>(Pass.Index)].Name.starts_with("ToonShadow"))
		{
			++NumPasses;
			Taps += static_cast<double>(Pass.Taps.value());
			Bytes += static_cast<double>(Pass.Counters.BytesRead + Pass.Counters.BytesWritten);
		}
	}
	const std::vector<std::string> Row = ReadRow("| [ToonShadowBlur]");
	const double NumPixels = 960.0 * 540.0;
	EXPECT_EQ(std::stoul(Row[2]), NumPasses);
	EXPECT_NEAR(std::stod(Row[3]), Taps / NumPixels, 0.05);
	EXPECT_NEAR(std::stod(Row[4]), Bytes / NumPixels, 0.5);
}
