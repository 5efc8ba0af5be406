// Functions of HLSL on constants.
#pragma once

#include "HlslProgram.h"

namespace Drydock::Hlsl
{

struct FConstantArgument
{
	const FType* Type = nullptr; // numeric
	const FConstant* Bits = nullptr;
};

/** The result of a pure function by the operations of SPIR-V that it is written in, or nothing: the call stays for run
 * time. */
std::optional<FConstant> EvaluateConstantCall(
	std::string_view Name, const FType* Result, const std::vector<FConstantArgument>& Arguments);

} // namespace Drydock::Hlsl
