// Builds the command line of all registered verbs, and explains arguments that do not fit it.
#include "Program/CommandLine.h"

#include "Diagnostics.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "RangeTools.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "Text/Terminal.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace Drydock
{

namespace
{

std::string ExplainUnknown(const char* Kind, const std::string& Name, const std::vector<std::string>& Candidates)
{
	return std::string("there is no ") + Kind + " " + Name + SuggestName(Name, Candidates);
}

/** The mistake in the arguments, in one sentence, with the nearest verb or option for a misspelt one. */
std::string ExplainMistake(
	const FProgramModel& Program, const std::vector<std::string>& Arguments, const std::string& Otherwise)
{
	const FVerbModel* Chosen = FindVerb(Program, "");
	for (size_t Level = 0; !Chosen->Verbs.empty(); ++Level)
	{
		if (Level >= Arguments.size())
		{
			return "a verb is missing after " + Arguments[Level - 1] + ": " + JoinWords(Chosen->Verbs, " or ");
		}
		if (!Contains(Chosen->Verbs, Arguments[Level]))
		{
			return ExplainUnknown("verb", Arguments[Level], Chosen->Verbs);
		}
		Chosen = FindVerb(Program, (Chosen->Name.empty() ? "" : Chosen->Name + " ") + Arguments[Level]);
	}
	for (size_t At = 0; At + 2 < Arguments.size(); ++At)
	{
		const FOptionModel* const Option = FindItem(Chosen->Options, Arguments[At], &FOptionModel::GetName);
		if (Option != nullptr && Option->Type.ends_with("=VALUE") &&
			Arguments[At + 1].find_first_of("=-") == std::string::npos)
		{
			return Arguments[At] + " takes " + Option->Type + " as one word: " + Arguments[At] + " " +
				   Arguments[At + 1] + "=" + Arguments[At + 2];
		}
	}
	auto Options = ToVector<std::string>(Chosen->Options, [&](const FOptionModel& Option) { return Option.GetName(); });
	for (const std::string& Argument : Arguments)
	{
		const std::string Name = Argument.substr(0, Argument.find('='));
		if (Name.starts_with("--") && !Contains(Options, Name))
		{
			return ExplainUnknown("option", Name, Options);
		}
	}
	return Otherwise;
}

/** The width of help: the terminal's, up to a limit that keeps lines readable; 80 without a terminal. */
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
	return Text + "\n`drydock VERB --help` describes a verb, `man drydock` describes all.\n";
}

void PrintMessages(const std::vector<FDiagnostic>& Diagnostics)
{
	FJsonWriter Writer;
	WriteMessages(Writer, Diagnostics);
	PrintText(stdout, Writer.GetText());
	std::fflush(stdout);
}

int TellMistake(const std::vector<std::string>& Arguments, const std::string& Mistake)
{
	PrintText(stderr, "drydock: " + Mistake + "\nTry drydock --help.\n");
	if (Contains(Arguments, "--json"))
	{
		PrintMessages({{.Code = ErrorBadArgument, .Message = Mistake}});
	}
	return ExitUsage;
}

FParsedArguments ParseArguments(FArgumentParser& Parser, const std::vector<std::string>& Arguments)
{
	try
	{
		return Parser.Parse(Arguments);
	}
	catch (...)
	{
		if (Parser.IsGiven("--json"))
		{
			PrintMessages(ExplainFailure(std::current_exception()).GetDiagnostics());
		}
		throw;
	}
}

} // namespace

FArgumentParser MakeProgram()
{
	return FArgumentParser(
		{
			.Name = "drydock",
			.Doc = "drydock runs Unreal-style post-process passes on a rendered frame, on the CPU.",
			.Version = std::string("drydock ") + GetVersion() +
					   (*GetCommit() != '\0' ? std::string(" (commit ") + GetCommit() + ")" : ""),
			.Footer =
				"Exit codes: 0 done, 1 a policy failed, 2 usage, config or graph error, 3 a file cannot be read or "
				"written, 70 a fault in drydock, 71 a fault in a plugin. `drydock VERB --help` describes a verb.",
		},
		GetVerbs());
}

FProgramModel MakeProgramModel()
{
	return MakeProgram().Read();
}

int CallProgram(const std::vector<std::string>& Arguments)
{
	if (Arguments.empty())
	{
		PrintText(stderr, "drydock: a verb is missing\n\n" + MakeOverview());
		return ExitUsage;
	}
	if (const FVerb* const Verb = FindItem(GetVerbs(), Arguments[0], &FVerb::Name);
		Verb != nullptr && Verb->AddOptions == nullptr)
	{
		return TellMistake(Arguments, "this build leaves " + Arguments[0] + " out: `./dev " + Arguments[0] +
										  "`, or cmake -DDRYDOCK_TOOLS=ON, builds it");
	}
	FArgumentParser Program = MakeProgram();
	const FParsedArguments Parsed = ParseArguments(Program, Arguments);
	if (Parsed.Parsed == EParsed::Mistaken)
	{
		return TellMistake(Arguments, ExplainMistake(Program.Read(), Arguments, Parsed.Text));
	}
	PrintText(stdout, FitLines(Parsed.Text, GetHelpWidth()));
	FlushOutput();
	return Parsed.ExitCode;
}

} // namespace Drydock
