// `drydock check`: reads and validates a config and its scene's header, compiles its frame and shaders, draws nothing.
#include <CLI/CLI.hpp>

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
	bool bJson = false;
};

int Check(const FCheckOptions& Options)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FEffectDecision> Effects;
	int ExitCode = ExitDone;
	try
	{
		const FCheckResult Result = CheckRun(Options.Run);
		Diagnostics = Result.Diagnostics;
		Effects = Result.Effects;
	}
	catch (const FError& Error)
	{
		Diagnostics = Error.GetDiagnostics();
		ExitCode = Error.GetExitCode();
	}
	if (Options.bJson)
	{
		FJsonWriter Writer;
		WriteDiagnostics(Writer, Diagnostics);
		std::fputs(Writer.GetText().c_str(), stdout);
		return ExitCode;
	}
	PrintDiagnostics(Diagnostics);
	PrintClosingLines(Effects);
	if (ExitCode == ExitDone)
	{
		std::printf("%s: no errors\n", Options.Run.ConfigFile.c_str());
	}
	return ExitCode;
}

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Options = std::make_shared<FCheckOptions>();
	AddConfig(Verb, Options->Run);
	Verb.add_flag("--json", Options->bJson, "Print the messages as JSON");
	return [Options]
	{
		return Check(*Options);
	};
}

const FVerbRegistration GRegistration({
	.Name = "check",
	.Place = 20,
	.Doc = "Read and validate a config, compile its frame and shaders; draw nothing",
	.AddOptions = AddOptions,
});

} // namespace

} // namespace Drydock
