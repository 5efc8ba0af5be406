// Watches threads, and sums up over a dispatch.
#include "KernelCheck.h"

#include "AuthorsNames.h"
#include "OperationText.h"
#include "PixelFormatConversion.h"
#include "StoreOverlap.h"
#include "ThreadRuns.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <set>
#include <tuple>

namespace Drydock
{

using namespace Spirv;

const char* GetCheckName(ECheck Check)
{
	constexpr const char* Names[] = {
		"nan", "overflow", "negative", "denormal", "bounds", "uninit", "overlap", "assert", "race"};
	return Names[size_t(Check)];
}

namespace
{

/** Kind, file, line: what a finding is known by. */
using FFindingKey = std::tuple<ECheck, uint32_t, int>;

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

const std::string NoText;

class FThreadChecker final : public IThreadWatcher
{
public:
	FThreadChecker(const FInspectedShader& InShader, const FKernelArgs& InArgs, const FCheckSet& InChecks)
		: Shader(InShader)
		, Module(InShader.GetModule())
		, Program(InShader.GetProgram())
		, Args(InArgs)
		, Checks(InChecks)
		, Names(Program)
		, AuthorsDepth(Module.Functions.empty() ? 0 : 1)
	{
	}

	void BeginThread(size_t, TSpirvThread<float>&) override
	{
		Found.clear();
		LastStore = nullptr;
	}

	void EndThread(size_t, TSpirvThread<float>& Thread) override
	{
		for (size_t i = 0; i < Module.Variables.size() && !Thread.WasDiscarded(); ++i)
		{
			if (Module.Variables[i].Storage == StorageOutput)
			{
				CheckTarget(Thread, i);
			}
		}
	}

	FRaceFinder* GetRaceFinder() override { return Checks[ECheck::Race] ? &Races : nullptr; }

	void EndGroup(const std::array<int32_t, 3>& GroupId) override
	{
		if (!Checks[ECheck::Race])
		{
			return;
		}
		for (const FSpirvRace& Race : Races.GetRaces())
		{
			const std::array<int32_t, 3> At = GetThreadPosition(Module, GroupId, Race.Thread);
			FCheckFinding& Finding = Count(ECheck::Race, *Race.Step->I, At.data());
			if (Finding.What.empty())
			{
				Finding.What =
					DescribeRace(Program, Race, ListThread(GetThreadPosition(Module, GroupId, Race.ThreadBefore)));
			}
		}
	}

	const std::map<FFindingKey, FCheckFinding>& GetFindings() const { return Findings; }
	const std::vector<FThreadStore>& GetStores() const { return Stores; }

	void OnStep(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const uint16_t Op = Step.I->Op;
		if (Checks[ECheck::Overlap])
		{
			NoteStore(Thread, Step);
		}
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
			// An output left unwritten gets the line of the last store, not of the shader's end.
			Add(Thread, Check, Fault.bAtEnd && LastStore ? *LastStore->I : *Step.I,
				[&Fault] { return DescribeFault(Fault); });
		}
	}

	void OnCall(const FSpirvThreadView& Thread, const FSpirvStep& Step) override
	{
		const bool bAssertion = Checks[ECheck::Assertion] && Step.Function < Module.Functions.size() &&
								Module.Functions[Step.Function].Name == "DrydockAssertValue";
		if (bAssertion && !Thread.GetBits(GetParameter(Thread, Step, 1)))
		{
			const uint32_t Text = Thread.GetBits(GetParameter(Thread, Step, 0));
			const std::string& Condition = Text < Shader.GetStrings().size() ? Shader.GetStrings()[Text] : NoText;
			Add(Thread, ECheck::Assertion, *Step.I,
				[&] { return Condition + " does not hold" + ListOperands(Thread, Step); });
		}
	}

private:
	/** First word of an argument that a function was called with. */
	uint32_t GetParameter(const FSpirvThreadView& Thread, const FSpirvStep& Step, size_t Index) const
	{
		const uint32_t Word = Program.Functions[Step.Function].Parameters[Index];
		const FSpirvType& Type = Module.GetValueType(Module.Functions[Step.Function].Parameters[Index]);
		return Type.Kind == ESpirvType::Pointer ? Thread.GetBits(Word) : Word;
	}

	/** Variables that the line of a call reads: ": Weight = 0, Color = (1, 2, 3)". */
	std::string ListOperands(const FSpirvThreadView& Thread, const FSpirvStep& Call) const
	{
		std::string List;
		std::set<std::string> Listed;
		for (const FSpirvStep& Step : Program.Steps)
		{
			const bool bRead = Step.I->Op == OpLoad && Step.I->Line == Call.I->Line && Step.I->File == Call.I->File &&
							   Step.Place == ~0u;
			const std::optional<FNamedVariable> Variable =
				bRead ? Names.Find(Step.I->Operands[0]) : std::optional<FNamedVariable>();
			const uint32_t First = Variable ? Names.FindWords(Thread, Program.Args[Step.FirstArg]) : GNoSpirvWord;
			if (First == GNoSpirvWord || !Listed.insert(Variable->Name).second)
			{
				continue;
			}
			std::string Numbers;
			const uint32_t Size = std::min<uint32_t>(16, Module.GetType(Variable->Type).NumScalars);
			for (uint32_t i = 0; i < Size; ++i)
			{
				const ESpirvType Kind = Module.GetScalarKind(Variable->Type, i);
				Numbers += (i ? ", " : "") + FormatWord(Thread, First + i, Kind);
			}
			List += (List.empty() ? ": " : ", ") + Variable->Name + " = " + (Size == 1 ? Numbers : "(" + Numbers + ")");
		}
		return List;
	}

