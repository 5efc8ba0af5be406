// Types of HLSL as types of SPIR-V: as values, and as they lie in buffers; constants.
#include "HlslEmitterImpl.h"

#include "HlslConstants.h"

#include <bit>

namespace Drydock::Hlsl
{

using namespace Spirv;

uint32_t FEmitter::Bits(EScalar Scalar) const
{
	return IsLiteral(Scalar) ? 32 : Types.GetBits(Scalar);
}

ENumber FEmitter::KindOf(EScalar Scalar)
{
	return Scalar == EScalar::Bool ? ENumber::Bool
		   : IsReal(Scalar)        ? ENumber::Real
		   : IsUnsigned(Scalar)    ? ENumber::Unsigned
								   : ENumber::Signed;
}

uint32_t FEmitter::ScalarType(EScalar Scalar)
{
	const ENumber Kind = KindOf(Scalar);
	if (Kind == ENumber::Bool)
	{
		return Module.Bool();
	}
	const uint32_t Width = Bits(Scalar);
	const bool bReal = Kind == ENumber::Real;
	if (Width != 32)
	{
		Module.Capability(Width == 16 ? (bReal ? CapabilityFloat16 : CapabilityInt16)
									  : (bReal ? CapabilityFloat64 : CapabilityInt64));
	}
	return bReal ? Module.Intern(OpTypeFloat, {Width})
				 : Module.Intern(OpTypeInt, {Width, Kind == ENumber::Signed ? 1u : 0u});
}

/** A matrix of SPIR-V; all others are arrays of their rows. */
bool FEmitter::IsRealMatrix(const FType* Type)
{
	return Type->IsMatrix() && IsReal(Type->Scalar) && Type->Rows >= 2 && Type->Columns >= 2;
}

/** In memory an array of its columns. */
bool FEmitter::IsTurned(const FType* Type)
{
	return Type->IsMatrix() && !IsRealMatrix(Type) && Type->Order == EOrder::Column;
}

uint32_t FEmitter::TypeOf(const FType* Type)
{
	switch (Type->Kind)
	{
	case EType::Numeric:
	{
		const uint32_t Row = VectorOf(Type->Scalar, Type->Columns);
		return !Type->IsMatrix()    ? Row
			   : IsRealMatrix(Type) ? Module.Intern(OpTypeMatrix, {Row, Type->Rows})
									: Module.Intern(OpTypeArray, {Row, Module.Uint(Type->Rows)});
	}
	case EType::Array:
	{
		const uint32_t Element = TypeOf(Type->Element);
		return Module.Intern(OpTypeArray, {Element, Module.Uint(std::max(Type->Count, 1u))});
	}
	case EType::Struct:
	{
		const auto Known = Structs.find(Type->Struct);
		if (Known != Structs.end())
		{
			return Known->second;
		}
		FWords Members;
		std::vector<std::string_view> Names;
		for (const FMember& Member : Type->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				Members.push_back(TypeOf(Member.Type));
				Names.push_back(Member.Name);
			}
		}
		const uint32_t Id = Module.MakeType(OpTypeStruct, Members);
		Module.Name(Id, Type->Struct->Name);
		for (size_t i = 0; i < Names.size(); ++i)
		{
			Module.MemberName(Id, uint32_t(i), Names[i]);
		}
		return Structs[Type->Struct] = Id;
	}
	default:
		return Module.Intern(OpTypeVoid, {});
	}
}

/** Members without numbers are not in SPIR-V's struct. */
uint32_t FEmitter::MemberIndex(const FStructType& Struct, uint32_t Member)
{
	uint32_t Index = 0;
	for (uint32_t i = 0; i < Member; ++i)
	{
		Index += CountScalars(Struct.Members[i].Type) > 0 ? 1 : 0;
	}
	return Index;
}

uint32_t FEmitter::MemoryArray(uint32_t Element, uint32_t Count, uint32_t Stride, ELayout Layout)
{
	uint32_t& Id = MemoryArrays[{Element, Count, Stride, uint32_t(Layout)}];
	if (Id == 0)
	{
		Id = Count == 0 ? Module.MakeType(OpTypeRuntimeArray, {Element})
						: Module.MakeType(OpTypeArray, {Element, Module.Uint(Count)});
		Module.Decorate(Id, DecorationArrayStride, {Stride});
	}
	return Id;
}

void FEmitter::DecorateMemory(uint32_t Struct, uint32_t Index, const FType* Type, uint32_t Offset, ELayout Layout)
{
	Module.DecorateMember(Struct, Index, DecorationOffset, {Offset});
	while (Type->IsArray())
	{
		Type = Type->Element;
	}
	if (IsRealMatrix(Type))
	{
		// A row of HLSL is a column of SPIR-V.
		Module.DecorateMember(
			Struct, Index, Type->Order == EOrder::Column ? uint32_t(DecorationRowMajor) : uint32_t(DecorationColMajor));
		Module.DecorateMember(Struct, Index, DecorationMatrixStride, {GetLayout(Types, Type, Layout).Stride});
	}
}

