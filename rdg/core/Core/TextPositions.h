// Converts an offset of a text to line and column, for messages.
#pragma once

#include "DrydockAPI.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Drydock
{

/** 1-based line and column of an offset; columns count characters, not bytes. */
struct FTextPosition
{
	int Line = 1;
	int Column = 1;
};

/** Answers for rising and falling offsets alike; rising ones of one line cost only the way between them. Text must
 * outlive this. */
class DRYDOCK_API FTextPositions
{
public:
	explicit FTextPositions(const std::string& Text);
	FTextPosition Find(size_t Offset) const;

private:
	const std::string& Text;
	std::vector<size_t> LineBegins;
	mutable size_t LastOffset = 0; // of the last answer, where the next count may begin
	mutable FTextPosition Last;
};

} // namespace Drydock
