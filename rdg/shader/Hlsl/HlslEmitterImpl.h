// The emitter's class: what it knows of the module, of the function that it writes and of places in memory. Its parts
// stand in HlslEmitter*.cpp.
#pragma once

#include "HlslEmitter.h"
#include "HlslModule.h"
#include "SpirvAliases.h"

#include <functional>
#include <optional>

namespace Drydock::Hlsl
{

/** Thrown where something cannot be written in SPIR-V; Emit catches it. */
struct FEmitFault
{
	std::string Message;
	FPlace Place;
};

/** One resource of the module: an element of an array of them is one. */
struct FLeaf
{
	std::string Name;
	const FType* Type = nullptr;
	uint32_t Number = 0;                   // among all leaves, those of an array in a row
	uint32_t Id = 0;                       // its variable; 0: not declared yet
	uint32_t Counter = 0;                  // the hidden counter's variable
	std::map<std::string, uint32_t> Views; // of a buffer of bytes as numbers of 16 and 64 bits
};

/** The resources that a value may be. Number: which of them, by FLeaf::Number; 0: there is one. */
struct FObjectSet
{
	std::vector<FLeaf*> Leaves;
	uint32_t Number = 0;
};

/** A value's resources in the order of memory: those of an array one behind the other. */
using FObjects = std::vector<FObjectSet>;

/** A variable's memory for one resource; Variable holds its number where there are several candidates. */
struct FObjectSlot
{
	std::vector<FLeaf*> Leaves;
	uint32_t Variable = 0;
};

/** A function for one set of resources. */
struct FInstance
{
	uint32_t Id = 0;
	std::vector<FObjectSlot> Results; // resources in what it returns
};

/** A value and its type in HLSL. */
struct FPart
{
	uint32_t Id = 0;
	const FType* Type = nullptr;
};

/** A place that can be read and written. */
struct FTarget
{
	enum class EKind : uint8_t
	{
		Pointer, // Base and Chain; of a structured buffer's element the base is one of Objects
		Scalars, // several pointers to scalars
		Texel,   // of one of Objects, at At
	};

	EKind Kind = EKind::Pointer;
	const FType* Type = nullptr; // of the place itself, before Parts and Component
	uint32_t Base = 0;
	uint32_t Storage = 0;
	FWords Chain;
	std::optional<ELayout> Layout; // it lies in a buffer
	std::vector<FTarget> Scalars;
	FObjectSet Objects;
	uint32_t At = 0;
	uint32_t Level = 0;         // of a texel that is read
	std::vector<uint8_t> Parts; // of Type, a vector; empty: all
	uint32_t Component = 0;     // an index into what Parts leave; 0: none
	FBits Bits;                 // of Type, a uint
};

/** The function that is written. */
struct FFrame
{
	FBody Body;
	const FFunction* Function = nullptr;
	FInstance* Instance = nullptr;
	std::map<const FVariable*, uint32_t> Locals; // pointers
	std::map<const FVariable*, uint32_t> Tables; // constants that are indexed
	std::map<const FVariable*, std::vector<FObjectSlot>> Slots;
	struct FExits
	{
		uint32_t Break = 0;
		uint32_t Continue = 0;
	};
	std::vector<FExits> Exits; // of loops and switches around
};

enum class ENumber : uint8_t
{
	Bool,
	Signed,
	Unsigned,
	Real,
};

class FEmitter
{
public:
	explicit FEmitter(const FProgram& InProgram)
		: Program(InProgram)
		, Types(*InProgram.Types)
	{
	}

