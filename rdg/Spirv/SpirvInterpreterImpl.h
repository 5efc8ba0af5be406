// The interpreter's state while one thread runs. SpirvInterpreterImpl.cpp: blocks and memory;
// SpirvInterpreterValues.cpp: vectors, matrices and functions of them; SpirvInterpreterImages.cpp: textures;
// SpirvVertexProgram.cpp: what belongs to vertices.
#pragma once

#include "SpirvInterpreter.h"

#include "Lanes.h"
#include "SpirvPlace.h"
#include "SpirvScalarMath.h"

#include <algorithm>

namespace Drydock
{

class FSpirvInterpreterImpl
{
public:
	FSpirvInterpreterImpl(const FSpirvModule& InModule, const FSpirvReflection& InReflection)
		: Module(InModule)
		, Reflection(InReflection)
	{
		for (const FSpirvBlock& Block : Module.Blocks)
		{
			for (const FSpirvInstruction& I : Block.Instructions)
			{
				if (I.Result)
				{
					Definitions[I.Result] = &I;
				}
			}
		}
	}

	FInterpretedPixel Run(const FKernelArgs& InArgs, int32_t X, int32_t Y, int32_t Z, uint64_t MaxSteps);
	FVertexOutput RunVertex(const FKernelArgs& InArgs, const FVertexInput& Input, uint64_t MaxSteps);

private:
	using FScalars = std::vector<uint32_t>;

	void RunThread(uint64_t MaxSteps);
	void Execute(const FSpirvInstruction& I);
	bool ExecuteComposite(const FSpirvInstruction& I, FScalars& Result);
	bool ExecuteMatrix(const FSpirvInstruction& I, FScalars& Result);
	bool ExecuteImage(const FSpirvInstruction& I, FScalars& Result);
	void ExecuteExtended(const FSpirvInstruction& I, FScalars& Result);
	FScalars Load(uint32_t Pointer);
	void Store(uint32_t Pointer, const FScalars& Value);
	FScalars LoadInput(const FSpirvVariable& Variable) const;
	FScalars LoadAttribute(const FSpirvVariable& Variable) const;
	uint32_t ChooseTarget(const FSpirvInstruction& Terminator);
	void EnterBlock(const FSpirvBlock& Block, uint32_t From);

	const FScalars& Get(uint32_t Id)
	{
		if (const FSpirvConstant* Constant = Module.FindConstant(Id))
		{
			return Constant->Scalars;
		}
		FScalars& Value = Values[Id];
		Value.resize(Module.GetValueType(Id).NumScalars, 0);
		return Value;
	}
	float GetFloat(uint32_t Id, uint32_t Index) { return ToFloat(Get(Id)[Index]); }
	FSpirvPlace Resolve(uint32_t Pointer) const
	{
		const auto Chain = Definitions.find(Pointer);
		return ResolvePlace(Module, Pointer, Chain == Definitions.end() ? nullptr : Chain->second);
	}
	uint32_t DynamicOffset(const FSpirvPlace& Place)
	{
		uint32_t Offset = Place.Offset;
		for (const FSpirvIndex& Index : Place.Indices)
		{
			Offset += std::min(Get(Index.Value)[0], Index.Count - 1) * Index.Stride;
		}
		return Offset;
	}
	const FSpirvVariable& HandleOf(uint32_t Id) const;
	uint32_t SlotOf(uint32_t Id) const { return Reflection.Slots.at(HandleOf(Id).Id); }

	const FSpirvModule& Module;
	const FSpirvReflection& Reflection;
	std::map<uint32_t, const FSpirvInstruction*> Definitions;
	std::unordered_map<uint32_t, FScalars> Values;
	std::unordered_map<uint32_t, FScalars> Memory; // variables of the thread
	const FKernelArgs* Args = nullptr;
	const FVertexInput* Vertex = nullptr; // of a vertex shader
	int32_t Position[3] = {};
	bool bDiscarded = false;
};

} // namespace Drydock
