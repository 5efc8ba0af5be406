// Counts texture samples statically: the "taps" of a pass where its control flow does not depend on the pixel.
#include "SpirvReflect.h"

#include <algorithm>
#include <optional>
#include <set>

namespace Drydock
{

namespace
{

using namespace Spirv;

constexpr int32_t Unknown = -1;
constexpr int64_t MaxTrips = 1 << 20;

int32_t Add(int32_t A, int32_t B)
{
	return A == Unknown || B == Unknown ? Unknown : A + B;
}

class FCounter
{
public:
	explicit FCounter(const FSpirvModule& InModule)
		: Module(InModule)
	{
		for (const FSpirvBlock& Block : Module.Blocks)
		{
			for (const FSpirvInstruction& I : Block.Instructions)
			{
				if (I.Result)
				{
					Definitions[I.Result] = &I;
				}
			}
		}
	}

	int32_t Count(const FStructRegion& Region)
	{
		int32_t Sum = 0;
		bool bSomeLeft = false; // threads that skip what follows
		for (const FStructNode& Node : Region.Nodes)
		{
			const int32_t Samples = Count(Node);
			Sum = Add(Sum, bSomeLeft && Samples != 0 ? Unknown : Samples);
			for (const FStructRegion& Inner : Node.Regions)
			{
				bSomeLeft = bSomeLeft || LeavesEarly(Inner, {Node.Merge, Node.Continue});
			}
			bSomeLeft = bSomeLeft || (Node.Kind == EStructNode::Block && Discards(Node.Label));
		}
		return Sum;
	}

private:
	int32_t Count(const FStructNode& Node);
	/** The block calls a function that discards. */
	bool Discards(uint32_t Label) const
	{
		const std::vector<FSpirvInstruction>& Instructions = Module.GetBlock(Label).Instructions;
		return std::any_of(Instructions.begin(), Instructions.end(),
			[](const FSpirvInstruction& I) { return I.Op == OpFunctionCall; });
	}
	std::optional<int64_t> GetTrips(const FStructNode& Loop) const;
	/** Some threads may not reach the region's end. Inside: labels that jumps may go to without leaving. */
	bool LeavesEarly(const FStructRegion& Region, const std::set<uint32_t>& Inside = {}) const;

	const FSpirvModule& Module;
	std::map<uint32_t, const FSpirvInstruction*> Definitions;
};

bool FCounter::LeavesEarly(const FStructRegion& Region, const std::set<uint32_t>& Inside) const
{
	for (const FStructNode& Node : Region.Nodes)
	{
		if ((Node.Kind == EStructNode::Edge && Node.bJump && !Inside.count(Node.To)) ||
			(Node.Kind == EStructNode::Block && Discards(Node.Label)) || Node.Kind == EStructNode::Return ||
			Node.Kind == EStructNode::Kill)
		{
			return true;
		}
		std::set<uint32_t> Deeper = Inside;
		Deeper.insert({Node.Merge, Node.Continue});
		for (const FStructRegion& Inner : Node.Regions)
		{
			if (LeavesEarly(Inner, Deeper))
			{
				return true;
			}
		}
	}
	return false;
}

/** for (i = A; i < B; i += C) with constants, left by its condition only. */
std::optional<int64_t> FCounter::GetTrips(const FStructNode& Loop) const
{
	const FSpirvBlock& Header = Module.GetBlock(Loop.Label);
	const FSpirvInstruction& Branch = Header.Terminator();
	if (Branch.Op != OpBranchConditional || Branch.Operands[2] != Loop.Merge)
	{
		return {};
	}
	const auto Condition = Definitions.find(Branch.Operands[0]);
	if (Condition == Definitions.end() || Condition->second->Operands.size() != 2)
	{
		return {};
	}
	const FSpirvInstruction& Test = *Condition->second;
	const auto Phi = Definitions.find(Test.Operands[0]);
	const FSpirvConstant* Bound = Module.FindConstant(Test.Operands[1]);
	if (Phi == Definitions.end() || Phi->second->Op != OpPhi || Phi->second->Operands.size() != 4 || !Bound)
	{
		return {};
	}
	const FSpirvConstant* Start = nullptr;
	std::optional<int64_t> Step;
	for (size_t i = 0; i < 4; i += 2)
	{
		const uint32_t Value = Phi->second->Operands[i];
		const auto Next = Definitions.find(Value);
		if (Module.FindConstant(Value))
		{
			Start = Module.FindConstant(Value);
		}
		else if (Next != Definitions.end() && Next->second->Op == OpIAdd && Next->second->Operands[0] == Phi->first &&
				 Module.FindConstant(Next->second->Operands[1]))
		{
			Step = int32_t(Module.GetConstantScalar(Next->second->Operands[1]));
		}
	}
	if (!Start || !Step)
	{
		return {};
	}
	const bool bSigned = Test.Op == OpSLessThan || Test.Op == OpSLessThanEqual || Test.Op == OpSGreaterThan ||
						 Test.Op == OpSGreaterThanEqual;
	const auto Widen = [bSigned](uint32_t Bits)
	{
		return bSigned ? int64_t(int32_t(Bits)) : int64_t(Bits);
	};
	const int64_t End = Widen(Bound->Scalars[0]);
	int64_t Trips = 0;
	for (int64_t i = Widen(Start->Scalars[0]); Trips <= MaxTrips; i += *Step, ++Trips)
	{
		bool bGoOn = false;
		// clang-format off
		switch (Test.Op)
		{
		case OpSLessThan: case OpULessThan: bGoOn = i < End; break;
		case OpSLessThanEqual: case OpULessThanEqual: bGoOn = i <= End; break;
		case OpSGreaterThan: case OpUGreaterThan: bGoOn = i > End; break;
		case OpSGreaterThanEqual: case OpUGreaterThanEqual: bGoOn = i >= End; break;
		case OpINotEqual: bGoOn = i != End; break;
		default: return {};
		}
		// clang-format on
		if (!bGoOn)
		{
			return Trips;
		}
	}
	return {};
}

int32_t FCounter::Count(const FStructNode& Node)
{
	switch (Node.Kind)
	{
	case EStructNode::Block:
	{
		int32_t Samples = 0;
		for (const FSpirvInstruction& I : Module.GetBlock(Node.Label).Instructions)
		{
			const bool bSample = I.Op == OpImageSampleExplicitLod || I.Op == OpImageSampleImplicitLod ||
								 I.Op == OpImageGather || I.Op == OpImageFetch;
			Samples += bSample;
		}
		return Samples;
	}
	case EStructNode::If:
	case EStructNode::Switch:
	{
		int32_t Same = Count(Node.Regions[0]);
		for (const FStructRegion& Region : Node.Regions)
		{
			Same = Count(Region) == Same ? Same : Unknown;
		}
		return Same;
	}
	case EStructNode::Loop:
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
		const std::optional<int64_t> Trips = GetTrips(Node);
		const int32_t Inside = Add(Count(Body.Nodes[1].Regions[0]), Count(Node.Regions[1]));
		return !Trips || Inside == Unknown || *Trips * Inside > (1 << 30) ? Unknown : int32_t(*Trips) * Inside;
	}
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
