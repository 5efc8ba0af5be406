// Finds how often a loop runs, if it is for (i = A; i < B; i += C) with constants.
#include "SpirvTurns.h"

#include <algorithm>

namespace Drydock
{

namespace
{

using namespace Spirv;

constexpr int64_t MaxTurns = 1 << 20;

/** How often `for (i = Start; i OP End; i += Step)` runs; nothing when that is never decided by the condition. */
std::optional<int64_t> CountTurns(uint16_t Op, int64_t Start, int64_t End, int64_t Step)
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
	const int64_t Turns = Upwards > 0 ? (Distance + Upwards - 1) / Upwards : MaxTurns + 1;
	return Turns <= MaxTurns ? std::optional<int64_t>(Turns) : std::nullopt;
}

} // namespace

FSpirvTurns::FSpirvTurns(const FSpirvModule& InModule)
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

std::optional<int64_t> FSpirvTurns::Find(uint32_t Label) const
{
	const FSpirvBlock& Header = Module.GetBlock(Label);
	const FSpirvInstruction& Branch = Header.Terminator();
	if (Branch.Op != OpBranchConditional || Branch.Operands[2] != Header.Merge)
	{
		return {};
	}
	const auto Condition = Definitions.find(Branch.Operands[0]);
	if (Condition == Definitions.end() || Condition->second->Operands.size() != 2)
	{
		return {};
	}
	const FSpirvInstruction& Test = *Condition->second;
	const FSpirvConstant* const Bound = Module.FindConstant(Test.Operands[1]);
	// A phi of a loop around this one stands still in it.
	const auto Phi = std::find_if(Header.Instructions.begin(), Header.Instructions.end(),
		[&Test](const FSpirvInstruction& I) { return I.Op == OpPhi && I.Result == Test.Operands[0]; });
	if (Phi == Header.Instructions.end() || Phi->Operands.size() != 4 || !Bound)
	{
		return {};
	}
	const FSpirvConstant* Start = nullptr;
	std::optional<int64_t> Step;
	for (size_t i = 0; i < 4; i += 2)
	{
		const uint32_t Value = Phi->Operands[i];
		const auto Next = Definitions.find(Value);
		const bool bSteps = Next != Definitions.end() && (Next->second->Op == OpIAdd || Next->second->Op == OpISub) &&
							Next->second->Operands[0] == Phi->Result && Module.FindConstant(Next->second->Operands[1]);
		if (Module.FindConstant(Value))
		{
			Start = Module.FindConstant(Value);
		}
		else if (bSteps)
		{
			const int64_t By = int32_t(uint32_t(Module.GetConstantScalar(Next->second->Operands[1])));
			Step = Next->second->Op == OpISub ? -By : By;
		}
	}
	if (!Start || !Step || Module.GetScalarKind(Phi->Type, 0) == ESpirvType::None ||
		GetSpirvBytes(Module.GetScalarKind(Phi->Type, 0)) != sizeof(int32_t))
	{
		return {};
	}
	const bool bSigned = Test.Op == OpSLessThan || Test.Op == OpSLessThanEqual || Test.Op == OpSGreaterThan ||
						 Test.Op == OpSGreaterThanEqual;
	const auto Widen = [bSigned](uint64_t Bits)
	{
		return bSigned ? int64_t(int32_t(Bits)) : int64_t(uint32_t(Bits));
	};
	const int64_t First = Widen(Start->Scalars[0]);
	const std::optional<int64_t> Turns = CountTurns(Test.Op, First, Widen(Bound->Scalars[0]), *Step);
	// `uint i >= 0` and `i <= 2147483647` always hold: the number that would end the loop wraps around.
	const int64_t Last = First + Turns.value_or(0) * *Step;
	const bool bFits = bSigned ? Last >= INT32_MIN && Last <= INT32_MAX : Last >= 0 && Last <= int64_t(UINT32_MAX);
	return bFits ? Turns : std::nullopt;
}

} // namespace Drydock
