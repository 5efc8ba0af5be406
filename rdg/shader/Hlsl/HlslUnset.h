// Finds local variables that are read where nothing may have set them, and out parameters that a path leaves unset.
#pragma once

#include "HlslProgram.h"

#include <string>
#include <vector>

namespace Drydock::Hlsl
{

struct FUnset
{
	const FVariable* Variable = nullptr;
	std::string Part;  // the first one that is not set: "X.y", "S.Member", "X"
	FPlace Place;      // of the read; of the parameter
	bool bOut = false; // an out parameter that is not set where the function ends
};

/** Each variable once, with the first place. Members of a struct and components of a vector are followed; of a member
 * a part that is set counts as all, and a loop counts as run at least once. */
std::vector<FUnset> FindUnset(const FFunction& Function);

} // namespace Drydock::Hlsl
