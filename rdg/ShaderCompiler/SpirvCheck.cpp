// Checks a module once, so that no later stage needs to: each operand is a value of the size that the instruction
// expects. What the CPU tier does not do is refused here, with the line and what to write instead. Source: drydock.
#include "SpirvCheck.h"

#include <algorithm>

namespace Drydock
{

namespace
{

using namespace Spirv;

/** What to do about an operation that is refused; null: the operation is not one of those. */
const char* GetRefusal(uint16_t Op)
{
	if (Op >= OpDPdx && Op <= OpFwidthCoarse)
	{
		return "there are no derivatives on the CPU tier: threads do not run in quads. Compute the step from the texel size, or use SampleLevel";
	}
	if (Op == OpControlBarrier || Op == OpMemoryBarrier)
	{
		return "barriers are not supported on the CPU tier: threads do not run in groups. Split the shader into two passes";
	}
	if ((Op >= OpAtomicLoad && Op <= OpAtomicXor) || Op == OpImageTexelPointer)
	{
		return "atomics (Interlocked*, append buffers) are not supported on the CPU tier. Give each thread a place of its own and reduce in another pass";
	}
	if (Op >= OpGroupNonUniformElect && Op <= OpGroupNonUniformQuadSwap)
	{
		return "wave operations are not supported on the CPU tier: the number of lanes differs between machines";
	}
	if (Op == OpImageQuerySamples)
	{
		return "multisampled textures are not supported on the CPU tier. Use Texture2D";
	}
	if (Op == OpImageQueryLod)
	{
		return "CalculateLevelOfDetail needs derivatives, which the CPU tier does not have. Compute the mip level and use SampleLevel";
	}
	if (Op == 89 || Op == 90 || Op == 97)
	{
		return "comparison samplers are not supported on the CPU tier. Sample the texture and compare";
	}
	return nullptr;
}

/** Operand counts and sizes of the operations that work scalar by scalar: all operands as large as the result. */
int GetComponentwiseOperands(uint16_t Op)
{
	switch (Op)
	{
	case OpConvertFToU: case OpConvertFToS: case OpConvertSToF: case OpConvertUToF: case OpBitcast: case OpSNegate:
	case OpFNegate: case OpIsNan: case OpIsInf: case OpLogicalNot: case OpNot: case OpBitReverse: case OpBitCount:
	case OpCopyObject:
		return 1;
	case OpSelect:
		return 3;
	case OpIAdd: case OpFAdd: case OpISub: case OpFSub: case OpIMul: case OpFMul: case OpUDiv: case OpSDiv: case OpFDiv:
	case OpUMod: case OpSRem: case OpSMod: case OpFRem: case OpFMod:
	case OpShiftRightLogical: case OpShiftRightArithmetic: case OpShiftLeftLogical: case OpBitwiseOr: case OpBitwiseXor:
	case OpBitwiseAnd:
		return 2;
	default:
		return (Op >= OpLogicalEqual && Op <= OpLogicalAnd) || (Op >= OpIEqual && Op <= OpFUnordGreaterThanEqual) ? 2 : 0;
	}
}

int GetComponentwiseExtOperands(uint32_t Ext)
{
	switch (Ext)
	{
	case ExtRound: case ExtRoundEven: case ExtTrunc: case ExtFAbs: case ExtSAbs: case ExtFSign: case ExtSSign:
	case ExtFloor: case ExtCeil: case ExtFract: case ExtRadians: case ExtDegrees: case ExtSin: case ExtCos: case ExtTan:
	case ExtAsin: case ExtAcos: case ExtAtan: case ExtSinh: case ExtCosh: case ExtTanh: case ExtExp: case ExtLog:
	case ExtExp2: case ExtLog2: case ExtSqrt: case ExtInverseSqrt: case ExtNormalize: case ExtFindILsb: case ExtFindSMsb:
	case ExtFindUMsb:
		return 1;
	case ExtAtan2: case ExtPow: case ExtFMin: case ExtUMin: case ExtSMin: case ExtFMax: case ExtUMax: case ExtSMax:
	case ExtStep: case ExtCross: case ExtReflect: case ExtNMin: case ExtNMax: case ExtLdexp:
		return 2;
	case ExtFClamp: case ExtUClamp: case ExtSClamp: case ExtFMix: case ExtSmoothStep: case ExtFma: case ExtFaceForward:
	case ExtNClamp:
		return 3;
	default:
		return 0;
	}
}

class FChecker
{
public:
	explicit FChecker(const FSpirvModule& InModule) : Module(InModule) {}

