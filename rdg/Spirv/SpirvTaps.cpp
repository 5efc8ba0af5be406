// Counts texture samples statically: the "taps" of a pass where its control flow does not depend on the pixel.
#include "SpirvImageOperands.h"
#include "SpirvReflect.h"

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
constexpr int64_t MaxTrips = 1 << 20;
constexpr int64_t MaxSamples = 1 << 30;

int32_t Add(int32_t A, int32_t B)
{
	return A == Unknown || B == Unknown || int64_t(A) + B > MaxSamples ? Unknown : A + B;
}

/** Some threads may not reach the region's end. Inside: labels that jumps may go to without leaving. */
bool LeavesEarly(const FStructRegion& Region, std::initializer_list<uint32_t> Inside = {})
{
	return Region.bEnds || Region.bDiscards ||
		   std::any_of(Region.Jumps.begin(), Region.Jumps.end(),
			   [&Inside](const FStructJump& Jump)
			   { return std::find(Inside.begin(), Inside.end(), Jump.To) == Inside.end(); });
}

/** How often `for (i = Start; i OP End; i += Step)` runs; nothing when that is never decided by the condition. */
std::optional<int64_t> CountTrips(uint16_t Op, int64_t Start, int64_t End, int64_t Step)
{
	// Towards a bound that is not reached itself, in steps upwards.
	int64_t Distance = 0;
	int64_t Upwards = Step;
	switch (Op)
	{
	case OpSLessThan:
	case OpULessThan:
		Distance = End - Start;
		break;
	case OpSLessThanEqual:
	case OpULessThanEqual:
		Distance = End - Start + 1;
		break;
	case OpSGreaterThan:
	case OpUGreaterThan:
		Distance = Start - End;
		Upwards = -Step;
		break;
	case OpSGreaterThanEqual:
	case OpUGreaterThanEqual:
		Distance = Start - End + 1;
		Upwards = -Step;
		break;
	case OpINotEqual:
		if (Start == End)
		{
			return 0;
		}
		if (Step == 0 || (End - Start) % Step != 0)
		{
			return {};
		}
		Distance = Step > 0 ? End - Start : Start - End;
		Upwards = Step > 0 ? Step : -Step;
		if (Distance < 0)
		{
			return {};
		}
		break;
	default:
		return {};
	}
	if (Distance <= 0)
	{
		return 0;
	}
	const int64_t Trips = Upwards > 0 ? (Distance + Upwards - 1) / Upwards : MaxTrips + 1;
	return Trips <= MaxTrips ? std::optional<int64_t>(Trips) : std::nullopt;
}

/** Each region is counted once, whoever asks how often. */
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
		return std::any_of(Instructions.begin(), Instructions.end(),
			[](const FSpirvInstruction& I) { return I.Op == OpFunctionCall; });
	}
	std::optional<int64_t> GetTrips(const FStructNode& Loop) const;

	const FSpirvModule& Module;
	std::unordered_map<uint32_t, const FSpirvInstruction*> Definitions;
	std::unordered_map<const FStructRegion*, int32_t> Counts;
};

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
	return CountTrips(Test.Op, Widen(Start->Scalars[0]), Widen(Bound->Scalars[0]), *Step);
}

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
	const std::optional<int64_t> Trips = GetTrips(Node);
	const int32_t Inside = Add(Count(Body.Nodes[1].Regions[0]), Count(Node.Regions[1]));
	return !Trips || Inside == Unknown || *Trips * Inside > MaxSamples ? Unknown : int32_t(*Trips) * Inside;
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
		return std::all_of(Node.Regions.begin(), Node.Regions.end(),
				   [this, First](const FStructRegion& Region) { return Count(Region) == First; })
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
