// Numbered messages for the user: what went wrong, where, and what was expected. Every stage collects as many as it can
// and reports them together. Numbers: DD1 config, DD2 graph and extensions, DD3 settings, DD4 numeric, DD5 files,
// DD6 shaders. docs/errors.md lists them all.
#pragma once

#include "DrydockAPI.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace Drydock
{

enum class ESeverity
{
	Note,
	Warning,
	Error,
};

/** Exit codes of the program. */
enum EExitCode
{
	ExitDone = 0,
	ExitPolicy = 1,    // a comparison, budget or numeric policy failed
	ExitUsage = 2,     // usage, config or graph error
	ExitFiles = 3,     // a file cannot be read or written
	ExitInternal = 70, // a fault of drydock's own
	ExitPlugin = 71    // a plugin's code crashed, threw or did not come back
};

struct FDiagnostic
{
	ESeverity Severity = ESeverity::Error;
	int Code = 0;             // 1012 is printed as DD1012
	std::string Message = {}; // one sentence; names the thing, what was expected, the nearest valid name
	std::string File = {};    // empty: no file
	int Line = 0;             // 1-based, 0: unknown
	int Column = 0;           // 1-based, 0: unknown
	std::string Where = {};   // JSON pointer, "pass X, parameter Y", ... or empty

	/** Text of strangers in it is made printable (PrintText.h): `configs/a.json:12:7: error DD1012 at /volumes/0:
	 * message`; a line of a shader: `X.usf:12: error: message [DD6010]`. */
	DRYDOCK_API std::string ToString() const;
};

/** Thrown by a stage that cannot go on, with everything it collected. */
class DRYDOCK_API FError : public std::runtime_error
{
public:
	FError(std::vector<FDiagnostic> InDiagnostics, EExitCode InExitCode);
	FError(const FDiagnostic& Diagnostic, EExitCode InExitCode);
	~FError() override;

	const std::vector<FDiagnostic>& GetDiagnostics() const { return Diagnostics; }
	EExitCode GetExitCode() const { return ExitCode; }

private:
	std::vector<FDiagnostic> Diagnostics;
	EExitCode ExitCode;
};

/** The nearest of Candidates to Name by Damerau-Levenshtein distance, ignoring case; empty when none is near enough
 *  (more than a third of the letters differ). */
DRYDOCK_API std::string FindNearestName(const std::string& Name, const std::vector<std::string>& Candidates);

/** "; did you mean X?" for the end of a message, with that name; empty when none is near enough. */
DRYDOCK_API std::string SuggestName(const std::string& Name, const std::vector<std::string>& Candidates);

} // namespace Drydock
