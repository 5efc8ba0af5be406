// Frames of a sequence as a person names them: "all", "1-8", "1-9x2" (every second), "1,3,5-8". The notation is the
// usual one of renderers.
#pragma once

#include "DrydockAPI.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FFrameRange
{
	int First = 0;
	int Last = 0; // inclusive, at least First
	int Step = 1; // above 0

	bool operator==(const FFrameRange&) const = default;
};

struct FFrameList
{
	bool bAll = false; // all that there are; then there are no ranges
	std::vector<FFrameRange> Ranges;

	bool operator==(const FFrameList&) const = default;
};

/** Frames ascend, because a frame's history is that of earlier ones. Empty if the text is not such a list; then
 * OutError is the fault, in a sentence without a full stop. */
DRYDOCK_API std::optional<FFrameList> ParseFrameList(const std::string& Text, std::string& OutError);

/** A list that names these numbers, which ascend: "1-8,20", "1-9x2". */
DRYDOCK_API std::string FormatFrameList(const std::vector<int>& Frames);

/** The numbers, ascending. Existing: the numbers that "all" means. */
DRYDOCK_API std::vector<int> ListFrames(const FFrameList& List, const std::vector<int>& Existing);

} // namespace Drydock
