// Reads the stability table (Table.h).
#include "Table.h"

#include <cctype>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace Stability
{

namespace
{

std::vector<std::string> Split(const std::string& Text)
{
	std::istringstream Stream(Text);
	std::vector<std::string> Words;
	for (std::string Word; Stream >> Word;)
	{
		Words.push_back(Word);
	}
	return Words;
}

/** The index of the entry of this name; the number of entries where there is none. */
template<typename TEntries>
size_t FindByName(const TEntries& Entries, const std::string& Name)
{
	size_t Index = 0;
	while (Index < std::size(Entries) && std::data(Entries)[Index].Name != Name)
	{
		++Index;
	}
	return Index;
}

/** The cells of Above replace those of Below. */
void Overlay(FCells& Below, const FCells& Above)
{
	for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
	{
		if (Above.at(Hazard).Expect != EExpect::MAX)
		{
			Below.at(Hazard) = Above.at(Hazard);
		}
	}
}

class FTableReader
{
public:
	std::vector<FRow> Rows;

	void Read(const FTableText& Text)
	{
		std::vector<std::pair<int, std::string>> Lines;
		std::istringstream Stream(Text.Text);
		int Number = 0;
		for (std::string Line; std::getline(Stream, Line);)
		{
			++Number;
			if (Line.starts_with("\t\t") && !Lines.empty())
			{
				Lines.back().second += " " + Line.substr(2);
			}
			else if (!Line.empty() && Line[0] != '#')
			{
				Lines.emplace_back(Number, Line);
			}
		}
		for (const auto& [At, Line] : Lines)
		{
			if (Line[0] != '\t')
			{
				FinishRow();
			}
			Place = Text.File + ":" + std::to_string(At);
			ReadLine(Line);
		}
		FinishRow();
	}

private:
	void Require(bool bHolds, const std::string& Mistake) const
	{
		if (!bHolds)
		{
			throw std::runtime_error(Place + ": " + Mistake);
		}
	}

	void ReadLine(const std::string& Line)
	{
		if (Line[0] == '\t')
		{
			Require(bInRow, "there is no row above");
			GiveCells(Own, Line.substr(1));
			return;
		}
		if (Line[0] == '[')
		{
			ReadHeader(Line);
			return;
		}
		const size_t Equals = Line.find(" = ");
		Require(Equals != std::string::npos, "expected [Row] Header.h, or Name = cells, or a tab and cells");
		FCells& Cells = Named[Line.substr(0, Equals)];
		const std::string Right = Line.substr(Equals + 3);
		Right.find(": ") == std::string::npos ? GiveNames(Cells, Right) : GiveCells(Cells, Right);
	}

	/** [Row] path/of/its/Header.h Word Word: [Other row] Name Name */
	void ReadHeader(const std::string& Line)
	{
		const size_t End = std::min(Line.find(']'), Line.size() - 1);
		const size_t Colon = Line.find(": ", End);
		const std::vector<std::string> Words = Split(Line.substr(End + 1, Colon - End - 1));
		Require(!Words.empty(), "expected a header after [Row]");
		FRow Row{.Name = Line.substr(1, End - 1),
			.Header = Words[0],
			.Words = {Words.begin() + 1, Words.end()},
			.Place = Place};
		std::string Names = Colon == std::string::npos ? "" : Line.substr(Colon + 2);
		if (Names.starts_with("["))
		{
			const size_t EndOfOther = Names.find(']');
			const std::string Other = Names.substr(1, EndOfOther - 1);
			const size_t Found = FindByName(Rows, Other);
			Require(Found < Rows.size(), "there is no row " + Other);
			Row.Cells = Rows[Found].Cells;
			Names = Names.substr(EndOfOther + 1);
		}
		FCells OfNames;
		GiveNames(OfNames, Names);
		Overlay(Row.Cells, OfNames);
		Rows.push_back(Row);
		bInRow = true;
	}

	void FinishRow()
	{
		if (bInRow)
		{
			Overlay(Rows.back().Cells, Own);
			Own = {};
			Place = Rows.back().Place;
			for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
			{
				Require(Rows.back().Cells.at(Hazard).Expect != EExpect::MAX,
					Rows.back().Name + " has no cell for " + Hazards[Hazard].Name);
			}
		}
		bInRow = false;
	}

	void Give(FCells& Cells, size_t Hazard, const FCell& Cell) const
	{
		FCell& Given = Cells.at(Hazard);
		Require(Given.Expect == EExpect::MAX,
			std::string(Hazards[Hazard].Name) + " is given twice, first at " + Given.Place);
		Given = Cell;
	}

	void GiveNames(FCells& Cells, const std::string& Names) const
	{
		for (const std::string& Name : Split(Names))
		{
			const auto Found = Named.find(Name);
			Require(Found != Named.end(), "there are no cells of the name " + Name);
			for (size_t Hazard = 0; Hazard < NumHazards; ++Hazard)
			{
				if (Found->second.at(Hazard).Expect != EExpect::MAX)
				{
					Give(Cells, Hazard, Found->second.at(Hazard));
				}
			}
		}
	}

	void GiveCells(FCells& Cells, const std::string& Line) const
	{
		const size_t Colon = Line.find(": ", 1);
		FCell Cell{.Reason = Colon == std::string::npos ? "" : Line.substr(Colon + 2), .Place = Place};
		Require(
			Cell.Reason.size() >= 6 && Cell.Reason.back() != '.', "expected a colon and a reason without a full stop");
		std::stringstream Groups(Line.substr(0, Colon));
		for (std::string Group; std::getline(Groups >> std::ws, Group, ',');)
		{
			std::vector<std::string> Words = Split(Group);
			const bool bBound = !Words.empty() && std::isdigit(static_cast<unsigned char>(Words.back()[0])) != 0;
			Cell.Bound = bBound ? std::stod(Words.back()) : 0.0;
			Words.resize(Words.size() - (bBound ? 1 : 0));
			Require(Words.size() >= 2, "expected hazards, an expectation and perhaps a bound: " + Group);
			const size_t Expect = FindByName(Expectations, Words.back());
			Require(Expect < std::size(Expectations), "there is no expectation " + Words.back());
			Cell.Expect = static_cast<EExpect>(Expect);
			Words.pop_back();
			for (const std::string& Word : Words)
			{
				const size_t Dots = Word.find("..");
				const size_t First = FindHazard(Word.substr(0, Dots));
				const size_t Last = Dots == std::string::npos ? First : FindHazard(Word.substr(Dots + 2));
				for (size_t Hazard = First; Hazard <= Last; ++Hazard)
				{
					Give(Cells, Hazard, Cell);
				}
			}
		}
	}

	size_t FindHazard(const std::string& Name) const
	{
		const size_t Found = FindByName(Hazards, Name);
		Require(Found < NumHazards, "there is no hazard " + Name);
		return Found;
	}

	std::map<std::string, FCells> Named;
	std::string Place;
	bool bInRow = false;
	FCells Own; // cells of the row's own lines
};

} // namespace

std::vector<FRow> ReadTable(const std::vector<FTableText>& Texts)
{
	FTableReader Reader;
	for (const FTableText& Text : Texts)
	{
		Reader.Read(Text);
	}
	return Reader.Rows;
}

std::vector<const FRow*> GetRows(std::string_view Folder)
{
	static const std::vector<FRow> Table = []
	{
		std::vector<FTableText> Texts;
		for (const char* Name : {"NamedCells.txt", "PassRows.txt", "BlendRows.txt"})
		{
			std::ostringstream Text;
			Text << std::ifstream(std::string(DRYDOCK_TEST_SOURCE_DIR "/tests/stability/") + Name).rdbuf();
			Texts.push_back({Name, Text.str()});
		}
		return ReadTable(Texts);
	}();
	std::vector<const FRow*> Rows;
	for (const FRow& Row : Table)
	{
		if (Row.Header.starts_with(Folder))
		{
			Rows.push_back(&Row);
		}
	}
	return Rows;
}

} // namespace Stability
