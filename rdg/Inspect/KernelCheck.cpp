// Watches threads, and sums up over a dispatch.
#include "KernelCheck.h"

#include "OperationText.h"
#include "PixelFormatConversion.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace Drydock
{

using namespace Spirv;

const char* GetCheckName(ECheck Check)
{
	constexpr const char* Names[] = {"nan", "overflow", "negative", "denormal", "bounds", "uninit"};
	return Names[size_t(Check)];
}

namespace
{

constexpr uint64_t MaxSteps = 100'000'000;

/** Kind, file, line: what a finding is known by. */
using FFindingKey = std::tuple<ECheck, uint32_t, int>;

struct FFindings
{
	std::map<FFindingKey, FCheckFinding> All;
};

double GetLeastNormal(ETexelStorage Storage)
{
	switch (Storage)
	{
	case ETexelStorage::R16_FLOAT:
	case ETexelStorage::RG16_FLOAT:
	case ETexelStorage::RGBA16_FLOAT:
	case ETexelStorage::R11G11B10_FLOAT:
		return 0x1p-14;
	case ETexelStorage::R32_FLOAT:
	case ETexelStorage::RG32_FLOAT:
	case ETexelStorage::RGB32_FLOAT:
	case ETexelStorage::RGBA32_FLOAT:
		return 0x1p-126;
	default:
		return 0;
	}
}

class FThreadChecker final : public ISpirvObserver
{
public:
	FThreadChecker(
		const FInspectedShader& InShader, const FKernelArgs& InArgs, const FCheckSet& InChecks, FFindings& OutFindings)
		: Shader(InShader)
		, Module(InShader.GetModule())
		, Program(InShader.GetProgram())
		, Args(InArgs)
		, Checks(InChecks)
		, Findings(OutFindings)
		, AuthorsDepth(Module.Functions.empty() ? 0 : 1)
	{
	}

	void Begin()
	{
		Found.clear();
		LastStore = nullptr;
	}

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const uint16_t Op = Step.I->Op;
		if (Op == OpImageWrite)
		{
			CheckWrite(Thread, Step);
		}
		else if (Op == OpStore || Op == OpReturnValue)
		{
			LastStore = Thread.GetDepth() == AuthorsDepth ? &Step : LastStore;
		}
		else if (Checks[ECheck::NonFinite])
		{
			CheckOperation(Thread, Step);
		}
	}

	void OnFault(const FSpirvThreadView& Thread, const FSpirvStep& Step, const FSpirvFault& Fault) override
	{
		const ECheck Check = Fault.Kind == ESpirvFault::Undefined ? ECheck::Uninitialized : ECheck::Bounds;
		if (Checks[Check])
		{
			// What leaves the thread unwritten has the line of the last store, not of the shader's end.
			Add(Thread, Check, Fault.bAtEnd && LastStore ? *LastStore->I : *Step.I, DescribeFault(Fault));
		}
	}

	/** A colour that goes to a render target; its line is that of the last store. */
	void CheckTarget(const FSpirvThreadView& Thread, size_t Variable)
	{
		const FSpirvVariable& Output = Module.Variables[Variable];
		if (Output.Location >= uint32_t(Args.NumTargets) || !LastStore)
		{
			return;
		}
		const FSpirvMemory& Memory = Program.Memory[Variable];
		std::vector<double> Color;
		for (uint32_t i = 0; i < Memory.Size; ++i)
		{
			Color.push_back(Thread.GetReal(Memory.First + i));
		}
		CheckColor(Thread, *LastStore->I, Color, Args.Targets[Output.Location].Texture,
			"SV_Target" + std::to_string(Output.Location));
	}

private:
	void CheckWrite(const FSpirvThreadView& Thread, const FSpirvStep& Step)
	{
		const uint32_t Variable = Thread.GetBits(Program.Args[Step.FirstArg]);
		const int32_t Slot = Shader.GetSlots().Slots.at(Variable);
		const FSpirvType& Image = Module.GetValueType(Step.I->Operands[0]);
		if (Slot < 0 || Image.Dim == DimBuffer || Module.GetType(Image.Element).Kind != ESpirvType::Float)
		{
			return;
		}
		std::vector<double> Color;
		const uint32_t Size = Module.GetValueType(Step.I->Operands[2]).NumScalars;
		for (uint32_t i = 0; i < Size && i < 4; ++i)
		{
			Color.push_back(Thread.GetReal(Program.Args[Step.FirstArg + 2] + i));
		}
		CheckColor(Thread, *Step.I, Color, Args.RWTextures[Slot], Module.Variables.at(Variable).Name);
	}

	void CheckColor(const FSpirvThreadView& Thread, const FSpirvInstruction& I, const std::vector<double>& Color,
		const FKernelTexture& Texture, const std::string& Name)
	{
		const FTexelStorageInfo& Info = GetTexelStorageInfo(Texture.Storage);
		if (Info.Kind != ETexelKind::Float)
		{
			return;
		}
		double RGBA[4] = {0, 0, 0, 1};
		std::copy_n(Color.begin(), std::min<size_t>(4, Color.size()), RGBA);
		uint8_t Texel[32] = {};
		double Kept[4] = {};
		EncodeTexel(Texture.Storage, RGBA, Texel, Texture.bSaturateStore != 0);
		DecodeTexel(Texture.Storage, Texel, Kept);
		constexpr const char* Channels[] = {"red", "green", "blue", "alpha"};
		for (int c = 0; c < Info.NumChannels && c < 4; ++c)
		{
			const std::string Stored = FormatReal(RGBA[c]) + " is stored to " + Name + " (" + Channels[c] + ")";
			if (Checks[ECheck::Overflow] && std::isfinite(RGBA[c]) && std::isinf(Kept[c]))
			{
				Add(Thread, ECheck::Overflow, I, Stored + ", whose " + Info.Name + " makes it infinite");
			}
			if (Checks[ECheck::Negative] && c < 3 && RGBA[c] < 0)
			{
				Add(Thread, ECheck::Negative, I, Stored);
			}
			if (Checks[ECheck::Denormal] && RGBA[c] != 0 && std::fabs(RGBA[c]) < GetLeastNormal(Texture.Storage))
			{
				Add(Thread, ECheck::Denormal, I, Stored + ", whose " + Info.Name + " has no full precision there");
			}
		}
	}

	/** An operation that makes NaN or infinity of finite numbers. What reads it from memory is not to blame. */
	void CheckOperation(const FSpirvThreadView& Thread, const FSpirvStep& Step)
	{
		const FSpirvInstruction& I = *Step.I;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const double Value = Thread.GetReal(Step.To + i);
			if (std::isfinite(Value))
			{
				continue;
			}
			const size_t First = I.Op == OpExtInst ? 2 : 0;
			bool bFinite = true;
			for (size_t k = First; k < I.Operands.size() && bFinite; ++k)
			{
				const uint32_t Type = Module.GetValueTypeId(I.Operands[k]);
				const uint32_t Size = Module.GetType(Type).NumScalars;
				for (uint32_t c = 0; c < Size; ++c)
				{
					const bool bReal = Module.GetScalarKind(Type, c) == ESpirvType::Float;
					bFinite = bFinite && (!bReal || std::isfinite(Thread.GetReal(Program.Args[Step.FirstArg + k] + c)));
				}
			}
			if (bFinite)
			{
				Add(Thread, ECheck::NonFinite, I,
					DescribeOperation(Program, Thread, Step, i) + " is " + FormatReal(Value));
				return;
			}
		}
	}

	void Add(const FSpirvThreadView& Thread, ECheck Check, const FSpirvInstruction& I, const std::string& What)
	{
		const FFindingKey Key(Check, I.File, I.Line);
		if (!Found.insert(Key).second)
		{
			return; // of this thread already
		}
		const int32_t* const At = Thread.GetPosition();
		const auto [Entry, bNew] = Findings.All.try_emplace(Key);
		FCheckFinding& Finding = Entry->second;
		if (bNew)
		{
			Finding.Check = Check;
			Finding.File = Module.Files.at(I.File);
			Finding.Line = I.Line;
			Finding.What = What;
			std::copy_n(At, 3, Finding.First);
		}
		++Finding.Threads;
		if (Finding.Pixels.size() < MaxCheckPixels)
		{
			Finding.Pixels.push_back({At[0], At[1]});
		}
	}

	const FInspectedShader& Shader;
	const FSpirvModule& Module;
	const FSpirvProgram& Program;
	const FKernelArgs& Args;
	const FCheckSet& Checks;
	FFindings& Findings;
	const size_t AuthorsDepth;   // of the entry point: below it is what the front end put around it
	std::set<FFindingKey> Found; // of the thread that runs
	const FSpirvStep* LastStore = nullptr;
};

