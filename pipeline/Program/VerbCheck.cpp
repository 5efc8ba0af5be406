// `drydock check`: reads and validates a config and its scene's header, compiles its frame and shaders, draws nothing.
#include "PrintText.h"
#include "Program/JUnitOption.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Run/RunJson.h"
#include "Text/JsonWriter.h"

#include <cstdio>
#include <memory>

namespace Drydock
{

namespace
{

struct FCheckOptions
{
	FRunOptions Run;
	std::string JUnit; // file to write; empty: none
	bool bJson = false;
};

/** A case for each family of messages, which are told apart by the thousands of their numbers. */
std::vector<FJUnitCase> MakeCheckCases(const std::vector<FDiagnostic>& Diagnostics)
{
	static const std::vector<std::pair<int, const char*>> Families = {
		{1, "config"}, {2, "graph and extensions"}, {3, "settings"}, {4, "numbers"}, {5, "files"}, {6, "shaders"}};
	std::vector<FJUnitCase> Cases;
	for (const auto& [Family, Name] : Families)
	{
		FJUnitCase Case{Name};
		for (const FDiagnostic& Diagnostic : Diagnostics)
		{
			if (Diagnostic.Code / 1000 == Family)
			{
				const bool bError = Diagnostic.Severity == ESeverity::Error;
				std::string& Text = bError ? Case.Message : Case.Output;
				Text += (Text.empty() ? "" : "\n") + Diagnostic.ToString();
				Case.Outcome = bError ? EJUnitOutcome::Failed : Case.Outcome;
			}
		}
		Cases.push_back(std::move(Case));
	}
	return Cases;
}

int Check(const FCheckOptions& Options, FJUnitSuite& Suite)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FEffectDecision> Effects;
	std::string Looked; // of plugins' shaders; empty: there are none
	int ExitCode = ExitDone;
	try
	{
		const FCheckResult Result = CheckRun(Options.Run);
		Diagnostics = Result.Diagnostics;
		Effects = Result.Effects;
		Looked = Result.Shaders.NumClasses > 0 ? "; looked at " + Result.Shaders.Describe() : "";
	}
	catch (const FError& Error)
	{
		Diagnostics = Error.GetDiagnostics();
		ExitCode = Error.GetExitCode();
	}
	Suite.Cases = MakeCheckCases(Diagnostics);
	if (Options.bJson)
	{
		FJsonWriter Writer;
		WriteMessages(Writer, Diagnostics);
		PrintText(stdout, Writer.GetText());
		return ExitCode;
	}
	PrintDiagnostics(Diagnostics);
	PrintClosingLines(Effects);
	if (ExitCode == ExitDone)
	{
		PrintText(stdout, Options.Run.ConfigFile + ": no errors" + Looked + "\n");
	}
	return ExitCode;
}

} // namespace

FVerbCall AddCheckOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FCheckOptions>();
	AddConfig(Verb, Options->Run);
	AddJUnit(Verb, Options->JUnit, "a case for each family of messages");
	Verb.AddFlag("--json", Options->bJson, "Print the messages as JSON");
	return [Options]
	{
		return CallWithJUnit(
			Options->JUnit, Options->Run.ConfigFile, [&Options](FJUnitSuite& Suite) { return Check(*Options, Suite); });
	};
}

} // namespace Drydock
