// Checks the operands of instructions on vectors, matrices and textures. Source: SPIR-V specification, section 3.
#include "SpirvChecker.h"

#include "SpirvRefusals.h"

namespace Drydock
{

using namespace Spirv;

bool FSpirvChecker::CheckComposite(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpVectorExtractDynamic:
		Expect(Size(I, 0) >= 1 && Size(I, 1) == 1 && ResultSize(I) == 1, I);
		return true;
	case OpVectorInsertDynamic:
		Expect(Size(I, 0) == ResultSize(I) && Size(I, 1) == 1 && Size(I, 2) == 1, I);
		return true;
	case OpVectorShuffle:
	{
		const uint32_t Known = Size(I, 0) + Size(I, 1);
		Expect(I.Operands.size() == 2 + ResultSize(I), I);
		for (size_t i = 2; i < I.Operands.size(); ++i)
		{
			Expect(I.Operands[i] < Known || I.Operands[i] == ~0u, I);
		}
		return true;
	}
	case OpCompositeConstruct:
	{
		uint64_t Sum = 0;
		for (size_t i = 0; i < I.Operands.size(); ++i)
		{
			Sum += Size(I, i);
		}
		Expect(Sum != 0 && Sum == ResultSize(I), I);
		return true;
	}
	case OpCompositeExtract:
	case OpCompositeInsert:
	{
		const size_t Composite = I.Op == OpCompositeExtract ? 0 : 1;
		Size(I, Composite);
		uint32_t Type = Module.GetValueTypeId(I.Operands[Composite]);
		for (size_t i = Composite + 1; i < I.Operands.size(); ++i)
		{
			Type = Module.GetMemberType(Type, I.Operands[i]);
		}
		const uint32_t Part = Module.GetType(Type).NumScalars;
		Expect(
			I.Op == OpCompositeExtract ? Part == ResultSize(I) : Part == Size(I, 0) && Size(I, 1) == ResultSize(I), I);
		return true;
	}
	default:
		return false;
	}
}

bool FSpirvChecker::CheckMatrix(const FSpirvInstruction& I)
{
	// Columns and rows of operand i: a vector is one column.
	struct FShape
	{
		uint32_t Columns;
		uint32_t Rows;
	};
	const auto ShapeOf = [this, &I](uint32_t TypeId)
	{
		const FSpirvType& Type = Module.GetType(TypeId);
		if (Type.Kind == ESpirvType::Matrix)
		{
			return FShape{Type.Count, Module.GetType(Type.Element).Count};
		}
		Expect(Type.Kind == ESpirvType::Vector, I);
		return FShape{1, Type.Count};
	};
	const auto Shape = [this, &I, &ShapeOf](size_t i)
	{
		Size(I, i);
		return ShapeOf(Module.GetValueTypeId(I.Operands[i]));
	};
	switch (I.Op)
	{
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
		Expect(Size(I, 0) == ResultSize(I) && Size(I, 1) == 1, I);
		return true;
	case OpDot:
		Expect(Size(I, 0) == Size(I, 1) && ResultSize(I) == 1, I);
		return true;
	case OpAny:
	case OpAll:
		Expect(Size(I, 0) >= 1 && ResultSize(I) == 1, I);
		return true;
	case OpVectorTimesMatrix:
		Expect(Shape(0).Rows == Shape(1).Rows && ResultSize(I) == Shape(1).Columns, I);
		return true;
	case OpMatrixTimesVector:
		Expect(Shape(0).Columns == Shape(1).Rows && Shape(1).Columns == 1 && ResultSize(I) == Shape(0).Rows, I);
		return true;
	case OpMatrixTimesMatrix:
	{
		const FShape Result = ShapeOf(I.Type);
		Expect(
			Shape(0).Columns == Shape(1).Rows && Result.Rows == Shape(0).Rows && Result.Columns == Shape(1).Columns, I);
		return true;
	}
	case OpTranspose:
	{
		const FShape Result = ShapeOf(I.Type);
		Expect(Result.Columns == Shape(0).Rows && Result.Rows == Shape(0).Columns, I);
		return true;
	}
	case OpOuterProduct:
	{
		const FShape Result = ShapeOf(I.Type);
		Expect(Result.Rows == Size(I, 0) && Result.Columns == Size(I, 1), I);
		return true;
	}
	default:
		return false;
	}
}

