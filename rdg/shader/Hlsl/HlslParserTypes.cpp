// Reads names, types, structs, enumerations and the parameters of templates.
#include "HlslParserImpl.h"

#include <algorithm>
#include <string>

namespace Drydock::Hlsl
{

namespace
{

/** Modifiers that are a type's as well as its declaration's. */
constexpr uint32_t ParserTypeModifiers = ModifierConst | ModifierVolatile | ModifierPrecise | ModifierRowMajor |
										 ModifierColumnMajor | ModifierUnorm | ModifierSnorm;

} // namespace

/** One word of a name. */
void FParser::ParsePart(FName& Name)
{
	FNamePart& Part = Name.Parts.emplace_back();
	Part.Place = At().Place;
	Part.Text = Next().Text;
}

/** `A::B<C>::D`, with the arguments of templates. The words of types are names, too. */
FNamed FParser::ParseName(FName& Name)
{
	const FScope* Inside = nullptr;
	bool bInside = Take("::");
	if (bInside)
	{
		Name.bGlobal = true;
		Inside = Scopes[0];
	}
	for (;;)
	{
		const EWord Kind = WordAt(Pos).Kind;
		if (!IsWord() || Kind == EWord::Keyword || Kind == EWord::Modifier)
		{
			Unexpected("a name");
		}
		const FNamed Named = !bInside ? Find(Pos) : Inside != nullptr ? FindIn(*Inside, At().Text) : FNamed{};
		ParsePart(Name);
		if (TakesArguments(Named, Pos))
		{
			ParseTemplateArguments(Name);
		}
		if (!Take("::"))
		{
			return Named;
		}
		Inside = Named.Scope;
		bInside = true;
	}
}

/** `<A, 2>` of the last word of the name. */
void FParser::ParseTemplateArguments(FName& Name)
{
	const FLevel Level(*this);
	const FAngles Angles(*this, true);
	Expect("<");
	std::vector<FTemplateArgument> Arguments;
	if (!Is(">"))
	{
		do
		{
			Arguments.push_back(ParseTemplateArgument(Name));
		} while (Take(","));
	}
	const bool bDouble = Is(">") && At().bTouches && Pos > 0 && Tokens[Pos - 1].Is(">");
	if (bDouble)
	{
		Fail(At().Place, "X3000: a space is required between consecutive right angle brackets (use '> >')");
	}
	Expect(">", "behind the template's arguments");
	Name.Parts.back().bArguments = true;
	Name.Parts.back().Arguments = std::move(Arguments);
}

FTemplateArgument FParser::ParseTemplateArgument(FName& Name)
{
	FTemplateArgument Argument;
	if (IsTypeAt(Pos))
	{
		Argument.Type = ParseTypeWithDimensions();
		Name.Height = std::max(Name.Height, Argument.Type->Name.Height);
	}
	else
	{
		Argument.Value = ParseConditional();
		Name.Height = std::max(Name.Height, Argument.Value->Height);
	}
	return Argument;
}

/** Whether a modifier stands here. `sample` is one in front of another word, unless it is the name of a type. */
bool FParser::IsModifier() const
{
	const EWord Kind = WordAt(Pos).Kind;
	return Kind == EWord::Modifier || (Kind == EWord::SoftModifier && IsWord(1) && !FindDeclared(At().Text).IsType());
}

/** Whether a type stands there and not a value: a call of its constructor is one. */
bool FParser::IsTypeAt(size_t Where, bool bGuess) const
{
	const FToken& Token = Tokens[Where];
	const EWord Kind = WordAt(Where).Kind;
	if (Kind == EWord::Keyword)
	{
		return Token.Is("struct") || Token.Is("typename") || Token.Is("unsigned") || Token.Is("signed");
	}
	size_t End = 0;
	return Kind == EWord::Modifier || (LookAtName(Where, End, bGuess).IsType() && !Tokens[End].Is("("));
}

/** Whether a declaration begins here and not an expression. Two names in a row are one, be the first a type or not. */
bool FParser::IsDeclaration() const
{
	if (IsKeyword())
	{
		return !Is("this") && !Is("true") && !Is("false") && !Is("sizeof") && !Is("operator");
	}
	if (IsModifier())
	{
		return true;
	}
	size_t End = 0;
	const FNamed Named = LookAtName(Pos, End);
	if (Named.IsType())
	{
		return !Tokens[End].Is("(") && !Tokens[End].Is(".");
	}
	const EWord Behind = WordAt(End).Kind;
	return End > Pos && Tokens[End].Kind == EToken::Word && Behind != EWord::Keyword;
}

/** A type with the modifiers before and behind it. */
FTypeName* FParser::ParseSpecifiers(uint32_t& Modifiers)
{
	Modifiers = 0;
	while (IsModifier())
	{
		Modifiers |= WordAt(Pos).Modifiers;
		Next();
	}
	FTypeName* Type = ParseType();
	while (WordAt(Pos).Kind == EWord::Modifier)
	{
		Modifiers |= WordAt(Pos).Modifiers;
		Next();
	}
	if ((Modifiers & (ModifierRowMajor | ModifierColumnMajor)) != 0)
	{
		Type->Modifiers = 0; // its own order, not that of a #pragma
	}
	Type->Modifiers |= Modifiers & ParserTypeModifiers;
	if (Is("*") || Is("&"))
	{
		Fail(At().Place, "X3000: syntax error: unexpected token '" + std::string(At().Text) +
							 "'; HLSL has no pointers and references: write inout for an argument that is changed");
	}
	return Type;
}

FTypeName* FParser::ParseType()
{
	const FLevel Level(*this);
	while (Take("typename"))
	{
	}
	FTypeName* Type = Tree.Make<FTypeName>(At().Place);
	if (Is("struct") || Is("class"))
	{
		ParseStruct(*Type);
	}
	else if (Is("enum"))
	{
		ParseEnum(*Type);
	}
	else if (Is("unsigned") || Is("signed"))
	{
		const std::string_view Text = Is("unsigned") ? "uint" : "int";
		ParsePart(Type->Name);
		Type->Name.Parts[0].Text = Text;
		if (IsWord() && (At().Text.starts_with("int") || Is("dword")) && IsTypeAt(Pos)) // unsigned int3
		{
			const bool bInt = !Is("dword");
			const std::string_view Rest = Next().Text.substr(bInt ? 3 : 5);
			if (!Rest.empty())
			{
				Type->Name.Parts[0].Text = Tree.Keep(std::string(Text) + std::string(Rest));
			}
		}
	}
	else
	{
		const EWord Kind = WordAt(Pos).Kind;
		if (!Is("::") && (!IsWord() || Kind == EWord::Keyword || Kind == EWord::Modifier))
		{
			Unexpected("a type");
		}
		const bool bOrder = Kind == EWord::Matrix;
		const FNamed Named = ParseName(Type->Name);
		if (Is("<") && Named.Kind == EName::Unknown)
		{
			Fail(Type->Place, "X3000: unrecognized identifier '" + std::string(Type->Name.Last()) +
								  "'; no template of this name is declared before it");
		}
		Type->Modifiers = bOrder && Pack != 0 ? ModifierPacked | Pack : 0;
	}
	return Type;
}

/** A type alone, as in a cast: `const float[3]`. */
FTypeName* FParser::ParseTypeWithDimensions()
{
	uint32_t Modifiers = 0;
	FTypeName* Type = ParseSpecifiers(Modifiers);
	ParseDimensions(Type->Dimensions, &Type->Name.Height);
	return Type;
}

void FParser::ParseDimensions(std::vector<FExpression*>& Dimensions, uint32_t* Height)
{
	while (Take("["))
	{
		const FAngles Angles(*this, false);
		FExpression* Size = Is("]") ? nullptr : ParseConditional();
		Expect("]", "behind the number of elements");
		Dimensions.push_back(Size);
		if (Size != nullptr && Height != nullptr)
		{
			*Height = std::max(*Height, Size->Height);
		}
	}
}

/** `struct S : B { ... }`, or `struct S` as a name for one that was declared. */
void FParser::ParseStruct(FTypeName& Type)
{
	const bool bTemplate = std::exchange(bTemplateHead, false);
	const FToken Keyword = Next();
	FPlace Place = Keyword.Place;
	if (IsName())
	{
		Place = At().Place;
		const FNamed Known = Find(Pos);
		ParsePart(Type.Name);
		if (Is("<") && Known.IsTemplate())
		{
			ParseTemplateArguments(Type.Name);
		}
	}
	if (!Is("{") && !Is(":"))
	{
		if (Type.Name.Parts.empty())
		{
			Unexpected("the name of the " + std::string(Keyword.Text) + " or '{'");
		}
		return;
	}
	FStruct& Struct = *Tree.Make<FStruct>(Place);
	Type.Struct = &Struct;
	Struct.bClass = Keyword.Text == "class";
	FScope& Scope = *MakeScope();
	if (Take(":"))
	{
		ParseBases(Struct, Scope);
	}
	if (!Type.Name.Parts.empty())
	{
		Struct.Name = Type.Name.Last();
		if (!Type.Name.Parts[0].bArguments)
		{
			Declare(Struct.Name, {bTemplate ? EName::TypeTemplate : EName::Type, &Scope});
		}
	}
	const FToken Open = At();
	Expect("{", "of the struct");
	const FInside Inside(*this, &Scope);
	ParseDeclarationsUpTo(Struct.Members, EWhere::Member, Open);
}

void FParser::ParseBases(FStruct& Struct, FScope& Scope)
{
	do
	{
		(void)(Take("public") || Take("private") || Take("protected"));
		FTypeName* Base = Tree.Make<FTypeName>(At().Place);
		const FNamed Named = ParseName(Base->Name);
		Struct.Bases.push_back(Base);
		if (Scope.Base == nullptr && Named.Scope != nullptr)
		{
			Scope.Base = Named.Scope->Names.empty() ? Named.Scope->Base : Named.Scope;
		}
	} while (Take(","));
}

/** `enum class E : uint { A = 1, B }`. */
void FParser::ParseEnum(FTypeName& Type)
{
	FPlace Place = Next().Place;
	const bool bScoped = Take("class") || Take("struct");
	if (IsName())
	{
		Place = At().Place;
		ParsePart(Type.Name);
	}
	if (!Is("{") && !Is(":"))
	{
		if (Type.Name.Parts.empty())
		{
			Unexpected("the name of the enum or '{'");
		}
		return;
	}
	FEnum& Enum = *Tree.Make<FEnum>(Place);
	Type.Enum = &Enum;
	Enum.bScoped = bScoped;
	if (!Type.Name.Parts.empty())
	{
		Enum.Name = Type.Name.Last();
		Declare(Enum.Name, {EName::Type});
	}
	if (Take(":"))
	{
		Enum.Base = ParseType();
	}
	const FToken Open = At();
	Expect("{", "of the enum");
	while (!Is("}"))
	{
		if (!IsName())
		{
			Unexpected("a name of the enum or '}'");
		}
		FEnumerator Enumerator;
		Enumerator.Place = At().Place;
		Enumerator.Name = Next().Text;
		Enumerator.Value = Take("=") ? ParseConditional() : nullptr;
		if (!bScoped)
		{
			DeclareOther(Enumerator.Name);
		}
		Enum.Enumerators.push_back(Enumerator);
		if (!Take(","))
		{
			break;
		}
	}
	Expect("}", "of the '{' in line " + std::to_string(Open.Place.Line));
}

/** `<typename T = float, int N = 3>`. */
void FParser::ParseTemplateParameters(std::vector<FTemplateParameter>& Parameters)
{
	const FAngles Angles(*this, true);
	Expect("<", "of the template's parameters");
	while (!Is(">"))
	{
		FTemplateParameter Parameter;
		const bool bType = Take("typename") || Take("class");
		Parameter.ValueType = bType ? nullptr : ParseTypeWithDimensions();
		Parameter.Place = At().Place;
		if (IsName())
		{
			Parameter.Name = Next().Text;
			Scopes.back()->Names[Parameter.Name] = {bType ? EName::Type : EName::Other};
		}
		if (Take("="))
		{
			FName Heights;
			Parameter.Default = ParseTemplateArgument(Heights);
		}
		Parameters.push_back(Parameter);
		if (!Take(","))
		{
			break;
		}
	}
	Expect(">", "behind the template's parameters");
}

} // namespace Drydock::Hlsl
