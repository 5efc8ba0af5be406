// `drydock check`: reads and validates a config and its scene's header, compiles its frame and shaders, draws nothing.
#include "PrintText.h"
#include "Program/FindingsOption.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Run/RunJson.h"
#include "Run/ShaderWarnings.h"
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
	FFindingsOptions Findings;
	bool bJson = false;
};

int Check(const FCheckOptions& Options, FJUnitSuite& Suite)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FEffectDecision> Effects;
	std::string Looked; // of plugins' shaders; empty: there are none
	int ExitCode = ExitDone;
	try
	{
		const FShaderWarnings Warnings;
		const FCheckResult Result = CheckRun(Options.Run);
		Diagnostics = Warnings.Find();
		Diagnostics.insert(Diagnostics.begin(), Result.Diagnostics.begin(), Result.Diagnostics.end());
		Effects = Result.Effects;
		Looked = Result.Shaders.NumClasses > 0 ? "; looked at " + Result.Shaders.Describe() : "";
	}
	catch (const FError& Error)
	{
		Diagnostics = Error.GetDiagnostics();
		ExitCode = Error.GetExitCode();
	}
	Suite.Cases = MakeDiagnosticCases(Diagnostics);
	if (Options.bJson)
	{
		FJsonWriter Writer;
		WriteMessages(Writer, Diagnostics);
		PrintText(stdout, Writer.GetText());
		for (const FDiagnostic& Diagnostic : Diagnostics)
		{
			Suite.Findings.push_back({Diagnostic});
		}
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
	AddFindings(Verb, Options->Findings, "a case for each family of messages");
	Verb.AddFlag("--json", Options->bJson, "Print the messages as JSON");
	return [Options]
	{
		return CallWithFindings(Options->Findings, "check", Options->Run.ConfigFile,
			[&Options](FJUnitSuite& Suite) { return Check(*Options, Suite); });
	};
}

} // namespace Drydock