/** Instructions whose result is made, not fetched. */
bool IsArithmetic(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	const bool bMade = I.Op == OpExtInst || I.Op == OpBitcast || (I.Op >= OpSNegate && I.Op <= OpDot);
	return bMade && I.Type && Module.GetType(I.Type).NumScalars && Module.GetScalarKind(I.Type, 0) == ESpirvType::Float;
}

void SetHooks(FInspectedShader& Shader, const FCheckSet& Checks)
{
	const bool bStores = Checks[ECheck::Overflow] || Checks[ECheck::Negative] || Checks[ECheck::Denormal];
	const FSpirvModule& Module = Shader.GetModule();
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		const uint16_t Op = Step.I->Op;
		const bool bStore = Op == OpStore || Op == OpReturnValue;
		Step.bHook =
			(Op == OpImageWrite && bStores) || bStore || (Checks[ECheck::NonFinite] && IsArithmetic(Module, *Step.I));
	}
}

/** Whether threads see what others stored: then their order counts. */
bool ReadsWhatItWrites(const FInspectedShader& Shader)
{
	const FSpirvModule& Module = Shader.GetModule();
	for (const FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		if (Step.I->Op == OpImageRead)
		{
			return true;
		}
		if (Step.I->Op == OpLoad && Step.Place != ~0u && Shader.GetProgram().PlaceOf(Step).ElementStride)
		{
			return true;
		}
	}
	return Module.ExecutionModel != ExecutionModelCompute && Module.ExecutionModel != ExecutionModelFragment;
}

