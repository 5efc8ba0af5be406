// docs/stability.md is made of the table: run with DRYDOCK_BLESS=1 to write it anew after changing a cell.
#include <gtest/gtest.h>

#include "Inspect/StatedFindings.h"
#include "HazardScene.h"
#include "RangeRows.h"
#include "StabilityPicture.h"
#include "Table.h"
#include "WholeFrame.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace Stability
{

using Drydock::FStatedFinding;
using Drydock::StatedFindings;

namespace
{

constexpr const char* DocFile = DRYDOCK_TEST_SOURCE_DIR "/docs/stability.md";
constexpr const char* PictureFile = DRYDOCK_TEST_SOURCE_DIR "/docs/images/stability.svg";

constexpr const char* Introduction =
	R"(# Stability

![every pass against every hazard](images/stability.svg)

The table shows every pass and every rule of blending (rows) with numbers, sizes and parameters that break other programs
(columns). A green square stands for a result that is finite and as the page states. Picture and page are made of the table in
`tests/stability` (`DRYDOCK_BLESS=1 build/release/bin/test_stability --gtest_filter='StabilityDoc.*'` writes both anew), and
the same program runs every cell; it refuses a table in which a cell is missing. Each pass states its contract in its header
too. `drydock hazards CONFIG --pass P` prints the results of your own pass ([see-inside.md](see-inside.md)).

**In a frame.** `r.Drydock.NonFinite` decides about NaN and infinities in the scene's channels: with 0 they pass on, as in the
engine, and are counted (DD4001), with where they went (DD4003); with 1 they are loaded as 0; with 2 the run fails (DD4002).
`r.Drydock.SceneColorClamp V`, off by default, comes first and loads red, green and blue within -V .. V, infinities too; NaN
it leaves to the policy.

**Denormals.** Shaders of float flush them to 0, on input and on output; stores keep denormal halves. A `double` in such a
shader keeps them, as Direct3D has it; made a float, it is flushed. The control word of the thread is as it was after every
pass.
)";

constexpr const char* AboutScene = R"(
## The hazard scene

`configs/scenes/hazards.exr` holds such pixels side by side ([configs/scenes/README.md](../configs/scenes/README.md)). Every
sample config runs on it in `test_stability`. **The final picture is finite for all of them.** The linear picture before the
tonemapper is not finite where the scene is not (NaN, both infinities, and 65520 and 1e30, which a half stores as infinity),
and nowhere else, but for these:

| config | why |
|---|---|
)";

constexpr const char* AfterScene = R"(
With `r.Drydock.NonFinite=1` and `r.Drydock.SceneColorClamp=1000` the linear picture is finite too, for all of them. Sequences
and studies run as their first frame.
)";

constexpr const char* AboutFrame = R"(
## The whole frame

From scene colour through bloom and tonemapper to the final picture, at default settings, in pictures of 64 x 48 pixels: in
so small a one the bloom's kernels reach everywhere.
)";

constexpr const char* AboutRanges = R"(
## Ranges

Settings that span a range, each pair of ends in `settings/Table/PostProcessSettingsTable.h` among them, where the range is empty,
inverted or far away: in a frame with every effect on the picture is finite, the final one within 0..1, and it has the bits
of the picture that the last column names (`tests/stability/RangeRows.h`).

| range | case | settings | counts as |
|---|---|---|---|
)";

constexpr const char* AboutSweep = R"(
## The sweep

`DRYDOCK_SWEEP=all build/release/bin/test_stability --gtest_filter='Sweep.*'` runs every setting and every console variable,
by the table and the registry, with 0, 1, -1, both ends of its range and of its slider, +-1e9, 1e20, +-1e38, a denormal, NaN
and the infinities (whole numbers: the ends of their type; enums: each of their names), in two frames with every effect on,
of 32 x 18 pixels, and every setting once more without automatic exposure. Each run ends with a finite final picture or with a message and exit code 2, within 20 s and 4 GB. All
tests run one case in 50; `DRYDOCK_SWEEP=TEXT` runs those whose name holds the text. `r.Drydock.ShaderSeconds` is left out: it
ends the process.
)";

