// Builds the tree of a shader's control flow from its merge instructions. Source: SPIR-V specification, section 2.11.
#include "SpirvStructure.h"

#include "SpirvLimits.h"

#include <algorithm>
#include <set>
#include <utility>

namespace Drydock
{

namespace
{

using namespace Spirv;

bool CallsDiscard(const FSpirvBlock& Block)
{
	return std::ranges::any_of(
		Block.Instructions, [](const FSpirvInstruction& I) { return I.Op == OpFunctionCall || I.Op == OpDemote; });
}

size_t GetWeight(const FSpirvModule& Module, const FSpirvBlock& Block)
{
	size_t Weight = 0;
	for (const FSpirvInstruction& I : Block.Instructions)
	{
		Weight += I.Op == OpStore ? Module.GetValueType(I.Operands[1]).NumScalars
				  : I.Result      ? Module.GetType(I.Type).NumScalars
								  : 1;
	}
	return Weight;
}

/** Fills in what is found from the innermost regions outwards. */
void FindExits(const FSpirvModule& Module, FStructRegion& Region)
{
	std::map<uint32_t, FStructJump> Jumps;
	const auto Add = [&Jumps](const FStructJump& Jump)
	{
		FStructJump& Known = Jumps.emplace(Jump.To, Jump).first->second;
		Known.bInnerLoop = Known.bInnerLoop || Jump.bInnerLoop;
		Known.bFallsThrough = Known.bFallsThrough || Jump.bFallsThrough;
	};
	for (FStructNode& Node : Region.Nodes)
	{
		Region.bEnds = Region.bEnds || Node.Kind == EStructNode::Return || Node.Kind == EStructNode::Kill;
		if (Node.Kind == EStructNode::Block)
		{
			Region.bDiscards = Region.bDiscards || CallsDiscard(Module.GetBlock(Node.Label));
			Node.Weight = GetWeight(Module, Module.GetBlock(Node.Label));
		}
		if (Node.Kind == EStructNode::Edge && Node.bJump)
		{
			Add({Node.To, false, false});
		}
		std::set<uint32_t> Cases;
		for (const FStructCase& Case : Node.Cases)
		{
			Cases.insert(Case.Label);
		}
		for (FStructRegion& Inner : Node.Regions)
		{
			FindExits(Module, Inner);
			Region.bEnds = Region.bEnds || Inner.bEnds;
			Region.bDiscards = Region.bDiscards || Inner.bDiscards;
			Node.Weight += Inner.Weight;
			for (FStructJump& Jump : Inner.Jumps)
			{
				Jump.bFallsThrough = Jump.bFallsThrough || Cases.count(Jump.To);
				if (Jump.To != Node.Merge && Jump.To != Node.Continue)
				{
					Add({Jump.To, Jump.bInnerLoop || Node.Kind == EStructNode::Loop, Jump.bFallsThrough});
				}
			}
		}
		Region.Weight += Node.Weight;
	}
	for (const auto& [Label, Jump] : Jumps)
	{
		Region.Jumps.push_back(Jump);
	}
}

/** The cases in the order in which the instruction names their labels; values that lead to one label are one case. */
std::vector<FStructCase> ListCases(const FSpirvInstruction& Switch)
{
	std::vector<FStructCase> Cases;
	const auto CaseOf = [&Cases](uint32_t Label) -> FStructCase&
	{
		const auto Known = std::ranges::find(Cases, Label, &FStructCase::Label);
		return Known == Cases.end() ? Cases.emplace_back(FStructCase{Label, {}, false}) : *Known;
	};
	CaseOf(Switch.Operands[1]).bDefault = true;
	for (size_t i = 2; i + 1 < Switch.Operands.size(); i += 2)
	{
		CaseOf(Switch.Operands[i + 1]).Values.push_back(Switch.Operands[i]);
	}
	return Cases;
}

/** A case of a switch with all that is in it. */
struct FBuiltCase
{
	FStructRegion Region;
	std::vector<size_t> FallsInto; // indices of other cases
};

/** The order in which a case that falls through comes before the one that it falls into; cases in a circle are left
 * out. */
std::vector<size_t> OrderCases(const std::vector<FBuiltCase>& Cases)
{
	std::vector<size_t> NumBefore(Cases.size(), 0);
	for (const FBuiltCase& Case : Cases)
	{
		for (const size_t Into : Case.FallsInto)
		{
			++NumBefore[Into];
		}
	}
	std::set<size_t> Ready; // the first of them comes next
	for (size_t i = 0; i < Cases.size(); ++i)
	{
		if (NumBefore[i] == 0)
		{
			Ready.insert(i);
		}
	}
	std::vector<size_t> Order;
	while (!Ready.empty())
	{
		Order.push_back(*Ready.begin());
		Ready.erase(Ready.begin());
		for (const size_t Into : Cases[Order.back()].FallsInto)
		{
			if (--NumBefore[Into] == 0)
			{
				Ready.insert(Into);
			}
		}
	}
	return Order;
}

class FBuilder
{
public:
	explicit FBuilder(const FSpirvModule& InModule)
		: Module(InModule)
	{
	}

