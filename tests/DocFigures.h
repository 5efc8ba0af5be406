// Figures that stand in a page of docs/, for tests that compute them again: found by the words before them or by the
// row and column of a table, and held to the digits they are written with.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace DocFigures
{

/** A number as it is written: 0.086 is known to 0.001. */
struct FFigure
{
	double Value = std::nan("");
	double LastDigit = 0.0;
};

/** The number that a text begins with; NaN where it begins with none. */
inline FFigure ParseFigure(const std::string& Text)
{
	char* End = nullptr;
	FFigure Figure{std::strtod(Text.c_str(), &End), 1.0};
	const std::string Written(Text.c_str(), static_cast<const char*>(End));
	const size_t Exponent = std::min(Written.find('e'), Written.size());
	const size_t Point = Written.find('.');
	Figure.LastDigit = std::pow(10.0, Exponent < Written.size() ? std::atoi(Written.c_str() + Exponent + 1) : 0) *
					   (Point < Exponent ? std::pow(10.0, -static_cast<double>(Exponent - Point - 1)) : 1.0);
	return Written.empty() ? FFigure() : Figure;
}

/** One page; lines joined by single spaces. */
class FPage
{
public:
	/** Name: "tonemapper.md", of docs/ in the source tree. */
	FPage(const std::string& SourceFolder, const std::string& Name)
	{
		std::ifstream File(SourceFolder + "/docs/" + Name);
		EXPECT_TRUE(File.good()) << Name;
		for (std::string Line; std::getline(File, Line);)
		{
			Lines.push_back(Line);
			std::istringstream Words(Line);
			for (std::string Word; Words >> Word;)
			{
				Text += Word + " ";
			}
		}
	}

	/** The number behind the first place with these words. */
	FFigure After(const std::string& Words) const
	{
		const size_t Place = Text.find(Words + " ");
		EXPECT_NE(std::string::npos, Place) << "the page does not say: " << Words;
		const FFigure Figure =
			Place == std::string::npos ? FFigure() : ParseFigure(Text.substr(Place + Words.size() + 1));
		EXPECT_FALSE(std::isnan(Figure.Value)) << "no number follows: " << Words;
		return Figure;
	}

	/** The cells of the table's rows below its rule; the table whose header line begins so. */
	std::vector<std::vector<std::string>> GetTable(const std::string& Header) const
	{
		std::vector<std::vector<std::string>> Rows;
		size_t Index = 0;
		while (Index < Lines.size() && !Lines[Index].starts_with(Header))
		{
			++Index;
		}
		EXPECT_LT(Index, Lines.size()) << "the page has no table with the header: " << Header;
		for (Index += 2; Index < Lines.size() && Lines[Index].starts_with("|"); ++Index)
		{
			Rows.emplace_back();
			std::istringstream Row(Lines[Index].substr(1));
			for (std::string Cell; std::getline(Row, Cell, '|');)
			{
				const size_t First = Cell.find_first_not_of(' ');
				const size_t Last = Cell.find_last_not_of(' ');
				Rows.back().push_back(First == std::string::npos ? "" : Cell.substr(First, Last - First + 1));
			}
		}
		return Rows;
	}

private:
	std::vector<std::string> Lines;
	std::string Text;
};

/** Computed, rounded as the page rounds, is what the page says. */
inline void ExpectWritten(const FFigure& Figure, double Computed, const std::string& What)
{
	EXPECT_NEAR(Figure.Value, Computed, 0.5000001 * Figure.LastDigit) << What;
}

} // namespace DocFigures
