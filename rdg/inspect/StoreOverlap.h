// Finds threads of one dispatch that store different values to one texel or element: the value that remains is chance.
#pragma once

#include "SpirvProgram.h"

#include <array>
#include <string>

namespace Drydock
{

/** A store of a thread to a texture or buffer. */
struct FThreadStore
{
	uint32_t Variable = 0;          // index into the module's
	std::array<int32_t, 3> Texel{}; // of a buffer: the byte or element
	std::array<int32_t, 3> Thread{};
	uint64_t Value = 0; // a hash of its bits
	const FSpirvStep* Step = nullptr;
};

struct FStoreOverlap
{
	FThreadStore Before; // the first store there, by the order of threads
	FThreadStore Store;  // of another thread, with another value
};

/** "(3, 4)", "(3, 4, 1)" */
std::string ListThread(const std::array<int32_t, 3>& At);

/** Stores: by the order of threads. Overlaps come in that order, too; of each store at most one. */
std::vector<FStoreOverlap> FindOverlaps(const std::vector<FThreadStore>& Stores);

/** "a store to Out at (3, 4), where thread (2, 4) stores another value in line 40" */
std::string DescribeOverlap(const FSpirvModule& Module, const FStoreOverlap& Overlap);

} // namespace Drydock
