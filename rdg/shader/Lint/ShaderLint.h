// The portability lint: finds shader code that fails on other platforms than drydock, from its SPIR-V, and from its
// text where the front end lost it.
#pragma once

#include "LintRules.h"
#include "ShaderEntries.h"

#include <map>
#include <tuple>

namespace Drydock
{

struct FLintFinding
{
	const FLintRule* Rule = nullptr;
	std::string File; // virtual path
	int Line = 0;     // 0: of the whole shader
	std::string What; // the thing: "T", "32 x 32 x 1 threads"; may be empty

	bool operator==(const FLintFinding&) const = default;
	bool operator<(const FLintFinding& Other) const
	{
		return std::tie(File, Line, Rule->Id, What) < std::tie(Other.File, Other.Line, Other.Rule->Id, Other.What);
	}
};

/** Runs the front end. Findings are sorted by file, line and rule, each once; without what the shader allows
 * (LintAllowances.h). Platforms: bits of ELintPlatform that are asked for. Throws FError as CompileToSpirv does. If
 * drydock cannot run the shader, only text and head are checked: Refused, if not null, then receives the reason. */
DRYDOCK_API std::vector<FLintFinding> LintShader(
	const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused = nullptr);

/** The same of a module's words, and of the flattened text behind them, which may be empty; with what it allows. */
DRYDOCK_API std::vector<FLintFinding> LintSpirv(const std::vector<uint32_t>& Words, const std::string& Text,
	const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused = nullptr);

/** LintShader of one entry point after the other of one file: it is flattened once for each stage, and the others are
 * left out of what the front end reads. */
class DRYDOCK_API FFileLinter
{
public:
	/** Requests are alike, but for entry point and stage; none is of a module of SPIR-V. */
	std::vector<FLintFinding> Lint(
		const FShaderCompileRequest& Request, uint8_t Platforms, std::vector<FDiagnostic>* Refused = nullptr);

private:
	std::map<EShaderStage, std::unique_ptr<FEntryTexts>> ByStage;
};

} // namespace Drydock
