// Makes lines of steps.
#include "TraceRecorder.h"

#include "GroupRuns.h"
#include "LanesLod.h"

#include <optional>

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr size_t MaxTracedWords = 64; // of one value: a larger array is not written out at every store

class FTraceRecorder final : public ISpirvObserver
{
public:
	FTraceRecorder(const FInspectedShader& InShader, const FKernelArgs& InArgs, FPixelTrace& OutTrace)
		: Shader(InShader)
		, Module(InShader.GetModule())
		, Program(InShader.GetProgram())
		, Args(InArgs)
		, Trace(OutTrace)
	{
		Functions.push_back(FindName(Module.EntryFunction));
	}

	/** Numbers that the thread will read from groupshared memory. */
	void SetShared(std::vector<FSharedRead> InShared) { Shared = std::move(InShared); }

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		++Trace.Steps;
		const size_t FirstShared = NextShared;
		NextShared += FindShared(Thread, Step) < Module.Variables.size() ? Step.Size : 0;
		if (Functions.back().empty() && !Module.Functions.empty())
		{
			return; // around the author's entry point
		}
		FTraceLine* const Line = FindLine(Thread, *Step.I);
		if (!Line)
		{
			return;
		}
		switch (Step.I->Op)
		{
		case OpStore:
			AddStore(Thread, Step, *Line);
			break;
		case OpLoad:
			AddBufferLoad(Thread, Step, *Line);
			AddSharedLoad(Thread, Step, *Line, FirstShared);
			break;
		case OpImageSampleImplicitLod:
		case OpImageSampleExplicitLod:
		case OpImageSampleDrefImplicitLod:
		case OpImageSampleDrefExplicitLod:
		case OpImageDrefGather:
		case OpImageGather:
			AddSample(Thread, Step, *Line);
			break;
		case OpImageFetch:
		case OpImageRead:
		case OpImageWrite:
			AddTexel(Thread, Step, *Line);
			break;
		case OpBranchConditional:
		case OpSwitch:
			Line->Events.push_back({ETraceEvent::Branch, {}, ValueOf(Thread, Step, 0), {}, 0, {}, {}});
			break;
		default:
			break;
		}
	}

	void OnCall(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const std::string Name = FindName(Step.I->Operands[0]);
		FTraceLine* const Line = Functions.back().empty() ? nullptr : FindLine(Thread, *Step.I, 1);
		if (Line && !Name.empty())
		{
			Line->Events.push_back({ETraceEvent::Call, Name, {}, {}, 0, {}, {}});
		}
		Functions.push_back(Name);
		bNewLine = true;
	}

	void OnReturn(const FSpirvThreadView& Thread, const FSpirvStep& Call) override
	{
		const std::string Name = Functions.back();
		Functions.pop_back();
		FTraceLine* const Line = Functions.back().empty() ? nullptr : FindLine(Thread, *Call.I);
		bNewLine = true;
		if (Line && Call.Size)
		{
			bNewLine = false;
			Line->Events.push_back({ETraceEvent::Return, Name, Read(Thread, Call.I->Type, Call.To), {}, 0, {}, {}});
		}
	}

	void OnFault(const FSpirvThreadView& Thread, const FSpirvStep& Step, const FSpirvFault& Fault) override
	{
		FTraceLine* const Line =
			Fault.bAtEnd ? (Trace.Lines.empty() ? nullptr : &Trace.Lines.back()) : FindLine(Thread, *Step.I);
		if (Line)
		{
			Line->Events.push_back({ETraceEvent::Fault, DescribeFault(Fault), {}, {}, 0, {}, {}});
		}
	}

