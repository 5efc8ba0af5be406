// The chart of a walk: well-formed, the same bytes every time, nothing outside, and where lines go.
#include <gtest/gtest.h>

#include "Blend/WalkChart.h"
#include "Picture/SvgTools.h"

#include <regex>
#include <vector>

using namespace Drydock;

namespace
{

FWalkChart MakeChart()
{
	FWalkChart Chart;
	Chart.Title = "A & B <walk>";
	Chart.Subtitle = "3 points";
	Chart.MarkName = "point";
	Chart.Length = 200.0;
	Chart.Marks = {{0.0, "1"}, {100.0, "2"}, {200.0, "3"}};
	Chart.Volumes = {
		{"Base", true, {{0.0, 1.0}, {200.0, 1.0}}}, {"Room", false, {{0.0, 0.0}, {100.0, 0.5}, {200.0, 1.0}}}};
	Chart.Rows = {{"BloomIntensity", "", false, {}, {{"", {{0.0, 0.0}, {100.0, 1.0}, {200.0, 4.0}}}}},
		{"BloomMethod", "", true, {"BM_SOG", "BM_FFT"}, {{"", {{0.0, 0.0}, {100.0, 1.0}, {200.0, 1.0}}}}}};
	return Chart;
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

TEST(WalkChart, IsWellFormedAndEscaped)
{
	const std::string Svg = DrawWalkChart(MakeChart());
	EXPECT_EQ("", FindUnbalancedTag(Svg));
	EXPECT_NE(std::string::npos, Svg.find("A &amp; B &lt;walk&gt;"));
	EXPECT_EQ(CountOf(Svg, "&"), CountOf(Svg, "&amp;") + CountOf(Svg, "&lt;") + CountOf(Svg, "&gt;"));
}

TEST(WalkChart, IsTheSameEveryTime)
{
	EXPECT_EQ(DrawWalkChart(MakeChart()), DrawWalkChart(MakeChart()));
}

TEST(WalkChart, NamesVolumesAndSettings)
{
	const std::string Svg = DrawWalkChart(MakeChart());
	for (const char* Name : {">Base<", ">Room<", ">BloomIntensity", ">BloomMethod", ">BM_FFT<", ">BM_SOG<"})
	{
		EXPECT_NE(std::string::npos, Svg.find(Name)) << Name;
	}
}

TEST(WalkChart, EveryLineHasADotAtEveryPoint)
{
	EXPECT_EQ(6u, CountOf(DrawWalkChart(MakeChart()), "<circle "));
}

TEST(WalkChart, OnlyBoundedVolumesShade)
{
	const std::string Svg = DrawWalkChart(MakeChart());
	EXPECT_EQ(1u, CountOf(Svg, "<linearGradient "));
	EXPECT_EQ(2u, CountOf(Svg, "fill=\"url(#g1)\"")); // behind both rows
}

TEST(WalkChart, ShadeIsAsStrongAsTheWeight)
{
	// A weight that rises evenly from 0 to 1 needs two stops; the strongest shade is 0.2.
	const std::string Svg = DrawWalkChart(MakeChart());
	EXPECT_NE(std::string::npos, Svg.find("<stop offset=\"0\" class=\"v0\" stop-opacity=\"0\"/>"
										  "<stop offset=\"1\" class=\"v0\" stop-opacity=\"0.2\"/></linearGradient>"));
}

TEST(WalkChart, SurvivesNothingToDraw)
{
	FWalkChart Chart = MakeChart();
	Chart.Length = 0.0;
	Chart.Volumes.clear();
	Chart.Rows = {{"Flat", "", false, {}, {{"", {{0.0, 2.0}, {0.0, 2.0}}}}}, {"Empty", "", false, {}, {}}};
	EXPECT_EQ("", FindUnbalancedTag(DrawWalkChart(Chart)));
	EXPECT_EQ(std::string::npos, DrawWalkChart(Chart).find("nan"));
}

TEST(SvgTools, NumbersAreShort)
{
	EXPECT_EQ("1.5", FixedText(1.5, 2));
	EXPECT_EQ("-0.33", FixedText(-1.0 / 3.0, 2));
	EXPECT_EQ("0", FixedText(-0.001, 2));
	EXPECT_EQ("100", FixedText(100.0, 0));
	EXPECT_EQ("0.6131", ShortText(0.61312345));
}

TEST(SvgTools, TicksAreRound)
{
	EXPECT_EQ((std::vector<double>{0.0, 50.0, 100.0, 150.0, 200.0}), FAxisTicks(0.0, 241.0, 5).Values);
	EXPECT_EQ((std::vector<double>{-1.0, 0.0, 1.0}), FAxisTicks(-1.2, 1.2, 4).Values);
	EXPECT_EQ(1, FAxisTicks(0.0, 1.0, 5).Digits);
	EXPECT_EQ(0, FAxisTicks(0.0, 100.0, 5).Digits);
}

TEST(SvgTools, StraightRunsAreOneLine)
{
	EXPECT_EQ((std::vector<FSvgPoint>{{0.0, 0.0}, {2.0, 2.0}, {4.0, 0.0}}),
		SimplifyCurve({{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}, {3.0, 1.0}, {4.0, 0.0}}));
}

TEST(SvgTools, LongNamesEndInAnEllipsis)
{
	EXPECT_EQ("abc", ShortenText("abc", 3));
	EXPECT_EQ("ab\xE2\x80\xA6", ShortenText("abc", 2));
	EXPECT_EQ("\xC3\xA4\xE2\x80\xA6", ShortenText("\xC3\xA4\xC3\xB6", 1));
}
