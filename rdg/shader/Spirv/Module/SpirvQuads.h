// Runs pixel shaders by quads: two columns and two rows of pixels, from an even column and row on, whose four threads
// reach a derivative together. Threads of pixels that are not drawn, or are discarded, run on as helpers: they store
// and count nothing.
#pragma once

#include "SpirvModule.h"

#include <set>

namespace Drydock
{

/** Threads of a quad; by rows. */
constexpr uint32_t GQuadSize = 4;

/** Textures, as variables, that a pixel shader samples without saying at which level: of those that have mips it
 * depends on derivatives. */
std::set<uint32_t> FindImplicitSamples(const FSpirvModule& Module);

/** Makes a pixel shader one whose pixels run by quads: bQuads, a LocalSize of 2 x 2, and a pixel that a condition
 *  discards goes on as a helper behind it. Done once at most; of other shaders nothing. */
DRYDOCK_API void RunByQuads(FSpirvModule& Module);
/** The same where pixels have to know their neighbours whatever textures are bound: derivatives, quad operations. */
void RunByQuadsWhereUsed(FSpirvModule& Module);

/** Whether threads of a stage can do together what this is: waves in compute shaders, quads in pixel shaders. */
bool RunsTogether(uint32_t ExecutionModel, uint16_t Op);

/** The threads of a quad wait for each other at this instruction of a module with bQuads. */
bool IsQuadStep(const FSpirvInstruction& I);

} // namespace Drydock