	void Check();

private:
	void CheckVariables();
	void CheckBlock(const FSpirvBlock& Block);
	void CheckTerminator(const FSpirvInstruction& I);
	void CheckInstruction(const FSpirvInstruction& I);
	void RefuseGroupshared(uint32_t Id, const FSpirvInstruction& I) const;
	bool CheckMemory(const FSpirvInstruction& I);
	bool CheckComposite(const FSpirvInstruction& I);
	bool CheckMatrix(const FSpirvInstruction& I);
	bool CheckImage(const FSpirvInstruction& I);
	void CheckExtended(const FSpirvInstruction& I);
	void CheckPhi(const FSpirvInstruction& I);

	void Expect(bool bCondition, const FSpirvInstruction& I) const
	{
		if (!bCondition)
		{
			Module.Fail("SPIR-V: " + GetSpirvOpName(I.Op) + " has operands that do not fit", &I);
		}
	}
	void ExpectCount(const FSpirvInstruction& I, size_t Least) const { Expect(I.Operands.size() >= Least, I); }
	/** Operand i is numeric; its scalars. */
	uint32_t Size(const FSpirvInstruction& I, size_t i) const
	{
		ExpectCount(I, i + 1);
		const uint32_t Result = Module.GetValueType(I.Operands[i]).NumScalars;
		Expect(Result != 0, I);
		return Result;
	}
	uint32_t ResultSize(const FSpirvInstruction& I) const { return Module.GetType(I.Type).NumScalars; }
	const FSpirvType& Image(const FSpirvInstruction& I, size_t i) const;

	const FSpirvModule& Module;
};

void FChecker::Check()
{
	if (Module.Blocks.empty())
	{
		Module.Fail("SPIR-V: the module has no entry function");
	}
	if (Module.ExecutionModel != ExecutionModelFragment && Module.ExecutionModel != ExecutionModelCompute)
	{
		Module.Fail("only pixel and compute shaders run on the CPU tier");
	}
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		CheckBlock(Block);
	}
	CheckVariables();
}

void FChecker::CheckVariables()
{
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvType& Type = Module.GetType(Variable.Type);
		switch (Variable.Storage)
		{
		case StorageFunction:
		case StoragePrivate:
		case StorageInput:
		case StorageOutput:
			if (Type.NumScalars == 0)
			{
				Module.Fail("SPIR-V: variable '" + Variable.Name + "' is not numeric");
			}
			break;
		case StorageUniform:
		case StorageStorageBuffer:
		case StorageUniformConstant:
			break;
		default:
			Module.Fail("'" + Variable.Name + "' lives in memory that the CPU tier does not have (groupshared or a push constant)");
		}
	}
}

void FChecker::CheckBlock(const FSpirvBlock& Block)
{
	if (Block.Instructions.empty())
	{
		Module.Fail("SPIR-V: an empty block");
	}
	if (Block.Merge)
	{
		Module.GetBlock(Block.Merge);
	}
	if (Block.Continue)
	{
		Module.GetBlock(Block.Continue);
	}
	bool bPhisOver = false;
	for (size_t i = 0; i < Block.Instructions.size(); ++i)
	{
		const FSpirvInstruction& I = Block.Instructions[i];
		const bool bTerminator = I.Op >= OpBranch && I.Op <= OpUnreachable;
		Expect(bTerminator == (i + 1 == Block.Instructions.size()), I);
		if (bTerminator)
		{
			CheckTerminator(I);
		}
		else if (I.Op == OpPhi)
		{
			Expect(!bPhisOver, I);
			CheckPhi(I);
		}
		else
		{
			bPhisOver = true;
			CheckInstruction(I);
		}
	}
}

void FChecker::CheckTerminator(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpBranch:
		Expect(I.Operands.size() == 1, I);
		break;
	case OpBranchConditional:
		ExpectCount(I, 3);
		Expect(Module.GetValueType(I.Operands[0]).Kind == ESpirvType::Bool, I);
		break;
	case OpSwitch:
	{
		ExpectCount(I, 2);
		const ESpirvType Kind = Module.GetValueType(I.Operands[0]).Kind;
		Expect(I.Operands.size() % 2 == 0 && (Kind == ESpirvType::Int || Kind == ESpirvType::Uint), I);
		break;
	}
	case OpKill:
	case OpReturn:
	case OpUnreachable:
		break;
	default:
		Expect(false, I);
	}
	for (const uint32_t Label : GetSuccessors(I))
	{
		Module.GetBlock(Label);
	}
}