	FWords Run();
	const FPlace& GetPlace() const { return Current; }

private:
	// HlslEmitter.cpp: functions
	FInstance& GetInstance(const FFunction& Function, const std::vector<FObjects>& Arguments);
	void WriteFunction(const FFunction& Function, FInstance& Instance, const std::vector<FObjects>& Arguments);
	uint32_t Call(const FValue& Value, FInstance** Called = nullptr);
	void FindCallee(const FValue& Value, bool bEmit, FInstance*& Called);
	FWords Begin(FFrame& New, uint32_t Id, uint32_t Result, const FWords& Parameters, std::string_view Name);
	void WriteStatics();
	[[noreturn]] static void Fail(const FPlace& Place, const std::string& Message) { throw FEmitFault{Message, Place}; }
	/** An instruction with a result; without one. */
	uint32_t Op(uint16_t Opcode, uint32_t Type, const FWords& Operands);
	void Do(uint16_t Opcode, const FWords& Operands);
	uint32_t Ext(uint32_t Number, uint32_t Type, const FWords& Operands);
	void SetPlace(const FPlace& Place) { Current = Place; }
	uint32_t Temporary(uint32_t Type, std::string_view Name = {});
	/** Runs Work while there are not too many levels. */
	void Deeper(const FPlace& Place, const std::function<void()>& Work);

	// HlslEmitterFlow.cpp
	void Statement(const FCode& Code);
	void StatementBody(const std::vector<FCode*>& Body);
	void Loop(const FCode& Code);
	void Switch(const FCode& Code);
	void Return(const FCode& Code);
	void End(uint16_t Opcode, const FWords& Operands = {}); // of the block
	void Begin(uint32_t Label);
	void Branch(uint32_t Label);
	void BranchIf(uint32_t Condition, uint32_t Then, uint32_t Else, uint32_t Merge);
	void If(uint32_t Condition, const std::function<void()>& Then, const std::function<void()>& Else = nullptr);
	void BeginMerge(uint32_t Label);
	void Kill();
	void Declare(const FCode& Code);

	// HlslEmitterTypes.cpp
	uint32_t Bits(EScalar Scalar) const;
	static ENumber KindOf(EScalar Scalar);
	uint32_t ScalarType(EScalar Scalar);
	uint32_t TypeOf(const FType* Type);
	uint32_t VectorOf(EScalar Scalar, uint32_t Count) { return Module.Vector(ScalarType(Scalar), Count); }
	const FType* RowOf(const FType* Matrix) { return Types.Vector(Matrix->Scalar, Matrix->Columns); }
	static bool IsRealMatrix(const FType* Type);
	static bool IsTurned(const FType* Type);
	uint32_t MemoryType(const FType* Type, ELayout Layout);
	uint32_t MemoryArray(uint32_t Element, uint32_t Count, uint32_t Stride, ELayout Layout);
	void DecorateMemory(uint32_t Struct, uint32_t Index, const FType* Type, uint32_t Offset, ELayout Layout);
	bool IsSameInMemory(const FType* Type);
	uint32_t FromMemory(uint32_t Id, const FType* Type, ELayout Layout);
	uint32_t ToMemory(uint32_t Id, const FType* Type, ELayout Layout);
	static uint32_t MemberIndex(const FStructType& Struct, uint32_t Member);
	uint32_t ScalarConstant(EScalar Scalar, uint64_t Value);
	uint32_t ConstantOf(const FType* Type, const FConstant& Constant, size_t& Next);
	uint32_t ConstantOf(const FType* Type, const FConstant& Constant)
	{
		size_t Next = 0;
		return ConstantOf(Type, Constant, Next);
	}
	uint32_t RealConstant(EScalar Scalar, double Value);
	uint32_t Splat(uint32_t Id, uint32_t Scalar, uint32_t Count);

