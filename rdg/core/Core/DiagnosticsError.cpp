// Builds the text of an error that carries many messages.
#include "DiagnosticList.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

std::string JoinLines(const std::vector<FDiagnostic>& Diagnostics)
{
	return JoinText(Diagnostics, "\n", [&](const FDiagnostic& Diagnostic) { return Diagnostic.ToString(); });
}

} // namespace

FError::FError(std::vector<FDiagnostic> InDiagnostics, EExitCode InExitCode)
	: std::runtime_error(JoinLines(SummarizeDiagnostics(InDiagnostics)))
	, Diagnostics(std::move(InDiagnostics))
	, ExitCode(InExitCode)
{
}

FError::FError(const FDiagnostic& Diagnostic, EExitCode InExitCode)
	: FError(std::vector<FDiagnostic>{Diagnostic}, InExitCode)
{
}

FError::~FError() = default;

} // namespace Drydock