uint32_t FEmitter::MemoryType(const FType* Type, ELayout Layout)
{
	const auto Known = MemoryTypes.find({Type, Layout});
	if (Known != MemoryTypes.end())
	{
		return Known->second;
	}
	uint32_t Id = 0;
	if (Type->IsArray())
	{
		const uint32_t Element = MemoryType(Type->Element, Layout);
		Id = MemoryArray(Element, std::max(Type->Count, 1u), GetLayout(Types, Type, Layout).Stride, Layout);
	}
	else if (Type->IsStruct())
	{
		FWords Members;
		std::vector<size_t> Of;
		for (size_t i = 0; i < Type->Struct->Members.size(); ++i)
		{
			const FType* const Member = Type->Struct->Members[i].Type;
			if (CountScalars(Member) > 0)
			{
				Members.push_back(MemoryType(Member, Layout));
				Of.push_back(i);
			}
		}
		uint32_t& Struct = MemoryStructs[{Type->Struct, Layout}];
		if (Struct == 0)
		{
			Struct = Module.MakeType(OpTypeStruct, Members);
			Module.Name(Struct, Type->Struct->Name);
			const std::vector<uint32_t> Offsets = GetOffsets(Types, *Type->Struct, Layout);
			for (uint32_t i = 0; i < Of.size(); ++i)
			{
				const FMember& Member = Type->Struct->Members[Of[i]];
				Module.MemberName(Struct, i, Member.Name);
				DecorateMemory(Struct, i, Member.Type, Offsets[Of[i]], Layout);
			}
		}
		Id = Struct;
	}
	else if (Type->IsMatrix() && !IsRealMatrix(Type))
	{
		const bool bTurned = IsTurned(Type);
		const EScalar Scalar = Type->Scalar == EScalar::Bool ? EScalar::Uint : Type->Scalar;
		Id = MemoryArray(VectorOf(Scalar, bTurned ? Type->Rows : Type->Columns), bTurned ? Type->Columns : Type->Rows,
			GetLayout(Types, Type, Layout).Stride, Layout);
	}
	else if (Type->IsNumeric() && Type->Scalar == EScalar::Bool)
	{
		Id = VectorOf(EScalar::Uint, Type->Columns);
	}
	else
	{
		Id = TypeOf(Type);
	}
	if (Layout == ELayout::Structured && Type->IsNumeric() && Bits(Type->Scalar) == 16)
	{
		Module.Extension("SPV_KHR_16bit_storage");
		Module.Capability(CapabilityStorageBuffer16);
		Module.Capability(CapabilityUniform16);
	}
	return MemoryTypes[{Type, Layout}] = Id;
}

bool FEmitter::IsSameInMemory(const FType* Type)
{
	return Type->IsNumeric() && Type->Scalar != EScalar::Bool && (!Type->IsMatrix() || IsRealMatrix(Type));
}

uint32_t FEmitter::FromMemory(uint32_t Id, const FType* Type, ELayout Layout)
{
	if (IsSameInMemory(Type))
	{
		return Id;
	}
	FWords Parts;
	if (Type->IsArray())
	{
		const uint32_t Element = MemoryType(Type->Element, Layout);
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			Parts.push_back(FromMemory(ExtractAt(Id, Element, {i}), Type->Element, Layout));
		}
	}
	else if (Type->IsStruct())
	{
		for (const FMember& Member : Type->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				const uint32_t Part = ExtractAt(Id, MemoryType(Member.Type, Layout), {uint32_t(Parts.size())});
				Parts.push_back(FromMemory(Part, Member.Type, Layout));
			}
		}
	}
	else if (!Type->IsMatrix())
	{
		const uint32_t Zero = Module.Null(VectorOf(EScalar::Uint, Type->Columns));
		return Op(OpINotEqual, TypeOf(Type), {Id, Zero});
	}
	else
	{
		const EScalar Scalar = Type->Scalar == EScalar::Bool ? EScalar::Uint : Type->Scalar;
		const FType* const Row = RowOf(Type);
		for (uint32_t r = 0; r < Type->Rows; ++r)
		{
			FWords Scalars;
			for (uint32_t c = 0; c < Type->Columns && IsTurned(Type); ++c)
			{
				Scalars.push_back(ExtractAt(Id, ScalarType(Scalar), Type->Rows == 1 ? FWords{c} : FWords{c, r}));
			}
			const uint32_t RowType = VectorOf(Scalar, Type->Columns);
			const uint32_t Part = Scalars.empty() ? ExtractAt(Id, RowType, {r}) : Construct(RowType, Scalars);
			Parts.push_back(FromMemory(Part, Row, Layout));
		}
	}
	return Construct(TypeOf(Type), Parts);
}

