// What verbs print fits the terminal, and is as wide as it wants where there is none.
#include "../TerminalTestUtils.h"

#include "Program/CommandLine.h"
#include "Program/ProgramModel.h"
#include "Text/Terminal.h"

#include <algorithm>

using namespace ProgramTest;
using namespace Drydock;

namespace
{

const std::string Configs = DRYDOCK_TEST_SOURCE_DIR "/configs/";

/** Verbs that print tables or reports, on a small frame. */
const std::vector<std::string> Tables = {"run a.json", "run a.json --cost", "explain a.json",
	"explain a.json --effect Bloom", "explain a.json --pass Tonemap", "check a.json", "graph a.json",
	"probe a.json 3,3", "blend a.json", "blend a.json --setting 'Bloom*'", "diff out/a out/a", "diff out/a out/b",
	"hazards a.json --pass BloomSetup", "study study.json", "list passes", "list passes --config a.json",
	"list shaders", "list settings", "list cvars", "list effects", "list extensions", "list hooks", "list hooks a.json",
	"prove a.json --only 'Four*'", "import scene.exr --out new.exr --dry-run",
	"blend '" + Configs + "volumes_walk.json' --path scene --out walk", "explain '" + Configs + "frame_full.json'",
	"list hooks '" + Configs + "hooks_all.json'", "check no_such_file_in_a_folder_with_a_long_name/config.json"};

class TerminalProgram : public testing::Test
{
protected:
	TerminalProgram()
	{
		Folder.WriteFrame("a.json", More);
		Folder.WriteFrame("b.json", More);
		Folder.WriteFrame("study.json",
			R"(, "study": {"axes": [{"name": "BloomIntensity", "values": [0.5, 1, 1.5]}, {"name": "r.BloomQuality", "values":
			[4, 5]}], "repetitions": 1})");
		Folder.Call("run a.json --dump '*'");
		Folder.Call("run b.json");
	}

	const std::string More = R"(, "camera": {"Settings": {"BloomIntensity": 1, "BloomThreshold": 0.5}})";
	const FProgramFolder Folder{"terminal"};
};

/** The first of a text's lines that is wider than Columns; empty: none. */
std::string FindWiderLine(const std::string& Printed, int Columns)
{
	for (const std::string& Line : GetScreenLines(Printed))
	{
		if (CountColumns(Line) > static_cast<size_t>(Columns))
		{
			return Line;
		}
	}
	return "";
}

} // namespace

TEST_F(TerminalProgram, NoLineIsWiderThanIt)
{
	for (const int Columns : {80, 100, 200})
	{
		for (const std::string& Arguments : Tables)
		{
			const FOutcome Outcome = CallAtTerminal(Folder, Columns, Arguments);
			EXPECT_GE(3, Outcome.ExitCode) << Arguments << "\n" << Outcome.Printed;
			EXPECT_LT(1u, GetScreenLines(Outcome.Printed).size()) << Arguments;
			EXPECT_EQ("", FindWiderLine(Outcome.Printed, Columns)) << Columns << " columns: " << Arguments;
		}
	}
}

TEST_F(TerminalProgram, TablesUseTheRoomThatThereIs)
{
	const auto GetWidest = [this](int Columns)
	{
		size_t Widest = 0;
		for (const std::string& Line : GetScreenLines(CallAtTerminal(Folder, Columns, "explain a.json").Printed))
		{
			Widest = std::max(Widest, CountColumns(Line));
		}
		return Widest;
	};
	EXPECT_LT(70u, GetWidest(80));
	EXPECT_LT(80u, GetWidest(100));
	EXPECT_LT(100u, GetWidest(200));
}

TEST_F(TerminalProgram, AFileGetsWholeLines)
{
	const std::string Printed = Folder.Call("explain a.json").Printed;
	EXPECT_NE("", FindWiderLine(Printed, 100));
	EXPECT_NE(std::string::npos, Printed.find("GlowIntensity 0: neutral, and nothing in the config sets it\n"))
		<< Printed;
	setenv("COLUMNS", "80", 1);
	EXPECT_EQ(Printed, Folder.Call("explain a.json").Printed);
	unsetenv("COLUMNS");
}

TEST_F(TerminalProgram, ColumnsOfTheEnvironmentWin)
{
	EXPECT_NE("", FindWiderLine(CallAtTerminal(Folder, 200, "list hooks").Printed, 60));
	const FOutcome Narrow = CallAtTerminal(Folder, 200, "list hooks", "COLUMNS=60");
	EXPECT_EQ("", FindWiderLine(Narrow.Printed, 60)) << Narrow.Printed;
}

TEST_F(TerminalProgram, JsonIsTheSameEverywhere)
{
	std::string Printed = CallAtTerminal(Folder, 80, "list hooks --json").Printed;
	Printed.erase(std::remove(Printed.begin(), Printed.end(), '\r'), Printed.end());
	EXPECT_EQ(Folder.Call("list hooks --json").Printed, Printed);
}

TEST_F(TerminalProgram, HelpOfEveryVerbFitsEightyColumns)
{
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		const FOutcome Outcome = CallAtTerminal(Folder, 80, Verb.Name + " --help");
		EXPECT_EQ(0, Outcome.ExitCode) << Verb.Name;
		EXPECT_EQ("", FindWiderLine(Outcome.Printed, 80)) << Verb.Name;
		EXPECT_EQ("", FindWiderLine(Folder.Call(Verb.Name + " --help").Printed, 80)) << Verb.Name;
	}
}

TEST_F(TerminalProgram, TheBareProgramNamesAllVerbsOnALineEach)
{
	const FOutcome Outcome = CallAtTerminal(Folder, 80, "");
	EXPECT_EQ(2, Outcome.ExitCode);
	EXPECT_EQ("", FindWiderLine(Outcome.Printed, 80));
	const std::vector<std::string> Lines = GetScreenLines(Outcome.Printed);
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		if (!Verb.Name.empty() && Verb.Name.find(' ') == std::string::npos)
		{
			const auto Names = [&Verb](const std::string& Line)
			{
				return Line.starts_with("  " + Verb.Name + " ") && Line.find(Verb.Doc) == Line.size() - Verb.Doc.size();
			};
			EXPECT_EQ(1, std::count_if(Lines.begin(), Lines.end(), Names)) << Verb.Name << "\n" << Outcome.Printed;
		}
	}
}
