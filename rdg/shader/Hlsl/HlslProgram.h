// The program of one entry: what the analysis gives and the emitter reads. All names are resolved, every conversion is
// written out, templates are made, and only what the entry reaches is in it.
#pragma once

#include "HlslTypes.h"

namespace Drydock::Hlsl
{

struct FFunction;
struct FValue;

enum class EStorage : uint8_t
{
	Local,
	Parameter, // of a function
	Static,    // one for each thread
	Groupshared,
	Loose, // a parameter of the shader at file scope, in $Global; read only, but FXC's older mode copies what is
		   // written
	Member,   // of a cbuffer, a tbuffer: Buffer is that one
	Resource, // a texture, sampler, buffer at file scope
	This,     // of a method: its object, a reference
};

/** A cbuffer or tbuffer, and the struct of loose parameters. */
struct FBuffer
{
	std::string Name; // "$Global" for loose parameters
	FPlace Place;
	bool bTBuffer = false;
	std::vector<struct FVariable*> Members;
	std::vector<uint32_t> Offsets; // bytes
};

/** The scalars of a constant, row by row, in the bits of their type: a float's as 32 bits, a bool's 0 or 1, what is
 * literal as long (LiteralInt) and double (LiteralFloat). */
using FConstant = std::vector<uint64_t>;

struct FVariable
{
	std::string Name;
	const FType* Type = nullptr;
	EStorage Storage = EStorage::Local;
	FPlace Place;
	uint32_t Modifiers = 0;
	FBuffer* Buffer = nullptr;         // Loose and Member
	uint32_t Index = 0;                // in Buffer->Members; of a parameter
	std::string Semantic;              // of an entry's parameter, in capital letters with its index
	FValue* Initializer = nullptr;     // Static: run before the entry, in the order of FProgram::Statics
	std::optional<FConstant> Constant; // of what is const and whose value is known
	bool bWritten = false;
	bool bFeedback = false;        // for the analysis
	std::string_view ResourceName; // as declared; arrays of resources have theirs here, too
};

enum class EValue : uint8_t
{
	Constant, // Constant
	Variable, // Variable
	Member,   // Operands[0] . member Index of its struct (FStructType::Members)
	Index,   // Operands[0] [Operands[1]]: of an array, of a vector (its component), of a matrix (its row); the index is
			 // int or uint
	Element, // Operands[0] [Operands[1]]: a place in a resource: RWTexture, RWBuffer, RWStructuredBuffer, or a value
			 // read from a resource that is read only. The index is an integer vector of as many components as the
			 // resource has dimensions
	Bits,    // a bit field: the bits Bits of the uint Operands[0]
	Swizzle, // components Parts of Operands[0], a scalar or vector
	Elements, // elements Parts of Operands[0], a matrix, each as row * 4 + column
	Unary,    // Operator: - ! ~, by components; the operand has the type of the result
	Binary,   // Operator; both operands have one type; comparisons give bool of its shape. % of reals truncates (fmod)
	And,      // && of bool scalars: the right side is run only where the left is true
	Or,
	Choose,  // ?: of a bool scalar: only the side that is taken is run
	Select,  // select(): by components, all sides are run; the condition is a bool of the result's shape
	Assign,  // Operands[0] = Operands[1], of one type; the value is what was stored
	Modify,  // Operands[0] Operator= Operands[1]. The arithmetic is done in the type of Operands[1] (a shift: of
			 // Operands[0]); Convert back where that is another. The value is what was stored
	Step,    // ++ and --, Operator "++" or "--"; bPostfix: the value is the one before
	Convert, // a numeric value of the same shape with another scalar; a splat of a scalar; a vector or matrix cut down;
			 // a matrix of n rows and 1 column as a vector and back
	Compose, // a numeric value, array or struct out of all scalars of the operands, in order, each converted already
	Zero,    // all 0 (a struct cast from 0)
	Call,    // Function; Operands are its arguments (of a method, the object first). out and inout arguments are places
	Intrinsic, // Name: one of HlslIntrinsics.h; Operands
	Method,    // Name: of the resource Operands[0]; the other Operands are its arguments, in the overload's types
	Comma,
	Cast,   // by scalars, in order, each converted: an array, struct or numeric value as another one. The first ones
			// where there are more (a struct as its base); a single scalar goes to all
	String, // Text
};

/** A bit field's place in a uint. */
struct FBits
{
	uint8_t First = 0;
	uint8_t Count = 0; // 0: it is not a bit field
	bool bSigned = false;
};

struct FValue
{
	EValue Kind = EValue::Constant;
	const FType* Type = nullptr;
	FPlace Place;
	bool bPlace = false; // it can be written to
	bool bConst = false; // a place that must not be
	bool bPostfix = false;
	bool bPrecise = false;
	bool bFractionLost = false; // a constant: a division of whole numbers that has a remainder
	uint32_t Index = 0;
	FBits Bits;
	std::string_view Operator;
	std::string_view Name;
	FVariable* Variable = nullptr;
	FFunction* Function = nullptr;
	FConstant Constant;
	std::vector<uint8_t> Parts;
	std::vector<FValue*> Operands;
	std::string Text;
};

enum class EStep : uint8_t
{
	Block,
	Variable, // Variable is declared, with Value or none
	Value,
	If,   // Value, Body[0], Body[1] or none
	Loop, // Body[0]: what runs before; Value: the condition or null; Next: what runs after each turn, or null; Body[1]
	DoLoop, // Body[1], then Value
	Switch, // Value, Cases
	Break,
	Continue,
	Return,
	Discard,
};

struct FCase
{
	std::vector<uint32_t> Labels; // bits of 32
	bool bDefault = false;
	std::vector<struct FCode*>
		Body; // without what follows a break; the analysis refuses fall-through of what is not empty, as D3D does
};

/** A statement. */
struct FCode
{
	EStep Kind = EStep::Block;
	FPlace Place;
	FVariable* Variable = nullptr;
	FValue* Value = nullptr;
	FValue* Next = nullptr;
	std::vector<FCode*> Body;
	std::vector<FCase> Cases;
	bool bUnroll = false;
	bool bLoop = false;
	bool bBranch = false;
	bool bFlatten = false;
	uint32_t MaxTurns = 0; // [unroll(N)]: no more turns than these; 0: no bound
};

struct FFunction
{
	std::string Name;    // with its namespaces and template arguments: "N::F<float>"
	std::string Mangled; // with the types of its parameters
	FPlace Place;
	const FType* Result = nullptr;
	std::string Semantic;               // of what the entry returns
	std::vector<FVariable*> Parameters; // of a method, `this` first
	FCode* Body = nullptr;
	bool bMethod = false;
	bool bPrecise = false;
};

enum class EStage : uint8_t
{
	Vertex,
	Pixel,
	Compute,
};

/** Owns all its nodes. */
struct FProgram
{
	EStage Stage = EStage::Compute;
	FTypes* Types = nullptr;
	FFunction* Entry = nullptr;
	uint32_t GroupSize[3] = {1, 1, 1};
	uint32_t WaveSize = 0; // [WaveSize(N)]; 0: none
	bool bEarlyDepthStencil = false;
	bool bFxcRules = false;
	std::vector<FFunction*> Functions; // those that the entry reaches, each after those that it calls
	std::vector<FVariable*> Statics;   // in the order of their declaration; Groupshared too
	std::vector<FVariable*> Resources; // those that are used, in the order of their declaration
	std::vector<FBuffer*> Buffers;     // those that are used; $Global first
	std::vector<std::string> Files;

	/** The semantic of an output in the words of Direct3D 10: FXC takes those of Direct3D 9 for pixel shaders, too. */
	std::string MapOutput(const std::string& Semantic) const
	{
		const bool bOld = bFxcRules && Stage == EStage::Pixel;
		const bool bColor =
			Semantic.starts_with("COLOR") && Semantic.find_first_not_of("0123456789", 5) == Semantic.npos;
		return bOld && bColor                 ? "SV_TARGET" + Semantic.substr(5)
			   : bOld && Semantic == "DEPTH0" ? "SV_DEPTH0"
											  : Semantic;
	}

	template<typename T>
	T* Make()
	{
		std::deque<T>& Pool = std::get<std::deque<T>>(Pools);
		return &Pool.emplace_back();
	}

private:
	std::tuple<std::deque<FValue>, std::deque<FVariable>, std::deque<FCode>, std::deque<FFunction>, std::deque<FBuffer>>
		Pools;
};

} // namespace Drydock::Hlsl
