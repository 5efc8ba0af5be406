// Builds the command line of all registered verbs, and explains arguments that do not fit it.
#include <CLI/CLI.hpp>

#include "Program/CommandLine.h"

#include "Diagnostics.h"
#include "Program/ProgramOutput.h"
#include "Program/Verbs.h"
#include "Text/Version.h"

#include <algorithm>
#include <cstdio>
#include <iostream>

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
			return Level < Arguments.size() ? ExplainUnknown("verb", Arguments[Level], Names)
				   : Level == 0             ? "a verb is missing: " + JoinNames(Names)
											: "a verb is missing after " + Arguments[Level - 1];
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

/** Translates CLI11's words to ours. */
void SetLabels(CLI::App& Program)
{
	Program.get_formatter()->label("SUBCOMMAND", "VERB ...");
	Program.get_formatter()->label("REQUIRED", "");
	Program.get_formatter()->label("TEXT", "");
	Program.get_formatter()->column_width(34);
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

} // namespace

int CallProgram(const std::vector<std::string>& Arguments)
{
	CLI::App Program("drydock runs Unreal-style post-process passes on a rendered frame, on the CPU.", "drydock");
	Program.set_version_flag("--version", std::string("drydock ") + GetVersion());
	Program.require_subcommand(1);
	SetLabels(Program);
	Program.footer(
		"Exit codes: 0 done, 1 a policy failed, 2 usage, config or graph error, 3 a file cannot be read or written,\n"
		"70 a fault of drydock's own, 71 one of a plugin's. `drydock VERB --help` explains a verb.");
	int ExitCode = ExitDone;
	for (const FVerb& Verb : GetVerbs())
	{
		AddVerb(Program, Verb, ExitCode);
	}
	for (CLI::App* const Verb : GetVerbsOf(Program))
	{
		Verb->group("Verbs"); // once all are there: those under a verb would take it over
	}
	try
	{
		Program.parse(std::vector<std::string>(Arguments.rbegin(), Arguments.rend())); // CLI11 takes them from the end
	}
	catch (const CLI::Success& Success)
	{
		ExitCode = Program.exit(Success, std::cout, std::cerr); // --help and --version
	}
	catch (const CLI::ParseError& Error)
	{
		const std::string Mistake = ExplainMistake(Program, Arguments, Error.what());
		std::fprintf(stderr, "drydock: %s\nTry drydock --help.\n", Mistake.c_str());
		return ExitUsage;
	}
	FlushOutput();
	return ExitCode;
}

} // namespace Drydock
