// Prints diagnostics as text and writes them as JSON; names the effects that were asked for and do not run.
#include "Program/ProgramOutput.h"

#include "Effects/Effects.h"
#include "Program/ProgressBar.h"
#include "Run/RunJson.h"
#include "Text/JsonWriter.h"

#include <cstdio>
#include <unistd.h>

namespace Drydock
{

namespace
{

const char* GetColor(ESeverity Severity)
{
	switch (Severity)
	{
	case ESeverity::Error:
		return "\x1b[31m";
	case ESeverity::Warning:
		return "\x1b[33m";
	case ESeverity::Note:
		break;
	}
	return "\x1b[36m";
}

} // namespace

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

void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics)
{
	const bool bColorful = IsColorful(STDERR_FILENO);
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		std::fprintf(stderr, "%s%s%s\n", bColorful ? GetColor(Diagnostic.Severity) : "", Diagnostic.ToString().c_str(),
			bColorful ? "\x1b[0m" : "");
	}
}

void PrintClosingLines(const std::vector<FEffectDecision>& Effects)
{
	for (const FEffectDecision& Effect : Effects)
	{
		if (Effect.bConfigured && !Effect.bActive)
		{
			std::fprintf(stderr, "%s: %s\n", Effect.GetName().c_str(), Effect.Reason.c_str());
		}
	}
}

} // namespace Drydock
