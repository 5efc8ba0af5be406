// Threads of a checked module, one after the other, in float.
#include "SpirvInterpreter.h"

#include "SpirvGroup.h"
#include "SpirvQuads.h"

namespace Drydock
{

using namespace Spirv;

class FSpirvInterpreterImpl
{
public:
	FSpirvInterpreterImpl(const FSpirvModule& Module, const FSpirvReflection& Reflection, uint32_t InWaveSize)
		: Program(Module)
		, Thread(Program, MakeSlots(Module, Reflection))
		, WaveSize(Module.bQuads ? GQuadSize : InWaveSize)
	{
		if (Program.Groups.bGroups || Module.bQuads)
		{
			Order = FindOrder(Module);
			Group = std::make_unique<TSpirvGroup<float>>(Program, Order, MakeSlots(Module, Reflection), WaveSize);
		}
	}

	static FSpirvSlotTable MakeSlots(const FSpirvModule& Module, const FSpirvReflection& Reflection)
	{
		FSpirvSlotTable Table;
		for (const FSpirvVariable& Variable : Module.Variables)
		{
			const auto Found = Reflection.Slots.find(Variable.Id);
			Table.Slots.push_back(Found == Reflection.Slots.end() ? -1 : int32_t(Found->second));
		}
		return Table;
	}

	static float GetReal(const TSpirvThread<float>& Of, size_t Variable, size_t Index)
	{
		return ToSpirvReal<float>(Of.GetMemory(Variable)[Index]);
	}

	/** The thread of one pixel or dispatch id, after its run. */
	const TSpirvThread<float>& Run(const FKernelArgs& Args, const int32_t (&At)[3], uint64_t MaxSteps)
	{
		if (!Program.Module.bQuads)
		{
			Thread.Run(Args, At, nullptr, MaxSteps);
			return Thread;
		}
		const uint32_t Index = uint32_t(At[1] & 1) * 2 + uint32_t(At[0] & 1);
		Group->SetHelpers(~(1u << Index));
		Group->Run(Args, {At[0] / 2, At[1] / 2, At[2]}, MaxSteps);
		return Group->GetThread(Index);
	}

	FSpirvProgram Program;
	TSpirvThread<float> Thread;
	const uint32_t WaveSize;
	FSpirvOrder Order;
	std::unique_ptr<TSpirvGroup<float>> Group; // where threads work together
};

FSpirvInterpreter::FSpirvInterpreter(const FSpirvModule& Module, const FSpirvReflection& Reflection, uint32_t WaveSize)
	: Impl(std::make_unique<FSpirvInterpreterImpl>(Module, Reflection, WaveSize))
{
}

FSpirvInterpreter::~FSpirvInterpreter() = default;

FInterpretedPixel FSpirvInterpreter::Run(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	const FSpirvModule& Module = Impl->Program.Module;
	if (Module.ExecutionModel == ExecutionModelVertex)
	{
		Module.Fail("a vertex shader has no pixel or thread to run for");
	}
	if (Impl->Program.Groups.bGroups)
	{
		Module.Fail("threads of this shader run by groups");
	}
	const TSpirvThread<float>& Thread = Impl->Run(Args, {X, Y, Z}, MaxSteps);
	FInterpretedPixel Pixel;
	Pixel.bDiscarded = Thread.WasDiscarded();
	for (size_t k = 0; k < Module.Variables.size(); ++k)
	{
		const FSpirvVariable& Variable = Module.Variables[k];
		if (Variable.Storage == StorageOutput && Variable.Location <= uint32_t(GDepthTarget))
		{
			for (uint32_t i = 0; i < 4 && i < Impl->Program.Memory[k].Size; ++i)
			{
				const float Value = Impl->GetReal(Thread, k, i);
				const bool bDepth = Variable.BuiltIn == BuiltInFragDepth;
				Pixel.Targets[Variable.Location][i] = bDepth ? (Value > 0 ? std::min(Value, 1.0f) : 0) : Value;
			}
		}
	}
	return Pixel;
}

void FSpirvInterpreter::RunGroup(const FKernelArgs& Args, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps)
{
	if (!Impl->Program.Groups.bGroups)
	{
		Impl->Program.Module.Fail("threads of this shader run one by one");
	}
	Impl->Group->Run(Args, {X, Y, Z}, MaxSteps);
}

FVertexOutput FSpirvInterpreter::RunVertex(const FKernelArgs& Args, const FVertexInput& Input, uint64_t MaxSteps)
{
	const FSpirvModule& Module = Impl->Program.Module;
	if (Module.ExecutionModel != ExecutionModelVertex)
	{
		Module.Fail("this is not a vertex shader");
	}
	Impl->Thread.Run(Args, {0, 0, 0}, &Input, MaxSteps);
	FVertexOutput Output;
	for (size_t k = 0; k < Module.Variables.size(); ++k)
	{
		const FSpirvVariable& Variable = Module.Variables[k];
		const int32_t TexCoord = GetInterpolantIndex(Variable);
		const bool bPosition = Variable.BuiltIn == BuiltInPosition;
		if (Variable.Storage != StorageOutput || (!bPosition && TexCoord < 0))
		{
			continue;
		}
		const FSpirvType& Type = Module.GetType(Variable.Type);
		const ESpirvType Kind = Module.GetScalarKind(Variable.Type, 0);
		const size_t NumWords = Impl->Program.Memory[k].Size;
		const size_t Size = Type.Kind == ESpirvType::Array ? Module.GetType(Type.Element).NumScalars : NumWords;
		for (size_t i = 0; i < NumWords; ++i)
		{
			const size_t Index = size_t(std::max(0, TexCoord)) + i / Size;
			if (bPosition ? i < 4 : Index < size_t(GMaxInterpolants) && i % Size < 4)
			{
				const auto Word = uint32_t(Impl->Thread.GetMemory(k)[i]);
				const float Real = Impl->GetReal(Impl->Thread, k, i);
				const double Value = Kind == ESpirvType::Int    ? double(int32_t(Word))
									 : Kind == ESpirvType::Uint ? double(Word)
																: double(Real);
				if (bPosition)
				{
					Output.Position[i] = Real;
				}
				else
				{
					Output.TexCoords[Index][i % Size] = Value;
				}
			}
		}
	}
	return Output;
}

} // namespace Drydock
