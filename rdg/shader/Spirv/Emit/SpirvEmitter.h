// The emitter's state and its parts: SpirvEmitter.cpp (module), SpirvEmitFlow.cpp (control flow and masks),
// SpirvEmitOps.cpp and SpirvEmitExtended.cpp (arithmetic), SpirvEmitComposites.cpp, SpirvEmitMemory.cpp (variables,
// buffers), SpirvEmitArrays.cpp, SpirvEmitImages.cpp, SpirvEmitGroups.cpp (groups and barriers), SpirvEmitAtomics.cpp,
// SpirvEmitWaves.cpp, SpirvEmitQuads.cpp.
//
// Values are single scalars: `const R v12_0 = v9_1 * v7_0;`. Moves between components cost no code at all. A scalar is
// uniform (Real, int32_t, uint32_t, bool) or varying (R, I, U, M); C++ overloads do the rest. `e` is the mask of lanes
// that run, and is never empty where code runs. A jump to T is `mT = mT | e; e = M(false);`, T itself `e = e | mT;`.
//
// Uniform values that no memory but constant buffers goes into are computed before the loop over packs that they stand
// still in: once a tile, or once a row where y goes into them. Wherever the shader computes them: every operation is
// total and without effects. A sample or load whose column depends on x alone and whose row on y alone has a tap, which
// remembers over a tile where it falls; in a loop that runs alike for all pixels it has one for each turn. So have
// costly functions of what changes from turn to turn only.
//
// The text is made twice: the first pass finds which values are used outside of the C++ block that defines them, the
// second declares those at the top. A long text is cut into lambdas that are not inlined; what goes from one to the
// other is found in the same way. Source of the masks per merge block: Pharr and Mark, "ispc" (InPar 2012).
#pragma once

#include "SpirvDependence.h"
#include "SpirvEmit.h"
#include "SpirvFlow.h"
#include "SpirvPlace.h"
#include "SpirvTurns.h"

#include <optional>
#include <set>
#include <string>

namespace Drydock
{

// The kinds that are named at every turn.
using ESpirvType::Bool;
using ESpirvType::Float;
using ESpirvType::Int;
using ESpirvType::Uint;

/** Place of emitted text: around the loop over a tile's rows, around the loop over a row's packs, or inside it. */
enum class EEmitLevel : uint8_t
{
	Tile,
	Row,
	Pack
};

/** A scalar operand in the generated text. */
struct FEmitScalar
{
	std::string Text;
	ESpirvType Kind = ESpirvType::Float;
	bool bVarying = false;
	int Local = -1;                      // index into Locals; literals and variables of the whole function: -1
	EEmitLevel Level = EEmitLevel::Tile; // of what cannot stand further out, beside its operands
};

/** The selection among the values that an edge hands over. */
enum class EPhiCopies : uint8_t
{
	All,
	Varying,
	Uniform
};

struct FSpirvImageOperands;

class FSpirvEmitter
{
public:
	/** Findings of the first pass that the second pass needs. */
	struct FFindings
	{
		std::set<std::string> Hoisted;     // locals used outside of their C++ block
		std::set<std::string> KeptByLanes; // locals that lanes read after leaving a loop: written under the mask
		std::set<uint32_t> MasksNeeded;    // labels that lanes wait at
	};

	FSpirvEmitter(const FSpirvEmitInput& Input, const FSpirvDependence& InDependence, FFindings InFindings);

	/** All of Run, from its declarations on. */
	std::string EmitRun();
	const std::string& GetTables() const { return TableText; }
	/** The text at the end of Run. */
	const std::string& GetEnd() const { return EndText; }
	const FFindings& GetFindings() const { return Findings; }

private:
	/** Around what runs where some lane is left. */
	static constexpr const char* GuardRest = "if (AnyLane(e))";

