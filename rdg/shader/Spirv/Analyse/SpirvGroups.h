// Finds what the threads of a compute shader do together, and so how they must be run: whole groups at once, waves in
// step, groups one after the other.
#pragma once

#include "SpirvStructure.h"

#include <map>
#include <set>

namespace Drydock
{

/** Threads of a wave are those with neighbouring SV_GroupIndex, the first at a multiple of this. */
constexpr uint32_t GDefaultWaveSize = 32;

struct FSpirvGroupUse
{
	/** groupshared memory or barriers, or bWaves: a group is run as a whole, in the order of SV_GroupIndex, from one
	 * barrier to the next. */
	bool bGroups = false;
	/** Threads of a wave go from one such operation to the next together, those of the lowest index first: wave
	 * operations; atomics whose result is used, or of several kinds on one groupshared variable, so that the order does
	 * not depend on the machine. */
	bool bWaves = false;
	/** Groups run one after the other, by z, y and x: needed for atomics on buffers and textures whose order is
	 * visible.
	 * */
	bool bInOrder = false;
	/** Variables whose memory only gets atomics of one kind that give one result in any order: the kind. */
	std::map<uint32_t, uint16_t> Commuting;
};

FSpirvGroupUse FindGroupUse(const FSpirvModule& Module);

/** Results of loads that follow a barrier, with no write into groupshared memory between: all threads of the group read
 * the same from one place. */
std::set<uint32_t> FindSettledReads(const FSpirvModule& Module);

/** A barrier in the region or in one inside; null: there is none. */
const FSpirvInstruction* FindBarrier(const FSpirvModule& Module, const FStructRegion& Region);

/** The variable that a pointer of an atomic operation leads to; null: none. */
const FSpirvVariable* FindAtomicVariable(const FSpirvModule& Module, const FSpirvInstruction& Atomic,
	const std::unordered_map<uint32_t, const FSpirvInstruction*>& Pointers);

} // namespace Drydock
