// The table of names that differ between engine versions (Misc/EngineApi.h) as data, and what compilers say by it.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FEngineApiRow
{
	const char* Kind;      // "from", "until" or "deprecated"
	int Minor;             // of engine 5
	const char* Certainty; // "Public" or "Uncertain"
	const char* Name;
	const char* Instead = ""; // of deprecated ones
};

DRYDOCK_API const std::vector<FEngineApiRow>& GetEngineApi();

/** The sentences about names and the engine's version in a compiler's output, each once, with the first place that it
 * has: "Source/A.cpp:12: engine 5.4 does not have ISceneViewExtension::GetFlags, which is there from 5.7 on". */
DRYDOCK_API std::vector<std::string> FindVersionMessages(const std::string& CompilerOutput);

} // namespace Drydock
