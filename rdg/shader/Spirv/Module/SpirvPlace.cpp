// Follows a pointer of a shader to its place. Source of the layout decorations: SPIR-V specification, section 2.16.
#include "SpirvPlace.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** ComponentStride: of a vector that is a column of a matrix; 0: as large as its scalars. */
void AppendOffsets(const FSpirvModule& Module, uint32_t TypeId, uint32_t Offset, uint32_t MatrixStride, bool bRowMajor,
	uint32_t ComponentStride, std::vector<uint32_t>& Result)
{
	const FSpirvType& Type = Module.GetType(TypeId);
	const bool bVectors = Type.Kind == ESpirvType::Vector || Type.Kind == ESpirvType::Matrix;
	const uint32_t Scalar = bVectors ? GetSpirvBytes(Module.GetScalarKind(TypeId, 0)) : 0;
	switch (Type.Kind)
	{
	case ESpirvType::Vector:
		for (uint32_t i = 0; i < Type.Count; ++i)
		{
			Result.push_back(Offset + i * (ComponentStride ? ComponentStride : Scalar));
		}
		break;
	case ESpirvType::Matrix:
		for (uint32_t i = 0; i < Type.Count; ++i)
		{
			AppendOffsets(Module, Type.Element, Offset + i * (bRowMajor ? Scalar : MatrixStride), 0, false,
				bRowMajor ? MatrixStride : Scalar, Result);
		}
		break;
	case ESpirvType::Array:
		for (uint32_t i = 0; i < Type.Count; ++i)
		{
			AppendOffsets(Module, Type.Element, Offset + i * Type.ArrayStride, MatrixStride, bRowMajor, 0, Result);
		}
		break;
	case ESpirvType::Struct:
		for (const FSpirvMember& Member : Type.Members)
		{
			AppendOffsets(
				Module, Member.Type, Offset + Member.Offset, Member.MatrixStride, Member.bRowMajor, 0, Result);
		}
		break;
	default:
		Result.push_back(Offset);
		break;
	}
}

/** How the bytes of the matrix lie that a chain leads into. */
struct FMatrixLayout
{
	uint32_t MatrixStride = 0;
	uint32_t ComponentStride = 0; // of a vector that is a column
	bool bRowMajor = false;
};

/** Bytes from one part of the type to the next; a step into a matrix makes its columns known. */
uint32_t StepInBytes(const FSpirvModule& Module, const FSpirvType& Type, FMatrixLayout& Layout)
{
	switch (Type.Kind)
	{
	case ESpirvType::Vector:
		return Layout.ComponentStride ? Layout.ComponentStride : GetSpirvBytes(Module.GetType(Type.Element).Kind);
	case ESpirvType::Matrix:
	{
		const uint32_t Scalar = GetSpirvBytes(Module.GetScalarKind(Type.Element, 0));
		Layout.ComponentStride = Layout.bRowMajor ? Layout.MatrixStride : Scalar;
		return Layout.bRowMajor ? Scalar : Layout.MatrixStride;
	}
	default:
		return Type.ArrayStride;
	}
}

} // namespace

std::vector<uint32_t> GetScalarOffsets(const FSpirvModule& Module, uint32_t Type, uint32_t MatrixStride, bool bRowMajor)
{
	std::vector<uint32_t> Result;
	AppendOffsets(Module, Type, 0, MatrixStride, bRowMajor, 0, Result);
	return Result;
}

FSpirvPlace FollowChain(const FSpirvModule& Module, uint32_t BaseType, bool bBytes, const FSpirvInstruction& Chain)
{
	FSpirvPlace Place;
	Place.Type = BaseType;
	Place.bBytes = bBytes;
	FMatrixLayout Layout;
	for (size_t i = 1; i < Chain.Operands.size(); ++i)
	{
		const uint32_t Id = Chain.Operands[i];
		const FSpirvType& Type = Module.GetType(Place.Type);
		const FSpirvConstant* Constant = Module.FindConstant(Id);
		if (Type.Kind == ESpirvType::Struct)
		{
			const uint32_t Index = Module.GetConstantScalar(Id);
			const uint32_t Next = Module.GetMemberType(Place.Type, Index);
			if (Place.bBytes)
			{
				const FSpirvMember& Member = Type.Members[Index];
				Place.Offset += Member.Offset;
				Layout.MatrixStride = Member.MatrixStride;
				Layout.bRowMajor = Member.bRowMajor;
			}
			else
			{
				Place.Offset += Module.GetMemberScalar(Place.Type, Index);
			}
			Place.Type = Next;
			continue;
		}
		const uint32_t Next = Module.GetMemberType(Place.Type, 0);
		const uint32_t Stride = Place.bBytes ? StepInBytes(Module, Type, Layout) : Module.GetType(Next).NumScalars;
		if (Type.Kind == ESpirvType::RuntimeArray)
		{
			Place.Element = Id;
			Place.ElementStride = Stride ? Stride : 4;
		}
		else if (Constant)
		{
			Place.Offset += std::min(Module.GetConstantScalar(Id), Type.Count - 1) * Stride;
		}
		else
		{
			Place.Indices.push_back({Id, Stride, Type.Count});
		}
		Place.Type = Next;
	}
	const uint32_t NumScalars = Module.GetType(Place.Type).NumScalars;
	if (!Place.bBytes)
	{
		for (uint32_t i = 0; i < NumScalars; ++i)
		{
			Place.Scalars.push_back(i);
		}
	}
	else if (NumScalars)
	{
		AppendOffsets(
			Module, Place.Type, 0, Layout.MatrixStride, Layout.bRowMajor, Layout.ComponentStride, Place.Scalars);
	}
	return Place;
}

FSpirvPlace ResolvePlace(const FSpirvModule& Module, uint32_t Pointer, const FSpirvInstruction* Chain)
{
	const FSpirvVariable* const Variable = Module.FindVariable(Chain ? Chain->Operands[0] : Pointer);
	if (!Variable)
	{
		Module.Fail("SPIR-V: a pointer that does not start at a variable", Chain);
	}
	const bool bBytes = Variable->Storage == StorageUniform || Variable->Storage == StorageStorageBuffer;
	FSpirvPlace Place = FollowChain(Module, Variable->Type, bBytes, Chain ? *Chain : FSpirvInstruction());
	Place.Variable = Variable;
	return Place;
}

} // namespace Drydock