	void NoteStore(const FSpirvThreadView& Thread, const FSpirvStep& Step)
	{
		const bool bTexture = Step.I->Op == OpImageWrite;
		const bool bBuffer = Step.I->Op == OpStore && Step.Place != ~0u;
		if (!bTexture && !bBuffer)
		{
			return;
		}
		const uint32_t Where = Program.Args[Step.FirstArg];
		const int32_t* const At = Thread.GetPosition();
		FThreadStore Store{Thread.GetBits(bTexture ? Where : Where + 2), {}, {At[0], At[1], At[2]}, 0, &Step};
		const size_t ValueAt = bTexture ? 2 : 1;
		const uint32_t Coordinates = Program.Args[Step.FirstArg + 1];
		for (uint32_t i = 0; bTexture && i < 3 && i < Program.ArgSizes[Step.FirstArg + 1]; ++i)
		{
			Store.Texel[i] = int32_t(Thread.GetBits(Coordinates + i));
		}
		if (bBuffer)
		{
			Store.Texel = {int32_t(Thread.GetBits(Where + 1)), int32_t(Thread.GetBits(Where)), 0};
		}
		for (uint32_t i = 0; i < Program.ArgSizes[Step.FirstArg + ValueAt]; ++i)
		{
			Store.Value =
				Store.Value * 0x100000001b3 + Thread.GetWideBits(Program.Args[Step.FirstArg + ValueAt] + i) + 1;
		}
		Stores.push_back(Store);
	}

	/** A colour that goes to a render target; its line is that of the last store. */
	void CheckTarget(const FSpirvThreadView& Thread, size_t Variable)
	{
		const FSpirvVariable& Output = Module.Variables[Variable];
		if (Output.Location >= uint32_t(Args.NumTargets) || !LastStore ||
			Module.GetScalarKind(Output.Type, 0) != ESpirvType::Float)
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
			const auto Stored = [&](const std::string& Problem)
			{
				return FormatReal(RGBA[c]) + " is stored to " + Name + " (" + Channels[c] + ")" + Problem;
			};
			const std::string Format = std::string(", whose ") + Info.Name;
			if (Checks[ECheck::Overflow] && std::isfinite(RGBA[c]) && std::isinf(Kept[c]))
			{
				Add(Thread, ECheck::Overflow, I, [&] { return Stored(Format + " makes it infinite"); });
			}
			if (Checks[ECheck::Negative] && c < 3 && RGBA[c] < 0)
			{
				Add(Thread, ECheck::Negative, I, [&] { return Stored({}); });
			}
			if (Checks[ECheck::Denormal] && RGBA[c] != 0 && std::fabs(RGBA[c]) < GetLeastNormal(Texture.Storage))
			{
				Add(Thread, ECheck::Denormal, I, [&] { return Stored(Format + " has no full precision there"); });
			}
		}
	}

	/** An operation that makes NaN or infinity of finite numbers. A read of such a value from memory is not to
	 * blame. */
	void CheckOperation(const FSpirvThreadView& Thread, const FSpirvStep& Step)
	{
		const FSpirvInstruction& I = *Step.I;
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			const double Value = Thread.GetNumber(Step.To + i, Module.GetScalarKind(I.Type, i));
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
					const ESpirvType Kind = Module.GetScalarKind(Type, c);
					const uint32_t Word = Program.Args[Step.FirstArg + k] + c;
					bFinite = bFinite && (!IsSpirvReal(Kind) || std::isfinite(Thread.GetNumber(Word, Kind)));
				}
			}
			if (bFinite)
			{
				Add(Thread, ECheck::NonFinite, I,
					[&] { return DescribeOperation(Program, Thread, Step, i) + " is " + FormatReal(Value); });
				return;
			}
		}
	}

	/** Adds a finding, whose text What makes from the first thread. */
	void Add(const FSpirvThreadView& Thread, ECheck Check, const FSpirvInstruction& I, TFunctionRef<std::string()> What)
	{
		const FFindingKey Key(Check, I.File, I.Line);
		if (!Found.insert(Key).second)
		{
			return; // of this thread already
		}
		FCheckFinding& Finding = Count(Check, I, Thread.GetPosition());
		Finding.What = Finding.What.empty() ? What() : Finding.What;
	}

	/** Counts one more thread for the finding. Its What is empty if the finding is new. */
	FCheckFinding& Count(ECheck Check, const FSpirvInstruction& I, const int32_t* At)
	{
		const auto [Entry, bNew] = Findings.try_emplace(FFindingKey(Check, I.File, I.Line));
		FCheckFinding& Finding = Entry->second;
		if (bNew)
		{
			Finding.Check = Check;
			Finding.File = Module.Files.at(I.File);
			Finding.Line = I.Line;
			std::copy_n(At, 3, Finding.First);
		}
		++Finding.Threads;
		if (Finding.Pixels.size() < MaxCheckPixels)
		{
			Finding.Pixels.push_back({At[0], At[1]});
		}
		return Finding;
	}

	const FInspectedShader& Shader;
	const FSpirvModule& Module;
	const FSpirvProgram& Program;
	const FKernelArgs& Args;
	const FCheckSet& Checks;
	std::map<FFindingKey, FCheckFinding> Findings;
	std::vector<FThreadStore> Stores;
	FRaceFinder Races;
	const FAuthorsNames Names;
	const size_t AuthorsDepth;   // of the entry point: below it is what the front end put around it
	std::set<FFindingKey> Found; // of the thread that runs
	const FSpirvStep* LastStore = nullptr;
};

