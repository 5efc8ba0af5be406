// Finds what a value depends on: the pixel's column, its row, or anything else that may differ between pixels. A
// texture coordinate that depends on the column alone is the same in all rows of a tile, however the shader computes
// it: facts found in one row hold in the others.
#pragma once

#include "SpirvUniformity.h"

namespace Drydock
{

enum ESpirvDependence : uint8_t
{
	DependsOnColumn = 1,
	DependsOnRow = 2,
	DependsOnOther = 4 // textures, buffers, variables in memory, z
};

class FSpirvDependence
{
public:
	/** Bits of ESpirvDependence of one scalar of a value at the n-th time that its block runs for a pixel. Inputs that
	 *  are interpolated are taken for a full-screen triangle's: x and z depend on the column, y and w on the row. */
	uint8_t Get(uint32_t Value, uint32_t Scalar) const;
	uint8_t GetAll(uint32_t Value) const;
	/** Whether the block runs equally often for all pixels that reach the loops around it. */
	bool IsSteady(uint32_t Label) const { return !UnsteadyBlocks.count(Label); }

private:
	friend class FDependenceAnalysis;
	std::unordered_map<uint32_t, std::vector<uint8_t>> Bits;
	std::set<uint32_t> UnsteadyBlocks;
};

DRYDOCK_API FSpirvDependence AnalyzeDependence(const FSpirvModule& Module, const FSpirvStructure& Structure);

} // namespace Drydock
