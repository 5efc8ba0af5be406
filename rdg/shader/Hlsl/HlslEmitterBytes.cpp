// Buffers of bytes: any type word by word, its members where C++ has them, matrices by rows. Bit fields of words.
#include "HlslEmitterImpl.h"

#include <utility>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr uint32_t EmitMaxByteScalars = 1024; // each is an instruction

} // namespace

/** (Address + Offset) >> Shift. */
uint32_t FEmitter::ByteIndex(uint32_t Address, uint32_t Offset, uint32_t Shift)
{
	const uint32_t Uint = Module.Uint();
	uint32_t Known = 0;
	if (Module.FindNumber(Address, Known))
	{
		return Module.Uint((Known + Offset) >> Shift);
	}
	const uint32_t At = Offset == 0 ? Address : Op(OpIAdd, Uint, {Address, Module.Uint(Offset)});
	return Op(OpShiftRightLogical, Uint, {At, Module.Uint(Shift)});
}

uint32_t FEmitter::WordPointer(FLeaf& Leaf, uint32_t Address, uint32_t Offset)
{
	const uint32_t Index = ByteIndex(Address, Offset, 2);
	return Op(OpAccessChain, Module.Pointer(StorageUniform, Module.Uint()), {IdOf(Leaf), Module.Int(0), Index});
}

uint32_t FEmitter::LoadByteScalar(FLeaf& Leaf, uint32_t Address, EScalar Scalar, uint32_t Offset)
{
	const uint32_t Uint = Module.Uint();
	const uint32_t Low = Op(OpLoad, Uint, {WordPointer(Leaf, Address, Offset)});
	const uint32_t Type = ScalarType(Scalar);
	switch (Scalar == EScalar::Bool ? 32 : Bits(Scalar))
	{
	case 64:
	{
		const uint32_t High = Op(OpLoad, Uint, {WordPointer(Leaf, Address, Offset + 4)});
		return Op(OpBitcast, Type, {Construct(VectorOf(EScalar::Uint, 2), {Low, High})});
	}
	case 16:
	{
		const uint32_t At = Op(OpIAdd, Uint, {Address, Module.Uint(Offset)});
		const uint32_t Half = Op(OpBitwiseAnd, Uint, {At, Module.Uint(2)});
		const uint32_t By = Op(OpShiftLeftLogical, Uint, {Half, Module.Uint(3)});
		const uint32_t Part = Op(OpShiftRightLogical, Uint, {Low, By});
		const uint32_t Short = Op(OpUConvert, ScalarType(EScalar::Ushort), {Part});
		return Scalar == EScalar::Ushort ? Short : Op(OpBitcast, Type, {Short});
	}
	default:
		return Scalar == EScalar::Bool ? ConvertScalars(Low, EScalar::Uint, EScalar::Bool, 1)
			   : Type == Uint          ? Low
									   : Op(OpBitcast, Type, {Low});
	}
}

void FEmitter::StoreByteScalar(FLeaf& Leaf, uint32_t Address, uint32_t Id, EScalar Scalar, uint32_t Offset)
{
	const uint32_t Uint = Module.Uint();
	const uint32_t Type = ScalarType(Scalar);
	switch (Scalar == EScalar::Bool ? 32 : Bits(Scalar))
	{
	case 64:
	{
		const uint32_t Pair = Op(OpBitcast, VectorOf(EScalar::Uint, 2), {Id});
		Do(OpStore, {WordPointer(Leaf, Address, Offset), ExtractAt(Pair, Uint, {0})});
		Do(OpStore, {WordPointer(Leaf, Address, Offset + 4), ExtractAt(Pair, Uint, {1})});
		return;
	}
	case 16: // by itself: another thread may have the other half of the word
	{
		const uint32_t Short = ScalarType(EScalar::Ushort);
		const uint32_t Written = Type == Short ? Id : Op(OpBitcast, Short, {Id});
		const uint32_t Pointer = Op(OpAccessChain, Module.Pointer(StorageUniform, Short),
			{ViewOf(Leaf, "Shorts", EScalar::Ushort), Module.Int(0), ByteIndex(Address, Offset, 1)});
		Do(OpStore, {Pointer, Written});
		return;
	}
	default:
	{
		const uint32_t Written = Scalar == EScalar::Bool ? ConvertScalars(Id, EScalar::Bool, EScalar::Uint, 1)
								 : Type == Uint          ? Id
														 : Op(OpBitcast, Uint, {Id});
		Do(OpStore, {WordPointer(Leaf, Address, Offset), Written});
		return;
	}
	}
}