void RunChunk(FInspectedShader& Shader, const FKernelArgs& Args, const std::vector<std::array<int32_t, 3>>& Threads,
	int32_t Begin, int32_t End, const FCheckSet& Checks, FFindings& Findings)
{
	FThreadChecker Checker(Shader, Args, Checks, Findings);
	TSpirvThread<float> Thread(Shader.GetProgram(), Shader.GetSlots());
	Thread.SetObserver(&Checker, Checks[ECheck::Uninitialized]);
	const FSpirvModule& Module = Shader.GetModule();
	for (int32_t Index = Begin; Index < End; ++Index)
	{
		const std::array<int32_t, 3>& At = Threads[size_t(Index)];
		Checker.Begin();
		Thread.Run(Args, {At[0], At[1], At[2]}, nullptr, MaxSteps);
		for (size_t i = 0; i < Module.Variables.size() && !Thread.WasDiscarded(); ++i)
		{
			if (Module.Variables[i].Storage == StorageOutput)
			{
				Checker.CheckTarget(Thread, i);
			}
		}
	}
}

} // namespace

std::vector<FCheckFinding> CheckThreads(FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args,
	const FKernelTile& Whole, const std::vector<std::array<int32_t, 3>>& Given, const FCheckSet& Checks)
{
	std::vector<std::array<int32_t, 3>> Threads = Given;
	for (int32_t z = Whole.MinZ; z < Whole.MaxZ && Given.empty(); ++z)
	{
		for (int32_t y = Whole.MinY; y < Whole.MaxY; ++y)
		{
			for (int32_t x = Whole.MinX; x < Whole.MaxX; ++x)
			{
				Threads.push_back({x, y, z});
			}
		}
	}
	SetHooks(Shader, Checks);
	constexpr int32_t ChunkSize = 1024;
	const bool bInOrder = ReadsWhatItWrites(Shader);
	const int32_t NumThreads = int32_t(Threads.size());
	const int32_t PerChunk = bInOrder ? std::max(1, NumThreads) : ChunkSize;
	std::vector<FFindings> Found(size_t((NumThreads + PerChunk - 1) / PerChunk));
	const FSandbox Sandbox(Args, Bound.GetReflection());
	ForEachTile(
		{0, 0, 0, NumThreads, 1, 1}, FIntPoint(PerChunk, 1),
		[&](const FKernelTile& Tile) {
			RunChunk(
				Shader, Sandbox.GetArgs(), Threads, Tile.MinX, Tile.MaxX, Checks, Found[size_t(Tile.MinX / PerChunk)]);
		},
		EDenormals::Flush);

	FFindings All;
	for (FFindings& Chunk : Found)
	{
		for (auto& [Key, Finding] : Chunk.All)
		{
			const auto [Entry, bNew] = All.All.try_emplace(Key, Finding);
			if (!bNew)
			{
				FCheckFinding& Known = Entry->second;
				Known.Threads += Finding.Threads;
				const size_t Room = MaxCheckPixels - Known.Pixels.size();
				Known.Pixels.insert(Known.Pixels.end(), Finding.Pixels.begin(),
					Finding.Pixels.begin() + std::ptrdiff_t(std::min(Room, Finding.Pixels.size())));
			}
		}
	}
	std::vector<FCheckFinding> Findings;
	for (auto& [Key, Finding] : All.All)
	{
		const std::string Line = Shader.GetLine(Finding.File, Finding.Line);
		const size_t Begin = Line.find_first_not_of(" \t");
		Finding.Source =
			Begin == std::string::npos ? std::string() : Line.substr(Begin, Line.find_last_not_of(" \t") + 1 - Begin);
		Findings.push_back(std::move(Finding));
	}
	std::stable_sort(Findings.begin(), Findings.end(),
		[](const FCheckFinding& A, const FCheckFinding& B)
		{ return std::tie(A.First[2], A.First[1], A.First[0]) < std::tie(B.First[2], B.First[1], B.First[0]); });
	return Findings;
}

} // namespace Drydock
