// One thread of a shader, run instruction by instruction, block after block, as the specification says. It knows
// nothing of lanes, masks, structure or uniformity. SpirvThread.inl: inputs, blocks and calls; SpirvThreadMemory.inl:
// pointers and buffers; SpirvThreadGroups.inl, SpirvThreadWaves.inl and SpirvThreadQuads.inl: what threads do
// together; SpirvThreadValues.inl: vectors and matrices; SpirvThreadFunctions.inl: functions of GLSL.std.450;
// SpirvThreadImages.inl: textures.
#pragma once

#include "SpirvImageOperands.h"
#include "SpirvObserver.h"
#include "SpirvOrder.h"
#include "SpirvRace.h"
#include "SpirvReflect.h"
#include "SpirvScalarMath.h"
#include "TileExecutor.h"
#include "VertexProgram.h"

#include <algorithm>
#include <optional>

namespace Drydock
{

/** Place of each of the module's resources among the kernel's arguments. */
struct FSpirvSlotTable
{
	std::vector<int32_t> Slots; // by the module's variable; -1: nowhere
};

template<typename Real>
class DRYDOCK_API TSpirvThread final : public FSpirvThreadView
{
public:
	using FWord = TSpirvWord<Real>;

	TSpirvThread(const FSpirvProgram& InProgram, FSpirvSlotTable InSlots);

	/** Runs the entry point to its end, alone: barriers are passed. Throws FSpirvError after MaxSteps instructions. */
	void Run(
		const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex, uint64_t MaxSteps);

	/** For TSpirvGroup: the state before the first instruction; on to the next step that threads wait at, or, false, to
	 * the end; over that step, which ExecuteWaiting has done or somebody else. */
	void Start(const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex = nullptr);
	bool Advance(uint64_t MaxSteps);
	const FSpirvStep& GetWaiting() const { return Program.Steps[At]; }
	void ExecuteWaiting();
	/** A wave or quad operation that all of these wait at, in the order of their lanes. */
	static void ExecuteTogether(const std::vector<TSpirvThread*>& Together);
	void StepOver();
	/** Its place in its group and wave. */
	void SetPlace(uint32_t InGroupIndex, uint32_t InWaveSize)
	{
		GroupIndex = InGroupIndex;
		Lane = InGroupIndex % InWaveSize;
		WaveSize = InWaveSize;
	}
	/** Sets the finder that sees every access to groupshared memory; null: none. */
	void SetRaceFinder(FRaceFinder* InRaces) { Races = InRaces; }
	/** The pixel is not drawn, but run for its quad: it stores and counts nothing. Applies to the run that has been
	 * started. */
	void SetHelper(bool bInHelper) { bHelper = bInHelper; }
	/** Sets groupshared memory of the program's number of words; null: the thread's own. */
	void SetGroupshared(FWord* Memory) { Groupshared = Memory; }
	/** Turns of each loop around the place where the thread waits, by Order; and where it is. */
	void SetOrder(const FSpirvOrder* InOrder);
	std::vector<uint32_t> GetWhereInOrder() const;
	/** Log takes the results of this thread's loads and atomics, which other threads influence, or replays them: a
	 * thread of a group that has run can be run again alone. Null: neither. */
	void SetLog(std::vector<FWord>* InLog, bool bInReplay);

	/** For callers that choose the next instruction: the state before the first instruction, and one instruction that
	 * neither calls a function of the module nor branches. False: it ended the thread. */
	void Begin(const FKernelArgs& InArgs, const int32_t (&InPosition)[3], const FVertexInput* InVertex);
	bool ExecuteStep(const FSpirvStep& Step);
	/** Counts a turn when control reaches the header of a loop that may not end; throws if it is one turn too many. */
	void CountTurn(uint32_t To, uint32_t FromBlock);
	FWord* GetWords() { return Words.data(); }

	bool WasDiscarded() const { return bDiscarded || bDemoted; }
	/** A variable's words: outputs, after Run. */
	const FWord* GetMemory(size_t Variable) const { return Words.data() + Program.Memory[Variable].First; }

	/** Observer may be null. With bInTrackUndefined, values that nothing wrote are followed to where they matter. */
	void SetObserver(ISpirvObserver* InObserver, bool bInTrackUndefined);
	/** How often each block was entered; counted on from run to run. */
	std::vector<uint64_t> BlockRuns;
	/** Texture samples and loads of the last run. */
	uint64_t Taps = 0;