constexpr const char* AboutChecks = R"(
## What `--check` finds

`drydock run CONFIG --check nan,overflow,negative,denormal,bounds,uninit` ([see-inside.md](see-inside.md)) finds nothing in any
sample config but this, none of which is a fault; `test_stability --gtest_filter='Shipped/CheckedConfig.*'` runs them all in a
part of their pictures.

| check | shader | why it is none |
|---|---|---|
)";

constexpr const char* GroupTitles[] = {"Values", "Sizes", "Parameters", "Sums and weights"};

using FRows = std::vector<const FRow*>;

const char* GetSymbol(const FCell& Cell)
{
	return Expectations[static_cast<size_t>(Cell.Expect)].Symbol;
}

/** Columns in which some row of these has something to say. */
std::vector<EHazard> GetColumns(const FRows& Rows, EHazardGroup Group)
{
	std::vector<EHazard> Columns;
	for (size_t Index = 0; Index < NumHazards; ++Index)
	{
		const EHazard Hazard = static_cast<EHazard>(Index);
		bool bApplies = false;
		for (const FRow* Row : Rows)
		{
			bApplies = bApplies || Row->Cells[Hazard].Expect != EExpect::DoesNotApply;
		}
		if (Hazards[Index].Group == Group && bApplies)
		{
			Columns.push_back(Hazard);
		}
	}
	return Columns;
}

void WriteTables(std::ostream& Text, const FRows& Rows, const char* Kind)
{
	for (size_t Group = 0; Group < static_cast<size_t>(EHazardGroup::MAX); ++Group)
	{
		const std::vector<EHazard> Columns = GetColumns(Rows, static_cast<EHazardGroup>(Group));
		if (Columns.empty())
		{
			continue;
		}
		Text << "\n### " << GroupTitles[Group] << "\n\n| " << Kind << " |";
		for (const EHazard Hazard : Columns)
		{
			Text << " " << Hazards[static_cast<size_t>(Hazard)].Title << " |";
		}
		Text << "\n|---|";
		for (size_t Column = 0; Column < Columns.size(); ++Column)
		{
			Text << ":-:|";
		}
		Text << "\n";
		for (const FRow* Row : Rows)
		{
			Text << "| " << Row->Name << " |";
			for (const EHazard Hazard : Columns)
			{
				Text << " " << GetSymbol(Row->Cells[Hazard]) << " |";
			}
			Text << "\n";
		}
	}
}

/** Hazards of one reason on one line, in the order of the table; what does not apply comes last. */
void WriteReasons(std::ostream& Text, const FRow& Row)
{
	Text << "\n### " << Row.Name << "\n\n`" << Row.Header << "`\n\n";
	std::vector<std::pair<const FCell*, std::string>> Lines;
	for (size_t Index = 0; Index < NumHazards; ++Index)
	{
		const FCell& Cell = Row.Cells.at(Index);
		std::string* Found = nullptr;
		for (auto& [Other, Titles] : Lines)
		{
			if (Other->Expect == Cell.Expect && Other->Reason == Cell.Reason && Other->Bound == Cell.Bound)
			{
				Found = &Titles;
			}
		}
		if (Found != nullptr)
		{
			*Found += std::string(", ") + Hazards[Index].Title;
		}
		else
		{
			Lines.emplace_back(&Cell, Hazards[Index].Title);
		}
	}
	for (const bool bApplies : {true, false})
	{
		for (const auto& [Cell, Titles] : Lines)
		{
			if ((Cell->Expect != EExpect::DoesNotApply) != bApplies)
			{
				continue;
			}
			Text << "- " << (bApplies ? std::string("**") + GetSymbol(*Cell) + "** " : "") << Titles
				 << (bApplies ? ": " : " " + std::string(GetSymbol(*Cell)) + " ") << Cell->Reason;
			if (Cell->Bound != 0.0)
			{
				Text << " (" << Cell->Bound << ")";
			}
			Text << "\n";
		}
	}
}

