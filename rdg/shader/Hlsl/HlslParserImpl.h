// The parser's inside, which its four files share: its tokens, its scopes of names, and what reads each construct.
#pragma once

#include "HlslParser.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace Drydock::Hlsl
{

/** The kind of a word. */
enum class EWord : uint8_t
{
	Name,         // of the text's own
	Keyword,      // if, struct, ...: never a name
	Modifier,     // static, const, ...: never a name
	SoftModifier, // sample, point, ...: a modifier in front of another word, else a name
	Numeric,      // a type: float3, void
	Matrix,       // a type with an order: float3x2, matrix
	Object,       // a type whose word may name something else, too: Texture2D, sampler
};

struct FWord
{
	EWord Kind = EWord::Name;
	uint32_t Modifiers = 0;
};

const FWord& FindWord(std::string_view Text);

enum class EName : uint8_t
{
	Unknown,
	Other, // a variable, a function: known where it hides a type
	Type,
	TypeTemplate,
	FunctionTemplate,
	Namespace,
};

struct FScope;

/** The thing that a name stands for, and the names in it. */
struct FNamed
{
	EName Kind = EName::Unknown;
	FScope* Scope = nullptr;

	bool IsType() const { return Kind == EName::Type || Kind == EName::TypeTemplate; }
	bool IsTemplate() const { return Kind == EName::TypeTemplate || Kind == EName::FunctionTemplate; }
};

struct FScope
{
	std::unordered_map<std::string_view, FNamed> Names;
	FScope* Base = nullptr; // of a struct
	std::vector<FScope*> Usings;
	bool bTemplate = false; // of template parameters: what the declaration declares goes outside
};

/** Thrown where a fault was reported; caught where statements and declarations begin. */
struct FParserFault
{
};

/** Thrown where there are too many. */
struct FParserStop
{
};

/** The place of a declaration. */
enum class EWhere : uint8_t
{
	File, // also a namespace, a cbuffer
	Member,
	Local,
	Parameter,
};

/** The kind of a declaration. */
enum class EDeclared : uint8_t
{
	Global,
	Field,
	Local,
	Function,
	Method,
	Typedef,
	Parameter,
};

class FParser
{
public:
	FParser(FTree& InTree, const std::vector<FToken>& AllTokens, std::vector<FDiagnostic>& InErrors);

	void ParseText();

private:
	/** One level of nesting. */
	struct FLevel
	{
		explicit FLevel(FParser& InParser);
		~FLevel() { --Parser.Depth; }
		FLevel(const FLevel&) = delete;

		FParser& Parser;
	};

	/** A scope as long as this lives: its own or another. */
	struct FInside
	{
		explicit FInside(FParser& InParser, FScope* Other = nullptr)
			: Parser(InParser)
		{
			Parser.Scopes.push_back(Other != nullptr ? Other : &Own);
		}
		~FInside() { Parser.Scopes.pop_back(); }
		FInside(const FInside&) = delete;

		FParser& Parser;
		FScope Own;
	};

	/** Whether `>` closes, as long as this lives. */
	struct FAngles
	{
		FAngles(FParser& InParser, bool bIn)
			: Parser(InParser)
			, bBefore(std::exchange(InParser.bInAngles, bIn))
		{
		}
		~FAngles() { Parser.bInAngles = bBefore; }
		FAngles(const FAngles&) = delete;

		FParser& Parser;
		const bool bBefore;
	};

	// HlslParser.cpp: tokens, faults and names.
	const FToken& At(size_t Offset = 0) const { return Tokens[std::min(Pos + Offset, Tokens.size() - 1)]; }
	const FWord& WordAt(size_t Where) const { return *Words[std::min(Where, Words.size() - 1)]; }
	bool Is(std::string_view Text, size_t Offset = 0) const { return At(Offset).Is(Text); }
	bool IsWord(size_t Offset = 0) const { return At(Offset).Kind == EToken::Word; }
	bool IsKeyword(size_t Offset = 0) const { return IsWord(Offset) && WordAt(Pos + Offset).Kind == EWord::Keyword; }
	bool IsEnd() const { return At().Kind == EToken::End; }
	bool IsName(size_t Offset = 0) const;
	FToken Next();
	bool Take(std::string_view Text);
	void Expect(std::string_view Text, const std::string& Behind = {});
	[[noreturn]] void Unexpected(const std::string& Expected);
	[[noreturn]] void Fail(const FPlace& Place, const std::string& Message);
	void SkipBalanced();
	void Recover(size_t Start);
	void RecoverBehind(size_t Open);
	FNamed FindIn(const FScope& Scope, std::string_view Name) const;
	FNamed FindDeclared(std::string_view Name) const;
	FNamed Find(size_t Where) const;
	FScope& GetScope();
	FScope* MakeScope();
	void Declare(std::string_view Name, FNamed Named);
	void DeclareOther(std::string_view Name);
	size_t FindAngleEnd(size_t Where) const;
	bool TakesArguments(const FNamed& Named, size_t Where, bool bGuess = true) const;
	FNamed LookAtName(size_t Where, size_t& End, bool bGuess = true) const;

	// HlslParserTypes.cpp: names, types, structs, enumerations, templates.
	FNamed ParseName(FName& Name);
	void ParsePart(FName& Name);
	void ParseTemplateArguments(FName& Name);
	FTemplateArgument ParseTemplateArgument(FName& Name);
	bool IsModifier() const;
	bool IsTypeAt(size_t Where, bool bGuess = true) const;
	bool IsDeclaration() const;
	FTypeName* ParseSpecifiers(uint32_t& Modifiers);
	FTypeName* ParseType();
	FTypeName* ParseTypeWithDimensions();
	void ParseDimensions(std::vector<FExpression*>& Dimensions, uint32_t* Height = nullptr);
	void ParseStruct(FTypeName& Type);
	void ParseBases(FStruct& Struct, FScope& Scope);
	void ParseEnum(FTypeName& Type);
	void ParseTemplateParameters(std::vector<FTemplateParameter>& Parameters);

	// HlslParserModifiers.cpp
	void CheckModifiers(uint32_t Modifiers, EDeclared Declared, const FPlace& Place);

	// HlslParserExpressions.cpp
	FExpression* ParseExpression();
	FExpression* ParseAssignment();
	FExpression* ParseConditional();
	FExpression* ParseBinary(int Least);
	FExpression* ParseUnary();
	FExpression* ParsePostfix();
	FExpression* ParsePrimary();
	FExpression* ParseParenthesized();
	FExpression* ParseNameOrConstruct();
	FExpression* ParseSizeOf();
	FExpression* ParseMember(FExpression* Object);
	FExpression* ParseList();
	FExpression* ParseInitializer();
	void ParseArguments(FExpression& Call);
	std::string_view TakeOperator(int Least);
	FExpression* Make(EExpression Kind, const FPlace& Place);
	FExpression* Make(EExpression Kind, const FToken& Token);
	void AddOperand(FExpression& Parent, FExpression* Operand);
	void Raise(FExpression& Parent, uint32_t Height);

	// HlslParserStatements.cpp
	FStatement* ParseStatement(bool bInSwitch = false);
	bool ParseKeywordStatement(FStatement& Statement, bool bInSwitch);
	void ParseDo(FStatement& Statement);
	void ParseForHeader(FStatement& Statement);
	FStatement* ParseSimple();
	FStatement* ParseBlock(bool bSwitch = false);
	FStatement* ParseSubstatement();
	void ParseIf(FStatement& Statement);
	void ParseFor(FStatement& Statement);
	void ParseSwitch(FStatement& Statement);
	void ParseLabel(FStatement& Statement, bool bInSwitch);
	FExpression* ParseCondition(const char* Of);
	std::vector<FAttribute> ParseAttributes();
	void ParseAttribute(std::vector<FAttribute>& Attributes);

	// HlslParserDeclarations.cpp
	void ParseDeclaration(std::vector<FDeclaration*>& Out, EWhere Where);
	void ParseDeclarationsUpTo(std::vector<FDeclaration*>& Out, EWhere Where, const FToken& Open);
	bool SkipTechnique();
	bool ParseKeywordDeclaration(std::vector<FDeclaration*>& Out, EWhere Where);
	void RefuseKeyword(EWhere Where);
	void ParseNamespace(std::vector<FDeclaration*>& Out);
	void ParseBuffer(std::vector<FDeclaration*>& Out);
	void ParseTemplate(std::vector<FDeclaration*>& Out, EWhere Where);
	void ParseTypedef(std::vector<FDeclaration*>& Out);
	void ParseUsing(std::vector<FDeclaration*>& Out);
	void ParseAssert(std::vector<FDeclaration*>& Out);
	void ParseDeclarators(std::vector<FDeclaration*>& Out, EWhere Where);
	void AddTypeDeclaration(std::vector<FDeclaration*>& Out, FTypeName& Type, uint32_t Modifiers);
	bool ParseForwardStruct(std::vector<FDeclaration*>& Out);
	FDeclaration* ParseDeclarator(FTypeName* Type, uint32_t Modifiers, EWhere Where, bool bTemplate = false);
	FScope* ParseDeclaredName(FDeclaration& Declaration, bool bTemplate);
	bool IsParameterList() const;
	void ParseOperator(FDeclaration& Declaration);
	void ParseFunction(FDeclaration& Function, EWhere Where, FScope* Owner);
	void ParseParameters(FDeclaration& Function);
	FDeclaration* ParseParameter();
	void ParseVariable(FDeclaration& Variable, EWhere Where);
	bool IsStateBlock(const FDeclaration& Variable) const;
	void ParseAnnotation(std::vector<FAnnotation>& Annotations);
	void SkipAnnotations();
	void SkipState();

	FTree& Tree;
	std::vector<FToken> Tokens;                     // without #pragma
	std::vector<const FWord*> Words;                // of each token
	std::vector<std::pair<size_t, uint32_t>> Packs; // from that token on, this order
	std::vector<FDiagnostic>& Errors;
	std::deque<FScope> OwnScopes; // of namespaces and structs
	std::vector<FScope*> Scopes;  // the innermost last
	size_t Pos = 0;
	size_t NextPack = 0;
	uint32_t Pack = 0;
	size_t LastFault = size_t(-1);
	int Depth = 0;
	bool bNumberNames = false; // a variable has the name of a type of numbers
	bool bInAngles = false;
	bool bTemplateHead = false; // the next name that is declared is a template's
};

} // namespace Drydock::Hlsl