	uint32_t GetBits(uint32_t Word) const override { return uint32_t(Words[Word]); }
	uint64_t GetWideBits(uint32_t Word) const override { return Words[Word]; }
	double GetReal(uint32_t Word) const override { return double(ToSpirvReal<Real>(Words[Word])); }
	size_t GetDepth() const override { return Calls.size(); }
	const int32_t* GetPosition() const override { return Position; }
	double GetLevel() const override { return double(Level); }

private:
	static constexpr uint32_t Nowhere = ~0u;

	struct FCall
	{
		uint32_t Step = 0; // of the call
		uint32_t Block = 0;
	};

	void ClearMemory();
	void FillInputs();
	void FillInput(const FSpirvVariable& Variable, FWord* Out) const;
	void FillAttribute(const FSpirvVariable& Variable, FWord* Out) const;
	void EnterBlock(uint32_t To, uint32_t FromBlock);
	uint32_t ChooseTarget(const FSpirvStep& Step) const;
	void Execute(const FSpirvStep& Step);
	void TellRaces(const FSpirvStep& Step, uint32_t Word, uint32_t Size, ESharedAccess Access, const FWord* Values);
	bool ExecuteFromLog(const FSpirvStep& Step);
	FWord TakeFromLog(const FSpirvStep& Step);
	using FWaveResult = std::vector<FWord>; // of one thread
	static std::vector<FWaveResult> CombineWave(const std::vector<TSpirvThread*>& Together);
	static FWaveResult AskWave(const std::vector<TSpirvThread*>& Together);
	FWaveResult ReadInWave(const std::vector<TSpirvThread*>& Together) const;
	bool AgreesWith(const TSpirvThread& Other) const;
	static void ExecuteQuad(const std::vector<TSpirvThread*>& Together);
	void Discard();
	bool Stores() const { return !bReplay && !bHelper; }
	void Note(const FSpirvStep& Step);
	void ShowWaiting();
	bool ExecuteAtomic(const FSpirvStep& Step);
	void PointAtTexel(const FSpirvStep& Step);
	uint32_t* FindTexel(const FSpirvStep& Step);
	/** Bits: uint32_t or uint64_t, as wide as the number in memory. */
	template<typename FBits>
	FBits ReplaceAtomically(FBits* Place, const FSpirvStep& Step);
	bool ExecuteTerminator(const FSpirvStep& Step);
	bool ExecuteCall(const FSpirvStep& Step);
	/** The memory of Size words from Word on. A pointer that leaves the memory, as a damaged module makes it, is
	 * refused.
	 */
	FWord* MemoryAt(const FSpirvStep& Step, uint32_t Word, uint32_t Size);
	bool IsShared(uint32_t Word) const
	{
		return Groupshared && Word - Program.Groupshared.First < Program.Groupshared.Size;
	}
	void ExecuteChain(const FSpirvStep& Step);
	void Load(const FSpirvStep& Step);
	void Store(const FSpirvStep& Step, uint32_t Pointer, const FWord* Value, uint32_t Size);
	void LoadBytes(const FSpirvStep& Step);
	void StoreBytes(const FSpirvStep& Step);
	const FKernelBuffer* FindBuffer(uint32_t Variable) const;
	void ArrayLength(const FSpirvStep& Step);
	bool ExecuteComposite(const FSpirvStep& Step);
	template<typename Number>
	bool ExecuteMatrix(const FSpirvStep& Step);
	bool ExecuteImage(const FSpirvStep& Step);
	void ExecuteSample(const FSpirvStep& Step);
	Real GetGradientLevel(const FSpirvStep& Step, const FSpirvImageOperands& Told, const FKernelTexture& Texture) const;
	Real ClampLevel(const FSpirvStep& Step, const FSpirvImageOperands& Told, Real Found) const;
	void ExecuteImageLoad(const FSpirvStep& Step);
	void ExecuteImageWrite(const FSpirvStep& Step);
	void ExecuteBitcast(const FSpirvStep& Step);
	void ExecuteScalars(const FSpirvStep& Step);
	/** Number: Real, or double where the shader's own type is double. */
	template<typename Number>
	bool ExecuteGeometric(const FSpirvStep& Step);
	template<typename Number, int Count>
	bool ExecuteWithVectors(const FSpirvStep& Step);
	template<typename Number>
	Number GetDeterminant(const FSpirvStep& Step);
	template<typename Number>
	bool ExecuteWhole(const FSpirvStep& Step);
	void ExecuteExtended(const FSpirvStep& Step);
	static FWord ViewOperand(const FSpirvStep& Step, bool bSigned, FWord Word);
	void Narrow(const FSpirvStep& Step, FWord* Out) const;
	void CheckTexel(const FSpirvStep& Step, const FKernelTexture& Texture, const int32_t (&At)[4], bool bStore);
	void CheckElement(const FSpirvStep& Step, const FKernelBuffer& Buffer, uint64_t Index, bool bStore);
	void Fault(const FSpirvStep& Step, const FSpirvFault& Fault);
	void Move(const FSpirvStep& Step);
	void FollowUndefined(const FSpirvStep& Step);
	void CheckDefined(const FSpirvStep& Step, size_t Operand);
	void CheckSampleDefined(const FSpirvStep& Step);
	void ReportUndefined(const FSpirvStep& Step, uint32_t Word, bool bAtEnd);
	void CheckOutputs();