/** What WholeFrameTest.cpp measures and computes. */
std::string MakeFloodFigure()
{
	std::ostringstream Text;
	Text << "\n**One infinite pixel turns " << 100 * ShareTurnedWhite << " % of the final picture white**: +Inf at ("
		 << InfinitePixelX << ", " << InfinitePixelY
		 << ") of `toon_character.exr` at default settings, because\nbloom carries it over the whole reach of its "
			"kernels; with `r.Drydock.NonFinite 1` it is one pixel of 0. A run of such a scene names\nthe passes "
			"that spread it and counts the pixels (DD4003). The figure: "
			"`build/release/bin/test_stability --gtest_filter='WholeFrame.*'`.\n";
	return Text.str();
}

std::string MakeDoc()
{
	std::ostringstream Text;
	Text << Introduction << MakeFloodFigure() << "\n## How to read it\n\n| symbol | what holds |\n|:-:|---|\n";
	for (const FExpectation& Expectation : Expectations)
	{
		Text << "| " << Expectation.Symbol << " | " << Expectation.Meaning << " |\n";
	}
	Text << "\nA footprint is what a pixel looks at: one bad pixel changes no pixel that does not look at it. Numbers "
			"in "
			"parentheses\nare bounds: relative errors, slopes, or the value that a pixel counts as.\n\n| hazard | case "
			"|\n|---|---|\n";
	for (const FHazard& Hazard : Hazards)
	{
		Text << "| " << Hazard.Title << " | " << Hazard.Case << " |\n";
	}
	Text << AboutScene;
	for (const FStatedConfig& Stated : StatedConfigs)
	{
		Text << "| " << Stated.Config << ".json | " << Stated.Reason << " |\n";
	}
	Text << AfterScene << AboutRanges;
	for (const FRangeCase& Case : RangeCases)
	{
		Text << "| " << Case.Range << " | " << Case.Kind << " | `" << Case.Given << "` | " << Case.Result << " |\n";
	}
	Text << AboutSweep << AboutChecks;
	for (const FStatedFinding& Stated : StatedFindings)
	{
		Text << "| " << Stated.Check << " | " << Stated.File << " | " << Stated.Reason << " |\n";
	}
	Text << AboutFrame;
	WriteTables(Text, GetRows("pipeline/"), "frame");
	Text << "\n## Passes\n";
	WriteTables(Text, GetRows("passes/"), "pass");
	Text << "\n## Rules of blending\n";
	WriteTables(Text, GetRows("settings/"), "rule");
	for (const auto& [Title, Rows] : {std::pair("the whole frame", GetRows("pipeline/")),
			 std::pair("passes", GetRows("passes/")), std::pair("rules of blending", GetRows("settings/"))})
	{
		Text << "\n## Why: " << Title << "\n";
		for (const FRow* Row : Rows)
		{
			WriteReasons(Text, *Row);
		}
	}
	return Text.str();
}

std::string ReadFile(const char* Path)
{
	std::ifstream File(Path);
	std::ostringstream Text;
	Text << File.rdbuf();
	return Text.str();
}

} // namespace

TEST(StabilityDoc, IsTheTable)
{
	if (std::getenv("DRYDOCK_BLESS") != nullptr)
	{
		std::ofstream(DocFile) << MakeDoc();
	}
	EXPECT_EQ(ReadFile(DocFile), MakeDoc()) << "run with DRYDOCK_BLESS=1 and commit";
}

TEST(StabilityDoc, OpensWithThePictureOfTheTable)
{
	if (std::getenv("DRYDOCK_BLESS") != nullptr)
	{
		std::ofstream(PictureFile) << MakeStabilityPicture();
	}
	EXPECT_EQ(ReadFile(PictureFile), MakeStabilityPicture()) << "run with DRYDOCK_BLESS=1 and commit";
	EXPECT_EQ(0u, MakeDoc().find("# Stability\n\n![every pass against every hazard](images/stability.svg)\n"));
}

TEST(StabilityDoc, SymbolsAreUnique)
{
	std::map<std::string, std::string> Names;
	for (const FExpectation& Expectation : Expectations)
	{
		EXPECT_TRUE(Names.emplace(Expectation.Symbol, Expectation.Name).second)
			<< Expectation.Name << " and " << Names[Expectation.Symbol];
	}
}

} // namespace Stability
