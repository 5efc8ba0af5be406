// The control flow of a shader as a tree: SPIR-V's blocks with their merge instructions become nested selections and
// loops. "Open labels" of a place are those that control may jump to from there: merge blocks of the enclosing
// selections, merge and continue blocks of the enclosing loops, cases of the enclosing switches.
#pragma once

#include "SpirvModule.h"

#include <map>

namespace Drydock
{

struct FStructNode;

/** A way out of a region past what follows it in the text. */
struct FStructJump
{
	uint32_t To = 0;
	bool bInnerLoop = false;    // from a loop inside of the region, perhaps among others
	bool bFallsThrough = false; // to another case of a switch that the region is a case of, or that lies in it
};

/** Statements one after the other. Control that reaches the end goes on to the region's Follow label. */
struct FStructRegion
{
	uint32_t Follow = 0; // 0: end of the function
	std::vector<FStructNode> Nodes;
	std::vector<FStructJump> Jumps; // of the region and all inside, by label
	bool bEnds = false;             // a Return or Kill is in it or inside
	bool bDiscards = false;         // a call of a function that discards is in it or inside
	size_t Weight = 0;              // scalars that its instructions and all inside compute or store
};

enum class EStructNode : uint8_t
{
	Block,  // the instructions of Label, without phis and terminator
	Edge,   // control passes From -> To; phis of To take their values. bJump: To is not the next thing in the text
	If,     // Condition; Regions: then, else
	Switch, // Selector; Regions: one per case
	Loop,   // Label is the header; Regions: body (which starts with the header block), continue part
	Return,
	Kill,
};

struct FStructCase
{
	uint32_t Label = 0;
	std::vector<uint32_t> Values; // bit patterns of the selector
	bool bDefault = false;
};

struct FStructNode
{
	EStructNode Kind = EStructNode::Block;
	uint32_t Label = 0;    // block; loop header; selection: the block that branches
	uint32_t From = 0;     // edge
	uint32_t To = 0;       // edge
	bool bJump = false;    // edge
	uint32_t Value = 0;    // condition or selector
	uint32_t Merge = 0;    // selection (0: both sides leave or the rest is inside), loop
	uint32_t Continue = 0; // loop
	std::vector<FStructCase> Cases;
	std::vector<FStructRegion> Regions;
	size_t Weight = 0; // as of regions
};

struct FOpenLabel
{
	uint32_t Label = 0;
	uint32_t Loop = 0; // header of the loop this label belongs to, 0: a selection
	bool bLoopMerge = false;
};

struct FSpirvStructure
{
	FStructRegion Root;
	std::map<uint32_t, std::vector<FOpenLabel>>
		OpenLabels;                                  // block -> from the outermost inwards, as seen by its terminator
	std::map<uint32_t, std::vector<uint32_t>> Loops; // block -> headers of the loops around it, outermost first
};

/** Builds the structure of the function that begins with that block, by its index. Throws FSpirvError when the control
 * flow is not structured. */
DRYDOCK_API FSpirvStructure BuildSpirvStructure(const FSpirvModule& Module, uint32_t FirstBlock = 0);

} // namespace Drydock
