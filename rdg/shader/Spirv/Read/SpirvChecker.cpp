// Checks a module once, so that no later stage needs to: each operand is a value of the size that the instruction
// expects. Instructions that the CPU tier lacks are refused here, with the line and a replacement.
#include "SpirvChecker.h"

#include "SpirvFlow.h"

#include "SpirvQuads.h"

#include "SpirvRefusals.h"

#include <algorithm>

namespace Drydock
{

namespace
{

using namespace Spirv;

/** Operand counts and sizes of the operations that work scalar by scalar: all operands as large as the result. */
int GetComponentwiseOperands(uint16_t Op)
{
	// clang-format off
	switch (Op)
	{
	case OpConvertFToU: case OpConvertFToS: case OpConvertSToF: case OpConvertUToF: case OpSNegate:
	case OpUConvert: case OpSConvert: case OpFConvert:
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
	// clang-format on
}

int GetComponentwiseExtOperands(uint32_t Ext)
{
	// clang-format off
	switch (Ext)
	{
	case ExtRound: case ExtRoundEven: case ExtTrunc: case ExtFAbs: case ExtSAbs: case ExtFSign: case ExtSSign:
	case ExtFloor: case ExtCeil: case ExtFract: case ExtRadians: case ExtDegrees: case ExtSin: case ExtCos: case ExtTan:
	case ExtAsin: case ExtAcos: case ExtAtan: case ExtSinh: case ExtCosh: case ExtTanh:
	case ExtAsinh: case ExtAcosh: case ExtAtanh: case ExtExp: case ExtLog:
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
	// clang-format on
}

} // namespace

void FSpirvChecker::Check()
{
	if (Module.Blocks.empty())
	{
		Module.Fail("SPIR-V: the module has no entry function");
	}
	if (Module.ExecutionModel != ExecutionModelFragment && Module.ExecutionModel != ExecutionModelCompute &&
		Module.ExecutionModel != ExecutionModelVertex)
	{
		Module.Fail("only vertex, pixel and compute shaders run on the CPU tier");
	}
	CheckGroupSize();
	for (const FSpirvBlock& Block : Module.Blocks)
	{
		CheckBlock(Block);
	}
	CheckVariables();
	CheckGroupshared();
	CheckOrder();
}

void FSpirvChecker::CheckGroupSize()
{
	// Direct3D's limits.
	const uint32_t* const Size = Module.LocalSize;
	const bool bFits = Size[0] >= 1 && Size[1] >= 1 && Size[2] >= 1 && Size[0] <= 1024 && Size[1] <= 1024 &&
					   Size[2] <= 64 && Size[0] * Size[1] * Size[2] <= 1024;
	if (!bFits)
	{
		Module.Fail("numthreads(" + std::to_string(Size[0]) + ", " + std::to_string(Size[1]) + ", " +
					std::to_string(Size[2]) + "): a group has 1 to 1024 threads, at most 64 of them along Z");
	}
}

void FSpirvChecker::CheckInput(const FSpirvVariable& Variable)
{
	const FSpirvType& Type = Module.GetType(Variable.Type);
	const uint32_t Size = Type.NumScalars;
	bool bFits = true;
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
	case BuiltInWorkgroupId:
	case BuiltInLocalInvocationId:
		bFits = Size == 3;
		break;
	case BuiltInFragCoord:
		bFits = Size == 4;
		break;
	case BuiltInLocalInvocationIndex:
	case BuiltInSubgroupSize:
	case BuiltInSubgroupLocalInvocationId:
	case BuiltInFrontFacing:
	case BuiltInVertexIndex:
	case BuiltInInstanceIndex:
		bFits = Size == 1;
		break;
	case BuiltInNone:
	{
		const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
		bFits = Size <= 4 && (Module.ExecutionModel == ExecutionModelVertex || Kind == ESpirvType::Float ||
								 Kind == ESpirvType::Int || Kind == ESpirvType::Uint);
	}
	break;
	default: // reflection refuses what is used of these
		break;
	}
	if (!bFits)
	{
		const bool bWhole = Variable.BuiltIn == BuiltInNone && Size <= 4;
		Module.Fail("input '" + Variable.Name + "' (" + Variable.Semantic +
					") is of a type that the CPU tier does not fill (" + GetHlslTypeName(Module, Type) +
					"); use up to four floats" + (bWhole ? ", int or uint" : ""));
	}
}

void FSpirvChecker::CheckVariables()
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
				Module.Fail(
					"the variable '" + Variable.Name + "' holds a " + GetHlslTypeName(Module, Type) +
					", which variables cannot on the CPU tier; name the texture, sampler or buffer where it is used");
			}
			if (Variable.Storage == StorageInput)
			{
				CheckInput(Variable);
			}
			break;
		case StorageUniform:
		case StorageStorageBuffer:
		case StorageUniformConstant:
		case StorageWorkgroup:
			break;
		default:
			Module.Fail("'" + Variable.Name + "' lives in memory that the CPU tier does not have (a push constant)");
		}
	}
}

