// Runs a test through the shader tier: compiles, binds the buffers, dispatches, compares.
#pragma once

#include "ShaderCompileRequest.h"

#include <string>

namespace Drydock::Conformance
{

enum class EVerdict : uint8_t
{
	Passed,
	Refused,        // with a message that names file and line
	RefusedNowhere, // with a message that does not
	Wrong,
	Crashed,
	Hung,
	NotRead
};

struct FOptions
{
	FLaneConfig Lanes;
	bool bInterpreter = false; // in place of the compiled kernel
	bool bSabotage = false;    // each expected value changed, one after the other: each has to be found
};

struct FVerdict
{
	EVerdict Verdict = EVerdict::Passed;
	std::string Message;
};

/** Runs the test in the file at Path. Name: what its messages call it. */
FVerdict RunTest(const std::string& Path, const std::string& Name, const FOptions& Options);

} // namespace Drydock::Conformance
