// Keeps the resources of a run that are to be looked at, with their values. Dumping observes and never changes culling.
#pragma once

#include "Run/RunResult.h"

namespace Drydock
{

/** A pass's name without the sizes behind it: "BloomSetup" of "BloomSetup 480x270 (PS)". */
DRYDOCK_API std::string GetShortPassName(const std::string& Pass);

/** Whether a pattern with * and ? is of a pass, by its whole name or the short one. */
DRYDOCK_API bool IsPassNamed(const std::string& Pattern, const std::string& Pass);

/** Whether one of the patterns names the pass (in full or short), the resource, or Pass.Resource. */
DRYDOCK_API bool IsDumped(
	const std::vector<TConfigValue<std::string>>& Patterns, const std::string& Pass, const std::string& Resource);

/** "007.BloomSetup.BloomSetup" (the short name), with .mipK where the resource has several; characters outside
 * [A-Za-z0-9_-] become _. */
DRYDOCK_API std::string GetDumpFileName(const FRunDump& Dump);

/** The rect of a texture that a pass declares to write, from the viewport Output of its parameters (as
 * GetScreenPassTextureViewportParameters fills it), if the viewport's extent is the texture's. Null without one. */
DRYDOCK_API TOptional<FIntRect> FindOutputRect(const FRDGPass& Pass, FIntPoint Extent);

/** A warning for each pattern that no executed pass fits. */
std::vector<FDiagnostic> CheckDumpPatterns(
	const std::vector<TConfigValue<std::string>>& Patterns, const FRunResult& Result);

} // namespace Drydock