uint32_t FEmitter::LoadBytes(FLeaf& Leaf, uint32_t Address, const FType* Type, uint32_t Offset)
{
	FWords Parts;
	if (Type->IsArray())
	{
		const uint32_t Stride = GetLayout(Types, Type, ELayout::Structured).Stride;
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			Parts.push_back(LoadBytes(Leaf, Address, Type->Element, Offset + i * Stride));
		}
	}
	else if (Type->IsStruct())
	{
		const std::vector<uint32_t> Offsets = GetOffsets(Types, *Type->Struct, ELayout::Structured);
		for (size_t i = 0; i < Offsets.size(); ++i)
		{
			if (CountScalars(Type->Struct->Members[i].Type) > 0)
			{
				Parts.push_back(LoadBytes(Leaf, Address, Type->Struct->Members[i].Type, Offset + Offsets[i]));
			}
		}
	}
	else
	{
		const uint32_t Bytes = Type->Scalar == EScalar::Bool ? 4 : Bits(Type->Scalar) / 8;
		for (uint32_t r = 0; r < Type->Rows && Type->IsMatrix(); ++r)
		{
			Parts.push_back(LoadBytes(Leaf, Address, RowOf(Type), Offset + r * Type->Columns * Bytes));
		}
		for (uint32_t c = 0; c < Type->Columns && !Type->IsMatrix(); ++c)
		{
			Parts.push_back(LoadByteScalar(Leaf, Address, Type->Scalar, Offset + c * Bytes));
		}
		if (!Type->IsMatrix() && Parts.size() == 1)
		{
			return Parts[0];
		}
	}
	return Construct(TypeOf(Type), Parts);
}

void FEmitter::StoreBytes(FLeaf& Leaf, uint32_t Address, const FPart& Whole, uint32_t Offset)
{
	const FType* const Type = Whole.Type;
	if (Type->IsArray())
	{
		const uint32_t Stride = GetLayout(Types, Type, ELayout::Structured).Stride;
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			const uint32_t Part = ExtractAt(Whole.Id, TypeOf(Type->Element), {i});
			StoreBytes(Leaf, Address, {Part, Type->Element}, Offset + i * Stride);
		}
		return;
	}
	if (Type->IsStruct())
	{
		const std::vector<uint32_t> Offsets = GetOffsets(Types, *Type->Struct, ELayout::Structured);
		for (uint32_t i = 0, Index = 0; i < Offsets.size(); ++i)
		{
			const FType* const Member = Type->Struct->Members[i].Type;
			if (CountScalars(Member) > 0)
			{
				const uint32_t Part = ExtractAt(Whole.Id, TypeOf(Member), {Index++});
				StoreBytes(Leaf, Address, {Part, Member}, Offset + Offsets[i]);
			}
		}
		return;
	}
	const uint32_t Bytes = Type->Scalar == EScalar::Bool ? 4 : Bits(Type->Scalar) / 8;
	for (uint32_t i = 0; i < Type->NumComponents(); ++i)
	{
		StoreByteScalar(Leaf, Address, Extract(Whole.Id, Type, i), Type->Scalar, Offset + i * Bytes);
	}
}