	// HlslEmitterBuffers.cpp: cbuffers and resources
	uint32_t BufferOf(const FBuffer& Buffer);
	void MakeLeaves();
	void AddLeaves(const FType* Type, const std::string& Name, std::vector<FLeaf*>& List, const FPlace& Place);
	FObjects UnboundedLeaves(const FVariable& Variable, uint32_t Index, const FPlace& Place);
	uint32_t IdOf(FLeaf& Leaf);
	uint32_t CounterOf(FLeaf& Leaf);
	uint32_t ViewOf(FLeaf& Leaf, const std::string& Of, EScalar Scalar);
	uint32_t MakeBuffer(const std::string& Name, const std::string& Type, const FType* Element, bool bReadOnly);
	uint32_t MakeConstantBlock(const FLeaf& Leaf);
	uint32_t ImageType(const FType* Type);
	bool IsWideBuffer(const FType* Type) const;
	static EScalar TexelScalar(EScalar Scalar);
	void Bind(uint32_t Id);
	/** Work for each candidate; its results (of type Type, 0: none) come together. */
	uint32_t ForEach(const FObjectSet& Set, uint32_t Type, const std::function<uint32_t(FLeaf&)>& Work);
	FObjects Objects(const FValue& Value, bool bEmit = true);
	FObjects VariableObjects(const FValue& Value, bool bEmit);
	FObjects ChosenObjects(const FValue& Value, bool bEmit);
	FObjects ElementObjects(const FValue& Value, bool bEmit);
	FObjectSet Object(const FValue& Value);
	/** The numbers of a value and its resources, computed once. */
	uint32_t Both(const FValue& Value, FObjects& Found);
	/** Memory that an assignment may go to; Condition 0: it does. */
	struct FSlotChoice
	{
		std::vector<FObjectSlot*> Slots;
		uint32_t Condition = 0;
	};
	std::vector<FSlotChoice> SlotsOf(const FValue& Value, bool bEmit);
	FSlotChoice SlotsOf(const FVariable& Variable);
	void StoreObjects(const std::vector<FSlotChoice>& Choices, const FObjects& Values);
	void FindObjects(const FFunction& Function);
	bool FindObjectsOf(const FCode& Code);
	bool FindObjectsOf(const FValue& Value);
	static uint32_t CountObjects(const FType* Type);
	uint32_t NumberOf(const FObjectSet& Set);

	// HlslEmitterPlaces.cpp
	static bool IsPlace(const FValue& Value);
	FTarget Place(const FValue& Value);
	FTarget VariablePlace(const FVariable& Variable);
	FTarget BufferPlace(const FVariable& Variable);
	FTarget BlockPlace(const FValue& Value);
	FTarget ElementPlace(const FValue& Value);
	FTarget IndexPlace(const FValue& Value);
	FTarget MatrixPlace(const FTarget& Matrix, const std::vector<uint8_t>& Parts);
	FTarget At(FTarget Target, uint32_t Index, const FType* Type);
	FTarget Component(FTarget Target, uint32_t Index);
	uint32_t Load(const FTarget& Target);
	uint32_t LoadWhole(const FTarget& Target);
	uint32_t BitsOf(uint32_t Id, const FBits& Bits);
	void StoreBits(FTarget Target, uint32_t Id);
	void Store(const FTarget& Target, uint32_t Id);
	uint32_t PointerTo(const FTarget& Target, uint32_t Base, uint32_t Storage);
	void StoreParts(const FTarget& Target, uint32_t Id);
	void StoreTexel(const FTarget& Target, uint32_t Id);
	uint32_t ReadTexel(const FTarget& Target, FLeaf& Leaf);
	uint32_t Table(const FVariable& Variable);
	FTarget Local(uint32_t Pointer, const FType* Type, uint32_t Storage = Spirv::StorageFunction);

