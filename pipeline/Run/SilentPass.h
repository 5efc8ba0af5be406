// Finds passes that do nothing: what they wrote has, bit for bit, the values of a texture that they read.
#pragma once

#include "PassCounters.h"

#include <optional>
#include <string>
#include <vector>

class FRDGPass;
class FRDGTexture;

namespace Drydock
{

struct FSilentPass
{
	std::string Input;   // texture that it read
	std::string Because; // likely reason: "Strength is 0", "Mask is 0 everywhere"
};

/** Called right after the pass. Looks at textures of one mip and of one format with an input, at what the pass drew of
 * them, and stops at the first difference; so it costs as much as the pictures have in common. None if a pass copies on
 * purpose, runs no shader, or wrote one colour everywhere, which proves nothing. */
std::optional<FSilentPass> FindSilentPass(
	const FRDGPass& Pass, const FPassCounters& Counters, const std::vector<FRDGTexture*>& Written);

/** "it wrote the same values as it read from SceneColor, bit for bit: Strength is 0" */
std::string DescribeSilentPass(const FSilentPass& Silent);

} // namespace Drydock
