// Emits barriers and atomics. Lanes change memory one after the other, the first one first.
#include "SpirvEmitter.h"

namespace Drydock
{

using namespace Spirv;

namespace
{

std::string GetOperation(uint16_t Op, bool bWide)
{
	const std::string Signed = bWide ? "<int64_t>" : "<int32_t>";
	const std::string Unsigned = bWide ? "<uint64_t>" : "<uint32_t>";
	return Op == OpAtomicLoad || Op == OpAtomicOr          ? "FAtomicOr"
		   : Op == OpAtomicStore || Op == OpAtomicExchange ? "FAtomicExchange"
		   : Op == OpAtomicCompareExchange                 ? "FAtomicCompareExchange"
		   : Op == OpAtomicSMin                            ? "FAtomicMin" + Signed
		   : Op == OpAtomicUMin                            ? "FAtomicMin" + Unsigned
		   : Op == OpAtomicSMax                            ? "FAtomicMax" + Signed
		   : Op == OpAtomicUMax                            ? "FAtomicMax" + Unsigned
		   : Op == OpAtomicAnd                             ? "FAtomicAnd"
		   : Op == OpAtomicXor                             ? "FAtomicXor"
														   : "FAtomicAdd";
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
		return std::string("AtomicBytes<uint") + (GetSpirvBytes(Module.GetType(Place.Type).Kind) == 8 ? "64" : "32") +
			   "_t>(g" + std::to_string(Place.Variable->Id) + ", " + (bVarying ? Offset : "U(" + Offset + ")") + ")";
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
		Handles += std::string("\tTTileAtomics<") + GetOperation(Kind->second, false) + ", N> " + Name + "(g" + Id +
				   ", " + (bTyped ? "HoldsWords(g" + Id + ".Storage)" : "true") + ");\n";
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
	const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
	const bool bWide = GetSpirvBytes(Module.GetType(Pointer.Element).Kind) == 8;
	const ESpirvType Bits = bWide ? ESpirvType::Ulong : Uint;
	const auto Operand = [this, &I, Bits](size_t Index)
	{
		return UseAs(Scalar(I.Operands[Index], 0), Bits, true);
	};
	const auto Constant = [this, Bits](uint64_t Value)
	{
		return UseAs(Literal(Bits, Value), Bits, true);
	};
	const bool bCompares = I.Op == OpAtomicCompareExchange;
	const std::string Value = I.Op == OpAtomicLoad         ? Constant(0)
							  : I.Op == OpAtomicIIncrement ? Constant(1)
							  : I.Op == OpAtomicIDecrement ? Constant(bWide ? ~uint64_t(0) : ~0u)
							  : I.Op == OpAtomicISub       ? Constant(0) + " - " + Operand(3)
														   : Operand(bCompares ? 4 : 3);
	const std::string Tile = bWide ? std::string() : TileAtomics(I);
	const std::string Text =
		!Tile.empty() ? Tile + ".Apply(" + GetStoreMask() + ", " + AtomicPlace(I) + ", " + Value + ")"
					  : "Atomic<" + GetOperation(I.Op, bWide) + ">(" + GetStoreMask() + ", " + AtomicPlace(I) + ", " +
							Value + ", " + (bCompares ? Operand(5) : Constant(0)) + ")";
	const auto Uses = NumUses.find(I.Result);
	if (I.Result && Uses != NumUses.end())
	{
		Define(I.Result, 0, {Text, Bits, true, -1});
	}
	else
	{
		Line(Text + ";");
	}
	Line(std::string("CountLanesOf(Args, &FKernelCounters::Stores, ") + GetStoreMask() + ");");
	return true;
}

} // namespace Drydock
