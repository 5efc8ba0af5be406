// Builds the tree of a shader's control flow from its merge instructions. Source: SPIR-V specification, section 2.11.
#include "SpirvStructure.h"

#include <algorithm>
#include <set>
#include <utility>

namespace Drydock
{

namespace
{

using namespace Spirv;

constexpr int MaxNesting = 200;

class FBuilder
{
public:
	explicit FBuilder(const FSpirvModule& InModule)
		: Module(InModule)
	{
	}

	FSpirvStructure Build()
	{
		AddRegion(Result.Root, Module.Blocks[0].Label, 0);
		return std::move(Result);
	}

private:
	void AddRegion(FStructRegion& Region, uint32_t Label, uint32_t Follow);
	/** Appends the block and its terminator; the label that the region goes on with, 0 at its end. */
	uint32_t AddBlock(FStructRegion& Region, uint32_t Label);
	uint32_t AddLoop(FStructRegion& Region, const FSpirvBlock& Header);
	uint32_t AddConditional(FStructRegion& Region, const FSpirvBlock& Block);
	uint32_t AddSwitch(FStructRegion& Region, const FSpirvBlock& Block);
	/** The edge From -> To and, unless To is open, what follows there. */
	void AddBranch(FStructRegion& Region, uint32_t From, uint32_t To, uint32_t Follow);
	/** Only the edge; true when To is open, so that the region ends here. */
	bool AddEdge(FStructRegion& Region, uint32_t From, uint32_t To);

	bool IsOpen(uint32_t Label) const
	{
		return std::any_of(Open.begin(), Open.end(), [Label](const FOpenLabel& Entry) { return Entry.Label == Label; });
	}
	void Push(FOpenLabel Entry) { Open.push_back(Entry); }
	void Pop(size_t Count) { Open.resize(Open.size() - Count); }

