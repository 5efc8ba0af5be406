// Reads the stability table (Table.h).
#include "Table.h"

#include <fstream>
#include <map>
#include <regex>
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
		static const std::regex Header("\\[(.+?)\\] (\\S+?)( [^:]+)?(: (\\[(.+)\\] ?)?(.*))?");
		static const std::regex NameAndCells("(\\w+) = (.+)");
		std::smatch Parts;
		if (std::regex_match(Line, Parts, Header))
		{
			FRow Row{.Name = Parts[1], .Header = Parts[2], .Words = Split(Parts[3]), .Place = Place};
			if (Parts[6].matched)
			{
				const size_t Other = FindByName(Rows, Parts[6]);
				Require(Other < Rows.size(), "there is no row " + Parts[6].str());
				Row.Cells = Rows[Other].Cells;
			}
			FCells OfNames;
			GiveNames(OfNames, Parts[7]);
			Overlay(Row.Cells, OfNames);
			Rows.push_back(Row);
			bInRow = true;
			return;
		}
		Require(std::regex_match(Line, Parts, NameAndCells),
			"expected [Row] Header.h, or Name = cells, or a tab and cells");
		FCells& Cells = Named[Parts[1]];
		Line.find(": ") == std::string::npos ? GiveNames(Cells, Parts[2]) : GiveCells(Cells, Parts[2]);
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
			static const std::regex HazardsAndExpectation("(.+) ([A-Za-z]+)( [0-9][-.e0-9]*)?");
			std::smatch Parts;
			Require(std::regex_match(Group, Parts, HazardsAndExpectation),
				"expected hazards, an expectation and perhaps a bound: " + Group);
			const size_t Expect = FindByName(Expectations, Parts[2]);
			Require(Expect < std::size(Expectations), "there is no expectation " + Parts[2].str());
			Cell.Expect = static_cast<EExpect>(Expect);
			Cell.Bound = Parts[3].matched ? std::stod(Parts[3]) : 0.0;
			for (const std::string& Word : Split(Parts[1]))
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
