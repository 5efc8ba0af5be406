// Syntax tree to the program of one entry, by the rules of HLSL 2021.
#pragma once

#include "Diagnostics.h"
#include "HlslProgram.h"

#include <memory>

namespace Drydock::Hlsl
{

struct FTree;

struct FAnalysisOptions
{
	std::string EntryPoint;
	EStage Stage = EStage::Compute;
	bool bRealHalf = false;      // half is float16_t
	bool bFloatLiterals = false; // HLSL 202x: a literal without a suffix is a float
	bool bFxcRules = false;      // shader model 5: ?:, && and || take vectors, and all their sides are run
	std::string VirtualPath;     // of the shader, for messages without a place
	bool bAllLoose = false; // parameters at file scope that nothing names are made beside those that something does
	/** "View.Foo" of a uniform buffer: the buffer's name and its members; X.Member is the variable X_Member of the
	 * text, where the text declares no X of its own. */
	std::vector<std::pair<std::string, std::vector<std::string>>> UniformBuffers;
};

struct FAnalysis
{
	std::shared_ptr<const FTree> Tree; // whose names the program has, where Read keeps it
	std::shared_ptr<FTypes> Types;
	std::shared_ptr<FProgram> Program; // null where there are errors
	std::vector<FDiagnostic> Errors;   // DD6010; DD6011: the entry point does not exist
	std::vector<FDiagnostic> Warnings;
};

/** Analyses what the entry reaches: functions that nothing calls are not judged, variables that nothing names are not
 * made. Every message has its file, line and column, the nearest name where one lacks, and the number of D3D's
 * compilers where people search for it ("error X3004: undeclared identifier 'Foo'; did you mean Fog?"). */
DRYDOCK_API FAnalysis Analyse(const FTree& Tree, const FAnalysisOptions& Options);

} // namespace Drydock::Hlsl
