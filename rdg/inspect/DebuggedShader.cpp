// Compiles what the emitter wrote; the interpreter carries out what its functions ask for.
#include "DebuggedShader.h"

#include "GroupRuns.h"

#include <optional>

#include "DebugEmitter.h"
#include "Diagnostics.h"
#include "KernelCompiler.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** Thrown through the shader's functions to its caller. */
struct FThreadEnds
{
};

struct FDebugRun
{
	const FSpirvProgram& Program;
	const FKernelArgs& Args;
	const FSpirvSlotTable& Slots;
	TSpirvThread<float> Thread;
	uint64_t StepsLeft;

	static void Execute(void* Self, uint32_t Step)
	{
		FDebugRun& Run = *static_cast<FDebugRun*>(Self);
		const FSpirvStep& Found = Run.Program.Steps[Step];
		if (Run.StepsLeft-- == 0)
		{
			Run.Program.Module.Fail("the shader did not end", Found.I);
		}
		if (!Run.Thread.ExecuteStep(Found))
		{
			throw FThreadEnds();
		}
	}

	static void Turn(void* Self, uint32_t To, uint32_t From)
	{
		static_cast<FDebugRun*>(Self)->Thread.CountTurn(To, From);
	}

	static void Take(const uint64_t* Words, void* To, uint32_t Count)
	{
		for (uint32_t i = 0; i < Count; ++i)
		{
			const uint32_t Bits = uint32_t(Words[i]);
			std::memcpy(static_cast<uint32_t*>(To) + i, &Bits, sizeof(Bits));
		}
	}

	static void Put(uint64_t* Words, const void* From, uint32_t Count)
	{
		for (uint32_t i = 0; i < Count; ++i)
		{
			uint32_t Bits = 0;
			std::memcpy(&Bits, static_cast<const uint32_t*>(From) + i, sizeof(Bits));
			Words[i] = Bits;
		}
	}

	static uint64_t ReadConstant(void* Self, uint32_t Variable, uint32_t Offset, uint8_t Kind)
	{
		const FDebugRun& Run = *static_cast<FDebugRun*>(Self);
		const int32_t Slot = Run.Slots.Slots.at(Variable);
		uint64_t Bits = 0;
		if (Slot >= 0 && Run.Args.ConstantBuffers[Slot])
		{
			std::memcpy(&Bits, Run.Args.ConstantBuffers[Slot] + Offset, GetSpirvBytes(ESpirvType(Kind)));
		}
		return FromSpirvMemory<float>(ESpirvType(Kind), Bits);
	}
};

std::string EmitOrExplain(const FInspectedShader& Shader, const FShaderCompileRequest& Request)
{
	try
	{
		return EmitDebugKernel(Shader, Request.EntryPoint);
	}
	catch (const FSpirvError& Error)
	{
		const std::string File = Error.File.empty() ? Request.VirtualPath : Error.File;
		throw FError(
			{ESeverity::Error, 6020, "'" + Request.EntryPoint + "' cannot be built for a debugger: " + Error.what(),
				File, Error.Line, 0, {}},
			ExitUsage);
	}
}

} // namespace

FDebuggedShader::FDebuggedShader(const FShaderCompileRequest& Request, const FShaderReflection& Reflection)
	: Inspected(Request, Reflection)
	, Kernel(CompileDebugKernel(EmitOrExplain(Inspected, Request), Folder, Request))
{
}

FDebuggedThread FDebuggedShader::Run(const FKernelArgs& Args, const FKernelTile& Whole,
	const std::array<int32_t, 3>& Position, uint64_t MaxSteps, bool bDebugged) const
{
	const FSpirvProgram& Program = Inspected.GetProgram();
	FDebugRun Run{Program, Args, Inspected.GetSlots(), TSpirvThread<float>(Program, Inspected.GetSlots()), MaxSteps};
	std::optional<TGroupRuns<float>> Groups;
	if (Inspected.HasGroups())
	{
		Groups.emplace(Inspected);
		Groups->RunFor(Run.Thread, Args, Position, MaxSteps);
	}
	FKernelArgs Own = Args;
	Own.Limits = bDebugged ? nullptr : Args.Limits;
	Run.Thread.Begin(Own, {Position[0], Position[1], Position[2]}, nullptr);
	FDebugKernelArgs Asked{Run.Thread.GetWords(), &Run, &FDebugRun::Execute, &FDebugRun::Turn, &FDebugRun::ReadConstant,
		&FDebugRun::Take, &FDebugRun::Put, {Position[0], Position[1], Position[2]},
		{Whole.MinX, Whole.MinY, Whole.MinZ}, {Whole.MaxX, Whole.MaxY, Whole.MaxZ}, {}, false};
	try
	{
		Kernel(Asked);
	}
	catch (const FThreadEnds&)
	{
		// As the thread asked.
	}
	FDebuggedThread Result;
	Result.bDiscarded = Run.Thread.WasDiscarded();
	const FSpirvModule& Module = Inspected.GetModule();
	for (size_t i = 0; i < Module.Variables.size() && !Result.bDiscarded; ++i)
	{
		const FSpirvVariable& Variable = Module.Variables[i];
		if (Variable.Storage == StorageOutput && Variable.Location < 8)
		{
			Result.Targets.resize(std::max<size_t>(Result.Targets.size(), Variable.Location + 1));
			for (uint32_t k = 0; k < Program.Memory[i].Size; ++k)
			{
				Result.Targets[Variable.Location].push_back(
					Run.Thread.GetNumber(Program.Memory[i].First + k, Module.GetScalarKind(Variable.Type, k)));
			}
		}
	}
	if (Asked.bAgain)
	{
		Result.Next = {Asked.Next[0], Asked.Next[1], Asked.Next[2]};
	}
	return Result;
}

} // namespace Drydock
