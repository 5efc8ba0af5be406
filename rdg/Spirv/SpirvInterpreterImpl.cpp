// Runs a thread of the model block by block, and its loads and stores. Source of the instructions' meaning: SPIR-V
// specification, section 3.
#include "SpirvInterpreterImpl.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

FSpirvInterpreterImpl::FScalars FSpirvInterpreterImpl::LoadInput(const FSpirvVariable& Variable) const
{
	const int32_t* const Group = Reflection.Reflection.GroupSize;
	const auto Local = [this, Group](int Axis)
	{
		return uint32_t(Position[Axis] % Group[Axis]);
	};
	switch (Variable.BuiltIn)
	{
	case BuiltInGlobalInvocationId:
		return {uint32_t(Position[0]), uint32_t(Position[1]), uint32_t(Position[2])};
	case BuiltInWorkgroupId:
		return {uint32_t(Position[0] / Group[0]), uint32_t(Position[1] / Group[1]), uint32_t(Position[2] / Group[2])};
	case BuiltInLocalInvocationId:
		return {Local(0), Local(1), Local(2)};
	case BuiltInLocalInvocationIndex:
		return {(Local(2) * uint32_t(Group[1]) + Local(1)) * uint32_t(Group[0]) + Local(0)};
	case BuiltInFragCoord:
		return {ToBits(float(Position[0]) + 0.5f), ToBits(float(Position[1]) + 0.5f), ToBits(0.0f), ToBits(1.0f)};
	case BuiltInFrontFacing:
		return {1};
	case BuiltInVertexIndex:
		return {Vertex->VertexId};
	case BuiltInInstanceIndex:
		return {Vertex->InstanceId};
	default:
	{
		if (Vertex)
		{
			return LoadAttribute(Variable);
		}
		FScalars Result;
		const FKernelInterpolant& Interpolant = Args->Interpolants[GetTexCoordIndex(Variable.Semantic)];
		for (uint32_t i = 0; i < Module.GetType(Variable.Type).NumScalars; ++i)
		{
			Result.push_back(
				ToBits(Lanes::Interpolate<float>(Interpolant, int(i), Lanes::TInt<4>(Position[0]), Position[1])[0]));
		}
		return Result;
	}
	}
}

FSpirvInterpreterImpl::FScalars FSpirvInterpreterImpl::Load(uint32_t Pointer)
{
	const FSpirvPlace Place = Resolve(Pointer);
	const uint32_t Offset = DynamicOffset(Place);
	FScalars Result;
	for (const uint32_t Part : Place.Scalars)
	{
		const uint32_t At = Offset + Part;
		if (!Place.bBytes)
		{
			const FScalars& Whole = Place.Variable->Storage == StorageInput
										? (Memory[Place.Variable->Id] = LoadInput(*Place.Variable))
										: Memory[Place.Variable->Id];
			Result.push_back(At < Whole.size() ? Whole[At] : 0);
			continue;
		}
		uint32_t Bits = 0;
		const uint32_t Slot = Reflection.Slots.at(Place.Variable->Id);
		const FSpirvType& Type = Module.GetType(Place.Variable->Type);
		if (!Type.bBufferBlock)
		{
			std::memcpy(&Bits, Args->ConstantBuffers[Slot] + At, 4);
		}
		else
		{
			const FKernelBuffer& Buffer = Type.Members[0].bNonWritable ? Args->Buffers[Slot] : Args->RWBuffers[Slot];
			const uint64_t Byte = uint64_t(Get(Place.Element)[0]) * Place.ElementStride + At;
			if (Get(Place.Element)[0] < Buffer.SizeInBytes / Place.ElementStride && Byte + 4 <= Buffer.SizeInBytes)
			{
				std::memcpy(&Bits, Buffer.Data + Byte, 4);
			}
		}
		Result.push_back(Bits);
	}
	return Result;
}

void FSpirvInterpreterImpl::Store(uint32_t Pointer, const FScalars& Value)
{
	const FSpirvPlace Place = Resolve(Pointer);
	const uint32_t Offset = DynamicOffset(Place);
	for (size_t i = 0; i < Place.Scalars.size() && i < Value.size(); ++i)
	{
		const uint32_t At = Offset + Place.Scalars[i];
		if (!Place.bBytes)
		{
			FScalars& Whole = Memory[Place.Variable->Id];
			if (At < Whole.size())
			{
				Whole[At] = Value[i];
			}
			continue;
		}
		if (!Place.ElementStride)
		{
			Module.Fail("a store into '" + Place.Variable->Name + "', which is read-only");
		}
		const FKernelBuffer& Buffer = Args->RWBuffers[Reflection.Slots.at(Place.Variable->Id)];
		const uint64_t Byte = uint64_t(Get(Place.Element)[0]) * Place.ElementStride + At;
		if (Get(Place.Element)[0] < Buffer.SizeInBytes / Place.ElementStride && Byte + 4 <= Buffer.SizeInBytes)
		{
			std::memcpy(Buffer.Data + Byte, &Value[i], 4);
		}
	}
}

