// Keeps the one block of memory that the transient resources of all graphs share.
#include "RenderGraphHeap.h"

#include "DiagnosticList.h"
#include "HugePages.h"
#include "RenderGraphAlias.h"

#include <cstdlib>
#include <memory>

namespace Drydock
{

namespace
{

struct FFree
{
	void operator()(uint8* Memory) const { std::free(Memory); }
};

struct FHeap
{
	std::unique_ptr<uint8, FFree> Memory;
	uint64 Bytes = 0;
	bool bUsed = false;
};

FHeap& GetHeap()
{
	static FHeap Heap;
	return Heap;
}

} // namespace

uint8* ReserveTransientHeap(uint64 Bytes)
{
	FHeap& Heap = GetHeap();
	Heap.bUsed = true;
	if (Bytes > Heap.Bytes)
	{
		Heap.Memory.reset(); // first, so that both do not exist at once
		Heap.Bytes = 0;
		const uint64 Rounded = (Bytes + GRDGHeapAlignment - 1) / GRDGHeapAlignment * GRDGHeapAlignment;
		Heap.Memory.reset(static_cast<uint8*>(std::aligned_alloc(GRDGHeapAlignment, Rounded)));
		if (!Heap.Memory)
		{
			throw Drydock::MakeMemoryError("the transient textures of the graph", Rounded);
		}
		AskForHugePages(Heap.Memory.get(), Rounded);
		Heap.Bytes = Rounded;
	}
	return Heap.Memory.get();
}

void TickTransientHeap()
{
	FHeap& Heap = GetHeap();
	if (!Heap.bUsed)
	{
		Heap.Memory.reset();
		Heap.Bytes = 0;
	}
	Heap.bUsed = false;
}

} // namespace Drydock
