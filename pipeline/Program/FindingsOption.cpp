// Writes the findings of a verb, also where the verb fails.
#include "Program/FindingsOption.h"

#include "DiagnosticList.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Writes the files. Adds the case of --fail-on warning where there are warnings; true: there are. */
bool Finish(const FFindingsOptions& Options, const std::string& Verb, const std::string& About, FJUnitSuite& Suite,
	const std::vector<FDiagnostic>& Printed)
{
	std::string Warnings;
	for (const FDiagnostic& Diagnostic : Printed)
	{
		Suite.Findings.push_back({Diagnostic});
	}
	for (const FJUnitCase& Case : Suite.Cases)
	{
		if (Case.Outcome == EJUnitOutcome::Failed && !Case.Rule.empty())
		{
			Suite.Findings.push_back({{.Message = Case.Name + ": " + Case.Message}, Case.Rule});
		}
	}
	for (const FFinding& Finding : Suite.Findings)
	{
		const bool bWarning = Finding.Diagnostic.Severity == ESeverity::Warning;
		Warnings += bWarning ? (Warnings.empty() ? "" : "\n") + Finding.Diagnostic.ToString() : "";
	}
	const bool bFails = Options.bFailOnWarning && !Warnings.empty();
	if (bFails)
	{
		Suite.Cases.push_back({.Name = "no warnings", .Outcome = EJUnitOutcome::Failed, .Message = Warnings});
	}
	if (!Options.JUnit.empty())
	{
		WriteJUnit(Options.JUnit, {Suite});
	}
	if (!Options.Sarif.empty())
	{
		WriteTextFile(Options.Sarif, MakeSarif(Verb, About, Suite.Findings));
	}
	return bFails;
}

} // namespace

void AddFindings(FVerbOptions& Verb, FFindingsOptions& Options, const char* Cases)
{
	Verb.Add("--junit", Options.JUnit, std::string("Write JUnit XML for build servers: a suite with ") + Cases)
		.SetType("FILE");
	Verb.Add("--sarif", Options.Sarif, "Write the findings as SARIF, which code hosts show at their lines")
		.SetType("FILE");
	Verb.Add(
			"--fail-on", [&Options](const std::string& Word) { Options.bFailOnWarning = Word == "warning"; },
			"Exit with code 1 at a warning too; by default only at an error")
		.RequireOneOf({"error", "warning"});
}

std::vector<FJUnitCase> MakeDiagnosticCases(const std::vector<FDiagnostic>& Diagnostics)
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

int CallWithFindings(const FFindingsOptions& Options, const std::string& Verb, const std::string& About,
	const std::function<int(FJUnitSuite&)>& Call)
{
	FJUnitSuite Suite{About};
	const FScopedPrintedDiagnostics Printed;
	try
	{
		const int ExitCode = Call(Suite);
		const bool bFails = Finish(Options, Verb, About, Suite, Printed.Get());
		if (bFails && ExitCode == ExitDone)
		{
			PrintText(stderr, "there are warnings, and --fail-on warning is given\n");
		}
		return bFails && ExitCode == ExitDone ? ExitPolicy : ExitCode;
	}
	catch (...)
	{
		const FError Error = ExplainFailure(std::current_exception());
		std::string Message = JoinText(SummarizeDiagnostics(Error.GetDiagnostics()), "\n",
			[&](const FDiagnostic& Diagnostic) { return Diagnostic.ToString(); });
		Suite.Cases.push_back({.Name = "runs", .Outcome = EJUnitOutcome::Broken, .Message = Message});
		std::vector<FDiagnostic> Said = Printed.Get();
		Said.insert(Said.end(), Error.GetDiagnostics().begin(), Error.GetDiagnostics().end());
		Finish(Options, Verb, About, Suite, Said);
		throw;
	}
}

} // namespace Drydock
