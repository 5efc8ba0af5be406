// Finds the values that are the same in all lanes that are active together. A uniform value is computed once, as a
// plain scalar, and branches on it are plain branches. A fixpoint over single scalars: y of a pixel is uniform (lanes
// are neighbours in a row), x is not.
#pragma once

#include "SpirvStructure.h"

#include <set>

namespace Drydock
{

class FSpirvUniformity
{
public:
	/** One flattened scalar of a value. Constants are never varying. */
	bool IsVarying(uint32_t Value, uint32_t Scalar) const;
	bool IsAnyVarying(uint32_t Value) const;
	/** A private or function variable holds a different thing per lane. */
	bool IsVariableVarying(uint32_t Variable) const { return VaryingVariables.count(Variable) != 0; }
	/** Lanes may arrive at this label by different edges, or at different times. */
	bool IsDivergentJoin(uint32_t Label) const { return DivergentJoins.count(Label) != 0; }
	/** Lanes may leave this loop at different times. */
	bool IsDivergentLoop(uint32_t Header) const { return DivergentLoops.count(Header) != 0; }
	/** The block may run while some lanes of the function wait elsewhere. */
	bool IsDivergentBlock(uint32_t Label) const { return DivergentBlocks.count(Label) != 0; }

private:
	friend class FUniformityAnalysis;
	std::unordered_map<uint32_t, std::vector<bool>> Varying;
	std::set<uint32_t> VaryingVariables;
	std::set<uint32_t> DivergentJoins;
	std::set<uint32_t> DivergentLoops;
	std::set<uint32_t> DivergentBlocks;
};

DRYDOCK_API FSpirvUniformity AnalyzeUniformity(const FSpirvModule& Module, const FSpirvStructure& Structure);

/** Variables that only ever hold one constant: tables. Variable id -> constant id. */
std::map<uint32_t, uint32_t> FindConstantTables(const FSpirvModule& Module);

} // namespace Drydock