/** Instructions whose result is made, not fetched. A bitcast is a constant's infinity (POSITIVE_INFINITY) or bits that
 * were packed. */
bool IsArithmetic(const FSpirvModule& Module, const FSpirvInstruction& I)
{
	const bool bMade = I.Op == OpExtInst || (I.Op >= OpSNegate && I.Op <= OpDot);
	return bMade && I.Type && Module.GetType(I.Type).NumScalars && IsSpirvReal(Module.GetScalarKind(I.Type, 0));
}

void SetHooks(FInspectedShader& Shader, const FCheckSet& Checks)
{
	const bool bStores = Checks[ECheck::Overflow] || Checks[ECheck::Negative] || Checks[ECheck::Denormal];
	const FSpirvModule& Module = Shader.GetModule();
	for (FSpirvStep& Step : Shader.GetProgram().Steps)
	{
		const uint16_t Op = Step.I->Op;
		const bool bStore = Op == OpStore || Op == OpReturnValue;
		Step.bHook = (Op == OpImageWrite && (bStores || Checks[ECheck::Overlap])) || bStore ||
					 (Checks[ECheck::NonFinite] && IsArithmetic(Module, *Step.I));
	}
}

void AddOverlaps(const FSpirvModule& Module, const std::vector<FStoreOverlap>& Overlaps,
	std::map<FFindingKey, FCheckFinding>& Findings)
{
	for (const FStoreOverlap& Overlap : Overlaps)
	{
		const FSpirvInstruction& I = *Overlap.Store.Step->I;
		const auto [Entry, bNew] = Findings.try_emplace({ECheck::Overlap, I.File, I.Line});
		FCheckFinding& Finding = Entry->second;
		if (bNew)
		{
			Finding.Check = ECheck::Overlap;
			Finding.File = Module.Files.at(I.File);
			Finding.Line = I.Line;
			Finding.What = DescribeOverlap(Module, Overlap);
			std::copy_n(Overlap.Store.Thread.begin(), 3, Finding.First);
		}
		++Finding.Threads;
		if (Finding.Pixels.size() < MaxCheckPixels)
		{
			Finding.Pixels.push_back({Overlap.Store.Thread[0], Overlap.Store.Thread[1]});
		}
	}
}

} // namespace

std::vector<FCheckFinding> CheckThreads(FInspectedShader& Shader, const FBoundShader& Bound, const FKernelArgs& Args,
	const FKernelTile& Whole, const std::vector<std::array<int32_t, 3>>& Given, const FCheckSet& Checks)
{
	SetHooks(Shader, Checks);
	const FThreadRuns Runs(Shader, Bound, Args, Given.empty() ? ListThreads(Whole) : Given);
	std::deque<FThreadChecker> Checkers;
	for (size_t Piece = 0; Piece < Runs.GetNumPieces(); ++Piece)
	{
		Checkers.emplace_back(Shader, Args, Checks);
	}
	Runs.Run([&](size_t Piece) -> IThreadWatcher& { return Checkers[Piece]; }, Checks[ECheck::Uninitialized]);

	std::map<FFindingKey, FCheckFinding> All;
	for (const FThreadChecker& Checker : Checkers)
	{
		for (const auto& [Key, Finding] : Checker.GetFindings())
		{
			const auto [Entry, bNew] = All.try_emplace(Key, Finding);
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
	if (Checks[ECheck::Overlap])
	{
		std::vector<FThreadStore> Stores;
		for (const FThreadChecker& Checker : Checkers)
		{
			Stores.insert(Stores.end(), Checker.GetStores().begin(), Checker.GetStores().end());
		}
		AddOverlaps(Shader.GetModule(), FindOverlaps(Stores), All);
	}
	std::vector<FCheckFinding> Findings;
	for (auto& [Key, Finding] : All)
	{
		Finding.Source = Shader.GetTrimmedLine(Finding.File, Finding.Line);
		Findings.push_back(std::move(Finding));
	}
	std::ranges::stable_sort(Findings, [](const FCheckFinding& A, const FCheckFinding& B)
		{ return std::tie(A.First[2], A.First[1], A.First[0]) < std::tie(B.First[2], B.First[1], B.First[0]); });
	return Findings;
}

} // namespace Drydock
