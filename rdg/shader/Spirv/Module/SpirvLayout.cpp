// Lays buffers out as Direct3D does. glslang's own offsets come close (--hlsl-offsets) but follow std430 in structured
// buffers, where C++ code writes tightly packed structs, and leave holes before float3 in constant buffers.
// Source: Microsoft, "Packing rules for constant variables"; structured buffers are packed without padding.
#include "SpirvLayout.h"

#include "SpirvRefusals.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t Register = 16;

uint32_t RoundUp(uint32_t Value, uint32_t Multiple)
{
	return (Value + Multiple - 1) / Multiple * Multiple;
}

class FLayout
{
public:
	explicit FLayout(FSpirvModule& InModule)
		: Module(InModule)
	{
	}

	void Apply(uint32_t Type, bool bTight)
	{
		bTightPacking = bTight;
		SizeOf(Type, nullptr, false);
	}

private:
	/** Bytes that a value takes without padding behind it; lays out what is inside. MatrixStride is written back. */
	uint32_t SizeOf(uint32_t TypeId, uint32_t* MatrixStride, bool bRowMajor)
	{
		FSpirvType& Type = Module.Types.at(TypeId);
		switch (Type.Kind)
		{
		case ESpirvType::Vector:
			return SizeOf(Type.Element, nullptr, false) * Type.Count;
		case ESpirvType::Matrix:
		{
			const uint32_t Rows = Module.GetType(Type.Element).Count;
			const uint32_t Vectors = bRowMajor ? Rows : Type.Count;
			const uint32_t Scalar = GetSpirvBytes(Module.GetScalarKind(TypeId, 0));
			const uint32_t Size = Scalar * (bRowMajor ? Type.Count : Rows);
			const uint32_t Stride = bTightPacking ? Size : RoundUp(Size, Register);
			if (MatrixStride)
			{
				*MatrixStride = Stride;
			}
			return Stride * (Vectors - 1) + Size;
		}
		case ESpirvType::Array:
		case ESpirvType::RuntimeArray:
		{
			const uint32_t Element = Type.Element;
			const uint32_t Count = Type.Kind == ESpirvType::Array ? Type.Count : 1;
			const uint32_t Size = SizeOf(Element, MatrixStride, bRowMajor);
			const uint32_t Stride = bTightPacking ? Size : RoundUp(Size, Register);
			Claim(TypeId);
			Module.Types.at(TypeId).ArrayStride = Stride;
			return Stride * (Count - 1) + Size;
		}
		case ESpirvType::Struct:
		{
			uint32_t End = 0;
			uint32_t Alignment = 1;
			for (FSpirvMember& Member : Type.Members)
			{
				const uint32_t Size = SizeOf(Member.Type, &Member.MatrixStride, Member.bRowMajor);
				const uint32_t Own = AlignmentOf(Member.Type);
				Alignment = std::max(Alignment, Own);
				End = RoundUp(End, Own);
				if (!bTightPacking)
				{
					const ESpirvType Kind = Module.GetType(Member.Type).Kind;
					const bool bOwnRegister =
						Kind == ESpirvType::Struct || Kind == ESpirvType::Array || Kind == ESpirvType::Matrix;
					const bool bCrosses = End % Register + Size > Register;
					End = bOwnRegister || bCrosses ? RoundUp(End, Register) : End;
				}
				Member.Offset = End;
				End += Size;
			}
			Claim(TypeId);
			return bTightPacking ? RoundUp(End, Alignment) : End;
		}
		default:
			return GetSpirvBytes(Type.Kind);
		}
	}

	/** Bytes of the widest scalar inside: members begin at a multiple of it, and structs in structured buffers end at
	 * one. */
	uint32_t AlignmentOf(uint32_t TypeId) const
	{
		const FSpirvType& Type = Module.GetType(TypeId);
		uint32_t Alignment = 1;
		for (const FSpirvMember& Member : Type.Members)
		{
			Alignment = std::max(Alignment, AlignmentOf(Member.Type));
		}
		return Type.Kind == ESpirvType::Struct ? Alignment
			   : Type.Element                  ? AlignmentOf(Type.Element)
											   : GetSpirvBytes(Type.Kind);
	}

	/** A type has one layout; glslang declares it twice where a shader uses it in both kinds of buffers. */
	void Claim(uint32_t TypeId)
	{
		const auto [Known, bNew] = Packing.emplace(TypeId, bTightPacking);
		if (Known->second != bTightPacking)
		{
			Module.Fail(
				"the type " + GetHlslTypeName(Module, Module.GetType(TypeId)) +
				" is used in a constant buffer and in a structured buffer, which lay it out differently; declare it "
				"twice, under two names");
		}
	}

	FSpirvModule& Module;
	std::unordered_map<uint32_t, bool> Packing;
	bool bTightPacking = false;
};

} // namespace

void ApplyD3DLayout(FSpirvModule& Module)
{
	FLayout Layout(Module);
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvType& Type = Module.GetType(Variable.Type);
		if ((Variable.Storage == StorageUniform || Variable.Storage == StorageStorageBuffer) &&
			Type.Kind == ESpirvType::Struct)
		{
			Layout.Apply(Variable.Type, Type.bBufferBlock);
		}
	}
}

} // namespace Drydock
