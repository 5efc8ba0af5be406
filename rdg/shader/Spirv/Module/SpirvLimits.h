// Limits the size of shaders. A larger shader is refused (DD6021) with shader, entry, line and limit, before a compiler
// is kept busy for minutes or a lane needs more stack than its thread has. All counts are those of the entry point
// after the front end has inlined every call.
#pragma once

#include <cstddef>
#include <cstdint>

namespace Drydock::SpirvLimits
{

/** Instructions of the entry point. The largest shipped shader has 741. */
constexpr size_t MaxInstructions = 50000;

/** Selections, switches and loops inside each other. A return from the middle of a function nests what follows it. */
constexpr int MaxNesting = 200;

/** Labels that control may jump to from one place: ends of selections and loops, cases of switches. */
constexpr size_t MaxOpenLabels = 1000;

/** Scalars (4 bytes) of one type: an array of 16,384 float4. */
constexpr uint32_t MaxTypeScalars = 1u << 16;

/** Scalars of all constants, of all types in a composite, of all results of instructions: what is kept in memory. */
constexpr size_t MaxConstantScalars = 1u << 22;
constexpr size_t MaxValueScalars = 1u << 20;

/** Bytes of arrays that one lane has at once: variables, and copies made where an array is passed by value. 16 lanes
 *  have 2 MiB of them, half of a worker thread's stack. */
constexpr uint32_t MaxArrayBytesPerLane = 128 * 1024;

/** Bytes of groupshared variables: Direct3D's limit. */
constexpr uint32_t MaxGroupsharedBytes = 32 * 1024;

/** Bytes of what the threads of a group keep from one barrier to the next. */
constexpr uint32_t MaxGroupBytes = 1024 * 1024;

/** Levels of types inside types. */
constexpr int MaxTypeDepth = 32;

/** Ids of a module. */
constexpr uint32_t MaxIds = 1u << 22;

/** Lines of the C++ text of one kernel: half a minute of the compiler. */
constexpr size_t MaxLines = 100000;

/** Kernels of more lines than these are cut into functions of LinesPerPart: compilers take time quadratic in the length
 *  of a function. */
constexpr size_t MaxLinesUncut = 4000;
constexpr size_t LinesPerPart = 1000;

/** Arrays of so many scalars are copied by a loop, not scalar by scalar; variables of so many are arrays in C++ too,
 * even where no index is computed. */
constexpr uint32_t MinLoopedCopy = 64;
constexpr uint32_t MinArrayScalars = 1024;

} // namespace Drydock::SpirvLimits
