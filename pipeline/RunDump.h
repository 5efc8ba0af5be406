// Which resources a run keeps to look at, and what they hold. Dumping observes and never changes culling. Source:
// drydock.
#pragma once

#include "Run.h"

class FRHITexture;

namespace Drydock
{

/** Whether Text as a whole fits a pattern with * (any text) and ? (any character). */
DRYDOCK_API bool MatchesPattern(const std::string& Pattern, const std::string& Text);

/** A pass's name without the sizes behind it: "BloomSetup" of "BloomSetup 480x270 (PS)". */
DRYDOCK_API std::string GetShortPassName(const std::string& Pass);

/** Whether one of the patterns names the pass (in full or short), the resource, or Pass.Resource. */
DRYDOCK_API bool IsDumped(
	const std::vector<TConfigValue<std::string>>& Patterns, const std::string& Pass, const std::string& Resource);

/** "007.BloomSetup.BloomSetup" (the short name), with .mipK where the resource has several; characters outside
 * [A-Za-z0-9_-] become _. */
DRYDOCK_API std::string GetDumpFileName(const FRunDump& Dump);

/** The values of one mip as stored, channels that the format has. */
FImage ReadTexture(FRHITexture& Texture, int Mip = 0);

/** The part of an image inside a rect, padded to four channels (0, alpha 1). */
FImage CropToRgba(const FImage& Image, const FIntRect& Rect);

/** "R", "RG", ... for a number of channels. */
std::vector<std::string> GetChannelNames(int NumChannels);

/** A warning for each pattern that no executed pass fits. */
std::vector<FDiagnostic> CheckDumpPatterns(
	const std::vector<TConfigValue<std::string>>& Patterns, const FRunResult& Result);

} // namespace Drydock
