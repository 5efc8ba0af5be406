// Lists what a frame's layers can become: the channels of a scene in groups, each with one way of being encoded.
// Channels and their units: configs/scenes/README.md.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

enum class EImportKind
{
	Color,
	Depth,
	Normal,
	Velocity,
	Number, // a whole number
	Part,   // 0..1, as it is
};

struct FImportTarget
{
	const char* Group; // as --map takes it; a channel's own name does too
	std::vector<std::string> Channels;
	EImportKind Kind;
	/** Number of the channels, from the first, that a layer has to give. */
	size_t NumNeeded;
};

/** Colour first. */
DRYDOCK_API const std::vector<FImportTarget>& GetImportTargets();

/** Finds the target of a group, or null. */
DRYDOCK_API const FImportTarget* FindImportTarget(const std::string& Group);

/** A name for layers: the rule that it follows. */
struct FImportNameRule
{
	std::string Keyword; // small letters and digits
	std::string Group;   // empty: no channel takes it, because of Remark
	int Rank;            // of several layers of a group the highest is taken
	bool bWord;          // only as a word of its own
	std::string Remark;
};

/** The rule that a layer's name fits best: the whole name, else its end, else a part of it; the longest keyword of
 * these. Null where it fits none. */
DRYDOCK_API const FImportNameRule* FindImportNameRule(const std::string& Name);

} // namespace Drydock