	// HlslEmitterValues.cpp
	uint32_t Value(const FValue& Value);
	uint32_t ValueOf(const FValue& Value);
	uint32_t PartOf(const FValue& Value); // of a value that is not a place
	uint32_t Operate(const FValue& Value);
	uint32_t Arithmetic(std::string_view Operator, const FType* Type, uint32_t A, uint32_t B, const FType* Count);
	uint32_t ShortCircuit(const FValue& Value);
	uint32_t Choose(uint32_t Condition, const FType* Type, uint32_t A, uint32_t B);
	bool IsFree(const FValue& Value, int& Budget) const;
	uint32_t Assign(const FValue& Value);
	uint32_t Modify(const FValue& Value);
	uint32_t StepOf(const FValue& Value);
	uint32_t Negate(std::string_view Operator, const FType* Type, uint32_t A);
	uint32_t Convert(uint32_t Id, const FType* From, const FType* To);
	uint32_t ConvertScalars(uint32_t Id, EScalar From, EScalar To, uint32_t Count);
	uint32_t Extract(uint32_t Id, const FType* Type, uint32_t Scalar);
	uint32_t ExtractAt(uint32_t Id, uint32_t Type, const FWords& Path);
	uint32_t Shuffle(uint32_t Id, EScalar Scalar, uint32_t Count, const std::vector<uint8_t>& Parts);
	uint32_t Construct(uint32_t Type, const FWords& Ids);
	uint32_t Build(const FType* To, const std::vector<FPart>& Parts);
	uint32_t BuildPart(const FType* To, const std::vector<FPart>& Parts, size_t& Part, uint32_t& Offset);
	using FRowWork = std::function<uint32_t(const FType* Row, const FWords& Ids)>;
	/** Work for each row where the result is a matrix: other operands are given whole. */
	uint32_t ByRows(const FType* Result, const std::vector<FPart>& Operands, const FRowWork& Work);
	uint32_t ByScalars(const FType* Result, const std::vector<FPart>& Operands, const FRowWork& Work);

	// HlslEmitterIntrinsics.cpp, HlslEmitterMath.cpp, HlslEmitterWaves.cpp
	using FArguments = std::vector<FPart>;
	using FIntrinsicWork = uint32_t (FEmitter::*)(const FValue& Value, const FArguments& In);
	uint32_t Intrinsic(const FValue& Value);
	bool Extended(const FValue& Value, const FArguments& In, uint32_t& Result);
	uint32_t Multiply(const FValue& Value, const FArguments& In);
	uint32_t Dot(const FType* Type, uint32_t A, uint32_t B);
	uint32_t AllOrAny(const FValue& Value, const FArguments& In);
	uint32_t Transpose(const FValue& Value, const FArguments& In);
	uint32_t Reinterpret(const FValue& Value, const FArguments& In);
	uint32_t Parting(const FValue& Value, const FArguments& In); // modf, frexp, sincos
	uint32_t Packing(const FValue& Value, const FArguments& In);
	uint32_t OfBits(const FValue& Value, const FArguments& In);
	uint32_t OfWord(std::string_view Name, EScalar Scalar, uint32_t Count, uint32_t Id);
	uint32_t Lighting(const FValue& Value, const FArguments& In); // lit, dst
	uint32_t Bytes(const FValue& Value, const FArguments& In);    // msad4, dot4add, AddUint64
	uint32_t Simple(const FValue& Value, const FArguments& In);
	uint32_t Component(const FValue& Value, const FType* Part, const FWords& Ids);
	uint32_t Derivative(const FValue& Value, const FArguments& In);
	uint32_t Barrier(const FValue& Value, const FArguments& In);
	uint32_t Wave(const FValue& Value, const FArguments& In);
	uint32_t WaveOf(std::string_view Name, const FType* Type, const FWords& Ids);
	uint32_t WaveInput(uint32_t BuiltIn, const char* Name);
	uint32_t Interlocked(const FValue& Value);
	uint32_t Atomic(std::string_view Name, ENumber Kind, uint32_t Type, uint32_t Pointer, const FWords& Values);
	/** The last arguments of an atomic: values, then the place of the old one. */
	void AtomicOn(const FTarget& Target, std::string_view Name, ENumber Kind, const FValue& Value, size_t First);
	uint32_t Bitwise(uint32_t Id, EScalar From, EScalar To);

