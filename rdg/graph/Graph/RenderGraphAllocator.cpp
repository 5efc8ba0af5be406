// Allocates the memory that lives as long as its graph, in blocks.
#include "RenderGraphAllocator.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

FRDGAllocator::~FRDGAllocator()
{
	for (auto Destructor = Destructors.rbegin(); Destructor != Destructors.rend(); ++Destructor)
	{
		Destructor->Destroy(Destructor->Object);
	}
}

void* FRDGAllocator::Alloc(uint64 SizeInBytes, uint32 AlignInBytes)
{
	void* const Memory = AllocUninitialized(SizeInBytes, AlignInBytes);
	std::memset(Memory, 0, SizeInBytes);
	return Memory;
}

void* FRDGAllocator::AllocUninitialized(uint64 SizeInBytes, uint32 AlignInBytes)
{
	const auto Align = [AlignInBytes](uint8* Address)
	{
		return reinterpret_cast<uint8*>(
			(reinterpret_cast<uintptr_t>(Address) + AlignInBytes - 1) & ~uintptr_t(AlignInBytes - 1));
	};

	uint8* Memory = Align(Free);
	if (!Free || Memory > End || uint64(End - Memory) < SizeInBytes)
	{
		const uint64 Bytes = std::max(NextBlockSize, SizeInBytes + AlignInBytes);
		NextBlockSize = std::min(2 * NextBlockSize, LargestBlockSize);
		Blocks.push_back(std::make_unique_for_overwrite<uint8[]>(Bytes));
		Free = Blocks.back().get();
		End = Free + Bytes;
		AllocatedBytes += Bytes;
		Memory = Align(Free);
	}
	Free = Memory + SizeInBytes;
	return Memory;
}

} // namespace Drydock