const FSpirvType& FSpirvChecker::Image(const FSpirvInstruction& I, size_t i) const
{
	ExpectCount(I, i + 1);
	const FSpirvType* Type = &Module.GetValueType(I.Operands[i]);
	if (Type->Kind == ESpirvType::SampledImage)
	{
		Type = &Module.GetType(Type->Element);
	}
	Expect(Type->Kind == ESpirvType::Image, I);
	const ESpirvType Texel = Module.GetType(Type->Element).Kind;
	if (GetSpirvBytes(Texel) != 4)
	{
		Module.Fail(GetHlslTypeName(Module, *Type) +
						" is not supported on the CPU tier: texels are read and written as 32 bits; use float, int or "
						"uint, whatever the format",
			&I);
	}
	if (Type->bMultisampled)
	{
		Module.Fail(
			GetHlslTypeName(Module, *Type) + ": multisampled textures are not supported on the CPU tier; use Texture2D",
			&I);
	}
	if (Type->Dim == DimCube)
	{
		Module.Fail(GetHlslTypeName(Module, *Type) +
						": cube maps are not supported on the CPU tier; use a Texture2D in a latitude-longitude layout",
			&I);
	}
	if (Type->Dim != Dim2D && Type->Dim != Dim3D && Type->Dim != DimBuffer)
	{
		Module.Fail(GetHlslTypeName(Module, *Type) +
						" is not supported on the CPU tier; use Texture2D, Texture2DArray, Texture3D or Buffer",
			&I);
	}
	return *Type;
}

bool FSpirvChecker::CheckImage(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpSampledImage:
	{
		const FSpirvType& Type = Image(I, 0);
		const FSpirvType& Pair = Module.GetType(I.Type);
		ExpectCount(I, 2);
		Expect(
			!Type.bStorageImage && Pair.Kind == ESpirvType::SampledImage && &Module.GetType(Pair.Element) == &Type, I);
		Expect(Module.GetValueType(I.Operands[1]).Kind == ESpirvType::Sampler, I);
		return true;
	}
	case OpImage:
		Image(I, 0);
		return true;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
	case OpImageGather:
	{
		const FSpirvType& Type = Image(I, 0);
		const bool bGather = I.Op == OpImageGather;
		const size_t MaskAt = bGather ? 3 : 2;
		const uint32_t Needed = Type.Dim == Dim3D || Type.bArrayed ? 3 : 2;
		Expect(Type.Dim != DimBuffer && Size(I, 1) >= Needed && ResultSize(I) == 4, I);
		Expect(!bGather || (I.Operands.size() >= 3 && Module.FindConstant(I.Operands[2])), I);
		const uint32_t Mask = I.Operands.size() > MaskAt ? I.Operands[MaskAt] : 0;
		if (Mask & (ImageGrad | ImageBias))
		{
			Module.Fail(
				"SampleGrad and SampleBias need derivatives, which the CPU tier does not have; use SampleLevel", &I);
		}
		if (bGather && (Type.Dim != Dim2D || Type.bArrayed))
		{
			Module.Fail("Gather works on Texture2D only on the CPU tier", &I);
		}
		Expect((Mask & ~(ImageLod | ImageConstOffset | ImageOffset)) == 0, I);
		size_t Next = MaskAt + 1;
		if (Mask & ImageLod)
		{
			Expect(Size(I, Next++) == 1, I);
		}
		if (Mask & (ImageConstOffset | ImageOffset))
		{
			Expect(Size(I, Next) >= 2, I);
		}
		return true;
	}
	case OpImageFetch:
	case OpImageRead:
	{
		const FSpirvType& Type = Image(I, 0);
		const uint32_t Needed = Type.Dim == DimBuffer ? 1 : Type.Dim == Dim3D || Type.bArrayed ? 3 : 2;
		const uint32_t Mask = I.Operands.size() > 2 ? I.Operands[2] : 0;
		Expect(Size(I, 1) >= Needed && ResultSize(I) == 4 && (Mask & ~(ImageLod | ImageConstOffset | ImageOffset)) == 0,
			I);
		size_t Next = 3;
		if (Mask & ImageLod)
		{
			Expect(Size(I, Next++) == 1, I);
		}
		if (Mask & (ImageConstOffset | ImageOffset))
		{
			Expect(Size(I, Next) >= 2, I);
		}
		return true;
	}
	case OpImageWrite:
	{
		const FSpirvType& Type = Image(I, 0);
		const uint32_t Needed = Type.Dim == DimBuffer ? 1 : Type.Dim == Dim3D || Type.bArrayed ? 3 : 2;
		Expect(Size(I, 1) >= Needed && Size(I, 2) >= 1 && Size(I, 2) <= 4, I);
		CheckTexelKind(I, Type);
		return true;
	}
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	{
		const FSpirvType& Type = Image(I, 0);
		Expect(ResultSize(I) == (Type.Dim == DimBuffer ? 1u : Type.Dim == Dim3D || Type.bArrayed ? 3u : 2u), I);
		Expect(I.Op == OpImageQuerySize || Size(I, 1) == 1, I);
		return true;
	}
	case OpImageQueryLevels:
		Image(I, 0);
		Expect(ResultSize(I) == 1, I);
		return true;
	default:
		return false;
	}
}

} // namespace Drydock
