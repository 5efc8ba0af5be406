// The syntax tree of a preprocessed HLSL text: what the parser gives and the analysis reads. Nothing is looked up here
// but whether a name is a type.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace Drydock::Hlsl
{

/** The place of a token. File indexes FTree::Files; Column is 1-based, in the preprocessed line. */
struct FPlace
{
	uint32_t File = 0;
	int32_t Line = 0;
	int32_t Column = 0;
};

enum class EToken : uint8_t
{
	End,
	Word,
	Number,
	String, // with its quotes
	Sign,   // punctuation; the longest that HLSL has, but `>>` is two signs that touch
	Pragma, // the whole line of #pragma
};

struct FToken
{
	EToken Kind = EToken::End;
	bool bTouches = false; // no blank between this and the token before
	std::string_view Text;
	FPlace Place;

	bool Is(std::string_view Other) const { return Text == Other && Kind != EToken::String; }
};

/** Words of types that FXC takes as names of variables and members, too. */
inline bool IsNumberName(std::string_view Word)
{
	return Word == "bool" || Word == "int" || Word == "uint" || Word == "half" || Word == "float" || Word == "double";
}

struct FExpression;
struct FStatement;
struct FStruct;
struct FEnum;
struct FDeclaration;
struct FTypeName;

/** An argument between < and >: a type or an expression. A name alone is given as an expression, and as a type where
 * the parser knows it as one. */
struct FTemplateArgument
{
	FTypeName* Type = nullptr;
	FExpression* Value = nullptr;
};

/** A::B<C>::D; each part has its own arguments. */
struct FNamePart
{
	std::string_view Text;
	FPlace Place;
	bool bArguments = false; // < and > stand there, with nothing between them perhaps
	std::vector<FTemplateArgument> Arguments;
};

struct FName
{
	bool bGlobal = false; // ::A
	uint32_t Height = 0;  // of the highest expression between its < and >
	std::vector<FNamePart> Parts;

	/** Empty for a thing without a name. */
	std::string_view Last() const { return Parts.empty() ? std::string_view() : Parts.back().Text; }
};

/** Words before a declaration or a parameter. */
enum EModifier : uint32_t
{
	ModifierStatic = 1u << 0,
	ModifierConst = 1u << 1,
	ModifierUniform = 1u << 2,
	ModifierExtern = 1u << 3,
	ModifierGroupshared = 1u << 4,
	ModifierPrecise = 1u << 5,
	ModifierIn = 1u << 6,
	ModifierOut = 1u << 7, // inout has both
	ModifierRowMajor = 1u << 8,
	ModifierColumnMajor = 1u << 9,
	ModifierInline = 1u << 10,
	ModifierVolatile = 1u << 11,
	ModifierUnorm = 1u << 12,
	ModifierSnorm = 1u << 13,
	ModifierNoInterpolation = 1u << 14,
	ModifierLinear = 1u << 15,
	ModifierCentroid = 1u << 16,
	ModifierNoPerspective = 1u << 17,
	ModifierSample = 1u << 18,
	ModifierGloballyCoherent = 1u << 19,
	ModifierExport = 1u << 20,
	ModifierPacked = 1u << 21, // a matrix whose order a #pragma pack_matrix before it chose, row or column
};

/** A type as it is written. One of Struct and Enum where the declaration defines it; else Name. The declarators of one
 * declaration share one FTypeName. */
struct FTypeName
{
	FPlace Place;
	/** const, volatile, precise, row_major, column_major, unorm, snorm, which the declaration's Modifiers have, too. A
	 * matrix named by a word of the language that has neither order of its own has ModifierPacked and the order of the
	 * #pragma pack_matrix before it: that of a typedef is the order where the typedef stands. */
	uint32_t Modifiers = 0;
	FName Name;
	FStruct* Struct = nullptr;
	FEnum* Enum = nullptr;
	std::vector<FExpression*> Dimensions; // of `using A = float[3]` and of arguments; null: []
};

enum class EExpression : uint8_t
{
	Number,      // Text: the literal
	Boolean,     // Text: true or false
	String,      // Text
	Name,        // Name
	This,        // this
	Unary,       // Text: + - ! ~ ++ --, one operand
	Postfix,     // Text: ++ --
	Binary,      // Text: * / % + - << >> < > <= >= == != & ^ | && ||
	Assign,      // Text: = += -= ...
	Conditional, // three operands
	Comma,       // two
	Call,        // operand 0 is what is called (a Name, or a Member for a method), then the arguments
	Member,      // operand 0 . Name
	Index,       // operand 0 [ operand 1 ]
	Cast,        // (Type) operand 0
	Construct,   // Type(arguments), where the parser knows the name as a type
	List,        // { ... }
	SizeOf,      // of Type, or of operand 0
};

struct FExpression
{
	EExpression Kind = EExpression::Number;
	FPlace Place; // of the operator or of the first token
	std::string_view Text;
	FName Name;
	FTypeName* Type = nullptr;
	std::vector<FExpression*> Operands;
	bool bParenthesized = false;
	uint32_t Height = 1; // levels of expressions below it, itself counted; at most MaxHeight (HlslParser.h)
};

/** [numthreads(8, 8, 1)] and [unroll]: the name in small letters. */
struct FAttribute
{
	FPlace Place;
	std::string Name;
	std::vector<FExpression*> Arguments;
};

enum class EStatement : uint8_t
{
	Block,       // Body
	Declaration, // Declarations
	Expression,  // Value
	If,          // Value, Body[0], Body[1] or none
	For,         // Body[0] (initialisation, or null), Value or null, Step or null, Body[1]
	While,
	Do,
	Switch,  // Value, Body[0] is a block with Case and Default in it
	Case,    // Value; a label, what follows it stands beside it
	Default, // a label
	Break,
	Continue,
	Return, // Value or null
	Discard,
	Empty,
};

struct FStatement
{
	EStatement Kind = EStatement::Empty;
	FPlace Place;
	FPlace End; // of a block: its closing brace
	std::vector<FAttribute> Attributes;
	FExpression* Value = nullptr;
	FExpression* Step = nullptr;
	FDeclaration* Condition = nullptr; // if (T X = ...)
	std::vector<FStatement*> Body;
	std::vector<FDeclaration*> Declarations;
};

/** `: SV_Target0`, `: register(t0, space1)`, `: packoffset(c0.x)`. */
struct FAnnotation
{
	FPlace Place;
	std::string_view Name;                   // the semantic, register or packoffset
	std::vector<std::string_view> Arguments; // "t0", "space1"; "c0.x"
};

struct FTemplateParameter
{
	FPlace Place;
	std::string_view Name;
	FTypeName* ValueType = nullptr; // null: typename
	FTemplateArgument Default;      // neither: none
};

enum class EDeclaration : uint8_t
{
	Variable,  // also parameters and members
	Function,  // Parameters, Body or null
	Struct,    // Struct
	Enum,      // Enum
	Typedef,   // Type and Dimensions by Name; typedef and using
	Namespace, // Members
	Buffer,    // cbuffer and tbuffer: Members
	Assert,    // static_assert: Value, Text
	Pack,      // not made: FTypeName::Modifiers has what #pragma pack_matrix says
	Using,     // Name: of `using A::B;`, and of `using namespace A;` with Text "namespace"
};

struct FDeclaration
{
	EDeclaration Kind = EDeclaration::Variable;
	FPlace Place; // of the name
	/** One part, but for functions that are defined outside of their struct. The part of a specialization has its
	 * arguments, of structs, too. An operator's is "operator". */
	FName Name;
	uint32_t Modifiers = 0;
	FTypeName* Type = nullptr;            // of the variable; what the function returns
	std::vector<FExpression*> Dimensions; // of a variable; null: []
	FExpression* Value = nullptr;         // initializer or default argument
	FExpression* Width = nullptr;         // bits of a bit field
	bool bConstructed = false;            // the initializer stands in braces without a =
	std::vector<FAnnotation> Annotations;
	std::vector<FAttribute> Attributes;
	bool bTemplate = false; // template<...>; template<> has no parameters: a specialization
	std::vector<FTemplateParameter> Template;
	std::vector<FDeclaration*> Parameters;
	FStatement* Body = nullptr;
	std::string_view Operator; // of `operator+`: "+"; () and [] as "()" and "[]"
	bool bConstMethod = false; // F() const
	bool bTBuffer = false;
	FStruct* Struct = nullptr;
	FEnum* Enum = nullptr;
	std::vector<FDeclaration*> Members; // of namespaces and buffers
	std::string_view Text;
};

struct FStruct
{
	FPlace Place;
	std::string_view Name; // empty: none
	bool bClass = false;
	std::vector<FTypeName*> Bases;
	std::vector<FDeclaration*> Members; // variables, functions, structs, enums, typedefs
};

struct FEnumerator
{
	FPlace Place;
	std::string_view Name;
	FExpression* Value = nullptr;
};

struct FEnum
{
	FPlace Place;
	std::string_view Name;
	bool bScoped = false;
	FTypeName* Base = nullptr;
	std::vector<FEnumerator> Enumerators;
};

/** A whole text. It owns all nodes and the text that their views point into. */
struct FTree
{
	std::shared_ptr<const std::string> Text;
	std::vector<std::string> Files; // virtual paths
	std::vector<FDeclaration*> Declarations;

	template<typename T>
	T* Make(const FPlace& Place)
	{
		std::deque<T>& Pool = std::get<std::deque<T>>(Pools);
		Pool.emplace_back();
		Pool.back().Place = Place;
		return &Pool.back();
	}

	/** A name that the text does not have. */
	std::string_view Keep(const std::string& Name) { return Names.emplace_back(Name); }

private:
	std::deque<std::string> Names;
	std::tuple<std::deque<FExpression>, std::deque<FStatement>, std::deque<FDeclaration>, std::deque<FStruct>,
		std::deque<FEnum>, std::deque<FTypeName>>
		Pools;
};

} // namespace Drydock::Hlsl