	FSpirvStructure Build(uint32_t FirstBlock)
	{
		AddRegion(Result.Root, Module.Blocks.at(FirstBlock).Label, 0);
		FindExits(Module, Result.Root);
		return std::move(Result);
	}

private:
	void AddRegion(FStructRegion& Region, uint32_t Label, uint32_t Follow);
	/** Appends the block and its terminator; the label that the region goes on with, 0 at its end. */
	uint32_t AddBlock(FStructRegion& Region, uint32_t Label);
	uint32_t AddLoop(FStructRegion& Region, const FSpirvBlock& Header);
	uint32_t AddConditional(FStructRegion& Region, const FSpirvBlock& Block);
	uint32_t AddSwitch(FStructRegion& Region, const FSpirvBlock& Block);
	void CheckSwitch(const FSpirvBlock& Block) const;
	FBuiltCase BuildCase(const FSpirvBlock& Block, const std::vector<FStructCase>& Cases, size_t Index);
	/** The edge From -> To and, unless To is open, what follows there. */
	void AddBranch(FStructRegion& Region, uint32_t From, uint32_t To, uint32_t Follow);
	/** Only the edge; true when To is open, so that the region ends here. */
	bool AddEdge(FStructRegion& Region, uint32_t From, uint32_t To);

	bool IsOpen(uint32_t Label) const
	{
		return std::ranges::any_of(Open, [Label](const FOpenLabel& Entry) { return Entry.Label == Label; });
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
	if (++Nesting > SpirvLimits::MaxNesting)
	{
		Module.FailLimit(SpirvLimits::MaxNesting, "selections and loops inside each other",
			"calls are inlined, and a return from the middle of a function nests all that follows it",
			&Module.GetBlock(Label).Terminator());
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

void FBuilder::CheckSwitch(const FSpirvBlock& Block) const
{
	const FSpirvInstruction& Terminator = Block.Terminator();
	if (!Block.Merge || Block.IsLoopHeader() || IsOpen(Block.Merge))
	{
		Module.Fail("SPIR-V: a switch without a merge block of its own", &Terminator);
	}
	if (Open.size() + Terminator.Operands.size() / 2 > SpirvLimits::MaxOpenLabels)
	{
		Module.FailLimit(SpirvLimits::MaxOpenLabels, "cases in a switch and those around it",
			"read a table (a static const array, a buffer) instead", &Terminator);
	}
}

FBuiltCase FBuilder::BuildCase(const FSpirvBlock& Block, const std::vector<FStructCase>& Cases, size_t Index)
{
	const uint32_t Label = Cases[Index].Label;
	const std::set<uint32_t> ReachedBefore = std::exchange(Reached, {});
	FBuiltCase Built;
	Built.Region.Follow = Block.Merge;
	FStructNode Edge;
	Edge.Kind = EStructNode::Edge;
	Edge.From = Block.Label;
	Edge.To = Label;
	Built.Region.Nodes.push_back(std::move(Edge));
	if (Label == Block.Merge)
	{
		Reached.insert(Label);
	}
	else
	{
		AddRegion(Built.Region, Label, Block.Merge);
	}
	for (size_t i = 0; i < Cases.size(); ++i)
	{
		if (i != Index && Cases[i].Label != Block.Merge && Reached.count(Cases[i].Label))
		{
			Built.FallsInto.push_back(i);
		}
	}
	Reached.insert(ReachedBefore.begin(), ReachedBefore.end());
	return Built;
}

uint32_t FBuilder::AddSwitch(FStructRegion& Region, const FSpirvBlock& Block)
{
	CheckSwitch(Block);
	const FSpirvInstruction& Terminator = Block.Terminator();
	const std::vector<FStructCase> Cases = ListCases(Terminator);
	const size_t NumOpen = Open.size();
	Push({Block.Merge, 0, false});
	for (const FStructCase& Case : Cases)
	{
		if (Case.Label != Block.Merge)
		{
			Push({Case.Label, 0, false});
		}
	}
	Result.OpenLabels[Block.Label] = Open;
	std::vector<FBuiltCase> Built;
	for (size_t i = 0; i < Cases.size(); ++i)
	{
		Built.push_back(BuildCase(Block, Cases, i));
	}
	Pop(Open.size() - NumOpen);

	const std::vector<size_t> Order = OrderCases(Built);
	if (Order.size() < Cases.size())
	{
		Module.Fail("SPIR-V: the cases of a switch fall through in a circle", &Terminator);
	}
	FStructNode Node;
	Node.Kind = EStructNode::Switch;
	Node.Label = Block.Label;
	Node.Value = Terminator.Operands[0];
	Node.Merge = Block.Merge;
	for (const size_t Index : Order)
	{
		Node.Cases.push_back(Cases[Index]);
		Node.Regions.push_back(std::move(Built[Index].Region));
	}
	Region.Nodes.push_back(std::move(Node));
	return Reached.count(Block.Merge) ? Block.Merge : 0;
}

} // namespace

FSpirvStructure BuildSpirvStructure(const FSpirvModule& Module, uint32_t FirstBlock)
{
	return FBuilder(Module).Build(FirstBlock);
}

} // namespace Drydock