	// Control flow
	void EmitRegion(const FStructRegion& Region, size_t First = 0);
	void EmitNode(const FStructNode& Node);
	void EmitIf(const FStructNode& Node);
	void EmitSwitch(const FStructNode& Node);
	void EmitLoop(const FStructNode& Node);
	/** Counts a turn of the loop, and reports which loop took too many turns. bPacks: in a loop over packs. */
	void EmitTurn(const FStructNode& Node, bool bPacks);
	bool IsCounted(const FStructNode& Loop) const { return !Turns.Find(Loop.Label); }
	void EmitEdge(const FStructNode& Node);
	struct FPhiCopy
	{
		std::string Target;
		std::string Source;
		std::string Read; // the variable that Source reads
		bool bMasked = false;
	};
	const std::vector<FEmitScalar>& DeclarePhi(const FSpirvInstruction& I, uint32_t Label);
	std::vector<FPhiCopy> ListPhiCopies(uint32_t From, uint32_t To, EPhiCopies Which);
	void EmitPhiCopies(uint32_t From, uint32_t To, EPhiCopies Which = EPhiCopies::All);
	bool Escapes(const FStructNode& Node) const;
	bool EscapesFrom(const FStructRegion& Region, std::initializer_list<uint32_t> Inside, bool bInnerLoop) const;
	bool IsDirectBreak(uint32_t To) const;
	std::string MaskOf(uint32_t Label);
	void OpenScope(const std::string& Head);
	void CloseScope(const char* Tail = "}");
	void EmitBlock(const FStructNode& Node);
	bool Breaks(const FStructNode& Node) const;
	/** Opens or closes a function of its own for the text emitted from here on, in a long kernel. */
	void SetPart(bool bOpen);

	// Groups
	std::string EmitGroupRun();
	void EmitGroupRegion(const FStructRegion& Region);
	void EmitGroupEdge(const FStructNode& Node, bool bOwnLoop);
	/** The block has a value, by where control comes from, that is the same for all threads of the group. */
	bool HasUniformPhi(uint32_t Label);
	void EmitGroupIf(const FStructNode& Node);
	void EmitGroupSwitch(const FStructNode& Node);
	void EmitGroupLoop(const FStructNode& Node);
	bool IsGroupNode(const FStructNode& Node) const;
	[[noreturn]] void FailBarrier(const FStructNode& Node, const std::string& What) const;
	void OpenSegment(bool bAll);
	void CloseSegment();
	void EmitForAllPacks(const std::string& Statement);
	std::string PlaceDeclarations(std::string& InitialText);
	std::vector<FEmitScalar> LoadGroupInput(const FSpirvVariable& Variable);
	bool EmitGroups(const FSpirvInstruction& I);
	/** False when it is another wave operation. */
	bool EmitWaveArithmetic(const FSpirvInstruction& I);
	bool EmitWaves(const FSpirvInstruction& I);

	// Quads
	std::string EmitQuadRun();
	bool EmitQuads(const FSpirvInstruction& I);
	std::vector<FEmitScalar> LoadQuadInput(const FSpirvVariable& Variable);
	std::vector<FEmitScalar> LoadInterpolant(
		const FSpirvVariable& Variable, const std::string& Before, const std::string& Behind) const;
	std::string QuadLevelOf(const FSpirvInstruction& I, const std::string& Function);
	bool ChoosesLevel(const FSpirvInstruction& I) const { return Module.bQuads && ChoosesSpirvLevel(I.Op); }
	/** Mask of the lanes that run and are not helpers. */
	const char* GetStoreMask() const { return Module.bQuads ? "(e & Live)" : "e"; }

	std::string AtomicPlace(const FSpirvInstruction& I);
	std::string TileAtomics(const FSpirvInstruction& I);

	// Instructions
	void EmitInstruction(const FSpirvInstruction& I);
	void EmitDynamicExtract(const FSpirvInstruction& I);
	void EmitDynamicInsert(const FSpirvInstruction& I);
	std::optional<std::vector<FEmitScalar>> ListMoved(const FSpirvInstruction& I);
	bool EmitComposite(const FSpirvInstruction& I);
	bool EmitComponentwise(const FSpirvInstruction& I);
	/** A product that is part of a sum. */
	struct FTerm
	{
		FEmitScalar A;
		FEmitScalar B;
	};
	void EmitSum(const FSpirvInstruction& I, uint32_t Index, const std::vector<FTerm>& Terms);
	bool EmitMatrix(const FSpirvInstruction& I);
	std::string DeterminantText(uint32_t Matrix, ESpirvType Kind, bool bVarying);
	void EmitPacking(const FSpirvInstruction& I, bool bVarying);
	void EmitLdexp(const FSpirvInstruction& I, ESpirvType Kind);
	void EmitModf(const FSpirvInstruction& I, ESpirvType Kind);
	void EmitFrexp(const FSpirvInstruction& I, ESpirvType Kind);
	void EmitNorms(const FSpirvInstruction& I, const FSpirvNorms& Norms, bool bVarying);
	/** Functions that have no pattern. */
	void EmitExtended(const FSpirvInstruction& I);
	void EmitPattern(const FSpirvInstruction& I, size_t FirstOperand, const struct FEmitPattern& Pattern);
	void EmitConversion(const FSpirvInstruction& I);
	void EmitBitcast(const FSpirvInstruction& I);
	bool IsPerTurn(const FSpirvInstruction& I, uint32_t Index) const;
	std::string PerTurn(const FSpirvInstruction& I, uint32_t Index, const std::string& Text);

