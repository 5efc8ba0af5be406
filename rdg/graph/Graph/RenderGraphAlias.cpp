// Places transient resources in the heap, first fit.
#include "RenderGraphAlias.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace Drydock
{

namespace
{

/** The free parts of the heap, which has no end here: gaps in a tree by their place, each node of which knows the
 * largest gap below it. Every operation takes the logarithm of their number. */
class FFreeSpace
{
public:
	FFreeSpace() { Root = AddNode(0, std::numeric_limits<uint64_t>::max()); }

	/** The lowest place with so much room. */
	uint64_t Take(uint64_t Bytes)
	{
		uint64_t Begin = 0;
		Root = TakeFrom(Root, Bytes, Begin);
		return Begin;
	}

	/** It joins the gaps beside it. */
	void GiveBack(uint64_t Begin, uint64_t End)
	{
		auto [Before, After] = Split(Root, Begin);
		if (const int32_t Last = FindLast(Before); Last >= 0 && Nodes[size_t(Last)].End == Begin)
		{
			Begin = Nodes[size_t(Last)].Begin;
			Before = Split(Before, Begin).first;
			FreeNodes.push_back(Last);
		}
		if (const int32_t First = FindFirst(After); First >= 0 && Nodes[size_t(First)].Begin == End)
		{
			End = Nodes[size_t(First)].End;
			After = Split(After, Nodes[size_t(First)].Begin + 1).second;
			FreeNodes.push_back(First);
		}
		Root = Join(Join(Before, AddNode(Begin, End)), After);
	}

private:
	struct FNode
	{
		uint64_t Begin;
		uint64_t End;
		uint64_t Largest;  // of its own gap and those below it
		uint32_t Priority; // above those below it: with numbers that look random the tree is flat (a treap)
		int32_t Left = -1;
		int32_t Right = -1;
	};

	int32_t AddNode(uint64_t Begin, uint64_t End)
	{
		Random = Random * 1664525u + 1013904223u;
		const FNode Node = {Begin, End, End - Begin, Random};
		if (FreeNodes.empty())
		{
			Nodes.push_back(Node);
			return int32_t(Nodes.size()) - 1;
		}
		const int32_t Index = FreeNodes.back();
		FreeNodes.pop_back();
		Nodes[size_t(Index)] = Node;
		return Index;
	}

	uint64_t GetLargest(int32_t Node) const { return Node < 0 ? 0 : Nodes[size_t(Node)].Largest; }

	void Update(FNode& Node) const
	{
		Node.Largest = std::max({Node.End - Node.Begin, GetLargest(Node.Left), GetLargest(Node.Right)});
	}

	/** Returns what the tree is without that room. */
	int32_t TakeFrom(int32_t Tree, uint64_t Bytes, uint64_t& OutBegin)
	{
		FNode& Node = Nodes[size_t(Tree)];
		if (GetLargest(Node.Left) >= Bytes)
		{
			Node.Left = TakeFrom(Node.Left, Bytes, OutBegin);
		}
		else if (Node.End - Node.Begin >= Bytes)
		{
			OutBegin = Node.Begin;
			Node.Begin += Bytes;
			if (Node.Begin == Node.End)
			{
				FreeNodes.push_back(Tree);
				return Join(Node.Left, Node.Right);
			}
		}
		else
		{
			Node.Right = TakeFrom(Node.Right, Bytes, OutBegin);
		}
		Update(Node);
		return Tree;
	}

	/** Gaps that begin before Place, and the others. */
	std::pair<int32_t, int32_t> Split(int32_t Tree, uint64_t Place)
	{
		if (Tree < 0)
		{
			return {-1, -1};
		}
		FNode& Node = Nodes[size_t(Tree)];
		if (Node.Begin < Place)
		{
			const auto [Before, After] = Split(Node.Right, Place);
			Node.Right = Before;
			Update(Node);
			return {Tree, After};
		}
		const auto [Before, After] = Split(Node.Left, Place);
		Node.Left = After;
		Update(Node);
		return {Before, Tree};
	}

	/** All gaps of Before lie before those of After. */
	int32_t Join(int32_t Before, int32_t After)
	{
		if (Before < 0 || After < 0)
		{
			return std::max(Before, After);
		}
		FNode& Lower = Nodes[size_t(Before)];
		FNode& Upper = Nodes[size_t(After)];
		if (Lower.Priority > Upper.Priority)
		{
			Lower.Right = Join(Lower.Right, After);
			Update(Lower);
			return Before;
		}
		Upper.Left = Join(Before, Upper.Left);
		Update(Upper);
		return After;
	}

	int32_t FindFirst(int32_t Tree) const
	{
		while (Tree >= 0 && Nodes[size_t(Tree)].Left >= 0)
		{
			Tree = Nodes[size_t(Tree)].Left;
		}
		return Tree;
	}

	int32_t FindLast(int32_t Tree) const
	{
		while (Tree >= 0 && Nodes[size_t(Tree)].Right >= 0)
		{
			Tree = Nodes[size_t(Tree)].Right;
		}
		return Tree;
	}

	std::vector<FNode> Nodes;
	std::vector<int32_t> FreeNodes; // places in Nodes
	int32_t Root = -1;
	uint32_t Random = 1;
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
	std::ranges::stable_sort(Order, [&](size_t A, size_t B) { return Requests[A].First < Requests[B].First; });

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
