// The things that names stand for: scopes and symbols, overloads, instances of templates.
#pragma once

#include "HlslProgram.h"
#include "HlslTree.h"

#include <map>
#include <optional>
#include <unordered_map>

namespace Drydock::Hlsl
{

struct FNameScope;
struct FSymbol;
struct FStructInfo;

/** The kind of thing that a name stands for. */
enum class ESymbol : uint8_t
{
	Variable,  // of a file, a namespace, a block; static members
	Field,     // of a struct: Index
	Functions, // Overloads
	Struct,    // a template where Declaration->bTemplate
	Enum,
	Enumerator, // of Owner, or with Value
	Alias,      // typedef, using
	Type,       // an argument of a template
	Namespace,  // Inner
};

/** The argument for a parameter of a template. */
struct FTemplateValue
{
	const FType* Type = nullptr; // of the value where there is one
	FValue* Value = nullptr;     // a Constant

	bool operator==(const FTemplateValue& Other) const
	{
		return Type == Other.Type && !Value == !Other.Value && (!Value || Value->Constant == Other.Value->Constant);
	}
};

/** One function of a name, or one instance of a template of functions. */
struct FOverload
{
	const FDeclaration* Declaration = nullptr; // with a body where one is known
	FNameScope* Scope = nullptr;
	FStructInfo* Struct = nullptr; // whose method it is
	uint32_t Order = 0;            // what stands before this in the text cannot call it
	uint32_t BodyOrder = 0;        // the body cannot name what stands behind this
	bool bSigned = false;          // Result, Parameters and Declared are known
	bool bBad = false;             // and were wrong
	bool bOutside = false;         // of a template's struct, and defined outside of it
	bool bMerged = false;          // another one of the same parameters stands for it
	const FType* Result = nullptr;
	std::vector<FParameterType> Parameters;
	std::vector<const FDeclaration*> Declared; // the parameters
	std::vector<const FDeclaration*> Defaults; // those with a value, or null
	std::string Arguments;                     // "<float, 2>" of an instance
	FOverload* Template = nullptr;             // whose instance it is
	int Depth = 0;                             // of instances that call instances
	std::map<std::string, FOverload*> Instances;
	std::map<const FType*, FFunction*> Made; // by the type of `this`
};

struct FSymbol
{
	ESymbol Kind = ESymbol::Variable;
	std::string_view Name;
	FNameScope* Scope = nullptr;               // in which it stands
	const FDeclaration* Declaration = nullptr; // null: a struct or an enum in a type's place
	const FDeclaration* Buffer = nullptr;      // the cbuffer around it
	const FDeclaration* Definition = nullptr;  // of a static member, outside of its struct
	const FStruct* Struct = nullptr;
	const FEnum* Enum = nullptr;
	FPlace Place;
	uint32_t Order = 0; // what stands before this in the text cannot name it; 0: all can
	uint32_t Index = 0;
	FBits Bits;
	bool bBusy = false;     // to find what depends on itself
	bool bPrepared = false; // Overloads are signed and merged
	bool bOfLoop = false;   // a for in front of this place declared it, see KeepLoopVariables
	FVariable* Variable = nullptr;
	const FType* Type = nullptr;
	FValue* Value = nullptr;
	FSymbol* Owner = nullptr;
	FNameScope* Inner = nullptr; // of namespaces and enums
	FStructInfo* Info = nullptr;
	std::vector<FOverload*> Overloads;
	std::vector<FOverload*> Specializations;  // of functions
	std::vector<const FDeclaration*> Special; // of structs
	std::vector<const FDeclaration*> Outside; // members of a template that are defined outside of it
	std::map<std::string, FStructInfo*> Instances;
};

enum class EScopeKind : uint8_t
{
	File,
	Namespace,
	Struct,
	Template, // the arguments of an instance
	Block,
};

/** `using namespace A;` or `using A::B;`. */
struct FUsing
{
	const FDeclaration* Declaration = nullptr;
	uint32_t Order = 0;
	bool bResolved = false;
	FSymbol* Target = nullptr;
	FNameScope* Where = nullptr;
};

struct FNameScope
{
	EScopeKind Kind = EScopeKind::File;
	FNameScope* Parent = nullptr;
	std::string Prefix; // "N::S::"
	std::unordered_map<std::string_view, FSymbol> Symbols;
	FStructInfo* Struct = nullptr;
	uint32_t NumFields = 0; // of a struct, its own
	std::vector<FUsing> Usings;
	const FFunction* Function = nullptr; // of a block
};

/** A struct, or an instance of a template of structs. */
struct FStructInfo
{
	const FStruct* Tree = nullptr;
	FNameScope* Scope = nullptr; // its members
	std::string Name;
	uint32_t Order = 0;
	const FType* Type = nullptr; // once its members are known
	FStructInfo* Base = nullptr;
	bool bBusy = false;
	uint64_t NumLeaves = 0;
	uint32_t NumBits = 0; // of the last member that bit fields have taken; 0: it is an ordinary one
	FSymbol* Template = nullptr;
	std::vector<FTemplateValue> Arguments;
};

/** "<float, 2>". */
std::string NameTemplateArguments(const std::vector<FTemplateValue>& Values);

/** The known arguments of a template. */
struct FDeduction
{
	const FDeclaration* Template = nullptr;
	std::vector<std::optional<FTemplateValue>> Values;
	size_t NumGiven = 0; // those that are written, and not deduced
	std::string Why;     // there are no such arguments
};

} // namespace Drydock::Hlsl
