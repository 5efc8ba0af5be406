// Charts: axes and their ticks, drawings that are well-formed and the same bytes every time, and the chart of a walk.
#include <gtest/gtest.h>

#include "Blend/SettingsWalk.h"
#include "Blend/WalkChart.h"
#include "Picture/SvgTools.h"

#include <limits>
#include <regex>
#include <vector>

using namespace Drydock;

namespace
{

const std::string GTitle = "A & B <walk>";

/** From 0 to 200 cm, over three points: a volume that acts everywhere, one that comes in evenly, two settings. */
FSettingsWalk MakeWalk()
{
	FSettingsWalk Walk;
	Walk.Volumes = {"Base", "Room"};
	Walk.Unbound = {true, false};
	for (const char* Setting : {"BloomIntensity", "BloomMethod"})
	{
		Walk.Settings.push_back(static_cast<size_t>(FindSettingIndex(Setting)));
	}
	Walk.Points = {{FVector(0.0, 0.0, 0.0), "1"}, {FVector(100.0, 0.0, 0.0), "2"}, {FVector(200.0, 0.0, 0.0), "3"}};
	const double Intensities[] = {0.0, 1.0, 4.0};
	for (int Point = 0; Point < 3; ++Point)
	{
		FWalkSample Sample;
		Sample.Distance = 100.0 * Point;
		Sample.Point = Point;
		Sample.Weights = {1.0f, 0.5f * static_cast<float>(Point)};
		Sample.Values.resize(2);
		Sample.Values[0].Components[0] = Intensities[Point];
		Sample.Values[1].Components[0] = Point == 0 ? 0.0 : 1.0;
		Walk.Samples.push_back(Sample);
	}
	return Walk;
}

std::string DrawWalk(const FSettingsWalk& Walk = MakeWalk())
{
	return DrawChart(MakeWalkChart(Walk, GTitle, "point"));
}

/** Empty when every tag is closed in order. A chart has no comments and no CDATA. */
std::string FindUnbalancedTag(const std::string& Svg)
{
	std::vector<std::string> Open;
	const std::regex Tag("<(/?)([a-zA-Z]+)[^<>]*?(/?)>");
	for (std::sregex_iterator It(Svg.begin(), Svg.end(), Tag), End; It != End; ++It)
	{
		const std::string Name = (*It)[2];
		if ((*It)[1].length() > 0)
		{
			if (Open.empty() || Open.back() != Name)
			{
				return Name;
			}
			Open.pop_back();
		}
		else if ((*It)[3].length() == 0)
		{
			Open.push_back(Name);
		}
	}
	return Open.empty() ? "" : Open.back();
}

std::vector<std::string> GetTexts(const FChartAxis& Axis)
{
	std::vector<std::string> Texts;
	for (const FChartTick& Tick : Axis.Ticks)
	{
		Texts.push_back(Tick.Text);
	}
	return Texts;
}

size_t CountOf(const std::string& Text, const std::string& Part)
{
	size_t Count = 0;
	for (size_t At = Text.find(Part); At != std::string::npos; At = Text.find(Part, At + 1))
	{
		++Count;
	}
	return Count;
}

} // namespace

TEST(Chart, LogarithmicAxisMapsFactorsToEqualSteps)
{
	const FChartAxis Axis = MakeLogAxis("", {1e-4, 1.0, -3.0, 0.0});
	EXPECT_NEAR(Axis.Map(1e-2), (Axis.Map(1e-4) + Axis.Map(1.0)) / 2.0, 1e-12);
	EXPECT_GT(Axis.Map(1e-4), 0.0);
	EXPECT_LT(Axis.Map(1.0), 1.0);
	EXPECT_EQ(0.0, Axis.Map(0.0));
	EXPECT_EQ(1.0, Axis.Map(1e9));
}

TEST(Chart, TicksOfALogarithmicAxisAreFewAndRound)
{
	EXPECT_EQ((std::vector<std::string>{"10\u207B\u2074", "0.001", "0.01", "0.1", "1"}),
		GetTexts(MakeLogAxis("", {1e-4, 1.0})));
	EXPECT_EQ((std::vector<std::string>{"1", "2", "5", "10"}), GetTexts(MakeLogAxis("", {1.0, 9.0})));
	EXPECT_EQ((std::vector<std::string>{"1.5", "2", "3"}), GetTexts(MakeLogAxis("", {2.0, 3.0})));
	EXPECT_EQ("10\u2075", NameLogTick(1e5));
	EXPECT_EQ("0.0003", NameLogTick(3e-4));
}

TEST(Chart, TicksOfALinearAxisAreRound)
{
	EXPECT_EQ((std::vector<std::string>{"0", "50", "100", "150", "200"}), GetTexts(MakeLinearAxis("", 0.0, 241.0, 5)));
	EXPECT_EQ((std::vector<std::string>{"-1", "0", "1"}), GetTexts(MakeLinearAxis("", -1.2, 1.2, 4)));
	EXPECT_EQ(
		(std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}), GetTexts(MakeLinearAxis("", 0.0, 1.0, 5)));
}

