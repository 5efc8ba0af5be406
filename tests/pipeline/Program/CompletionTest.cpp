// Completion in bash and zsh, and the manual page: they say what the parser knows, and a shell that loads them
// completes.
#include "../ProgramTestUtils.h"

#include "Program/CompletionScript.h"
#include "Program/ManPage.h"
#include "Program/CommandLine.h"
#include "Program/ProgramModel.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

using namespace ProgramTest;
using namespace Drydock;
using testing::ElementsAre;

namespace
{

bool IsInstalled(const std::string& Program)
{
	return std::system(("command -v " + Program + " > /dev/null 2>&1").c_str()) == 0;
}

class Completion : public testing::Test
{
protected:
	Completion()
	{
		Folder.Write("drydock.bash", MakeBashCompletion(MakeProgramModel()));
		Folder.WriteFrame("frame.json", "");
		Folder.Write("notes.txt", "");
		Files::create_directories(Folder.Path / "out");
	}

	/** What bash offers for the last of the words, which it split as its own reader does. */
	std::vector<std::string> Complete(const std::vector<std::string>& Words) const
	{
		std::string Script = "cd '" + Folder.Path.string() +
							 "'\nsource drydock.bash\nCOMP_WORDS=('" DRYDOCK_TEST_BINARY_DIR "/bin/drydock'";
		for (const std::string& Word : Words)
		{
			Script += " '" + Word + "'";
		}
		Script += ")\nCOMP_CWORD=" + std::to_string(Words.size()) + "\n_drydock\nprintf '%s\\n' \"${COMPREPLY[@]}\"\n";
		Folder.Write("ask.bash", Script);
		FILE* const Pipe = popen(("bash '" + (Folder.Path / "ask.bash").string() + "' 2>&1").c_str(), "r");
		std::string Printed;
		std::array<char, 4096> Buffer;
		for (size_t NumRead; (NumRead = fread(Buffer.data(), 1, Buffer.size(), Pipe)) > 0;)
		{
			Printed.append(Buffer.data(), NumRead);
		}
		EXPECT_EQ(0, pclose(Pipe)) << Printed;
		std::vector<std::string> Offered;
		std::istringstream Lines(Printed);
		for (std::string Line; std::getline(Lines, Line);)
		{
			if (!Line.empty())
			{
				Offered.push_back(Line);
			}
		}
		std::sort(Offered.begin(), Offered.end());
		return Offered;
	}

	/** The same without order and twice the same. */
	std::set<std::string> CompleteSet(const std::vector<std::string>& Words) const
	{
		const std::vector<std::string> Offered = Complete(Words);
		return {Offered.begin(), Offered.end()};
	}

	const FProgramFolder Folder{"completion"};
};

} // namespace

TEST_F(Completion, VerbsAndThoseUnderAVerb)
{
	const FProgramModel Model = MakeProgramModel();
	EXPECT_EQ(CompleteSet({""}), std::set<std::string>(Model[0].Verbs.begin(), Model[0].Verbs.end()));
	EXPECT_THAT(Complete({"ex"}), ElementsAre("explain"));
	EXPECT_THAT(Complete({"settings", ""}), ElementsAre("cube", "export", "import", "plan"));
	EXPECT_THAT(Complete({"settings", "plan", "--def"}), ElementsAre("--default"));
}

TEST_F(Completion, EveryOptionOfEveryVerb)
{
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		std::set<std::string> Names;
		for (const FOptionModel& Option : Verb.Options)
		{
			if (!Option.bPositional)
			{
				Names.insert(Option.GetName());
			}
		}
		std::vector<std::string> Words;
		std::istringstream Parts(Verb.Name);
		for (std::string Word; Parts >> Word;)
		{
			Words.push_back(Word);
		}
		Words.push_back("--");
		EXPECT_EQ(CompleteSet(Words), Names) << Verb.Name;
	}
}

TEST_F(Completion, WordsOfAnOption)
{
	EXPECT_THAT(Complete({"run", "--precision", ""}), ElementsAre("double", "float"));
	EXPECT_THAT(Complete({"run", "--precision", "=", "d"}), ElementsAre("double"));
	EXPECT_THAT(Complete({"run", "--report", "=", ""}), ElementsAre("full", "off", "on"));
	EXPECT_THAT(Complete({"run", "--outputs", "png,j"}), ElementsAre("png,json"));
	EXPECT_THAT(Complete({"run", "--engine", "5.4"}), ElementsAre("5.4"));
	EXPECT_THAT(Complete({"list", "ho"}), ElementsAre("hooks"));
	EXPECT_THAT(Complete({"completion", ""}), ElementsAre("bash", "zsh"));
}

TEST_F(Completion, AWordThatMayStayAwayHidesNoOption)
{
	EXPECT_THAT(Complete({"run", "--report", "--prec"}), ElementsAre("--precision"));
}

TEST_F(Completion, ConfigsFoldersAndFiles)
{
	EXPECT_THAT(Complete({"run", ""}), ElementsAre("frame.json", "out"));
	EXPECT_THAT(Complete({"run", "--out", ""}), ElementsAre("out"));
	EXPECT_THAT(Complete({"diff", "no"}), ElementsAre("notes.txt"));
}

TEST_F(Completion, NamesThatTheProgramKnows)
{
	EXPECT_THAT(Complete({"run", "--set", "r.BloomQ"}), ElementsAre("r.BloomQuality="));
	EXPECT_THAT(Complete({"run", "--pp", "BloomInt"}), ElementsAre("BloomIntensity="));
	EXPECT_THAT(Complete({"explain", "frame.json", "--setting", "BloomThr"}), ElementsAre("BloomThreshold"));
	EXPECT_THAT(Complete({"explain", "frame.json", "--effect", "Toon"}), ElementsAre("ToonBloom", "ToonShadowBlur"));
	EXPECT_THAT(Complete({"run", "--set", "r.BloomQuality", "=", "4"}), ElementsAre());
}

