// Places each resource in the transient heap. Resources are placed in the order of their first pass, each at the lowest
// offset that no resource alive at the same time covers (first fit). The heap is one block of the peak size. (The
// engine's transient allocator works over pages of heaps instead.)
#pragma once

#include "DrydockAPI.h"

#include <cstdint>
#include <vector>

namespace Drydock
{

struct FRDGHeapRequest
{
	uint64_t Bytes = 0;
	int32_t First = -1; // first and last pass that hold it, inclusive; First < 0: not in the heap
	int32_t Last = -1;
};

struct FRDGHeapLayout
{
	std::vector<int64_t> Offsets;      // by request, multiples of the alignment; -1: not in the heap
	uint64_t PeakBytes = 0;            // size of the heap
	uint64_t WithoutAliasingBytes = 0; // the same requests side by side
};

constexpr uint64_t GRDGHeapAlignment = 64;

DRYDOCK_API FRDGHeapLayout PlaceInHeap(const std::vector<FRDGHeapRequest>& Requests);

} // namespace Drydock
