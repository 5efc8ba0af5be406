// Tables and lines that fit a terminal: no line is wider, and no word is lost where cells are wrapped.
#include <gtest/gtest.h>

#include "Text/Terminal.h"
#include "Text/TextTable.h"

#include <sstream>

using namespace Drydock;

namespace
{

constexpr ETextColumn Number = ETextColumn::Number;
constexpr ETextColumn Name = ETextColumn::Name;
constexpr ETextColumn Text = ETextColumn::Text;

size_t GetLongestLine(const std::string& Printed)
{
	size_t Longest = 0;
	std::istringstream Lines(Printed);
	for (std::string Line; std::getline(Lines, Line);)
	{
		Longest = std::max(Longest, CountColumns(Line));
	}
	return Longest;
}

} // namespace

TEST(TextTable, ColumnsAreAsWideAsTheirWidestCell)
{
	const FTextTable Table{{{Name}, {Number}}, {{"name", "ms"}, {"a", "1.50"}, {"longer", "2.0"}}};
	EXPECT_EQ("> name      ms\n> a       1.50\n> longer   2.0\n", Table.Format(0, "> "));
	EXPECT_EQ(Table.Format(), Table.Format(14)); // just wide enough
}

TEST(TextTable, LinesEndWithoutBlanks)
{
	EXPECT_EQ("a\nab  c\n", (FTextTable{{{Text}, {Text}}, {{"a", ""}, {"ab", "c"}}}.Format()));
}

TEST(TextTable, ReasonsAreWrappedIntoTheirColumn)
{
	const FTextTable Table{{{Name}, {Number}, {Text}},
		{{"effect", "ms", "why"}, {"Bloom", "2.64", "the intensity is above zero, so the setup pass is needed by it"}}};
	EXPECT_EQ("effect    ms  why\n"
			  "Bloom   2.64  the intensity is above\n"
			  "              zero, so the setup pass is\n" // 26 columns
			  "              needed by it\n",
		Table.Format(40));
}

TEST(TextTable, NamesLoseTheirMiddleOnlyWhenWrappingIsNotEnough)
{
	const std::string Path = "configs/scenes/moving_camera.0001.exr"; // 37
	const FTextTable Table{{{Name}, {Text}}, {{Path, "one two three four five six seven eight"}}};
	EXPECT_NE(std::string::npos, Table.Format(64).find(Path)); // 37 + 2 + 25
	const std::string Narrow = Table.Format(40);               // no word of the text is longer than 5
	EXPECT_EQ(std::string::npos, Narrow.find(Path));
	EXPECT_EQ(0u, Narrow.find("configs/")) << Narrow;
	EXPECT_NE(std::string::npos, Narrow.find("0001.exr")) << Narrow;
	EXPECT_GE(40u, GetLongestLine(Narrow));
}

TEST(TextTable, ColumnsAreLeftOutByTheirRankAndNamed)
{
	const std::string Long(20, '7');
	const FTextTable Table{{{Number}, {Number, 1}, {Number, 2}}, {{"first", "second", "third"}, {Long, Long, Long}}};
	EXPECT_EQ(std::string::npos, Table.Format(64).find("no room"));
	const std::string Two = Table.Format(44);
	EXPECT_NE(std::string::npos, Two.find("second")) << Two;
	EXPECT_NE(std::string::npos, Two.find("(no room at this width: third)\n")) << Two;
	const std::string One = Table.Format(40);
	EXPECT_NE(std::string::npos, One.find("(no room at this width: third, second)\n")) << One;
}

TEST(TextTable, AnyWidthFromFortyOnHolds)
{
	const FTextTable Table{{{Name}, {Text}, {Number}, {Text}, {Name, 1}},
		{{"point", "sees", "n", "remark", "file"},
			{"PostRenderBasePassDeferred", "linear HDR, pre-exposed", "12",
				"PreRenderViewFamily_RenderThread(FRHICommandListImmediate&, FSceneViewFamily&): no longer called",
				"a/b/c/d/e/f/g/h/i/j.usf"},
			{"MotionBlur", "display-encoded", "1234567", "", ""}}};
	for (int Width = 40; Width <= 200; ++Width)
	{
		EXPECT_GE(static_cast<size_t>(Width), GetLongestLine(Table.Format(Width))) << Table.Format(Width);
	}
	EXPECT_LT(150u, GetLongestLine(Table.Format()));
}

TEST(TextTable, ColorsTakeNoRoom)
{
	const FTextTable Table{{{Text}}, {{"one two three four five six seven eight nine ten"}}, {"\x1b[1m"}};
	EXPECT_EQ("\x1b[1mone two three four five six seven eight\x1b[0m\n\x1b[1mnine ten\x1b[0m\n", Table.Format(40));
}

TEST(TextTable, CharactersOfSeveralBytesAreOneColumn)
{
	EXPECT_EQ(3u, CountColumns("\xC3\xA4\xE2\x82\xAC\xF0\x9F\x98\x80"));
	EXPECT_EQ(
		"\xC3\xA4\xC3\xA4...\xC3\xA4", ShortenMiddle("\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4\xC3\xA4", 6));
}

TEST(FitLines, AreBrokenAtBlanksAndStandBehindTheirLabel)
{
	EXPECT_EQ("memory   2 MB transient, 3 MB without\n         aliasing and more\nshort\n",
		FitLines("memory   2 MB transient, 3 MB without aliasing and more\nshort\n", 40));
	EXPECT_EQ("   reads one two three four five six\n     seven eight\n",
		FitLines("   reads one two three four five six seven eight\n", 40));
}

TEST(FitLines, NoWidthMeansNoChange)
{
	const std::string Long = std::string(300, 'x') + " y\n";
	EXPECT_EQ(Long, FitLines(Long, 0));
}

TEST(FitLines, KeepsEveryWord)
{
	std::string Prose = "saved    ";
	for (int Word = 0; Word < 200; ++Word)
	{
		Prose += "word" + std::to_string(Word * 37) + " ";
	}
	for (int Width = 40; Width < 140; Width += 7)
	{
		const std::string Fitted = FitLines(Prose, Width);
		EXPECT_GE(static_cast<size_t>(Width), GetLongestLine(Fitted));
		std::istringstream Before(Prose), After(Fitted);
		for (std::string Word, Same; Before >> Word;)
		{
			ASSERT_TRUE(After >> Same);
			ASSERT_EQ(Word, Same);
		}
	}
}

TEST(Terminal, AFileIsNone)
{
	EXPECT_EQ(0, GetTerminalWidth(-1));
}