void FSpirvChecker::CheckBlock(const FSpirvBlock& Block)
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
		const bool bTerminator = IsSpirvTerminator(I.Op);
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

void FSpirvChecker::CheckTerminator(const FSpirvInstruction& I)
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
		if (Kind == ESpirvType::Long || Kind == ESpirvType::Ulong)
		{
			Module.Fail("a switch over a 64-bit integer is not supported on the CPU tier; use if", &I);
		}
		Expect(I.Operands.size() % 2 == 0 && IsSpirvInteger(Kind), I);
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

void FSpirvChecker::CheckPhi(const FSpirvInstruction& I)
{
	Expect(I.Operands.size() % 2 == 0 && ResultSize(I) != 0, I);
	for (size_t i = 0; i < I.Operands.size(); i += 2)
	{
		Expect(Size(I, i) == ResultSize(I), I);
		Module.GetBlock(I.Operands[i + 1]);
	}
}

void FSpirvChecker::CheckInstruction(const FSpirvInstruction& I)
{
	const bool bTogether = RunsTogether(Module.ExecutionModel, I.Op);
	if (const std::string Refusal = ExplainRefusedOp(I.Op, I.Operands.data(), I.Operands.size());
		!Refusal.empty() && !bTogether)
	{
		Module.Fail(Refusal, &I);
	}
	if (const int Operands = GetComponentwiseOperands(I.Op))
	{
		Expect(int(I.Operands.size()) == Operands && ResultSize(I) != 0, I);
		for (int i = 0; i < Operands; ++i)
		{
			const bool bOneForAll = I.Op == OpSelect && i == 0 && Size(I, 0) == 1;
			Expect(bOneForAll || Size(I, i) == ResultSize(I), I);
		}
		CheckKinds(I);
		return;
	}
	if (I.Op == OpIAddCarry || I.Op == OpISubBorrow)
	{
		Expect(I.Operands.size() == 2 && Size(I, 0) == Size(I, 1) && ResultSize(I) == 2 * Size(I, 0), I);
		CheckKinds(I);
		const ESpirvType Kind = Module.GetScalarKind(I.Type, 0);
		Expect(IsSpirvInteger(Kind) && GetSpirvBytes(Kind) >= 4, I);
		return;
	}
	if (I.Op >= OpBitFieldInsert && I.Op <= OpBitFieldUExtract)
	{
		const size_t Offset = I.Op == OpBitFieldInsert ? 2 : 1; // and behind it the count of bits
		Expect(
			I.Operands.size() == Offset + 2 && Size(I, 0) == ResultSize(I) && Size(I, Offset - 1) == ResultSize(I), I);
		Expect(Size(I, Offset) == 1 && Size(I, Offset + 1) == 1, I);
		CheckKinds(I);
		Expect(GetSpirvBytes(Module.GetScalarKind(I.Type, 0)) == 4, I);
		return;
	}
	if (Module.ExecutionModel == ExecutionModelFragment && (bTogether || I.Op == OpDemote))
	{
		CheckQuad(I);
		return;
	}
	if (I.Op == OpExtInst)
	{
		CheckExtended(I);
		CheckKinds(I);
		return;
	}
	if (I.Op == OpBitcast)
	{
		Expect(I.Operands.size() == 1 && ResultSize(I) != 0 && Size(I, 0) != 0, I);
		const uint32_t From = GetSpirvBytes(Module.GetScalarKind(Module.GetValueTypeId(I.Operands[0]), 0));
		Expect(From * Size(I, 0) == GetSpirvBytes(Module.GetScalarKind(I.Type, 0)) * ResultSize(I), I);
		return;
	}
	if (I.Op == OpFunctionCall)
	{
		ExpectCount(I, 1);
		const std::vector<uint32_t>& Kills = Module.KillFunctions;
		if (std::find(Kills.begin(), Kills.end(), I.Operands[0]) == Kills.end())
		{
			FailCall(I);
		}
		return;
	}
	if (CheckMatrix(I))
	{
		CheckKinds(I);
		return;
	}
	if (!CheckMemory(I) && !CheckGroups(I) && !CheckComposite(I) && !CheckImage(I))
	{
		Module.Fail(GetSpirvOpName(I.Op) +
						" is not supported on the CPU tier; write the expression in another way, or report it",
			&I);
	}
}