private:
	std::string FindName(uint32_t Function) const
	{
		for (const FSpirvFunction& Known : Module.Functions)
		{
			if (Known.Id == Function)
			{
				return Known.Name;
			}
		}
		return {};
	}

	/** Null: the trace is full, or the instruction has no line. */
	FTraceLine* FindLine(const FSpirvThreadView& Thread, const FSpirvInstruction& I, size_t Deeper = 0)
	{
		if (!I.Line)
		{
			return nullptr;
		}
		const size_t Depth = Thread.GetDepth() - Deeper;
		const bool bSame = !bNewLine && !Trace.Lines.empty() && Trace.Lines.back().Line == I.Line &&
						   LastFile == I.File && Trace.Lines.back().Depth == Depth;
		const size_t NumEvents = EarlierEvents + (Trace.Lines.empty() ? 0 : Trace.Lines.back().Events.size());
		// A loop may stand in one line.
		if (NumEvents >= MaxTraceEvents || (!bSame && Trace.Lines.size() >= MaxTraceLines))
		{
			Trace.bCut = true;
			return nullptr;
		}
		if (!bSame)
		{
			EarlierEvents = NumEvents;
			Trace.Lines.push_back({Module.Files.at(I.File), I.Line, Functions.back(), Depth, {}});
			LastFile = I.File;
			bNewLine = false;
		}
		return &Trace.Lines.back();
	}

	FTraceValue Read(const FSpirvThreadView& Thread, uint32_t Type, uint32_t First) const
	{
		FTraceValue Value;
		Value.Type = Type;
		const uint32_t Size = Program.WordsOf(Type);
		for (uint32_t i = 0; i < Size; ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(Type, i);
			Value.Bits.push_back(Thread.GetBits(First + i));
			Value.Reals.push_back(Thread.GetNumber(First + i, Kind));
		}
		return Value;
	}

	uint32_t WordOf(const FSpirvStep& Step, size_t Operand) const { return Program.Args[Step.FirstArg + Operand]; }

	FTraceValue ValueOf(const FSpirvThreadView& Thread, const FSpirvStep& Step, size_t Operand) const
	{
		return Read(Thread, Module.GetValueTypeId(Step.I->Operands[Operand]), WordOf(Step, Operand));
	}

	void AddStore(const FSpirvThreadView& Thread, const FSpirvStep& Step, FTraceLine& Line)
	{
		if (Step.Place != ~0u)
		{
			const uint32_t Pointer = WordOf(Step, 0);
			const FSpirvVariable& Buffer = Module.Variables.at(Thread.GetBits(Pointer + 2));
			Line.Events.push_back({ETraceEvent::Store, Buffer.Name, ValueOf(Thread, Step, 1), {}, 0,
				{int64_t(Thread.GetBits(Pointer + 1))}, {}});
			return;
		}
		const uint32_t At = Thread.GetBits(WordOf(Step, 0));
		for (size_t i = 0; i < Program.Memory.size(); ++i)
		{
			const FSpirvMemory& Memory = Program.Memory[i];
			const FSpirvVariable& Variable = Module.Variables[i];
			if (At < Memory.First || At >= Memory.First + Memory.Size)
			{
				continue;
			}
			const bool bNumeric = Module.GetType(Variable.Type).NumScalars != 0;
			const std::string& Name = Program.VariableNames[i];
			if (!bNumeric || Name.empty() || Memory.Size > MaxTracedWords)
			{
				return;
			}
			// A line that stores several components one by one gets one event: the whole.
			if (!Line.Events.empty() && Line.Events.back().Kind == ETraceEvent::Value &&
				Line.Events.back().Name == Name)
			{
				Line.Events.pop_back();
			}
			Line.Events.push_back({ETraceEvent::Value, Name, Read(Thread, Variable.Type, Memory.First), {}, 0, {}, {}});
			return;
		}
	}

	void AddBufferLoad(const FSpirvThreadView& Thread, const FSpirvStep& Step, FTraceLine& Line)
	{
		if (Step.Place == ~0u || !Step.Size || !Program.PlaceOf(Step).ElementStride)
		{
			return;
		}
		const uint32_t Pointer = WordOf(Step, 0);
		const FSpirvVariable& Buffer = Module.Variables.at(Thread.GetBits(Pointer + 2));
		Line.Events.push_back({ETraceEvent::Load, Buffer.Name, Read(Thread, Step.I->Type, Step.To), {}, 0,
			{int64_t(Thread.GetBits(Pointer + 1))}, {}});
	}

	/** The groupshared variable that a load is of; else past the last. */
	size_t FindShared(const FSpirvThreadView& Thread, const FSpirvStep& Step) const
	{
		size_t Found = Module.Variables.size();
		for (size_t i = 0; Step.I->Op == OpLoad && Step.Place == ~0u && i < Module.Variables.size(); ++i)
		{
			const uint32_t At = Thread.GetBits(WordOf(Step, 0));
			const bool bInside = At - Program.Memory[i].First < Program.Memory[i].Size;
			Found = bInside && Module.Variables[i].Storage == StorageWorkgroup ? i : Found;
		}
		return Found;
	}

	void AddSharedLoad(const FSpirvThreadView& Thread, const FSpirvStep& Step, FTraceLine& Line, size_t First)
	{
		const size_t Variable = FindShared(Thread, Step);
		if (Variable == Module.Variables.size() || First >= Shared.size())
		{
			return;
		}
		FTraceEvent Event;
		Event.Kind = ETraceEvent::Load;
		Event.bShared = true;
		Event.Name = Module.Variables[Variable].Name;
		Event.Value = Read(Thread, Step.I->Type, Step.To);
		const FSpirvType& Type = Module.GetType(Module.Variables[Variable].Type);
		if (Type.Kind == ESpirvType::Array)
		{
			const uint32_t Size = std::max(1u, Module.GetType(Type.Element).NumScalars);
			Event.Texel = {(Thread.GetBits(WordOf(Step, 0)) - Program.Memory[Variable].First) / Size};
		}
		if (const FSpirvStep* const Writer = Shared[First].Writer)
		{
			const int32_t* const At = Thread.GetPosition();
			std::array<int32_t, 3> GroupId;
			for (size_t Axis = 0; Axis < 3; ++Axis)
			{
				GroupId[Axis] = At[Axis] / int32_t(Module.LocalSize[Axis]);
			}
			Event.Writer = GetThreadPosition(Module, GroupId, Shared[First].Thread);
			Event.WriterLine = Writer->I->Line;
		}
		Line.Events.push_back(std::move(Event));
	}

	static double GetGradientLevel(const FKernelTexture& Texture, const FFootprintPlace& Place, std::vector<double> DX,
		std::vector<double> DY, uint32_t Axes)
	{
		using FFlat = Lanes::TVec<double, 2>;
		using FVector = Lanes::TVec<double, 3>;
		DX.resize(3);
		DY.resize(3);
		const FVector X(DX[0], DX[1], DX[2]);
		const FVector Y(DY[0], DY[1], DY[2]);
		return Place.bCube ? Lanes::GradientLevelCube(Texture, FVector(Place.At[0], Place.At[1], Place.At[2]), X, Y)
			   : Axes == 2 ? Lanes::GradientLevel(Texture, FFlat(DX[0], DX[1]), FFlat(DY[0], DY[1]))
						   : Lanes::GradientLevel(Texture, X, Y);
	}

	void AddSample(const FSpirvThreadView& Thread, const FSpirvStep& Step, FTraceLine& Line)
	{
		const uint32_t Pair = WordOf(Step, 0);
		const uint32_t TextureVariable = Thread.GetBits(Pair);
		const int32_t TextureSlot = Shader.GetSlots().Slots.at(TextureVariable);
		const int32_t SamplerSlot = Shader.GetSlots().Slots.at(Thread.GetBits(Pair + 1));
		const FSpirvType& Image = Module.GetType(Module.GetValueType(Step.I->Operands[0]).Element);
		FTraceEvent Event;
		Event.Kind = ETraceEvent::Sample;
		Event.Name = Module.Variables.at(TextureVariable).Name;
		Event.Value = Read(Thread, Step.I->Type, Step.To);
		Event.Coordinates = ValueOf(Thread, Step, 1).Reals;
		const FSpirvImageOperands Told = GetImageOperands(*Step.I);
		const uint32_t Axes = Image.Dim == Dim2D ? 2 : 3;
		FFootprintPlace Place;
		std::copy_n(Event.Coordinates.begin(), std::min<size_t>(Axes, Event.Coordinates.size()), Place.At);
		Place.Layer = Image.bArrayed && Event.Coordinates.size() > Axes ? Event.Coordinates[Axes] : 0;
		Place.bCube = Image.Dim == DimCube;
		const std::vector<double> Offset =
			Told.Offset ? ValueOf(Thread, Step, Told.Offset).Reals : std::vector<double>();
		std::copy_n(Offset.begin(), std::min<size_t>(Axes, Offset.size()), Place.Offset);
		Event.Coordinates.resize(std::min<size_t>(Axes + Image.bArrayed, Event.Coordinates.size()));
		if (TextureSlot < 0 || SamplerSlot < 0)
		{
			Line.Events.push_back(std::move(Event));
			return;
		}
		const FKernelTexture& Texture = Args.Textures[TextureSlot];
		Event.Level = Module.bQuads && ChoosesSpirvLevel(Step.I->Op) ? Thread.GetLevel()
					  : Told.Lod                                     ? Thread.GetReal(WordOf(Step, Told.Lod))
					  : Told.GradX ? GetGradientLevel(Texture, Place, ValueOf(Thread, Step, Told.GradX).Reals,
										 ValueOf(Thread, Step, Told.GradY).Reals, Axes)
								   : 0;
		if (Told.MinLod && Told.GradX)
		{
			Event.Level =
				Lanes::ClampLevel(Args.Samplers[SamplerSlot], Event.Level, Thread.GetReal(WordOf(Step, Told.MinLod)));
		}
		Place.Level = Event.Level;
		if (!IsSpirvGather(Step.I->Op))
		{
			Event.Texels = FindFootprint(Texture, Args.Samplers[SamplerSlot], Place);
		}
		else if (!Told.Offsets)
		{
			Event.Texels = FindGathered(Texture, Args.Samplers[SamplerSlot], Place);
		}
		Line.Events.push_back(std::move(Event));
	}

	void AddTexel(const FSpirvThreadView& Thread, const FSpirvStep& Step, FTraceLine& Line)
	{
		const bool bWrite = Step.I->Op == OpImageWrite;
		FTraceEvent Event;
		Event.Kind = bWrite ? ETraceEvent::Store : ETraceEvent::Load;
		Event.Name = Module.Variables.at(Thread.GetBits(WordOf(Step, 0))).Name;
		for (const double Index : ValueOf(Thread, Step, 1).Reals)
		{
			Event.Texel.push_back(int64_t(Index));
		}
		Event.Value = bWrite ? ValueOf(Thread, Step, 2) : Read(Thread, Step.I->Type, Step.To);
		Line.Events.push_back(std::move(Event));
	}

	const FInspectedShader& Shader;
	const FSpirvModule& Module;
	const FSpirvProgram& Program;
	const FKernelArgs& Args;
	FPixelTrace& Trace;
	std::vector<std::string> Functions; // that have not returned
	std::vector<FSharedRead> Shared;
	size_t NextShared = 0;
	size_t EarlierEvents = 0; // of lines before the last
	uint32_t LastFile = 0;
	bool bNewLine = false;
};