void FChecker::CheckPhi(const FSpirvInstruction& I)
{
	Expect(I.Operands.size() % 2 == 0 && ResultSize(I) != 0, I);
	for (size_t i = 0; i < I.Operands.size(); i += 2)
	{
		Expect(Size(I, i) == ResultSize(I), I);
		Module.GetBlock(I.Operands[i + 1]);
	}
}

void FChecker::CheckInstruction(const FSpirvInstruction& I)
{
	if (const char* Refusal = GetRefusal(I.Op))
	{
		Module.Fail(GetSpirvOpName(I.Op) + ": " + Refusal, &I);
	}
	if (const int Operands = GetComponentwiseOperands(I.Op))
	{
		Expect(int(I.Operands.size()) == Operands && ResultSize(I) != 0, I);
		for (int i = 0; i < Operands; ++i)
		{
			const bool bOneForAll = I.Op == OpSelect && i == 0 && Size(I, 0) == 1;
			Expect(bOneForAll || Size(I, i) == ResultSize(I), I);
		}
		return;
	}
	if (I.Op == OpExtInst)
	{
		CheckExtended(I);
		return;
	}
	if (I.Op == OpFunctionCall)
	{
		ExpectCount(I, 1);
		const std::vector<uint32_t>& Kills = Module.KillFunctions;
		if (std::find(Kills.begin(), Kills.end(), I.Operands[0]) == Kills.end())
		{
			Module.Fail("a function call could not be inlined (OpFunctionCall); the CPU tier needs functions without recursion", &I);
		}
		return;
	}
	if (!CheckMemory(I) && !CheckComposite(I) && !CheckMatrix(I) && !CheckImage(I))
	{
		Module.Fail(GetSpirvOpName(I.Op) + " is not supported on the CPU tier; write the expression in another way, or report it", &I);
	}
}

void FChecker::RefuseGroupshared(uint32_t Id, const FSpirvInstruction& I) const
{
	const FSpirvVariable* Variable = Module.FindVariable(Id);
	if (Variable && Variable->Storage == StorageWorkgroup)
	{
		Module.Fail("groupshared '" + Variable->Name + "' is not supported on the CPU tier: threads do not run in groups. "
			"Read the texture or buffer directly, or split the shader into two passes", &I);
	}
}

bool FChecker::CheckMemory(const FSpirvInstruction& I)
{
	if (!I.Operands.empty() && I.Op != OpArrayLength)
	{
		RefuseGroupshared(I.Operands[0], I);
	}
	switch (I.Op)
	{
	case OpLoad:
	{
		ExpectCount(I, 1);
		const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
		Expect(Pointer.Kind == ESpirvType::Pointer && Pointer.Element == I.Type, I);
		const ESpirvType Kind = Module.GetType(I.Type).Kind;
		const bool bHandle = Kind == ESpirvType::Image || Kind == ESpirvType::Sampler;
		if (bHandle && !Module.FindVariable(I.Operands[0]))
		{
			Module.Fail("arrays of textures or samplers are not supported on the CPU tier; declare them one by one", &I);
		}
		Expect(bHandle || ResultSize(I) != 0, I);
		return true;
	}
	case OpStore:
	{
		ExpectCount(I, 2);
		const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
		Expect(Pointer.Kind == ESpirvType::Pointer && Module.GetType(Pointer.Element).NumScalars == Size(I, 1), I);
		return true;
	}
	case OpAccessChain:
	case OpInBoundsAccessChain:
	{
		ExpectCount(I, 1);
		const FSpirvVariable* Variable = Module.FindVariable(I.Operands[0]);
		const FSpirvType& Result = Module.GetType(I.Type);
		if (!Variable)
		{
			// A chain on a chain: legal SPIR-V, but glslang flattens them.
			Module.Fail("SPIR-V: an access chain that does not start at a variable", &I);
		}
		uint32_t Type = Variable->Type;
		for (size_t i = 1; i < I.Operands.size(); ++i)
		{
			const FSpirvType& T = Module.GetType(Type);
			Expect(Size(I, i) == 1 && T.Kind != ESpirvType::Pointer, I);
			const bool bConstant = Module.FindConstant(I.Operands[i]) != nullptr;
			Expect(T.Kind != ESpirvType::Struct || bConstant, I);
			// A constant index past the end is the shader's fault; it is clamped like one known at run time only.
			Type = Module.GetMemberType(Type, T.Kind == ESpirvType::Struct ? Module.GetConstantScalar(I.Operands[i]) : 0);
		}
		Expect(Result.Kind == ESpirvType::Pointer && Result.Element == Type, I);
		return true;
	}
	case OpArrayLength:
	{
		Expect(I.Operands.size() == 2, I);
		const FSpirvVariable* Variable = Module.FindVariable(I.Operands[0]);
		Expect(Variable && Variable->Storage == StorageUniform, I);
		return true;
	}
	default:
		return false;
	}
}

