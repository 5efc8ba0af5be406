// Validates a declared graph before it is compiled: pass flags, render targets, hazards, reads of what nobody wrote.
// All errors are collected. Source: engine RenderGraphValidation.cpp, restated.
#pragma once

#include "RenderGraphCompiled.h"
#include "RenderGraphErrors.h"

namespace Drydock
{

struct FRDGValidationResult
{
	std::vector<FDiagnostic> Errors;  // checks: the graph must not run
	std::vector<FDiagnostic> Ensures; // reported, the graph runs
	std::vector<FDiagnostic> Warnings;
};

/** bDebug (r.RDG.Debug): also what merely wastes. bStrict (r.RDG.Validation 2): what is undefined is an error. */
DRYDOCK_API FRDGValidationResult ValidateGraph(const FRDGGraphDescription& Graph, bool bDebug, bool bStrict = false);

/** The errors of one pass of the graph alone. */
DRYDOCK_API std::vector<FDiagnostic> ValidatePass(
	const FRDGGraphDescription& Graph, const FRDGPassDescription& Pass, bool bStrict = false);

/** A message about a pass, at its AddPass call. Parameter and Resource may be empty. */
DRYDOCK_API FDiagnostic MakePassDiagnostic(ESeverity Severity, int Code, const FRDGPassDescription& Pass,
	const std::string& Message, const std::string& Parameter = "", const std::string& Resource = "");

} // namespace Drydock
