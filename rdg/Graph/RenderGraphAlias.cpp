// Places transient resources in the heap, first fit.
#include "RenderGraphAlias.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>

namespace Drydock
{

namespace
{

/** What is free of the heap, which has no end here. Taking costs by the number of different sizes of gaps, which is
 * small; giving back by the logarithm of their number. */
class FFreeSpace
{
public:
	/** The lowest place with so much room. */
	uint64_t Take(uint64_t Bytes)
	{
		uint64_t Begin = Endless;
		for (auto Size = BeginsBySize.lower_bound(Bytes); Size != BeginsBySize.end(); ++Size)
		{
			Begin = std::min(Begin, *Size->second.begin());
		}
		const uint64_t End = Gaps.at(Begin);
		RemoveGap(Begin);
		AddGap(Begin + Bytes, End);
		return Begin;
	}

	/** It joins the gaps beside it. */
	void GiveBack(uint64_t Begin, uint64_t End)
	{
		const auto After = Gaps.find(End);
		if (After != Gaps.end())
		{
			End = After->second;
			RemoveGap(After->first);
		}
		const auto Next = Gaps.lower_bound(Begin);
		if (Next != Gaps.begin() && std::prev(Next)->second == Begin)
		{
			Begin = std::prev(Next)->first;
			RemoveGap(Begin);
		}
		AddGap(Begin, End);
	}

private:
	static constexpr uint64_t Endless = std::numeric_limits<uint64_t>::max();

	void AddGap(uint64_t Begin, uint64_t End)
	{
		if (Begin < End)
		{
			Gaps[Begin] = End;
			BeginsBySize[End - Begin].insert(Begin);
		}
	}

	void RemoveGap(uint64_t Begin)
	{
		const auto Gap = Gaps.find(Begin);
		const auto Size = BeginsBySize.find(Gap->second - Begin);
		Size->second.erase(Begin);
		if (Size->second.empty())
		{
			BeginsBySize.erase(Size);
		}
		Gaps.erase(Gap);
	}

	std::map<uint64_t, uint64_t> Gaps = {{0, Endless}}; // end by begin
	std::map<uint64_t, std::set<uint64_t>> BeginsBySize = {{Endless, {0}}};
};

/** In the heap up to and with a pass. */
struct FBlock
{
	int32_t Last;
	uint64_t Begin;
	uint64_t End;

	bool operator>(const FBlock& Other) const { return Last > Other.Last; }
};

} // namespace

FRDGHeapLayout PlaceInHeap(const std::vector<FRDGHeapRequest>& Requests)
{
	std::vector<size_t> Order(Requests.size());
	std::iota(Order.begin(), Order.end(), size_t(0));
	std::stable_sort(
		Order.begin(), Order.end(), [&](size_t A, size_t B) { return Requests[A].First < Requests[B].First; });

	FRDGHeapLayout Layout;
	Layout.Offsets.assign(Requests.size(), -1);
	FFreeSpace Free;
	std::priority_queue<FBlock, std::vector<FBlock>, std::greater<>> Alive; // the first to end on top
	for (const size_t Index : Order)
	{
		const FRDGHeapRequest& Request = Requests[Index];
		if (Request.First < 0)
		{
			continue;
		}
		for (; !Alive.empty() && Alive.top().Last < Request.First; Alive.pop())
		{
			Free.GiveBack(Alive.top().Begin, Alive.top().End);
		}
		const uint64_t Bytes = (Request.Bytes + GRDGHeapAlignment - 1) / GRDGHeapAlignment * GRDGHeapAlignment;
		const uint64_t Begin = Bytes > 0 ? Free.Take(Bytes) : 0;
		if (Bytes > 0)
		{
			Alive.push({Request.Last, Begin, Begin + Bytes});
		}
		Layout.Offsets[Index] = int64_t(Begin);
		Layout.PeakBytes = std::max(Layout.PeakBytes, Begin + Bytes);
		Layout.WithoutAliasingBytes += Bytes;
	}
	return Layout;
}

} // namespace Drydock
