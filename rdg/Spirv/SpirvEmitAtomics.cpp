// Emits barriers and atomics. Lanes change memory one after the other, the first one first.
#include "SpirvEmitter.h"

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr ESpirvType Int = ESpirvType::Int;
constexpr ESpirvType Uint = ESpirvType::Uint;

const char* GetOperation(uint16_t Op)
{
	switch (Op)
	{
	case OpAtomicLoad:
		return "FAtomicOr";
	case OpAtomicStore:
	case OpAtomicExchange:
		return "FAtomicExchange";
	case OpAtomicCompareExchange:
		return "FAtomicCompareExchange";
	case OpAtomicSMin:
		return "FAtomicMin<int32_t>";
	case OpAtomicUMin:
		return "FAtomicMin<uint32_t>";
	case OpAtomicSMax:
		return "FAtomicMax<int32_t>";
	case OpAtomicUMax:
		return "FAtomicMax<uint32_t>";
	case OpAtomicAnd:
		return "FAtomicAnd";
	case OpAtomicOr:
		return "FAtomicOr";
	case OpAtomicXor:
		return "FAtomicXor";
	default:
		return "FAtomicAdd";
	}
}

} // namespace

std::string FSpirvEmitter::AtomicPlace(const FSpirvInstruction& I)
{
	const auto Texel = Definitions.find(I.Operands[0]);
	if (Texel != Definitions.end() && Texel->second->Op == OpImageTexelPointer)
	{
		const FSpirvInstruction& Pointer = *Texel->second;
		const std::string Handle = HandleOf(Pointer.Operands[0]);
		const FSpirvType& Type = Module.GetType(Module.FindVariable(Pointer.Operands[0])->Type);
		if (Type.Dim == DimBuffer)
		{
			return "AtomicElement(" + Handle + ", " + UseAs(Scalar(Pointer.Operands[1], 0), Uint, true) + ")";
		}
		const uint32_t Count = Type.Dim == Dim3D || Type.bArrayed ? 3 : 2;
		return "AtomicTexel(" + Handle + ", " + Coordinates(Pointer, 1, Count, false, 0) + ")";
	}
	const FSpirvPlace Place = Resolve(I.Operands[0]);
	if (Place.bBytes)
	{
		const FSpirvType& Type = Module.GetType(Place.Variable->Type);
		if (!Type.bBufferBlock || Type.Members[0].bNonWritable)
		{
			Module.Fail("Interlocked* on '" + Place.Variable->Name + "', which is read-only", &I);
		}
		bool bVarying = false;
		const std::string Offset = BufferOffsetText(Place, 0, bVarying);
		return "AtomicBytes(g" + std::to_string(Place.Variable->Id) + ", " + (bVarying ? Offset : "U(" + Offset + ")") +
			   ")";
	}
	bool bVarying = false;
	const std::string Index = SharedIndexText(Place, Place.Offset, bVarying);
	return "AtomicShared(" + LocalArray(*Place.Variable, Module.GetType(Place.Type).Kind) + ", " +
		   (bVarying ? Index : "I(" + Index + ")") + ")";
}

/** The name of what gathers the tile's atomics on a buffer whose order nobody sees; empty: there is none. */
std::string FSpirvEmitter::TileAtomics(const FSpirvInstruction& I)
{
	const auto Pointer = Definitions.find(I.Operands[0]);
	const FSpirvVariable* const Variable =
		Module.FindVariable(Pointer == Definitions.end() ? I.Operands[0] : Pointer->second->Operands[0]);
	const auto Kind = GroupUse.Commuting.find(Variable ? Variable->Id : 0);
	const FSpirvType* const Type = Variable ? &Module.GetType(Variable->Type) : nullptr;
	const bool bTyped = Type && Type->Kind == ESpirvType::Image;
	if (Kind == GroupUse.Commuting.end() || (bTyped && Type->Dim != DimBuffer))
	{
		return {};
	}
	const std::string Id = std::to_string(Variable->Id);
	const std::string Name = "p" + Id;
	if (Declared.insert(Name).second)
	{
		Handles += std::string("\tTTileAtomics<") + GetOperation(Kind->second) + ", N> " + Name + "(g" + Id + ", " +
				   (bTyped ? "g" + Id + ".Storage == ETexelStorage::R32_UINT" : "true") + ");\n";
		EndText += "\t" + Name + ".Finish();\n";
	}
	return Name;
}

bool FSpirvEmitter::EmitGroups(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpControlBarrier:
		CloseSegment();
		return true;
	case OpMemoryBarrier:     // what a thread writes is there for the next that looks
	case OpImageTexelPointer: // resolved where it is used
		return true;
	default:
		break;
	}
	if (!IsSpirvAtomic(I.Op))
	{
		return false;
	}
	const auto Operand = [this, &I](size_t Index)
	{
		return UseAs(Scalar(I.Operands[Index], 0), Uint, true);
	};
	const bool bCompares = I.Op == OpAtomicCompareExchange;
	const std::string Value = I.Op == OpAtomicLoad         ? "U(0u)"
							  : I.Op == OpAtomicIIncrement ? "U(1u)"
							  : I.Op == OpAtomicIDecrement ? "U(4294967295u)"
							  : I.Op == OpAtomicISub       ? "U(0u) - " + Operand(3)
														   : Operand(bCompares ? 4 : 3);
	const std::string Tile = TileAtomics(I);
	const std::string Text = !Tile.empty()
								 ? Tile + ".Apply(" + GetStoreMask() + ", " + AtomicPlace(I) + ", " + Value + ")"
								 : std::string("Atomic<") + GetOperation(I.Op) + ">(" + GetStoreMask() + ", " +
									   AtomicPlace(I) + ", " + Value + ", " + (bCompares ? Operand(5) : "U(0u)") + ")";
	const auto Uses = NumUses.find(I.Result);
	if (I.Result && Uses != NumUses.end())
	{
		Define(I.Result, 0, {Text, Uint, true, -1});
	}
	else
	{
		Line(Text + ";");
	}
	Line(std::string("CountLanesOf(Args, &FKernelCounters::Stores, ") + GetStoreMask() + ");");
	return true;
}

} // namespace Drydock
