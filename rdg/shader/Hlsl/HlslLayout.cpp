// Lays types out in memory as D3D does: cbuffers in registers of 16 bytes, structured buffers as C++. Source:
// Microsoft, "Packing Rules for Constant Variables".
#include "HlslTypes.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr uint32_t LayoutRegister = 16;

uint32_t AlignLayout(uint64_t Offset, uint32_t Alignment)
{
	const uint64_t Aligned = (Offset + Alignment - 1) / Alignment * Alignment;
	return uint32_t(std::min<uint64_t>(Aligned, UINT32_MAX / LayoutRegister * LayoutRegister));
}

uint32_t AddLayout(uint64_t A, uint64_t B)
{
	return uint32_t(std::min<uint64_t>(A + B, UINT32_MAX));
}

FLayout GetNumericLayout(uint32_t Bytes, const FType* Type, ELayout Layout)
{
	const bool bRows = Type->Order != EOrder::Column;
	const uint32_t Count = !Type->IsMatrix() ? 1 : bRows ? Type->Rows : Type->Columns;
	const uint32_t Size = Bytes * (Type->IsMatrix() && !bRows ? Type->Rows : Type->Columns); // of a row or column
	if (Layout == ELayout::Structured)
	{
		return {Size * Count, Bytes, Type->IsMatrix() ? Size : 0};
	}
	// A matrix of one register is a vector in it.
	const bool bWhole = Count > 1 || Size > LayoutRegister;
	const uint32_t Stride = AlignLayout(Size, LayoutRegister);
	return {Stride * (Count - 1) + Size, bWhole ? LayoutRegister : Bytes, Type->IsMatrix() ? Stride : 0};
}

/** The offset of a value that stands behind Cursor. */
uint32_t PlaceLayout(uint32_t Cursor, const FLayout& Value, ELayout Layout)
{
	const uint32_t Offset = AlignLayout(Cursor, Value.Alignment);
	const uint64_t Last = uint64_t(Offset) + std::max(Value.Size, 1u) - 1;
	const bool bStraddles = Layout == ELayout::Constants && Offset / LayoutRegister != Last / LayoutRegister;
	return bStraddles ? AlignLayout(Offset, LayoutRegister) : Offset;
}

FLayout MakeStructLayout(const FTypes& Types, const FStructType& Struct, ELayout Layout)
{
	const bool bConstants = Layout == ELayout::Constants;
	FLayout Result{0, bConstants ? LayoutRegister : 1, 0};
	for (const FMember& Member : Struct.Members)
	{
		const FLayout Value = GetLayout(Types, Member.Type, Layout);
		Result.Size = AddLayout(PlaceLayout(Result.Size, Value, Layout), Value.Size);
		Result.Alignment = std::max(Result.Alignment, Value.Alignment);
	}
	Result.Size = bConstants ? Result.Size : AlignLayout(Result.Size, Result.Alignment);
	return Result;
}

} // namespace

FLayout GetLayout(const FTypes& Types, const FType* Type, ELayout Layout)
{
	switch (Type->Kind)
	{
	case EType::Numeric:
		return GetNumericLayout(Types.GetBits(Type->Scalar) / 8, Type, Layout);
	case EType::Array:
	{
		const FLayout Element = GetLayout(Types, Type->Element, Layout);
		const uint32_t Alignment = Layout == ELayout::Constants ? LayoutRegister : Element.Alignment;
		const uint32_t Stride = AlignLayout(Element.Size, Alignment);
		const uint32_t Before = Type->Count ? Type->Count - 1 : 0;
		const uint32_t Last = Layout == ELayout::Constants ? Element.Size : Stride;
		return {Type->Count ? AddLayout(uint64_t(Stride) * Before, Last) : 0, Alignment, Stride};
	}
	case EType::Struct:
	{
		FStructFacts& Facts = Type->Struct->Facts;
		if (Facts.NumLaidOut != Type->Struct->Members.size())
		{
			Facts.Layouts[size_t(ELayout::Constants)] = MakeStructLayout(Types, *Type->Struct, ELayout::Constants);
			Facts.Layouts[size_t(ELayout::Structured)] = MakeStructLayout(Types, *Type->Struct, ELayout::Structured);
			Facts.NumLaidOut = Type->Struct->Members.size();
		}
		return Facts.Layouts[size_t(Layout)];
	}
	default:
		return {0, 1, 0}; // objects stand elsewhere
	}
}

std::vector<uint32_t> GetOffsets(const FTypes& Types, const FStructType& Struct, ELayout Layout)
{
	std::vector<uint32_t> Offsets;
	uint32_t Cursor = 0;
	for (const FMember& Member : Struct.Members)
	{
		const FLayout Value = GetLayout(Types, Member.Type, Layout);
		Offsets.push_back(PlaceLayout(Cursor, Value, Layout));
		Cursor = AddLayout(Offsets.back(), Value.Size);
	}
	return Offsets;
}

} // namespace Drydock::Hlsl