template<typename Real>
FPixelTrace Trace(FInspectedShader& Shader, const FKernelArgs& Args, const int32_t (&Position)[3], uint64_t MaxSteps)
{
	FPixelTrace Result;
	FTraceRecorder Recorder(Shader, Args, Result);
	TSpirvThread<Real> Thread(Shader.GetProgram(), Shader.GetSlots());
	std::optional<TGroupRuns<Real>> Runs;
	if (Shader.HasGroups())
	{
		// Groups that ran before it are not run again: where groups go in order, theirs is not seen.
		Runs.emplace(Shader);
		std::vector<FSharedRead> Shared;
		Runs->RunFor(Thread, Args, {Position[0], Position[1], Position[2]}, MaxSteps, &Shared);
		Recorder.SetShared(std::move(Shared));
	}
	Thread.SetObserver(&Recorder, true);
	Thread.Run(Args, Position, nullptr, MaxSteps);
	Result.bDiscarded = Thread.WasDiscarded();
	Result.Taps = Thread.Taps;
	const FSpirvModule& Module = Shader.GetModule();
	for (size_t i = 0; i < Module.Variables.size(); ++i)
	{
		const FSpirvVariable& Variable = Module.Variables[i];
		if (Variable.Storage != StorageOutput || Variable.Location >= 8 || Result.bDiscarded)
		{
			continue;
		}
		Result.Targets.resize(std::max<size_t>(Result.Targets.size(), Variable.Location + 1));
		for (uint32_t k = 0; k < Shader.GetProgram().Memory[i].Size; ++k)
		{
			Result.Targets[Variable.Location].push_back(
				Thread.GetNumber(Shader.GetProgram().Memory[i].First + k, Module.GetScalarKind(Variable.Type, k)));
		}
	}
	return Result;
}

} // namespace

FPixelTrace TracePixel(
	FInspectedShader& Shader, const FKernelArgs& Args, const int32_t (&Position)[3], bool bDouble, uint64_t MaxSteps)
{
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		Step.bHook = true;
	}
	return bDouble ? Trace<double>(Shader, Args, Position, MaxSteps) : Trace<float>(Shader, Args, Position, MaxSteps);
}

} // namespace Drydock