	// HlslEmitterMethods.cpp, HlslEmitterBytes.cpp
	/** Operands of an instruction on an image; 0: not given. */
	struct FSampling
	{
		uint32_t At = 0;
		uint32_t Reference = 0;
		uint32_t Bias = 0;
		uint32_t Lod = 0;
		uint32_t GradX = 0;
		uint32_t GradY = 0;
		uint32_t Offset = 0;
		uint32_t Clamp = 0;
	};
	uint32_t Method(const FValue& Value);
	FSampling ReadSampling(const FValue& Value);
	uint32_t Sample(const FValue& Value);
	uint32_t Gather(const FValue& Value);
	uint32_t OnImage(const FValue& Value, uint32_t Type, const std::function<uint32_t(uint32_t Pair)>& Work);
	void AddOffset(FWords& Words, uint32_t& Mask, uint32_t Offset);
	uint32_t Fetch(const FValue& Value);
	uint32_t CutTexel(uint32_t Id, const FType* Texture, const FType* To);
	uint32_t GetSizes(const FValue& Value);      // of Length: the value; of GetDimensions: 0
	uint32_t CountElements(const FValue& Value); // Append, Consume, IncrementCounter, DecrementCounter
	uint32_t ByteMethod(const FValue& Value);
	uint32_t LoadBytes(FLeaf& Leaf, uint32_t Address, const FType* Type, uint32_t Offset);
	uint32_t LoadByteScalar(FLeaf& Leaf, uint32_t Address, EScalar Scalar, uint32_t Offset);
	void StoreBytes(FLeaf& Leaf, uint32_t Address, const FPart& Value, uint32_t Offset);
	void StoreByteScalar(FLeaf& Leaf, uint32_t Address, uint32_t Id, EScalar Scalar, uint32_t Offset);
	uint32_t ByteIndex(uint32_t Address, uint32_t Offset, uint32_t Shift);
	uint32_t WordPointer(FLeaf& Leaf, uint32_t Address, uint32_t Offset);

	// HlslEmitterEntry.cpp
	struct FStageValue
	{
		std::string Name;
		std::string Semantic;
		uint32_t Modifiers = 0;
		uint32_t Index = 0; // of an element
		bool bOutput = false;
	};
	uint32_t WriteEntry();
	uint32_t ReadInput(const FType* Type, const FStageValue& Input);
	void WriteOutput(const FType* Type, const FStageValue& Output, uint32_t Id);
	static FStageValue StagePart(const FType* Type, const FStageValue& Value, uint32_t Index);
	uint32_t StageVariable(const FType* Type, const FStageValue& Value, const FType*& Declared);

	const FProgram& Program;
	FTypes& Types;
	FModule Module;
	FFrame* Frame = nullptr;
	FPlace Current;
	int Depth = 0;
	bool bWaves = false;
	uint32_t LastCall = 0; // what the latest call returned
	uint32_t NextBinding = 0;
	uint32_t NextLocation[2] = {0, 0}; // of inputs, of outputs
	FWords Interface;
	std::vector<FWords> Modes;
	std::map<uint32_t, uint32_t> BuiltIns;          // variables of waves
	std::map<const FStructType*, uint32_t> Structs; // as values
	std::map<std::pair<const FType*, ELayout>, uint32_t> MemoryTypes;
	std::map<std::pair<const FStructType*, ELayout>, uint32_t> MemoryStructs;
	std::map<FWords, uint32_t> MemoryArrays;
	std::map<const FBuffer*, uint32_t> Buffers;
	std::map<const FVariable*, uint32_t> Globals; // statics, groupshared, copies of loose parameters that are written
	std::deque<FLeaf> Leaves;
	std::map<const FVariable*, std::vector<FLeaf*>> LeavesOf;
	std::map<std::pair<const FVariable*, uint32_t>, std::vector<FLeaf*>> Unbounded;
	std::deque<FInstance> InstancePool;
	std::map<std::pair<const FFunction*, FWords>, FInstance*> Instances;
};

} // namespace Drydock::Hlsl
