// Places transient resources in the heap, first fit.
#include "RenderGraphAlias.h"

#include <algorithm>
#include <numeric>

namespace Drydock
{

namespace
{

struct FBlock
{
	uint64_t Begin;
	uint64_t End;
	int32_t Last;
};

/** The lowest gap of at least Bytes between blocks sorted by Begin. */
uint64_t FindGap(const std::vector<FBlock>& Blocks, uint64_t Bytes)
{
	uint64_t Offset = 0;
	for (const FBlock& Block : Blocks)
	{
		if (Block.Begin >= Offset + Bytes)
		{
			break;
		}
		Offset = std::max(Offset, Block.End);
	}
	return Offset;
}

} // namespace

FRDGHeapLayout PlaceInHeap(const std::vector<FRDGHeapRequest>& Requests)
{
	std::vector<size_t> Order(Requests.size());
	std::iota(Order.begin(), Order.end(), size_t(0));
	std::stable_sort(
		Order.begin(), Order.end(), [&](size_t A, size_t B) { return Requests[A].First < Requests[B].First; });

	FRDGHeapLayout Layout;
	Layout.Offsets.assign(Requests.size(), -1);
	std::vector<FBlock> Blocks; // alive at the current pass, sorted by Begin
	for (const size_t Index : Order)
	{
		const FRDGHeapRequest& Request = Requests[Index];
		if (Request.First < 0)
		{
			continue;
		}
		std::erase_if(Blocks, [&](const FBlock& Block) { return Block.Last < Request.First; });
		const uint64_t Bytes = (Request.Bytes + GRDGHeapAlignment - 1) / GRDGHeapAlignment * GRDGHeapAlignment;
		const FBlock Block{FindGap(Blocks, Bytes), FindGap(Blocks, Bytes) + Bytes, Request.Last};
		Blocks.insert(std::upper_bound(Blocks.begin(), Blocks.end(), Block,
						  [](const FBlock& A, const FBlock& B) { return A.Begin < B.Begin; }),
			Block);
		Layout.Offsets[Index] = int64_t(Block.Begin);
		Layout.PeakBytes = std::max(Layout.PeakBytes, Block.End);
		Layout.WithoutAliasingBytes += Bytes;
	}
	return Layout;
}

} // namespace Drydock