uint32_t FEmitter::ToMemory(uint32_t Id, const FType* Type, ELayout Layout)
{
	if (IsSameInMemory(Type))
	{
		return Id;
	}
	FWords Parts;
	if (Type->IsArray())
	{
		const uint32_t Element = TypeOf(Type->Element);
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			Parts.push_back(ToMemory(ExtractAt(Id, Element, {i}), Type->Element, Layout));
		}
	}
	else if (Type->IsStruct())
	{
		for (const FMember& Member : Type->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				const uint32_t Part = ExtractAt(Id, TypeOf(Member.Type), {uint32_t(Parts.size())});
				Parts.push_back(ToMemory(Part, Member.Type, Layout));
			}
		}
	}
	else if (!Type->IsMatrix())
	{
		return ConvertScalars(Id, EScalar::Bool, EScalar::Uint, Type->Columns);
	}
	else
	{
		const bool bTurned = IsTurned(Type);
		for (uint32_t i = 0; i < (bTurned ? Type->Columns : Type->Rows); ++i)
		{
			FWords Scalars;
			for (uint32_t k = 0; k < (bTurned ? Type->Rows : Type->Columns); ++k)
			{
				const uint32_t Scalar = Extract(Id, Type, bTurned ? k * Type->Columns + i : i * Type->Columns + k);
				Scalars.push_back(ToMemory(Scalar, Types.Scalar(Type->Scalar), Layout));
			}
			const EScalar Scalar = Type->Scalar == EScalar::Bool ? EScalar::Uint : Type->Scalar;
			Parts.push_back(Construct(VectorOf(Scalar, uint32_t(Scalars.size())), Scalars));
		}
	}
	return Construct(MemoryType(Type, Layout), Parts);
}

uint32_t FEmitter::ScalarConstant(EScalar Scalar, uint64_t Value)
{
	if (IsLiteral(Scalar))
	{
		const EScalar To = IsReal(Scalar) ? EScalar::Float : EScalar::Int;
		return ScalarConstant(To, ConvertConstant(Types, Scalar, To, Value));
	}
	const uint32_t Type = ScalarType(Scalar);
	if (Scalar == EScalar::Bool)
	{
		return Module.Intern(Value ? OpConstantTrue : OpConstantFalse, {Type});
	}
	switch (Bits(Scalar))
	{
	case 64:
		return Module.Intern(OpConstant, {Type, uint32_t(Value), uint32_t(Value >> 32)});
	case 16:
		return Module.Intern(OpConstant,
			{Type, KindOf(Scalar) == ENumber::Signed ? uint32_t(int32_t(int16_t(Value))) : uint32_t(uint16_t(Value))});
	default:
		return Module.Intern(OpConstant, {Type, uint32_t(Value)});
	}
}

uint32_t FEmitter::ConstantOf(const FType* Type, const FConstant& Constant, size_t& Next)
{
	FWords Parts;
	if (Type->IsArray())
	{
		for (uint32_t i = 0; i < Type->Count; ++i)
		{
			Parts.push_back(ConstantOf(Type->Element, Constant, Next));
		}
	}
	else if (Type->IsStruct())
	{
		for (const FMember& Member : Type->Struct->Members)
		{
			if (CountScalars(Member.Type) > 0)
			{
				Parts.push_back(ConstantOf(Member.Type, Constant, Next));
			}
		}
	}
	else if (Type->IsMatrix())
	{
		for (uint32_t r = 0; r < Type->Rows; ++r)
		{
			Parts.push_back(ConstantOf(RowOf(Type), Constant, Next));
		}
	}
	else
	{
		for (uint32_t c = 0; c < Type->Columns; ++c, ++Next)
		{
			Parts.push_back(ScalarConstant(Type->Scalar, Next < Constant.size() ? Constant[Next] : 0));
		}
		if (Type->Columns == 1)
		{
			return Parts[0];
		}
	}
	return Construct(TypeOf(Type), Parts);
}

uint32_t FEmitter::RealConstant(EScalar Scalar, double Value)
{
	const uint64_t Number = ConvertConstant(Types, EScalar::LiteralFloat, Scalar, std::bit_cast<uint64_t>(Value));
	return ScalarConstant(Scalar, Number);
}

uint32_t FEmitter::Splat(uint32_t Id, uint32_t Scalar, uint32_t Count)
{
	return Count == 1 ? Id : Construct(Module.Vector(Scalar, Count), FWords(Count, Id));
}

} // namespace Drydock::Hlsl
