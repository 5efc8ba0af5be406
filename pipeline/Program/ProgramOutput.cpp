// Prints diagnostics as text and writes them as JSON; names the effects that were asked for and do not run.
#include "Program/ProgramOutput.h"

#include "DiagnosticList.h"
#include "Effects/Effects.h"
#include "Program/ProgressBar.h"
#include "Run/RunJson.h"
#include "Text/AsideFile.h"
#include "Text/JsonWriter.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <system_error>
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
	for (const FDiagnostic& Diagnostic : SummarizeDiagnostics(Diagnostics))
	{
		std::fprintf(stderr, "%s%s%s\n", bColorful ? GetColor(Diagnostic.Severity) : "", Diagnostic.ToString().c_str(),
			bColorful ? "\x1b[0m" : "");
	}
}

void FlushOutput()
{
	errno = 0;
	if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
	{
		return;
	}
	std::clearerr(stdout);
	// Where it was an earlier writing that failed, one byte more asks for the reason.
	const bool bKnown = errno != 0 || write(STDOUT_FILENO, "\n", 1) < 0;
	throw MakeWriteError("standard output", bKnown ? std::generic_category().message(errno) : "some of it is lost");
}

void HoldStandardStreams()
{
	for (const int Stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
	{
		if (fcntl(Stream, F_GETFD) < 0 && errno == EBADF)
		{
			// The lowest free number is this one. In the wrong direction, so that it fails as a closed one does.
			(void)!open("/dev/null", Stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
		}
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