void FSpirvInterpreterImpl::Execute(const FSpirvInstruction& I)
{
	FScalars Result;
	switch (I.Op)
	{
	case OpLoad:
		if (Module.GetType(I.Type).NumScalars)
		{
			Values[I.Result] = Load(I.Operands[0]);
		}
		return;
	case OpStore:
		Store(I.Operands[0], Get(I.Operands[1]));
		return;
	case OpAccessChain:
	case OpInBoundsAccessChain:
		return;
	case OpFunctionCall:
		bDiscarded = true;
		return;
	case OpArrayLength:
	{
		const FSpirvVariable& Variable = *Module.FindVariable(I.Operands[0]);
		const FSpirvType& Type = Module.GetType(Variable.Type);
		const uint32_t Slot = Reflection.Slots.at(Variable.Id);
		const FKernelBuffer& Buffer = Type.Members[0].bNonWritable ? Args->Buffers[Slot] : Args->RWBuffers[Slot];
		Values[I.Result] = {
			Buffer.SizeInBytes /
			std::max(4u, Module.GetType(Module.GetMemberType(Variable.Type, I.Operands[1])).ArrayStride)};
		return;
	}
	case OpExtInst:
		ExecuteExtended(I, Result);
		break;
	default:
		if (!ExecuteComposite(I, Result) && !ExecuteMatrix(I, Result) && !ExecuteImage(I, Result))
		{
			for (uint32_t i = 0; i < Module.GetType(I.Type).NumScalars; ++i)
			{
				uint32_t Operands[3] = {};
				for (size_t k = 0; k < I.Operands.size() && k < 3; ++k)
				{
					const FScalars& Value = Get(I.Operands[k]);
					Operands[k] = Value[Value.size() == 1 ? 0 : i];
				}
				uint32_t Bits = 0;
				if (!EvaluateOperation(I.Op, Operands, Bits))
				{
					Module.Fail("the model does not know " + GetSpirvOpName(I.Op), &I);
				}
				Result.push_back(Bits);
			}
		}
		break;
	}
	if (I.Result)
	{
		Values[I.Result] = std::move(Result);
	}
}

void FSpirvInterpreterImpl::EnterBlock(const FSpirvBlock& Block, uint32_t From)
{
	// All phis of a block read before any of them is written.
	std::vector<std::pair<uint32_t, FScalars>> New;
	for (const FSpirvInstruction& I : Block.Instructions)
	{
		if (I.Op != OpPhi)
		{
			break;
		}
		for (size_t k = 0; k < I.Operands.size(); k += 2)
		{
			if (I.Operands[k + 1] == From)
			{
				New.emplace_back(I.Result, Get(I.Operands[k]));
				break;
			}
		}
	}
	for (auto& [Id, Value] : New)
	{
		Values[Id] = std::move(Value);
	}
}

uint32_t FSpirvInterpreterImpl::ChooseTarget(const FSpirvInstruction& Terminator)
{
	switch (Terminator.Op)
	{
	case OpBranch:
		return Terminator.Operands[0];
	case OpBranchConditional:
		return Terminator.Operands[Get(Terminator.Operands[0])[0] ? 1 : 2];
	case OpSwitch:
		for (size_t i = 2; i + 1 < Terminator.Operands.size(); i += 2)
		{
			if (Terminator.Operands[i] == Get(Terminator.Operands[0])[0])
			{
				return Terminator.Operands[i + 1];
			}
		}
		return Terminator.Operands[1];
	case OpKill:
		bDiscarded = true;
		return 0;
	default:
		return 0;
	}
}

void FSpirvInterpreterImpl::RunThread(uint64_t MaxSteps)
{
	bDiscarded = false;
	Values.clear();
	Memory.clear();
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const FSpirvConstant* Initial = Variable.Initializer ? Module.FindConstant(Variable.Initializer) : nullptr;
		if (!Variable.Initializer && Module.GetType(Variable.Type).NumScalars)
		{
			Memory[Variable.Id].assign(Module.GetType(Variable.Type).NumScalars, 0);
		}
		else if (Initial)
		{
			Memory[Variable.Id] = Initial->Scalars;
		}
	}
	uint64_t Steps = 0;
	const FSpirvBlock* Block = &Module.Blocks[0];
	while (Block && !bDiscarded)
	{
		for (const FSpirvInstruction& I : Block->Instructions)
		{
			if (++Steps > MaxSteps)
			{
				Module.Fail("the shader did not end", &I);
			}
			const bool bTerminator = I.Op >= OpBranch && I.Op <= OpUnreachable;
			if (I.Op != OpPhi && !bTerminator && !bDiscarded)
			{
				Execute(I);
			}
		}
		const uint32_t Target = bDiscarded ? 0 : ChooseTarget(Block->Terminator());
		const FSpirvBlock* const Next = Target ? &Module.GetBlock(Target) : nullptr;
		if (Next)
		{
			EnterBlock(*Next, Block->Label);
		}
		Block = Next;
	}
}

FInterpretedPixel FSpirvInterpreterImpl::Run(
	const FKernelArgs& InArgs, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	if (Module.ExecutionModel == ExecutionModelVertex)
	{
		Module.Fail("a vertex shader has no pixel or thread to run for");
	}
	Args = &InArgs;
	Vertex = nullptr;
	Position[0] = X;
	Position[1] = Y;
	Position[2] = Z;
	RunThread(MaxSteps);
	FInterpretedPixel Pixel;
	Pixel.bDiscarded = bDiscarded;
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		for (uint32_t i = 0;
			 Variable.Storage == StorageOutput && Variable.Location < 8 && i < 4 && i < Memory[Variable.Id].size(); ++i)
		{
			Pixel.Targets[Variable.Location][i] = ToFloat(Memory[Variable.Id][i]);
		}
	}
	return Pixel;
}

FSpirvInterpreter::FSpirvInterpreter(const FSpirvModule& Module, const FSpirvReflection& Reflection)
	: Impl(std::make_unique<FSpirvInterpreterImpl>(Module, Reflection))
{
}

FSpirvInterpreter::~FSpirvInterpreter() = default;

FInterpretedPixel FSpirvInterpreter::Run(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	return Impl->Run(Args, X, Y, Z, MaxSteps);
}

} // namespace Drydock