TEST(Chart, LinearAxisHasTicksAtNamesAlone)
{
	const FChartAxis Axis = MakeLinearAxis("", -0.1, 1.1, 5, {"BM_SOG", "BM_FFT"});
	ASSERT_EQ(2u, Axis.Ticks.size());
	EXPECT_EQ("BM_SOG", Axis.Ticks[0].Text);
	EXPECT_EQ("BM_FFT", Axis.NameValue(1.0));
	EXPECT_EQ("7", Axis.NameValue(7.0));
}

TEST(Chart, StraightRunsAreOneLine)
{
	FChart Chart;
	Chart.Panels.resize(1);
	Chart.Panels[0].Height = 100.0;
	Chart.Panels[0].X = MakeLinearAxis("", 0.0, 4.0, 5);
	Chart.Panels[0].Y = MakeLinearAxis("", 0.0, 2.0, 5);
	Chart.Panels[0].Series = {
		{"", "ink", {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {3.0, 1.0}, {4.0, 0.0}}, false, false, {}}};
	std::smatch Path;
	const std::string Svg = DrawChart(Chart);
	ASSERT_TRUE(std::regex_search(Svg, Path, std::regex("<path d=\"(M[^\"]*)\" class=\"line ink\"")));
	EXPECT_EQ(2u, CountOf(Path[1], " L"));
}

TEST(WalkChart, IsWellFormedAndEscaped)
{
	const std::string Svg = DrawWalk();
	EXPECT_EQ("", FindUnbalancedTag(Svg));
	EXPECT_NE(std::string::npos, Svg.find("A &amp; B &lt;walk&gt;"));
	EXPECT_EQ(CountOf(Svg, "&"), CountOf(Svg, "&amp;") + CountOf(Svg, "&lt;") + CountOf(Svg, "&gt;"));
}

TEST(WalkChart, IsTheSameEveryTime)
{
	EXPECT_EQ(DrawWalk(), DrawWalk());
}

TEST(WalkChart, NamesVolumesAndSettings)
{
	const std::string Svg = DrawWalk();
	for (const char* Name : {">Base<", ">Room<", ">BloomIntensity<", ">BloomMethod<", ">BM_FFT<", ">BM_SOG<"})
	{
		EXPECT_NE(std::string::npos, Svg.find(Name)) << Name;
	}
}

TEST(WalkChart, EveryLineHasADotAtEveryPoint)
{
	EXPECT_EQ(6u, CountOf(DrawWalk(), "<circle "));
	EXPECT_EQ(1u, CountOf(DrawWalk(), "<title>point 2: BM_FFT</title>"));
}

TEST(WalkChart, OnlyBoundedVolumesShade)
{
	const std::string Svg = DrawWalk();
	EXPECT_EQ(1u, CountOf(Svg, "<linearGradient "));
	EXPECT_EQ(2u, CountOf(Svg, "fill=\"url(#g0)\"")); // behind both settings
}

TEST(WalkChart, ShadeIsAsStrongAsTheWeight)
{
	// A weight that rises evenly from 0 to 1 needs two stops; the strongest shade is 0.2.
	EXPECT_NE(
		std::string::npos, DrawWalk().find("<stop offset=\"0\" class=\"c0\" stop-opacity=\"0\"/>"
										   "<stop offset=\"1\" class=\"c0\" stop-opacity=\"0.2\"/></linearGradient>"));
}

TEST(WalkChart, ValuesOfAnEnumAreSteps)
{
	const FChart Chart = MakeWalkChart(MakeWalk(), "", "point");
	ASSERT_EQ(4u, Chart.Panels.size()); // two volumes, two settings
	EXPECT_FALSE(Chart.Panels[2].Series[0].bSteps);
	EXPECT_TRUE(Chart.Panels[3].Series[0].bSteps);
	EXPECT_EQ("0 \u2192 4", Chart.Panels[2].Aside);
	EXPECT_EQ("BM_SOG \u2192 BM_FFT", Chart.Panels[3].Aside);
}

TEST(WalkChart, SurvivesNothingToDraw)
{
	FSettingsWalk Walk = MakeWalk();
	Walk.Volumes.clear();
	Walk.Unbound.clear();
	for (FWalkSample& Sample : Walk.Samples)
	{
		Sample.Distance = 0.0;
		Sample.Values[0].Components[0] = 2.0;
		Sample.Values[1].Components[0] = std::numeric_limits<double>::quiet_NaN();
	}
	EXPECT_EQ("", FindUnbalancedTag(DrawWalk(Walk)));
	EXPECT_EQ(std::string::npos, DrawWalk(Walk).find("nan"));
	EXPECT_EQ("", FindUnbalancedTag(DrawWalk(FSettingsWalk())));
}

TEST(SvgTools, NumbersAreShort)
{
	EXPECT_EQ("1.5", FixedText(1.5, 2));
	EXPECT_EQ("-0.33", FixedText(-1.0 / 3.0, 2));
	EXPECT_EQ("0", FixedText(-0.001, 2));
	EXPECT_EQ("100", FixedText(100.0, 0));
	EXPECT_EQ("0.6131", ShortText(0.61312345));
}

TEST(SvgTools, LongNamesEndInAnEllipsis)
{
	EXPECT_EQ("abc", ShortenText("abc", 3));
	EXPECT_EQ("ab\xE2\x80\xA6", ShortenText("abc", 2));
	EXPECT_EQ("\xC3\xA4\xE2\x80\xA6", ShortenText("\xC3\xA4\xC3\xB6", 1));
}
