// Scans JSON text before it is parsed: finds where each key and value begins, and numbers that no parser can hold.
#pragma once

#include "TextPositions.h"

#include <cstddef>
#include <string>
#include <vector>

namespace Drydock
{

struct FJsonToken
{
	size_t Offset = 0;
	bool bNotFinite = false; // NaN, Infinity, or a number beyond double
};

struct FJsonScan
{
	/** Begin of every key and value in order of appearance, the order in which a SAX parser reports them. */
	std::vector<FJsonToken> Tokens;
	/** The text with every non-finite number replaced by a 0 of the same length, so that the rest can still be parsed.
	 */
	std::string Text;
};

/** Part of a number or a word without quotes. */
bool IsBareCharacter(char Character);

/** Offset behind the string literal that begins at Begin. */
size_t SkipString(const std::string& Text, size_t Begin);

/** Offset behind the comment that begins at Begin, or Begin when there is none. */
size_t SkipComment(const std::string& Text, size_t Begin);

/** Stops after MaxTokens keys and values: those behind are not needed. */
FJsonScan ScanJson(const std::string& Text, size_t MaxTokens);

} // namespace Drydock
