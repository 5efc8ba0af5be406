// The values that a pass hands to its shader beside resources.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

class FRDGPass;

namespace Drydock
{

class FJsonWriter;

struct FPassValue
{
	std::string Name;  // as C++ calls it: "Input.ViewportMin"
	std::string Type;  // "float4", "float4[3]"
	std::string Value; // "0.5", "(1, 0.5, 0, 1)"; of a matrix row by row, of an array how many it has
};

/** Numbers of the pass's parameter struct, in its order, of a viewport its extent and rect; none for a pass without
 * parameters. */
std::vector<FPassValue> ReadPassValues(const FRDGPass& Pass);

/** "Strength = 0.5, Tint = (1, 0.5, 0)" */
DRYDOCK_API std::string FormatPassValues(const std::vector<FPassValue>& Values);

/** Member "values" of an object. */
void WriteValues(FJsonWriter& Writer, const std::vector<FPassValue>& Values);

} // namespace Drydock
