// Builds the command line of all registered verbs, and explains arguments that do not fit it.
#include <CLI/CLI.hpp>

#include "Program/CommandLine.h"

#include "Diagnostics.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "Text/Terminal.h"
#include "Text/Version.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <sstream>

namespace Drydock
{

namespace
{

std::vector<CLI::App*> GetVerbsOf(CLI::App& App)
{
	return App.get_subcommands([](const CLI::App*) { return true; });
}

/** "run, check or list" */
std::string JoinNames(const std::vector<std::string>& Names)
{
	std::string Text;
	for (size_t Index = 0; Index < Names.size(); ++Index)
	{
		Text += (Index == 0 ? "" : Index + 1 < Names.size() ? ", " : " or ") + Names[Index];
	}
	return Text;
}

std::string ExplainUnknown(const char* Kind, const std::string& Name, const std::vector<std::string>& Candidates)
{
	const std::string Nearest = FindNearestName(Name, Candidates);
	return std::string("there is no ") + Kind + " " + Name + (Nearest.empty() ? "" : "; did you mean " + Nearest + "?");
}

/** What is wrong with the arguments, in one sentence with the nearest verb or option where that is what was misspelt.
 */
std::string ExplainMistake(CLI::App& Program, const std::vector<std::string>& Arguments, const std::string& Otherwise)
{
	CLI::App* Chosen = &Program;
	for (size_t Level = 0; !GetVerbsOf(*Chosen).empty(); ++Level)
	{
		std::vector<std::string> Names;
		CLI::App* Next = nullptr;
		for (CLI::App* const Verb : GetVerbsOf(*Chosen))
		{
			Names.push_back(Verb->get_name());
			Next = Level < Arguments.size() && Verb->get_name() == Arguments[Level] ? Verb : Next;
		}
		if (Next == nullptr)
		{
			return Level < Arguments.size()
					   ? ExplainUnknown("verb", Arguments[Level], Names)
					   : "a verb is missing after " + Arguments[Level - 1] + ": " + JoinNames(Names);
		}
		Chosen = Next;
	}
	std::vector<std::string> Options;
	for (const CLI::Option* Option : Chosen->get_options())
	{
		Options.push_back(Option->get_name());
	}
	for (const std::string& Argument : Arguments)
	{
		const std::string Name = Argument.substr(0, Argument.find('='));
		if (Name.rfind("--", 0) == 0 && std::find(Options.begin(), Options.end(), Name) == Options.end())
		{
			return ExplainUnknown("option", Name, Options);
		}
	}
	return Otherwise;
}

/** An option's line has its value's type and nothing else: what excludes what is said where it is done. */
class FHelpFormatter : public CLI::Formatter
{
public:
	std::string make_option_opts(const CLI::Option* Option) const override
	{
		const bool bArgument = Option->get_positional(); // whose own name says what it is
		const std::string Type = Option->get_type_size() == 0 ? ""
								 : bArgument                  ? get_label(Option->get_type_name())
															  : Option->get_type_name();
		const bool bMany = bArgument && Option->get_expected_max() > 1;
		return (Type.empty() ? "" : " " + Type) + (bMany ? " ..." : "");
	}
};

/** Translates CLI11's words to ours. */
void SetLabels(CLI::App& Program)
{
	Program.formatter(std::make_shared<FHelpFormatter>());
	Program.get_formatter()->label("SUBCOMMAND", "VERB ...");
	Program.get_formatter()->label("REQUIRED", "");
	Program.get_formatter()->label("TEXT", "");
	Program.get_formatter()->column_width(28);
}

/** Adds the verb where its name says: "settings plan" under "settings", which has a lower place. */
void AddVerb(CLI::App& Program, const FVerb& Verb, int& ExitCode)
{
	CLI::App* Above = &Program;
	std::string Name = Verb.Name;
	for (size_t Space = Name.find(' '); Space != std::string::npos; Space = Name.find(' '))
	{
		Above = Above->get_subcommand(Name.substr(0, Space));
		Name = Name.substr(Space + 1);
	}
	CLI::App* const Added = Above->add_subcommand(Name, Verb.Doc);
	if (const FVerbCall Call = Verb.AddOptions(*Added))
	{
		Added->callback([&ExitCode, Call] { ExitCode = Call(); });
	}
}

/** What help is as wide as: the terminal up to where lines are still read with ease, and 80 where there is none. */
int GetHelpWidth()
{
	constexpr int Otherwise = 80;
	constexpr int Most = 120;
	const int Width = GetOutputWidth();
	return Width == 0 ? Otherwise : std::min(Width, Most);
}

/** All verbs by their groups, a line each. */
std::string MakeOverview()
{
	constexpr size_t NameColumns = 12;
	std::string Text = "drydock VERB ... runs Unreal-style post-process passes on a rendered frame.\n";
	std::vector<FVerb> Verbs = GetVerbs();
	std::stable_sort(Verbs.begin(), Verbs.end(), [](const FVerb& A, const FVerb& B) { return A.Group < B.Group; });
	std::optional<EVerbGroup> Group;
	for (const FVerb& Verb : Verbs)
	{
		const std::string Name = Verb.Name;
		if (Name.find(' ') != std::string::npos)
		{
			continue; // the verb above it names it
		}
		Text += Group == Verb.Group ? "" : std::string("\n") + ToString(Verb.Group) + "\n";
		Group = Verb.Group;
		Text += "  " + Name + std::string(NameColumns - std::min(NameColumns, Name.size()), ' ') + Verb.Doc + "\n";
	}
	return Text + "\n`drydock VERB --help` explains a verb, `man drydock` all of them.\n";
}

/** Whether the verb that was found prints JSON. */
bool WantsJson(const CLI::App& Program)
{
	const CLI::App* Chosen = &Program;
	while (!Chosen->get_subcommands().empty())
	{
		Chosen = Chosen->get_subcommands().front();
	}
	const CLI::Option* const Json = Chosen->get_option_no_throw("--json");
	return Json != nullptr && Json->count() > 0;
}

void PrintMessages(const std::vector<FDiagnostic>& Diagnostics)
{
	FJsonWriter Writer;
	WriteMessages(Writer, Diagnostics);
	std::fputs(Writer.GetText().c_str(), stdout);
	std::fflush(stdout);
}

int ExplainArguments(CLI::App& Program, const std::vector<std::string>& Arguments, const std::string& Otherwise)
{
	const std::string Mistake = ExplainMistake(Program, Arguments, Otherwise);
	std::fprintf(stderr, "drydock: %s\nTry drydock --help.\n", Mistake.c_str());
	if (std::find(Arguments.begin(), Arguments.end(), "--json") != Arguments.end())
	{
		PrintMessages({{.Code = ErrorBadArgument, .Message = Mistake}});
	}
	return ExitUsage;
}

} // namespace

std::shared_ptr<CLI::App> MakeProgram(int& ExitCode)
{
	const auto Program = std::make_shared<CLI::App>(
		"drydock runs Unreal-style post-process passes on a rendered frame, on the CPU.", "drydock");
	Program->set_version_flag("--version", std::string("drydock ") + GetVersion());
	Program->require_subcommand(1);
	SetLabels(*Program);
	Program->footer(
		"Exit codes: 0 done, 1 a policy failed, 2 usage, config or graph error, 3 a file cannot be read or "
		"written, 70 a fault of drydock's own, 71 one of a plugin's. `drydock VERB --help` explains a verb.");
	const std::vector<FVerb> Verbs = GetVerbs();
	for (const FVerb& Verb : Verbs)
	{
		AddVerb(*Program, Verb, ExitCode);
	}
	for (const FVerb& Verb : Verbs) // once all are there: those under a verb would take it over
	{
		const bool bBelow = std::string(Verb.Name).find(' ') != std::string::npos;
		if (!bBelow)
		{
			Program->get_subcommand(Verb.Name)->group(ToString(Verb.Group));
		}
	}
	return Program;
}

int CallProgram(const std::vector<std::string>& Arguments)
{
	if (Arguments.empty())
	{
		std::fprintf(stderr, "drydock: a verb is missing\n\n%s", MakeOverview().c_str());
		return ExitUsage;
	}
	int ExitCode = ExitDone;
	const std::shared_ptr<CLI::App> Program = MakeProgram(ExitCode);
	try
	{
		Program->parse(std::vector<std::string>(Arguments.rbegin(), Arguments.rend())); // CLI11 takes them from the end
	}
	catch (const CLI::Success& Success)
	{
		std::ostringstream Help; // or the version
		ExitCode = Program->exit(Success, Help, Help);
		std::fputs(FitLines(Help.str(), GetHelpWidth()).c_str(), stdout);
	}
	catch (const CLI::ParseError& Error)
	{
		return ExplainArguments(*Program, Arguments, Error.what());
	}
	catch (...)
	{
		if (WantsJson(*Program))
		{
			PrintMessages(ExplainFailure(std::current_exception()).GetDiagnostics());
		}
		throw;
	}
	FlushOutput();
	return ExitCode;
}

} // namespace Drydock