TEST_F(Completion, PassesOfTheConfigOnTheLine)
{
	EXPECT_THAT(Complete({"explain", "frame.json", "--pass", "Tone"}), ElementsAre("Tonemap"));
	EXPECT_THAT(Complete({"run", "frame.json", "--dump", "Tone"}), ElementsAre("Tonemap"));
	EXPECT_THAT(Complete({"explain", "--pass", "Tone"}), ElementsAre());
}

TEST_F(Completion, ZshLoadsItsScript)
{
	const std::string Script = MakeZshCompletion(MakeProgramModel());
	EXPECT_EQ(0u, Script.find("#compdef drydock\n"));
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		const size_t Case = Script.find("\t'" + Verb.Name + "')\n");
		ASSERT_NE(std::string::npos, Case) << Verb.Name;
		const std::string Body = Script.substr(Case, Script.find(" ;;\n", Case) - Case);
		for (const FOptionModel& Option : Verb.Options)
		{
			const std::string Wanted = Option.bPositional ? ":" + Option.GetName() + ":" : Option.GetName() + "[";
			EXPECT_NE(std::string::npos, Body.find(Wanted)) << Verb.Name << " " << Option.GetName();
		}
	}
	if (!IsInstalled("zsh"))
	{
		GTEST_SKIP() << "zsh is not installed";
	}
	Folder.Write("_drydock", Script);
	const std::string Path = (Folder.Path / "_drydock").string();
	EXPECT_EQ(0, std::system(("zsh -n '" + Path + "'").c_str()));
	// What _arguments is called with, for each verb: it stands in for zsh's own, which needs a line editor.
	Folder.Write(
		"ask.zsh", "cd '" + Folder.Path.string() +
					   "'\n_arguments() { print -rl -- \"$@\" }\n_describe() { print -rl "
					   "-- ${(P)2} }\nwords=(drydock run --pre); CURRENT=3; PREFIX=--pre\nsource ./_drydock\n");
	Folder.Write("asked", "");
	EXPECT_EQ(0,
		std::system(("zsh -f '" + (Folder.Path / "ask.zsh").string() + "' > '" + (Folder.Path / "asked").string() + "'")
						.c_str()));
	EXPECT_NE(std::string::npos, Folder.Read("asked").find("--precision[")) << Folder.Read("asked");
}

TEST_F(Completion, TheProgramPrintsTheScripts)
{
	EXPECT_EQ(MakeBashCompletion(MakeProgramModel()), Folder.Call("completion bash").Printed);
	EXPECT_EQ(MakeZshCompletion(MakeProgramModel()), Folder.Call("completion zsh").Printed);
	EXPECT_EQ(MakeManPage(MakeProgramModel()), Folder.Call("man").Printed);
}

TEST_F(Completion, ListsOfNamesHaveOneToALine)
{
	EXPECT_EQ("r.BloomQuality\n", Folder.Call("list cvars r.BloomQuality --names").Printed);
	for (const char* const Things : {"passes", "shaders", "settings", "cvars", "effects", "extensions", "hooks"})
	{
		const std::string Printed = Folder.Call(std::string("list ") + Things + " --names").Printed;
		EXPECT_EQ(std::string::npos, Printed.find(' ')) << Things;
		EXPECT_LT(3, std::count(Printed.begin(), Printed.end(), '\n')) << Things;
	}
}

TEST_F(Completion, TheManualPageHasEveryOption)
{
	const std::string Page = MakeManPage(MakeProgramModel());
	const auto Escape = [](std::string Text)
	{
		for (size_t At = 0; (At = Text.find('-', At)) != std::string::npos; At += 2)
		{
			Text.insert(At, "\\");
		}
		return Text;
	};
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		const size_t Begin = Verb.Name.empty() ? 0 : Page.find(".SS " + Escape(Verb.Name) + "\n");
		ASSERT_NE(std::string::npos, Begin) << Verb.Name;
		const size_t First = Verb.Name.empty() ? Page.find(".SH DESCRIPTION") : Begin;
		const std::string Section = Page.substr(First, Page.find("\n.S", First) - First);
		for (const FOptionModel& Option : Verb.Options)
		{
			for (const std::string& Name : Option.Names)
			{
				const std::string Font = Option.bPositional ? "\\fI" : "\\fB";
				EXPECT_NE(std::string::npos, Section.find(Font + Escape(Name) + "\\fR")) << Verb.Name << " " << Name;
			}
		}
	}
}

TEST_F(Completion, TheManualPageIsFaultless)
{
	Folder.Write("drydock.1", MakeManPage(MakeProgramModel()));
	const std::string Path = (Folder.Path / "drydock.1").string();
	const std::string Faults = (Folder.Path / "faults").string();
	bool bAsked = false;
	if (IsInstalled("mandoc"))
	{
		bAsked = true;
		// A page that is made of a program has no date of its own.
		const std::string Lint = "mandoc -T lint -W warning '" + Path + "' 2>&1 | grep -v 'missing date'";
		EXPECT_NE(0, std::system((Lint + " > '" + Faults + "'").c_str())); // of grep: nothing else
		EXPECT_EQ("", Folder.Read("faults"));
	}
	if (IsInstalled("groff"))
	{
		bAsked = true;
		EXPECT_EQ(0, std::system(("groff -man -ww -b -T ascii -z '" + Path + "' > '" + Faults + "' 2>&1").c_str()));
		EXPECT_EQ("", Folder.Read("faults"));
	}
	if (!bAsked)
	{
		GTEST_SKIP() << "neither mandoc nor groff is installed";
	}
}
