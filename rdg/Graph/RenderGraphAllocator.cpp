// Allocates the memory that lives as long as its graph, in blocks.
#include "RenderGraphAllocator.h"

#include <algorithm>

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
	const auto Align = [AlignInBytes](uint8* Address)
	{
		return reinterpret_cast<uint8*>(
			(reinterpret_cast<uintptr_t>(Address) + AlignInBytes - 1) & ~uintptr_t(AlignInBytes - 1));
	};

	uint8* Memory = Align(Free);
	if (!Free || Memory > End || uint64(End - Memory) < SizeInBytes)
	{
		const uint64 Bytes = std::max(BlockSize, SizeInBytes + AlignInBytes);
		Blocks.push_back(std::make_unique<uint8[]>(Bytes)); // zeroed
		Free = Blocks.back().get();
		End = Free + Bytes;
		AllocatedBytes += Bytes;
		Memory = Align(Free);
	}
	Free = Memory + SizeInBytes;
	return Memory;
}

} // namespace Drydock
