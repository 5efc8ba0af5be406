// A compiler of the user's own between HLSL and SPIR-V: DRYDOCK_HLSL_COMPILER names a program that is called as its
// base name says. docs/shaders.md states what it is given and what it has to give.
#pragma once

#include "ChildProcess.h"
#include "Diagnostics.h"
#include "ShaderCompileRequest.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

enum class EHlslCompiler
{
	Dxc,
	Slang,
};

struct FHlslCompiler
{
	std::string Program; // full path
	EHlslCompiler Kind = EHlslCompiler::Dxc;

	/** "dxc", without its folder. */
	std::string GetName() const { return Program.substr(Program.rfind('/') + 1); }
};

/** The compiler that DRYDOCK_HLSL_COMPILER names; nothing where it is not set. Throws FError DD6012 where that program
 * is not there, or its base name begins with neither dxc nor slangc. */
DRYDOCK_API std::optional<FHlslCompiler> FindHlslCompiler(const FShaderCompileRequest& Request);

/** Path, size and time of the program that DRYDOCK_HLSL_COMPILER names, hashed: its results are kept apart from those
 * of others. Empty where it is not set, and for SPIR-V, which needs none. Throws as FindHlslCompiler. */
std::string GetHlslCompilerId(const FShaderCompileRequest& Request);

/** The text with X_Y in place of X.Y for the members of uniform buffers, as the engine writes them for its compilers.
 */
DRYDOCK_API std::string WriteForCompiler(const std::string& Text, const FShaderCompileRequest& Request);

/** The program and its arguments: from the file Input, SPIR-V in the file Output. */
DRYDOCK_API std::vector<std::string> MakeHlslCompilerArguments(const FHlslCompiler& Compiler,
	const FShaderCompileRequest& Request, const std::string& Input, const std::string& Output);

/** "file:line:column: error: text", "file:line: error: text" and "file(line): error CODE: text" in what a compiler
 * wrote: DD6010, or DD6011 where it says that the entry point is not there. Warnings and notes are left out. */
DRYDOCK_API std::vector<FDiagnostic> ParseCompilerMessages(
	const std::string& Output, const FShaderCompileRequest& Request);

} // namespace Drydock