bool FChecker::CheckComposite(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpVectorExtractDynamic:
		Expect(Size(I, 0) >= 2 && Size(I, 1) == 1 && ResultSize(I) == 1, I);
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
		Expect(I.Op == OpCompositeExtract ? Part == ResultSize(I) : Part == Size(I, 0) && Size(I, 1) == ResultSize(I), I);
		return true;
	}
	default:
		return false;
	}
}

bool FChecker::CheckMatrix(const FSpirvInstruction& I)
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
		Expect(Shape(0).Columns == Shape(1).Rows && Result.Rows == Shape(0).Rows && Result.Columns == Shape(1).Columns, I);
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

const FSpirvType& FChecker::Image(const FSpirvInstruction& I, size_t i) const
{
	ExpectCount(I, i + 1);
	const FSpirvType* Type = &Module.GetValueType(I.Operands[i]);
	if (Type->Kind == ESpirvType::SampledImage)
	{
		Type = &Module.GetType(Type->Element);
	}
	Expect(Type->Kind == ESpirvType::Image, I);
	if (Type->bMultisampled)
	{
		Module.Fail("multisampled textures are not supported on the CPU tier; use Texture2D", &I);
	}
	if (Type->Dim == DimCube)
	{
		Module.Fail("cube maps are not supported on the CPU tier; use a Texture2D in a latitude-longitude layout", &I);
	}
	if (Type->Dim != Dim2D && Type->Dim != Dim3D && Type->Dim != DimBuffer)
	{
		Module.Fail("this kind of texture is not supported on the CPU tier; use Texture2D, Texture2DArray, Texture3D or Buffer", &I);
	}
	return *Type;
}

bool FChecker::CheckImage(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpSampledImage:
		Image(I, 0);
		ExpectCount(I, 2);
		Expect(Module.GetValueType(I.Operands[1]).Kind == ESpirvType::Sampler, I);
		return true;
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
			Module.Fail("SampleGrad and SampleBias need derivatives, which the CPU tier does not have; use SampleLevel", &I);
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
		Expect(Size(I, 1) >= Needed && ResultSize(I) == 4 && (Mask & ~(ImageLod | ImageConstOffset | ImageOffset)) == 0, I);
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

void FChecker::CheckExtended(const FSpirvInstruction& I)
{
	const uint32_t Ext = I.Operands[1];
	if (const int Operands = GetComponentwiseExtOperands(Ext))
	{
		Expect(int(I.Operands.size()) == Operands + 2 && ResultSize(I) != 0, I);
		for (int i = 0; i < Operands; ++i)
		{
			Expect(Size(I, 2 + i) == ResultSize(I), I);
		}
		Expect(Ext != ExtCross || ResultSize(I) == 3, I);
		return;
	}
	const uint32_t First = Size(I, 2);
	switch (Ext)
	{
	case ExtDeterminant:
	{
		const FSpirvType& Type = Module.GetValueType(I.Operands[2]);
		Expect(Type.Kind == ESpirvType::Matrix && First == Type.Count * Type.Count && ResultSize(I) == 1, I);
		return;
	}
	case ExtLength:
		Expect(ResultSize(I) == 1, I);
		return;
	case ExtDistance:
		Expect(Size(I, 3) == First && ResultSize(I) == 1, I);
		return;
	case ExtRefract:
		Expect(First == ResultSize(I) && Size(I, 3) == First && Size(I, 4) == 1, I);
		return;
	case ExtModf:
	{
		ExpectCount(I, 4);
		const FSpirvType& Pointer = Module.GetValueType(I.Operands[3]);
		Expect(First == ResultSize(I) && Pointer.Kind == ESpirvType::Pointer
			&& Module.GetType(Pointer.Element).NumScalars == First, I);
		return;
	}
	case ExtPackHalf2x16:
		Expect(First == 2 && ResultSize(I) == 1, I);
		return;
	case ExtUnpackHalf2x16:
		Expect(First == 1 && ResultSize(I) == 2, I);
		return;
	default:
		Module.Fail("GLSL.std.450 instruction " + std::to_string(Ext) + " is not supported on the CPU tier", &I);
	}
}

} // namespace

void CheckSpirv(const FSpirvModule& Module)
{
	FChecker(Module).Check();
}

} // namespace Drydock