/** The front end inlines nothing at all where it meets an operation that it does not know. */
void FSpirvChecker::FailCall(const FSpirvInstruction& I) const
{
	if (!Module.RefusedElsewhere.Message.empty())
	{
		const FSpirvRefusedPlace& Place = Module.RefusedElsewhere;
		throw FSpirvError(Place.Message, Module.Files[Place.File], Place.Line);
	}
	const auto Name = Module.FunctionNames.find(I.Operands[0]);
	Module.Fail(
		"the function " + (Name == Module.FunctionNames.end() ? std::string() : "'" + Name->second + "' ") +
			"could not be inlined, which the CPU tier needs: it or one that it calls has no body, calls itself, or "
			"does what the front end does not know",
		&I);
}

bool FSpirvChecker::CheckMemory(const FSpirvInstruction& I)
{
	switch (I.Op)
	{
	case OpLoad:
	{
		ExpectCount(I, 1);
		const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
		Expect(Pointer.Kind == ESpirvType::Pointer && Pointer.Element == I.Type, I);
		Expect(!Module.FindConstant(I.Operands[0]), I); // an undefined pointer
		const ESpirvType Kind = Module.GetType(I.Type).Kind;
		const bool bHandle = Kind == ESpirvType::Image || Kind == ESpirvType::Sampler;
		if (bHandle && !Module.FindVariable(I.Operands[0]))
		{
			Module.Fail(
				"arrays of textures or samplers are not supported on the CPU tier; declare them one by one", &I);
		}
		Expect(bHandle || ResultSize(I) != 0, I);
		return true;
	}
	case OpStore:
	{
		ExpectCount(I, 2);
		const FSpirvType& Pointer = Module.GetValueType(I.Operands[0]);
		Expect(Pointer.Kind == ESpirvType::Pointer && Module.GetType(Pointer.Element).NumScalars == Size(I, 1), I);
		Expect(!Module.FindConstant(I.Operands[0]), I);
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
			Type =
				Module.GetMemberType(Type, T.Kind == ESpirvType::Struct ? Module.GetConstantScalar(I.Operands[i]) : 0);
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

void FSpirvChecker::CheckExtended(const FSpirvInstruction& I)
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
	if (const FSpirvNorms* const Norms = FindSpirvNorms(Ext))
	{
		Expect(First == (Norms->bPacks ? Norms->Count : 1) && ResultSize(I) == (Norms->bPacks ? 1 : Norms->Count), I);
		return;
	}
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
		Expect(First == ResultSize(I) && Pointer.Kind == ESpirvType::Pointer &&
				   Module.GetType(Pointer.Element).NumScalars == First,
			I);
		return;
	}
	case ExtFrexpStruct:
	case ExtModfStruct:
		Expect(ResultSize(I) == 2 * First &&
				   Module.GetScalarKind(I.Type, 0) == Module.GetScalarKind(Module.GetValueTypeId(I.Operands[2]), 0),
			I);
		Expect(IsSpirvInteger(Module.GetScalarKind(I.Type, First)) == (Ext == ExtFrexpStruct), I);
		return;
	case ExtPackDouble2x32:
		Expect(First == 2 && ResultSize(I) == 1 && Module.GetScalarKind(I.Type, 0) == ESpirvType::Double, I);
		return;
	case ExtUnpackDouble2x32:
		Expect(First == 1 && ResultSize(I) == 2 && Module.GetValueType(I.Operands[2]).Kind == ESpirvType::Double, I);
		return;
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

void CheckSpirv(const FSpirvModule& Module)
{
	FSpirvChecker(Module).Check();
}

} // namespace Drydock
