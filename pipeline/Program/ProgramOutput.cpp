// Prints diagnostics as text and writes them as JSON; names the effects that were asked for and do not run.
#include "Program/ProgramOutput.h"

#include "DiagnosticList.h"
#include "Effects/Effects.h"
#include "PrintText.h"
#include "Program/ProgressBar.h"
#include "Run/RunJson.h"
#include "Text/AsideFile.h"
#include "Text/JsonWriter.h"
#include "Text/Terminal.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

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
	return Severity == ESeverity::Error ? "\x1b[31m" : Severity == ESeverity::Warning ? "\x1b[33m" : "\x1b[36m";
}

/** The name that a message offers, "did you mean X?"; empty where it offers none. */
std::string FindOffered(const std::string& Message)
{
	const std::string Phrase = "did you mean ";
	const size_t Found = Message.find(Phrase);
	const size_t Begin = Found + Phrase.size();
	const size_t End = Found == std::string::npos ? Found : Message.find('?', Begin);
	if (End == std::string::npos)
	{
		return "";
	}
	const std::string Name = Message.substr(Begin, End - Begin);
	const bool bQuoted = Name.size() > 1 && (Name[0] == '\'' || Name[0] == '"') && Name.back() == Name[0];
	return bQuoted ? Name.substr(1, Name.size() - 2) : Name;
}

} // namespace

void WriteDiagnostics(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics)
{
	Writer.BeginArray();
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Writer.BeginObject(true);
		Writer.Members({{"severity", Diagnostic.Severity == ESeverity::Error     ? "error"
									 : Diagnostic.Severity == ESeverity::Warning ? "warning"
																				 : "note"},
			{"code", FormatCode(Diagnostic.Code)}, {"text", Diagnostic.Message}, {"file", Diagnostic.File},
			{"line", Diagnostic.Line}, {"column", Diagnostic.Column}});
		const bool bPointer = Diagnostic.Where.starts_with('/');
		Writer.Members({{"pointer", bPointer ? Diagnostic.Where : ""}, {"where", Diagnostic.Where},
			{"nearest", FindOffered(Diagnostic.Message)}});
		Writer.EndObject();
	}
	Writer.EndArray();
}

void WriteMessages(FJsonWriter& Writer, const std::vector<FDiagnostic>& Diagnostics)
{
	Writer.BeginObject();
	Writer.Key("messages");
	WriteDiagnostics(Writer, Diagnostics);
	Writer.EndObject();
}

/** Messages of the innermost FScopedPrintedDiagnostics; null: nobody keeps messages. */
static std::vector<FDiagnostic>* GPrintedDiagnostics = nullptr;

FScopedPrintedDiagnostics::FScopedPrintedDiagnostics()
	: Outer(std::exchange(GPrintedDiagnostics, &Printed))
{
}

FScopedPrintedDiagnostics::~FScopedPrintedDiagnostics()
{
	GPrintedDiagnostics = Outer;
}

void PrintDiagnostics(const std::vector<FDiagnostic>& Diagnostics)
{
	const bool bColorful = IsColorful(STDERR_FILENO);
	if (GPrintedDiagnostics != nullptr)
	{
		GPrintedDiagnostics->insert(GPrintedDiagnostics->end(), Diagnostics.begin(), Diagnostics.end());
	}
	for (const FDiagnostic& Diagnostic : SummarizeDiagnostics(Diagnostics))
	{
		std::fputs(bColorful ? GetColor(Diagnostic.Severity) : "", stderr);
		PrintText(stderr,
			FitLines(Diagnostic.ToString(), GetTerminalWidth(STDERR_FILENO)) + (bColorful ? "\x1b[0m\n" : "\n"));
	}
}

int GetOutputWidth()
{
	return GetTerminalWidth(STDOUT_FILENO);
}

std::string ListLines(const std::vector<std::string>& Texts)
{
	return JoinText(Texts, "", [](const std::string& Text) { return "  " + Text + "\n"; });
}

void PrintResult(const std::string& Text, bool bJson)
{
	PrintText(stdout, bJson ? Text : FitLines(Text, GetOutputWidth()));
}

void FlushOutput()
{
	errno = 0;
	if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
	{
		return;
	}
	std::clearerr(stdout);
	// If an earlier write failed, writing one more byte gets the reason.
	const bool bKnown = errno != 0 || write(STDOUT_FILENO, "\n", 1) < 0;
	throw MakeWriteError("standard output", bKnown ? std::generic_category().message(errno) : "part of it is lost");
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
			const std::string Line = Effect.GetName() + ": " + Effect.Reason + "\n";
			PrintText(stderr, FitLines(Line, GetTerminalWidth(STDERR_FILENO)));
		}
	}
}

} // namespace Drydock