	uint32_t Arg(const FSpirvStep& Step, size_t Operand) const { return Program.Args[Step.FirstArg + Operand]; }
	const FWord* Value(const FSpirvStep& Step, size_t Operand) const { return Words.data() + Arg(Step, Operand); }
	uint32_t Bits(const FSpirvStep& Step, size_t Operand, uint32_t Index = 0) const
	{
		return uint32_t(Value(Step, Operand)[Index]);
	}
	template<typename Number = Real>
	Number GetValue(const FSpirvStep& Step, size_t Operand, uint32_t Index) const
	{
		return ToSpirvReal<Number>(Value(Step, Operand)[Index]);
	}
	uint32_t SizeOf(const FSpirvStep& Step, size_t Operand) const { return Program.ArgSizes[Step.FirstArg + Operand]; }
	FWord* Result(const FSpirvStep& Step) { return Words.data() + Step.To; }
	ESpirvType GetKind(uint32_t Type, uint32_t Index) const { return Program.Module.GetScalarKind(Type, Index); }
	bool IsReal(uint32_t Type, uint32_t Index) const { return IsSpirvReal(GetKind(Type, Index)); }
	const FSpirvVariable& Resource(const FSpirvStep& Step, size_t Operand, uint32_t Index = 0) const
	{
		return Program.Module.Variables.at(Bits(Step, Operand, Index));
	}
	/** The view of a resource. It is empty if the compiled shader left the resource out as unused. */
	template<typename T>
	const T& ViewOf(const T* Views, uint32_t Variable) const
	{
		static const T None = MakeEmpty(static_cast<T*>(nullptr));
		const int32_t Slot = Table.Slots.at(Variable);
		return Slot < 0 ? None : Views[Slot];
	}
	template<typename T>
	static T MakeEmpty(T*)
	{
		return {};
	}
	static FKernelTexture MakeEmpty(FKernelTexture*)
	{
		static uint8_t Black[144] = {}; // one texel, with the margins that samplers may read
		static const FKernelMip Mip = {Black + 64, 1, 1, 1, 16, 16};
		return {&Mip, 1, ETexelStorage::RGBA32_FLOAT, 0, 0};
	}
	const FKernelTexture& TextureOf(const FSpirvStep& Step, size_t Operand) const;
	const FKernelBuffer& BufferOf(const FSpirvStep& Step, size_t Operand) const;

	const FSpirvProgram& Program;
	FSpirvSlotTable Table;
	std::vector<FWord> Words;
	std::vector<uint32_t> Undefined; // by word: 1 + the word of the variable that nothing wrote; empty: nobody asks
	std::vector<FCall> Calls;
	std::vector<FWord> Incoming;   // of the block that is entered
	std::vector<uint32_t> Sources; // words that an instruction moves
	ISpirvObserver* Observer = nullptr;
	const FKernelArgs* Args = nullptr;
	const FVertexInput* Vertex = nullptr; // of a vertex shader
	int32_t Position[3] = {};
	bool bDiscarded = false; // and has ended with it
	bool bDemoted = false;   // and goes on as a helper
	bool bHelper = false;
	Real Level = 0; // of the latest sample that chose its own
	uint32_t Block = 0;
	uint32_t At = 0; // step
	uint64_t NumSteps = 0;
	FWord* Groupshared = nullptr;
	const FSpirvOrder* Order = nullptr;
	std::vector<uint32_t> Turns;        // of loops, by the block of their header
	std::vector<uint32_t> CountedTurns; // of loops that may not end, in the same way
	std::vector<FWord>* Log = nullptr;
	size_t LogPosition = 0;
	bool bReplay = false;
	uint32_t GroupIndex = 0;
	uint32_t Lane = 0;
	uint32_t WaveSize = 1;
	FRaceFinder* Races = nullptr;
};

extern template class TSpirvThread<float>;
extern template class TSpirvThread<double>;

} // namespace Drydock
