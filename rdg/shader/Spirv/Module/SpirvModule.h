// A SPIR-V module read into plain structs: the one input of reflection, emitter and interpreter. The reader trusts
// nothing: any sequence of words gives either a module whose ids, types and operand counts fit together, or
// FSpirvError.
//
// Every numeric type is a flat row of scalars of 16, 32 or 64 bits (a float3x3 is nine, column by column as SPIR-V
// counts columns; a struct its members one after the other), so later stages think in scalars only.
#pragma once

#include "DrydockAPI.h"
#include "SpirvOps.h"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace Drydock
{

/** The file of functions that the source pass adds: their work counts as that of the calling line. */
inline constexpr const char* GSpirvFileOfCallers = "/Drydock/Callers";

/** A module that cannot be used: garbage, or something the CPU tier does not do. File and Line are the .usf's where
 * known. */
class DRYDOCK_API FSpirvError : public std::runtime_error
{
public:
	FSpirvError(const std::string& Message, std::string InFile = {}, int InLine = 0);
	~FSpirvError() override;

	std::string File;
	int Line;
};

/** A shader beyond one of the limits of SpirvLimits.h. */
class DRYDOCK_API FSpirvLimitError : public FSpirvError
{
public:
	using FSpirvError::FSpirvError;
	~FSpirvLimitError() override;
};

enum class ESpirvType : uint8_t
{
	None,
	Void,
	Bool,
	Int,
	Uint,
	Float,
	Half,
	Short,
	Ushort,
	Double,
	Long,
	Ulong,
	Vector,
	Matrix,
	Array,
	RuntimeArray,
	Struct,
	Pointer,
	Image,
	Sampler,
	SampledImage,
	Function
};

constexpr bool IsSpirvScalar(ESpirvType Kind)
{
	return Kind >= ESpirvType::Bool && Kind <= ESpirvType::Ulong;
}

constexpr bool IsSpirvReal(ESpirvType Kind)
{
	return Kind == ESpirvType::Float || Kind == ESpirvType::Half || Kind == ESpirvType::Double;
}

constexpr bool IsSpirvInteger(ESpirvType Kind)
{
	return IsSpirvScalar(Kind) && !IsSpirvReal(Kind) && Kind != ESpirvType::Bool;
}

constexpr bool IsSpirvSigned(ESpirvType Kind)
{
	return Kind == ESpirvType::Int || Kind == ESpirvType::Short || Kind == ESpirvType::Long;
}

/** Bytes that a scalar takes in a buffer. */
constexpr uint32_t GetSpirvBytes(ESpirvType Kind)
{
	return Kind >= ESpirvType::Double && Kind <= ESpirvType::Ulong  ? 8
		   : Kind >= ESpirvType::Half && Kind <= ESpirvType::Ushort ? 2
																	: 4;
}

/** Another kind of a scalar's width: the signed or the unsigned integer. */
constexpr ESpirvType GetSpirvSigned(ESpirvType Kind)
{
	const uint32_t Bytes = GetSpirvBytes(Kind);
	return Bytes == 8 ? ESpirvType::Long : Bytes == 2 ? ESpirvType::Short : ESpirvType::Int;
}
constexpr ESpirvType GetSpirvUnsigned(ESpirvType Kind)
{
	const uint32_t Bytes = GetSpirvBytes(Kind);
	return Bytes == 8 ? ESpirvType::Ulong : Bytes == 2 ? ESpirvType::Ushort : ESpirvType::Uint;
}

struct FSpirvMember
{
	uint32_t Type = 0;
	std::string Name;
	uint32_t Offset = 0;       // bytes, blocks only
	uint32_t MatrixStride = 0; // bytes between the vectors of a matrix
	bool bRowMajor = false;    // SPIR-V's sense, the opposite of HLSL's
	bool bNonWritable = false;
};

struct FSpirvType
{
	ESpirvType Kind = ESpirvType::None;
	uint32_t Element =
		0; // vector: scalar, matrix: column, array: element, pointer: pointee, image: texel, sampled image: image
	uint32_t Count = 0;       // components, columns, elements
	uint32_t Storage = 0;     // pointer
	uint32_t ArrayStride = 0; // bytes
	std::vector<FSpirvMember> Members;
	std::vector<uint32_t> MemberScalars; // numeric struct: where the scalars of each member begin
	std::string Name;
	bool bBlock = false;
	bool bBufferBlock = false;
	uint32_t Dim = 0; // image
	bool bArrayed = false;
	bool bMultisampled = false;
	bool bStorageImage = false;
	uint32_t Format = 0;
	uint32_t NumScalars = 0; // flattened; 0: not numeric
};

/** One instruction inside the function. Operands: what follows type and result. */
struct FSpirvInstruction
{
	uint16_t Op = 0;
	uint32_t Type = 0;   // 0: none
	uint32_t Result = 0; // 0: none
	std::vector<uint32_t> Operands;
	uint32_t File = 0; // index into FSpirvModule::Files
	int Line = 0;      // 0: unknown
};

struct FSpirvBlock
{
	uint32_t Label = 0;
	std::vector<FSpirvInstruction> Instructions; // phis first; the last one is the terminator
	uint32_t Merge = 0;                          // 0: no merge instruction
	uint32_t Continue = 0;                       // 0: not a loop header

	const FSpirvInstruction& Terminator() const { return Instructions.back(); }
	bool IsLoopHeader() const { return Continue != 0; }
};

struct FSpirvConstant
{
	uint32_t Type = 0;
	std::vector<uint64_t> Scalars; // bit patterns of their own width, bools 0 and 1
};

struct FSpirvVariable
{
	uint32_t Id = 0;
	uint32_t Type = 0; // the pointee
	uint32_t Storage = 0;
	uint32_t Initializer = 0; // constant, 0: none
	uint32_t BuiltIn = Spirv::BuiltInNone;
	uint32_t Location = 0;
	std::string Name;
	std::string Semantic;  // "TEXCOORD0", "SV_TARGET1"
	uint32_t Counter = 0;  // structured buffers: the variable that is the hidden counter, where a decoration says it
	std::string CounterOf; // of a hidden counter: the buffer's name, see SpirvCounters.h
};

/** An operation that drydock does not run, in a function that was not inlined. */
struct FSpirvRefusedPlace
{
	std::string Message; // empty: there is none
	uint32_t File = 0;
	int Line = 0;
};

/** A function of a module that was read whole. Its blocks stand in a row in FSpirvModule::Blocks. */
struct FSpirvFunction
{
	uint32_t Id = 0;
	uint32_t Type = 0; // of what it returns
	std::string Name;  // as in HLSL; empty: the front end's own entry point around it
	std::vector<uint32_t> Parameters;
	uint32_t FirstBlock = 0;
	uint32_t NumBlocks = 0;
};

struct DRYDOCK_API FSpirvModule
{
	uint32_t Bound = 0;
	uint32_t ExecutionModel = ~0u; // of the entry point
	uint32_t LocalSize[3] = {1, 1, 1};
	std::unordered_map<uint32_t, FSpirvType> Types;
	std::unordered_map<uint32_t, FSpirvConstant> Constants;
	std::vector<FSpirvVariable> Variables;                   // module scope first, then the function's
	std::vector<std::string> Files;                          // Files[0] is empty
	std::vector<FSpirvBlock> Blocks;                         // the entry function; Blocks[0] is its first block
	std::unordered_map<uint32_t, uint32_t> BlockIndex;       // label -> index
	std::unordered_map<uint32_t, uint32_t> VariableIndex;    // id -> index
	std::unordered_map<uint32_t, uint32_t> ValueTypes;       // id of a constant, variable or result -> type
	std::vector<uint32_t> KillFunctions;                     // functions that only discard
	std::unordered_map<uint32_t, std::string> FunctionNames; // as in HLSL
	FSpirvRefusedPlace RefusedElsewhere;
	std::vector<FSpirvFunction> Functions;           // ReadWholeSpirv only
	uint32_t EntryFunction = 0;                      // id
	bool bQuads = false;                             // pixels run by quads, see SpirvQuads.h
	std::unordered_map<uint32_t, std::string> Names; // ReadWholeSpirv only: of values

	const FSpirvType& GetType(uint32_t Id) const;      // throws on an unknown id, as all of these
	const FSpirvType& GetValueType(uint32_t Id) const; // type of a value
	uint32_t GetValueTypeId(uint32_t Id) const;
	const FSpirvBlock& GetBlock(uint32_t Label) const;
	const FSpirvVariable* FindVariable(uint32_t Id) const;
	const FSpirvConstant* FindConstant(uint32_t Id) const;
	uint32_t GetConstantScalar(uint32_t Id) const;                  // throws when Id is not a scalar constant
	ESpirvType GetScalarKind(uint32_t Type, uint32_t Scalar) const; // of one flattened scalar
	uint32_t GetMemberScalar(uint32_t Type, uint32_t Index) const;  // flattened position of a member or element
	uint32_t GetMemberType(uint32_t Type, uint32_t Index) const;

	/** A part of a composite: where its scalars begin among those of the whole, and its type. */
	struct FPart
	{
		uint32_t Offset = 0;
		uint32_t Type = 0;
	};
	/** Walks from a value of Type by the indices, one a level. */
	FPart FindPart(uint32_t Type, const uint32_t* Begin, const uint32_t* End) const;
	[[noreturn]] void Fail(const std::string& Message, const FSpirvInstruction* Where = nullptr) const;
	/** "more than LIMIT WHAT, which is drydock's limit; ADVICE" */
	[[noreturn]] void FailLimit(size_t Limit, const std::string& What, const std::string& Advice,
		const FSpirvInstruction* Where = nullptr) const;
};

/** Reads and checks a module with one entry point. Throws FSpirvError. */
DRYDOCK_API FSpirvModule ReadSpirv(const std::vector<uint32_t>& Words);

/** Reads a module whose calls were not inlined, for the interpreter alone: all functions, all names. The sizes of
 * operands are not checked. Throws FSpirvError. */
DRYDOCK_API FSpirvModule ReadWholeSpirv(const std::vector<uint32_t>& Words);

/** Labels a terminator can go to, in operand order, without repetition. */
std::vector<uint32_t> GetSuccessors(const FSpirvInstruction& Terminator);

/** Ends a block. */
constexpr bool IsSpirvTerminator(uint16_t Op)
{
	return Op >= Spirv::OpBranch && Op <= Spirv::OpUnreachable;
}

/** Reads and writes one number at once: loads, stores and Interlocked*. Operands: pointer, scope, semantics, and more.
 */
constexpr bool IsSpirvAtomic(uint16_t Op)
{
	return Op >= Spirv::OpAtomicLoad && Op <= Spirv::OpAtomicXor;
}

/** Operations by which the threads of a wave exchange values. Operands: scope first. */
constexpr bool IsSpirvWave(uint16_t Op)
{
	return Op >= Spirv::OpGroupNonUniformElect && Op <= Spirv::OpGroupNonUniformQuadSwap;
}

/** A sample that does not say at which level. */
constexpr bool ChoosesSpirvLevel(uint16_t Op)
{
	return Op == Spirv::OpImageSampleImplicitLod || Op == Spirv::OpImageSampleDrefImplicitLod;
}

/** Operations by which a pixel asks the other three of its quad, and no other thread. */
constexpr bool IsSpirvDerivative(uint16_t Op)
{
	return (Op >= Spirv::OpDPdx && Op <= Spirv::OpFwidthCoarse) || Op == Spirv::OpImageQueryLod;
}

/** A wave operation whose first operand behind the scope selects all threads, or those before each one. */
constexpr bool HasGroupOperation(uint16_t Op)
{
	return Op == Spirv::OpGroupNonUniformBallotBitCount ||
		   (Op >= Spirv::OpGroupNonUniformIAdd && Op <= Spirv::OpGroupNonUniformBitwiseXor);
}

/** "OpFunctionCall", or "Op4711" when the number is not one that messages name. */
std::string GetSpirvOpName(uint16_t Op);

} // namespace Drydock
