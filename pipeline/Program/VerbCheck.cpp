// `drydock check`. Source: drydock.
#include "Program/Verbs.h"
#include "Run/Run.h"
#include "Run/RunJson.h"
#include "SceneFile/SceneFile.h"
#include "Text/JsonWriter.h"

#include <cstdio>

namespace Drydock
{

void WriteDiagnostics(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics)
{
	Writer.BeginArray();
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Writer.BeginObject(true);
		Writer.Member("severity", Diagnostic.Severity == ESeverity::Error     ? "error"
								  : Diagnostic.Severity == ESeverity::Warning ? "warning"
																			  : "note");
		Writer.Member("code", FormatCode(Diagnostic.Code));
		Writer.Member("message", Diagnostic.Message);
		Writer.Member("file", Diagnostic.File);
		Writer.Member("line", Diagnostic.Line);
		Writer.Member("column", Diagnostic.Column);
		Writer.Member("where", Diagnostic.Where);
		Writer.EndObject();
	}
	Writer.EndArray();
}

int CheckVerb(const FVerbOptions& Options)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<std::string> ClosingLines;
	int ExitCode = ExitDone;
	try
	{
		const FCheckResult Result = CheckConfig(Options.Run);
		Diagnostics = Result.Diagnostics;
		ClosingLines = MakeClosingLines(Result.Effects);
		if (Result.Config.Scene.File.IsSet())
		{
			const FSceneFile Scene(Result.Config); // reads the header, checks the names of channels
		}
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
	for (const std::string& Line : ClosingLines)
	{
		std::fprintf(stderr, "%s\n", Line.c_str());
	}
	if (ExitCode == ExitDone)
	{
		std::printf("%s: no errors\n", Options.Run.ConfigFile.c_str());
	}
	return ExitCode;
}

} // namespace Drydock