	// Memory
	bool EmitMemory(const FSpirvInstruction& I);
	bool EmitImage(const FSpirvInstruction& I);
	void EmitPlainSample(const FSpirvInstruction& I);
	void EmitImageLoad(const FSpirvInstruction& I);
	void EmitImageStore(const FSpirvInstruction& I);
	void EmitImageSize(const FSpirvInstruction& I);
	/** The result's scalars are the components of the expression. */
	void DefineParts(const FSpirvInstruction& I, const std::string& Expression, ESpirvType Kind, bool bVarying);
	/** Adds the number of lanes that run to a member of FKernelCounters. */
	void CountLanes(const std::string& Counter);
	/** False when it is a plain sample. */
	bool EmitSample(const FSpirvInstruction& I);
	std::string SampledHandles(const FSpirvInstruction& I) const;
	std::string LevelOf(const FSpirvInstruction& I);
	std::string UnclampedLevelOf(const FSpirvInstruction& I, const FSpirvImageOperands& Told);
	std::string SamplePlace(const FSpirvInstruction& I, size_t OffsetOperand, uint32_t FirstOffset);
	void EmitLoad(const FSpirvInstruction& I);
	void EmitStore(uint32_t Pointer, const std::vector<FEmitScalar>& Values, const FSpirvInstruction& I);
	std::vector<FEmitScalar> LoadInput(const FSpirvVariable& Variable);
	FEmitScalar LoadConstantBuffer(const FSpirvPlace& Place, uint32_t Scalar, ESpirvType Kind);
	FEmitScalar LoadStorageBuffer(const FSpirvPlace& Place, uint32_t Scalar, ESpirvType Kind);
	FEmitScalar LoadLocal(const FSpirvPlace& Place, uint32_t Scalar, ESpirvType Kind);
	std::string SharedIndexText(const FSpirvPlace& Place, uint32_t Offset, bool& bVarying);
	std::string IndexText(const FSpirvPlace& Place, const std::string& Offset, bool& bVarying);
	std::string BufferOffsetText(const FSpirvPlace& Place, uint32_t Scalar, bool& bVarying);
	static std::string ArraySuffix(ESpirvType Kind);
	/** C++'s type for the kind in memory; of 16 bits the bits. */
	static std::string MemoryName(ESpirvType Kind);
	std::string LocalArray(const FSpirvVariable& Variable, ESpirvType Kind) const;
	FSpirvPlace Resolve(uint32_t Pointer) const;
	std::string HandleOf(uint32_t Id) const;
	const FSpirvType& ImageTypeOf(uint32_t Id) const;
	std::string TapOf(const FSpirvInstruction& I, uint32_t Mip);
	void EmitTap(const FSpirvInstruction& I, const std::string& Handles, ESpirvType Kind, const std::string& Rest);
	std::string StillText() const;
	std::string Coordinates(
		const FSpirvInstruction& I, size_t Operand, uint32_t Count, bool bReal, size_t OffsetOperand);
	void FindDynamicVariables();
	void DeclareHandle(const FSpirvVariable& Variable, uint32_t Slot);
	void DeclareShared(const FSpirvVariable& Variable);
	void DeclareTable(const FSpirvVariable& Variable, uint32_t Constant);
	void DeclareLocal(const FSpirvVariable& Variable);
	std::string InitialText(const FSpirvVariable& Variable, ESpirvType Kind, uint32_t Constant) const;
	void DeclareVariables();
	void EmitOutputs();

	// Arrays as values: copied by a loop, and not at all where the variable they come from can be read instead.
	struct FArrayValue
	{
		std::map<ESpirvType, std::string> Names; // one C++ array for each kind of scalar in it
		uint32_t Offset = 0;
		bool bVarying = false;
		int Local = -1;
	};
	bool IsLoopedCopy(const FSpirvPlace& Place) const;
	bool CanReadInPlace(const FSpirvInstruction& Load, uint32_t Variable) const;
	void EmitLoopedLoad(const FSpirvInstruction& I, const FSpirvPlace& Place);
	/** False when the value is not an array. */
	bool EmitLoopedStore(const FSpirvInstruction& I);
	const FArrayValue* FindArrayValue(uint32_t Value);
	std::set<ESpirvType> GetKinds(uint32_t Type) const;
	void CountArray(uint32_t Size, size_t NumKinds, const FSpirvInstruction* Where);

