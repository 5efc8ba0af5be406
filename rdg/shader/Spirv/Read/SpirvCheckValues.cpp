// Checks the operands of instructions on vectors, matrices and textures. Source: SPIR-V specification, section 3.
#include "SpirvChecker.h"

#include "SpirvImageOperands.h"
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

/** Coordinates but for the layer. */
static uint32_t GetAxes(const FSpirvType& Image)
{
	return Image.Dim == DimBuffer ? 1 : Image.Dim == Dim2D ? 2 : 3;
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
	if (Type->Dim != Dim2D && Type->Dim != Dim3D && Type->Dim != DimCube && Type->Dim != DimBuffer)
	{
		Module.Fail(GetHlslTypeName(Module, *Type) +
						" is not supported on the CPU tier; use Texture2D, Texture3D, TextureCube or Buffer",
			&I);
	}
	return *Type;
}

void FSpirvChecker::CheckSample(const FSpirvInstruction& I)
{
	const FSpirvType& Type = Image(I, 0);
	const FSpirvImageOperands Told = GetImageOperands(I);
	const bool bGather = IsSpirvGather(I.Op);
	const bool bCompares = IsSpirvComparison(I.Op);
	const uint32_t Axes = GetAxes(Type);
	ExpectCount(I, Told.End - (Told.Mask ? 0 : 1));
	Expect(Type.Dim != DimBuffer && !Type.bStorageImage && Size(I, 1) >= Axes + Type.bArrayed, I);
	Expect(ResultSize(I) == (bCompares && !bGather ? 1u : 4u), I);
	Expect(!Told.Component || Module.FindConstant(I.Operands[Told.Component]), I);
	Expect(!bCompares || Size(I, Told.Reference) == 1, I);
	const bool bChooses = Module.ExecutionModel == ExecutionModelFragment && ChoosesSpirvLevel(I.Op);
	if (Told.Bias && !bChooses && I.Op != OpImageDrefGather) // glslang gives gathers one, that means nothing
	{
		Module.Fail("SampleBias needs derivatives, which only pixel shaders have; use SampleLevel", &I);
	}
	Expect(!Told.Bias || Size(I, Told.Bias) == 1, I);
	if ((bGather || bCompares) && Type.Dim == Dim3D)
	{
		Module.Fail("Texture3D has neither Gather nor comparisons; use SampleLevel", &I);
	}
	if (Told.MinLod && !bChooses && !Told.GradX)
	{
		Module.Fail(
			"a sample that clamps its level needs derivatives, which only pixel shaders have; use SampleLevel", &I);
	}
	Expect((Told.Mask & ~(ImageBias | ImageLod | ImageGrad | ImageConstOffset | ImageOffset | ImageConstOffsets |
							ImageMinLod)) == 0,
		I);
	Expect(!Told.MinLod || (!bGather && Size(I, Told.MinLod) == 1), I);
	Expect(!Told.Lod || Size(I, Told.Lod) == 1, I);
	Expect(!Told.GradX || (Size(I, Told.GradX) >= Axes && Size(I, Told.GradY) >= Axes), I);
	Expect(!(Told.Offset || Told.Offsets) || Type.Dim != DimCube, I);
	Expect(!Told.Offset || (Size(I, Told.Offset) >= Axes && Size(I, Told.Offset) <= 3), I);
	Expect(!Told.Offsets || (bGather && Size(I, Told.Offsets) == 8), I);
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
	case OpImageSampleDrefImplicitLod:
	case OpImageSampleDrefExplicitLod:
	case OpImageGather:
	case OpImageDrefGather:
		CheckSample(I);
		return true;
	case OpImageFetch:
	case OpImageRead:
	{
		const FSpirvType& Type = Image(I, 0);
		const FSpirvImageOperands Told = GetImageOperands(I);
		if (Type.Dim == DimCube)
		{
			Module.Fail(
				GetHlslTypeName(Module, Type) + " has no Load; use SampleLevel, or a Texture2DArray of its faces", &I);
		}
		Expect(Size(I, 1) >= GetAxes(Type) + Type.bArrayed && ResultSize(I) == 4 &&
				   (Told.Mask & ~(ImageLod | ImageConstOffset | ImageOffset)) == 0,
			I);
		Expect(!Told.Lod || Size(I, Told.Lod) == 1, I);
		Expect(!Told.Offset || Size(I, Told.Offset) >= GetAxes(Type), I);
		return true;
	}
	case OpImageWrite:
	{
		const FSpirvType& Type = Image(I, 0);
		Expect(Type.Dim != DimCube && Size(I, 1) >= GetAxes(Type) + Type.bArrayed && Size(I, 2) >= 1 && Size(I, 2) <= 4,
			I);
		CheckTexelKind(I, Type);
		return true;
	}
	case OpImageQuerySize:
	case OpImageQuerySizeLod:
	{
		const FSpirvType& Type = Image(I, 0);
		Expect(ResultSize(I) == (Type.Dim == DimCube ? 2u : GetAxes(Type)) + Type.bArrayed, I);
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
