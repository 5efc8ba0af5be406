// Walks the flow of a shader and remembers where its threads part.
#include "SpirvBarriers.h"

#include "SpirvGroups.h"

#include <algorithm>
#include <set>

namespace Drydock
{

namespace
{

using namespace Spirv;

class FBarrierWalk
{
public:
	FBarrierWalk(const FSpirvModule& InModule, const FSpirvUniformity& InUniformity)
		: Module(InModule)
		, Uniformity(InUniformity)
	{
	}

	/** Parting: of the threads that run here; null: all of the group do. */
	void Visit(const FStructRegion& Region, const FSpirvInstruction* Parting)
	{
		for (const FStructNode& Node : Region.Nodes)
		{
			if (Node.Kind == EStructNode::Block && Parting)
			{
				for (const FSpirvInstruction& I : Module.GetBlock(Node.Label).Instructions)
				{
					if (I.Op == OpControlBarrier)
					{
						Found.push_back({&I, Parting});
					}
				}
			}
			const FSpirvInstruction* const Left = Parting ? Parting : FindWayOut(Node, {});
			// Who left a loop misses its next turn.
			const FSpirvInstruction* const Turn =
				Node.Kind == EStructNode::Loop ? FindWayOutInside(Node, {Node.Continue, Node.Label}) : nullptr;
			const FSpirvInstruction* const Own = Turn ? Turn : GetDivision(Node);
			for (const FStructRegion& Inner : Node.Regions)
			{
				Visit(Inner, Parting ? Parting : Own);
			}
			Parting = Left;
		}
	}

	std::vector<FDivergentBarrier> Found;

private:
	/** The branch of a node that threads take differently; null: they do not. */
	const FSpirvInstruction* GetDivision(const FStructNode& Node) const
	{
		const bool bSelects = Node.Kind == EStructNode::If || Node.Kind == EStructNode::Switch;
		const bool bDivides = (bSelects && Uniformity.IsAnyVarying(Node.Value)) ||
							  (Node.Kind == EStructNode::Loop && Uniformity.IsDivergentLoop(Node.Label));
		return bDivides ? &Module.GetBlock(Node.Label).Terminator() : nullptr;
	}

	/** The branch by which some threads leave past what follows the node; null: they all go on there. Inside: labels
	 * that are not past it. */
	const FSpirvInstruction* FindWayOut(const FStructNode& Node, std::set<uint32_t> Inside) const
	{
		Inside.insert({Node.Merge, Node.Continue, Node.Label});
		const FSpirvInstruction* const Inner = FindWayOutInside(Node, Inside);
		const bool bLeaves = std::ranges::any_of(Node.Regions,
			[&Inside](const FStructRegion& Region)
			{
				return Region.bEnds || std::ranges::any_of(Region.Jumps, [&Inside](const FStructJump& Jump)
										   { return !Jump.bFallsThrough && !Inside.count(Jump.To); });
			});
		return Inner ? Inner : bLeaves ? GetDivision(Node) : nullptr;
	}

	/** The same of what is in the node. */
	const FSpirvInstruction* FindWayOutInside(const FStructNode& Node, const std::set<uint32_t>& Inside) const
	{
		const FSpirvInstruction* Found = nullptr;
		for (const FStructRegion& Region : Node.Regions)
		{
			for (const FStructNode& Inner : Region.Nodes)
			{
				Found = Found ? Found : FindWayOut(Inner, Inside);
			}
		}
		return Found;
	}

	const FSpirvModule& Module;
	const FSpirvUniformity& Uniformity;
};

} // namespace

std::vector<FDivergentBarrier> FindDivergentBarriers(
	const FSpirvModule& Module, const FSpirvStructure& Structure, const FSpirvUniformity& Uniformity)
{
	FBarrierWalk Walk(Module, Uniformity);
	if (FindBarrier(Module, Structure.Root))
	{
		Walk.Visit(Structure.Root, nullptr);
	}
	return std::move(Walk.Found);
}

} // namespace Drydock