	// Scalars
	static std::string Number(uint32_t Value) { return std::to_string(Value); }
	FEmitScalar Scalar(uint32_t Value, uint32_t Index);
	std::string Use(const FEmitScalar& S);
	std::string UseAs(const FEmitScalar& S, ESpirvType Kind, bool bVarying);
	void Define(uint32_t Value, uint32_t Index, const FEmitScalar& Expression);
	FEmitScalar Literal(ESpirvType Kind, uint64_t Bits) const;
	/** The text of arithmetic on numbers of Kind, under the denormal mode of the kind. */
	static std::string WithDenormals(ESpirvType Kind, const std::string& Text)
	{
		return Kind == ESpirvType::Double ? "KeepDenormals<Real>([&] { return " + Text + "; })" : Text;
	}
	uint32_t SizeOf(uint32_t Value) const { return Module.GetValueType(Value).NumScalars; }
	std::string TypeName(ESpirvType Kind, bool bVarying) const;
	/** Level of the text that comes next: that of the latest operands, if the instruction can stand anywhere. */
	EEmitLevel GetLevel() const { return bMovable ? OperandLevel : EEmitLevel::Pack; }
	bool IsMovable(const FSpirvInstruction& I) const;
	void Line(const std::string& Text);
	void SourceLine(const FSpirvInstruction& I);

	/** A C++ variable around the code of a pack. Initial: with its braces or equals sign. */
	struct FDeclaration
	{
		std::string Type;
		std::string Name;
		uint32_t Size = 0; // of an array
		std::string Initial;
		bool bVariable = false; // of the shader's: it keeps its value however often the code around it runs
	};
	void Declare(std::string Type, std::string Name, uint32_t Size, std::string Initial, bool bVariable = false)
	{
		Declarations.push_back({std::move(Type), std::move(Name), Size, std::move(Initial), bVariable});
	}

	/** The text of a loop over a group's packs, in Body. */
	struct FSegment
	{
		size_t Begin = 0;
		size_t End = 0;
		bool bAll = false;
		bool bInLoop = false;
	};

	struct FLocal
	{
		std::string Name;
		int Scope = 0;
		std::vector<uint32_t> Loops; // headers around its definition
	};

	const FSpirvModule& Module;
	const FSpirvStructure& Structure;
	const FSpirvUniformity& Uniformity;
	const FSpirvDependence& Dependence;
	const FSpirvReflection& Reflection;
	const std::map<uint32_t, uint32_t> Tables;
	const FSpirvTurns Turns;
	FFindings Findings;

	std::string Body;
	std::string TileText;
	std::string RowText;
	bool bMovable = false;
	EEmitLevel OperandLevel = EEmitLevel::Tile; // of what was used since the last definition
	std::string Handles;
	std::vector<FDeclaration> Declarations;
	const FSpirvGroupUse GroupUse;
	const bool bGroups;
	std::string SharedText; // groupshared arrays
	std::string EndText;
	std::vector<FSegment> Segments;
	bool bInSegment = false;
	size_t SegmentGuards = 0; // scopes that were opened in it and end with it
	std::string TableText;
	int Indent = 1;
	std::vector<int> Scopes{0};
	int NumScopes = 1;
	std::vector<uint32_t> Loops; // headers of the C++ loops around the text
	std::vector<FLocal> Locals;
	std::unordered_map<uint32_t, std::vector<FEmitScalar>> Values;
	std::map<uint32_t, FArrayValue> ArrayValues;
	std::map<uint32_t, const FSpirvInstruction*> Definitions;
	std::unordered_map<uint32_t, uint32_t> NumUses; // of results
	const FSpirvInstruction* Current = nullptr;
	uint64_t ArrayBytes = 0;
	size_t NumLines = 0;
	bool bInParts = false;               // long text is cut into functions
	size_t PartStart = 0;                // line that the open part begins at, 0: none is open
	std::set<uint32_t> DynamicVariables; // indexed at run time: C++ arrays
	std::set<std::string> Declared;
	uint32_t CurrentBlock = 0;
	uint32_t LastFile = ~0u;
	int LastLine = -1;
	uint32_t NumTaps = 0; // of all sites and turns
	uint32_t NumTapSites = 0;
};

} // namespace Drydock