	const FSpirvModule& Module;
	FSpirvStructure Result;
	std::vector<FOpenLabel> Open;
	std::vector<uint32_t> Loops;
	std::set<uint32_t> Visited;
	std::set<uint32_t> Reached; // open labels that some edge goes to
	uint32_t HeaderBeingBuilt = 0;
	int Nesting = 0;
};

void FBuilder::AddRegion(FStructRegion& Region, uint32_t Label, uint32_t Follow)
{
	if (++Nesting > MaxNesting)
	{
		Module.Fail("SPIR-V: control flow is nested too deeply");
	}
	Region.Follow = Follow;
	while (Label)
	{
		const FSpirvBlock& Block = Module.GetBlock(Label);
		Label = Block.IsLoopHeader() && HeaderBeingBuilt != Label ? AddLoop(Region, Block) : AddBlock(Region, Label);
	}
	--Nesting;
}

bool FBuilder::AddEdge(FStructRegion& Region, uint32_t From, uint32_t To)
{
	const bool bOpen = IsOpen(To);
	FStructNode Node;
	Node.Kind = EStructNode::Edge;
	Node.From = From;
	Node.To = To;
	Node.bJump = bOpen && To != Region.Follow;
	Region.Nodes.push_back(std::move(Node));
	if (bOpen)
	{
		Reached.insert(To);
	}
	return bOpen;
}

void FBuilder::AddBranch(FStructRegion& Region, uint32_t From, uint32_t To, uint32_t Follow)
{
	Region.Follow = Follow;
	if (!AddEdge(Region, From, To))
	{
		AddRegion(Region, To, Follow);
	}
}

uint32_t FBuilder::AddBlock(FStructRegion& Region, uint32_t Label)
{
	const FSpirvBlock& Block = Module.GetBlock(Label);
	if (!Visited.insert(Label).second)
	{
		Module.Fail(
			"SPIR-V: control flow is not structured (block " + std::to_string(Label) + " is entered from two places)",
			&Block.Terminator());
	}
	HeaderBeingBuilt = 0;
	FStructNode Node;
	Node.Kind = EStructNode::Block;
	Node.Label = Label;
	Region.Nodes.push_back(Node);
	Result.OpenLabels[Label] = Open;
	Result.Loops[Label] = Loops;

	const FSpirvInstruction& Terminator = Block.Terminator();
	switch (Terminator.Op)
	{
	case OpBranch:
		return AddEdge(Region, Label, Terminator.Operands[0]) ? 0 : Terminator.Operands[0];
	case OpBranchConditional:
		if (Terminator.Operands[1] == Terminator.Operands[2])
		{
			return AddEdge(Region, Label, Terminator.Operands[1]) ? 0 : Terminator.Operands[1];
		}
		return AddConditional(Region, Block);
	case OpSwitch:
		return AddSwitch(Region, Block);
	default:
		Node.Kind = Terminator.Op == OpKill ? EStructNode::Kill : EStructNode::Return;
		Region.Nodes.push_back(std::move(Node));
		return 0;
	}
}

uint32_t FBuilder::AddLoop(FStructRegion& Region, const FSpirvBlock& Header)
{
	const uint32_t Label = Header.Label;
	const bool bOwnContinue = Header.Continue == Label; // a loop of one block
	FStructNode Node;
	Node.Kind = EStructNode::Loop;
	Node.Label = Label;
	Node.Merge = Header.Merge;
	Node.Continue = Header.Continue;
	Node.Regions.resize(2);
	if (IsOpen(Header.Merge))
	{
		Module.Fail("SPIR-V: two constructs share a merge block", &Header.Terminator());
	}
	Loops.push_back(Label);
	Push({Header.Merge, Label, true});
	Push({Header.Continue, Label, false});
	HeaderBeingBuilt = Label;
	AddRegion(Node.Regions[0], Label, Header.Continue);
	Pop(1);
	if (!bOwnContinue && Reached.count(Header.Continue))
	{
		Push({Label, Label, false});
		AddRegion(Node.Regions[1], Header.Continue, Label);
		Pop(1);
	}
	Pop(1);
	Loops.pop_back();
	Region.Nodes.push_back(std::move(Node));
	return Reached.count(Header.Merge) ? Header.Merge : 0;
}

uint32_t FBuilder::AddConditional(FStructRegion& Region, const FSpirvBlock& Block)
{
	const std::vector<uint32_t>& Operands = Block.Terminator().Operands;
	FStructNode Node;
	Node.Kind = EStructNode::If;
	Node.Label = Block.Label;
	Node.Value = Operands[0];
	Node.Merge = Block.IsLoopHeader() ? 0 : Block.Merge;
	Node.Regions.resize(2);
	const bool bOwnMerge = Node.Merge && !IsOpen(Node.Merge);
	const uint32_t Follow = bOwnMerge ? Node.Merge : Region.Follow;
	if (bOwnMerge)
	{
		Push({Node.Merge, 0, false});
		Result.OpenLabels[Block.Label] = Open;
	}
	else
	{
		Node.Merge = 0;
	}
	AddBranch(Node.Regions[0], Block.Label, Operands[1], Follow);
	AddBranch(Node.Regions[1], Block.Label, Operands[2], Follow);
	if (bOwnMerge)
	{
		Pop(1);
	}
	const uint32_t Next = bOwnMerge && Reached.count(Node.Merge) ? Node.Merge : 0;
	Region.Nodes.push_back(std::move(Node));
	return Next;
}

uint32_t FBuilder::AddSwitch(FStructRegion& Region, const FSpirvBlock& Block)
{
	const FSpirvInstruction& Terminator = Block.Terminator();
	if (!Block.Merge || Block.IsLoopHeader() || IsOpen(Block.Merge))
	{
		Module.Fail("SPIR-V: a switch without a merge block of its own", &Terminator);
	}
	FStructNode Node;
	Node.Kind = EStructNode::Switch;
	Node.Label = Block.Label;
	Node.Value = Terminator.Operands[0];
	Node.Merge = Block.Merge;

	const auto CaseOf = [&Node](uint32_t Label) -> FStructCase&
	{
		const auto Known = std::find_if(
			Node.Cases.begin(), Node.Cases.end(), [Label](const FStructCase& Case) { return Case.Label == Label; });
		if (Known != Node.Cases.end())
		{
			return *Known;
		}
		Node.Cases.push_back({Label, {}, false});
		return Node.Cases.back();
	};
	CaseOf(Terminator.Operands[1]).bDefault = true;
	for (size_t i = 2; i + 1 < Terminator.Operands.size(); i += 2)
	{
		CaseOf(Terminator.Operands[i + 1]).Values.push_back(Terminator.Operands[i]);
	}

	Push({Block.Merge, 0, false});
	size_t Pushed = 1;
	for (const FStructCase& Case : Node.Cases)
	{
		if (Case.Label != Block.Merge)
		{
			Push({Case.Label, 0, false});
			++Pushed;
		}
	}
	Result.OpenLabels[Block.Label] = Open;
	// A case that falls through must come before the one it falls into.
	std::vector<FStructRegion> Regions(Node.Cases.size());
	std::vector<std::set<uint32_t>> FallsInto(Node.Cases.size());
	for (size_t i = 0; i < Node.Cases.size(); ++i)
	{
		const uint32_t Label = Node.Cases[i].Label;
		const std::set<uint32_t> ReachedBefore = std::exchange(Reached, {});
		Regions[i].Follow = Block.Merge;
		FStructNode Edge;
		Edge.Kind = EStructNode::Edge;
		Edge.From = Block.Label;
		Edge.To = Label;
		Regions[i].Nodes.push_back(std::move(Edge));
		if (Label == Block.Merge)
		{
			Reached.insert(Label);
		}
		else
		{
			AddRegion(Regions[i], Label, Block.Merge);
		}
		FallsInto[i] = Reached;
		Reached.insert(ReachedBefore.begin(), ReachedBefore.end());
	}
	Pop(Pushed);

	std::vector<FStructCase> Ordered;
	std::vector<bool> Placed(Node.Cases.size(), false);
	while (Ordered.size() < Node.Cases.size())
	{
		const size_t Before = Ordered.size();
		for (size_t i = 0; i < Node.Cases.size(); ++i)
		{
			bool bReady = !Placed[i];
			for (size_t k = 0; bReady && k < Node.Cases.size(); ++k)
			{
				bReady = Placed[k] || k == i || Node.Cases[i].Label == Block.Merge ||
						 !FallsInto[k].count(Node.Cases[i].Label);
			}
			if (bReady)
			{
				Placed[i] = true;
				Ordered.push_back(Node.Cases[i]);
				Node.Regions.push_back(std::move(Regions[i]));
				break;
			}
		}
		if (Ordered.size() == Before)
		{
			Module.Fail("SPIR-V: the cases of a switch fall through in a circle", &Terminator);
		}
	}
	Node.Cases = std::move(Ordered);
	const uint32_t Next = Reached.count(Block.Merge) ? Block.Merge : 0;
	Region.Nodes.push_back(std::move(Node));
	return Next;
}

} // namespace

FSpirvStructure BuildSpirvStructure(const FSpirvModule& Module)
{
	return FBuilder(Module).Build();
}

} // namespace Drydock