uint32_t FEmitter::ByteMethod(const FValue& Node)
{
	const std::string_view Name = Node.Name;
	const FObjectSet Set = Object(*Node.Operands[0]);
	const FValue& Where = *Node.Operands.at(1);
	const uint32_t Address = Convert(Value(Where), Where.Type, Types.Scalar(EScalar::Uint));
	const bool bLoad = Name.starts_with("Load");
	const FType* const Type = bLoad ? Node.Type : Node.Operands.back()->Type;
	if ((bLoad || Name.starts_with("Store")) && CountScalars(Type) > EmitMaxByteScalars)
	{
		Fail(Node.Place, GetName(Type) + " has more than " + std::to_string(EmitMaxByteScalars) +
							 " numbers; read and write a large type of bytes in a loop");
	}
	if (bLoad)
	{
		if (Node.Operands.size() > 2)
		{
			Fail(Node.Place, "no buffer is tiled here, so that a load has no status; leave that argument out");
		}
		return ForEach(Set, TypeOf(Type), [&](FLeaf& Leaf) { return LoadBytes(Leaf, Address, Type, 0); });
	}
	if (Name.starts_with("Store"))
	{
		const FPart Written = {Value(*Node.Operands.back()), Type};
		return ForEach(Set, 0,
			[&](FLeaf& Leaf)
			{
				StoreBytes(Leaf, Address, Written, 0);
				return 0u;
			});
	}
	std::string_view Plain = Name;
	const bool bWide = Plain.ends_with("64");
	for (const std::string_view End : {"64", "FloatBitwise", "Float"})
	{
		Plain = Plain.ends_with(End) ? Plain.substr(0, Plain.size() - End.size()) : Plain;
	}
	FTarget Target;
	Target.Type = Types.Scalar(bWide ? EScalar::Ulong : EScalar::Uint);
	Target.Storage = StorageUniform;
	Target.Layout = ELayout::Structured;
	Target.Chain = {Module.Int(0), ByteIndex(Address, 0, bWide ? 3 : 2)};
	const ENumber Kind = KindOf(Node.Operands.at(2)->Type->Scalar);
	if (bWide && Set.Leaves.size() > 1)
	{
		Fail(Node.Place, std::string(Name) + " works on one buffer, which is known here");
	}
	Target.Base = bWide ? ViewOf(*Set.Leaves.at(0), "Longs", EScalar::Ulong) : 0;
	Target.Objects = Set;
	AtomicOn(Target, Plain, Kind, Node, 2);
	return 0;
}

/** A bit field of a uint, with its sign. */
uint32_t FEmitter::BitsOf(uint32_t Id, const FBits& Bits)
{
	const uint32_t Type = ScalarType(EScalar::Uint);
	const uint32_t High = Op(OpShiftLeftLogical, Type, {Id, Module.Int(32 - Bits.First - Bits.Count)});
	const uint32_t Down = Module.Int(32 - Bits.Count);
	return Bits.bSigned ? Op(OpShiftRightArithmetic, ScalarType(EScalar::Int),
							  {Bitwise(High, EScalar::Uint, EScalar::Int), Down})
						: Op(OpShiftRightLogical, Type, {High, Down});
}

/** A bit field is read, changed and written. */
void FEmitter::StoreBits(FTarget Target, uint32_t Id)
{
	const FBits Bits = std::exchange(Target.Bits, {});
	const uint32_t Mask = (~0u >> (32 - Bits.Count)) << Bits.First;
	const uint32_t Type = ScalarType(EScalar::Uint);
	const uint32_t New = Bits.bSigned ? Bitwise(Id, EScalar::Int, EScalar::Uint) : Id;
	const uint32_t Moved = Op(OpShiftLeftLogical, Type, {New, Module.Int(Bits.First)});
	const uint32_t Kept = Op(OpBitwiseAnd, Type, {Load(Target), ScalarConstant(EScalar::Uint, ~Mask)});
	const uint32_t Set = Op(OpBitwiseAnd, Type, {Moved, ScalarConstant(EScalar::Uint, Mask)});
	Store(Target, Op(OpBitwiseOr, Type, {Kept, Set}));
}

} // namespace Drydock::Hlsl
