// Counts texture samples statically: the "taps" of a pass where its control flow does not depend on the pixel.
#include "SpirvImageOperands.h"
#include "SpirvReflect.h"
#include "SpirvTurns.h"

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <unordered_map>

namespace Drydock
{

namespace
{

using namespace Spirv;

constexpr int32_t Unknown = -1;
constexpr int64_t MaxSamples = 1 << 30;

int32_t Add(int32_t A, int32_t B)
{
	return A == Unknown || B == Unknown || int64_t(A) + B > MaxSamples ? Unknown : A + B;
}

/** Some threads may not reach the region's end. Inside: labels that jumps may go to without leaving. */
bool LeavesEarly(const FStructRegion& Region, std::initializer_list<uint32_t> Inside = {})
{
	return Region.bEnds || Region.bDiscards ||
		   std::ranges::any_of(Region.Jumps,
			   [&Inside](const FStructJump& Jump) { return std::ranges::find(Inside, Jump.To) == Inside.end(); });
}

/** Each region is counted once, whoever asks how often. */
class FCounter
{
public:
	explicit FCounter(const FSpirvModule& InModule)
		: Module(InModule)
		, Turns(InModule)
	{
	}

	int32_t Count(const FStructRegion& Region)
	{
		const auto Known = Counts.find(&Region);
		if (Known != Counts.end())
		{
			return Known->second;
		}
		int32_t Sum = 0;
		bool bSomeLeft = false; // threads that skip what follows
		for (const FStructNode& Node : Region.Nodes)
		{
			const int32_t Samples = Count(Node);
			Sum = bSomeLeft && Samples != 0 ? Unknown : Add(Sum, Samples);
			for (const FStructRegion& Inner : Node.Regions)
			{
				bSomeLeft = bSomeLeft || LeavesEarly(Inner, {Node.Merge, Node.Continue});
			}
			bSomeLeft = bSomeLeft || (Node.Kind == EStructNode::Block && Discards(Node.Label));
		}
		Counts.emplace(&Region, Sum);
		return Sum;
	}

private:
	int32_t Count(const FStructNode& Node);
	int32_t CountBlock(uint32_t Label) const;
	int32_t CountLoop(const FStructNode& Node);
	/** The block calls a function that discards. */
	bool Discards(uint32_t Label) const
	{
		const std::vector<FSpirvInstruction>& Instructions = Module.GetBlock(Label).Instructions;
		return std::ranges::any_of(
			Instructions, [](const FSpirvInstruction& I) { return I.Op == OpFunctionCall || I.Op == OpDemote; });
	}

	const FSpirvModule& Module;
	const FSpirvTurns Turns;
	std::unordered_map<const FStructRegion*, int32_t> Counts;
};

int32_t FCounter::CountBlock(uint32_t Label) const
{
	int32_t Samples = 0;
	for (const FSpirvInstruction& I : Module.GetBlock(Label).Instructions)
	{
		Samples += IsSpirvSample(I.Op) || I.Op == OpImageFetch;
	}
	return Samples;
}

int32_t FCounter::CountLoop(const FStructNode& Node)
{
	const int32_t Once = Add(Count(Node.Regions[0]), Count(Node.Regions[1]));
	if (Once == 0)
	{
		return 0;
	}
	// The header's own exit is the If that the body starts with; every other way out makes the count unknown.
	const FStructRegion& Body = Node.Regions[0];
	if (Body.Nodes.size() < 2 || Body.Nodes[1].Kind != EStructNode::If || LeavesEarly(Body.Nodes[1].Regions[0]))
	{
		return Unknown;
	}
	const std::optional<int64_t> NumTurns = Turns.Find(Node.Label);
	const int32_t Inside = Add(Count(Body.Nodes[1].Regions[0]), Count(Node.Regions[1]));
	return !NumTurns || Inside == Unknown || *NumTurns * Inside > MaxSamples ? Unknown : int32_t(*NumTurns) * Inside;
}

int32_t FCounter::Count(const FStructNode& Node)
{
	switch (Node.Kind)
	{
	case EStructNode::Block:
		return CountBlock(Node.Label);
	case EStructNode::If:
	case EStructNode::Switch:
	{
		const int32_t First = Count(Node.Regions[0]);
		return std::ranges::all_of(
				   Node.Regions, [this, First](const FStructRegion& Region) { return Count(Region) == First; })
				   ? First
				   : Unknown;
	}
	case EStructNode::Loop:
		return CountLoop(Node);
	default:
		return 0;
	}
}

} // namespace

int32_t CountStaticSamples(const FSpirvModule& Module, const FSpirvStructure& Structure)
{
	return FCounter(Module).Count(Structure.Root);
}

} // namespace Drydock
