// Reads declarations.
#include "HlslParserImpl.h"

#include <algorithm>
#include <optional>
#include <string>

namespace Drydock::Hlsl
{

FTree Parse(const std::string& Text, const std::string& VirtualPath, std::vector<FDiagnostic>& Errors)
{
	FTree Tree;
	Tree.Text = std::make_shared<const std::string>(Text);
	const std::vector<FToken> Tokens = ReadTokens(*Tree.Text, VirtualPath, Tree.Files, Errors);
	try
	{
		if (Errors.size() < MaxErrors)
		{
			FParser(Tree, Tokens, Errors).ParseText();
		}
	}
	catch (const FParserStop&)
	{
	}
	return Tree;
}

void FParser::ParseText()
{
	while (!IsEnd())
	{
		const size_t Start = Pos;
		try
		{
			ParseDeclaration(Tree.Declarations, EWhere::File);
		}
		catch (const FParserFault&)
		{
			Recover(Start);
		}
	}
}

/** Declarations up to the `}` that closes Open, with it. */
void FParser::ParseDeclarationsUpTo(std::vector<FDeclaration*>& Out, EWhere Where, const FToken& Open)
{
	while (!Is("}") && !IsEnd())
	{
		const size_t Start = Pos;
		try
		{
			ParseDeclaration(Out, Where);
		}
		catch (const FParserFault&)
		{
			Recover(Start);
		}
	}
	Expect("}", "of the '{' in line " + std::to_string(Open.Place.Line));
}

/** One declaration with its `;` or body: each of its declarators goes to Out. */
void FParser::ParseDeclaration(std::vector<FDeclaration*>& Out, EWhere Where)
{
	const FLevel Level(*this);
	if (Take(";"))
	{
		return;
	}
	if (Where == EWhere::File && SkipTechnique())
	{
		return;
	}
	const size_t First = Out.size();
	std::vector<FAttribute> Attributes = ParseAttributes();
	if (!IsKeyword() || !ParseKeywordDeclaration(Out, Where))
	{
		ParseDeclarators(Out, Where);
	}
	if (Out.size() > First && !Attributes.empty())
	{
		Out[First]->Attributes = std::move(Attributes); // what has attributes is a function, one alone
	}
}

/** `technique T { pass P { ... } }` is what effects had; compilers of today pass over it. */
bool FParser::SkipTechnique()
{
	const std::string_view Word = At().Text;
	if ((Word != "technique" && Word != "technique10" && Word != "technique11") || !(Is("{", 1) || Is("{", 2)))
	{
		return false;
	}
	while (!Is("{"))
	{
		Next();
	}
	SkipBalanced();
	return true;
}

/** A declaration that a word of its own begins; false where it is a type, with nothing read. */
bool FParser::ParseKeywordDeclaration(std::vector<FDeclaration*>& Out, EWhere Where)
{
	if (Is("template"))
	{
		ParseTemplate(Out, Where);
	}
	else if (Is("typedef"))
	{
		ParseTypedef(Out);
	}
	else if (Is("using"))
	{
		ParseUsing(Out);
	}
	else if (Is("static_assert") || Is("_Static_assert"))
	{
		ParseAssert(Out);
	}
	else if (Where == EWhere::File && Is("namespace"))
	{
		ParseNamespace(Out);
	}
	else if (Where == EWhere::File && (Is("cbuffer") || Is("tbuffer")))
	{
		ParseBuffer(Out);
	}
	else if (Where == EWhere::Member && (Is("public") || Is("private") || Is("protected")) && Is(":", 1))
	{
		Next();
		Next();
	}
	else if (Is("struct") || Is("class"))
	{
		return ParseForwardStruct(Out);
	}
	else
	{
		RefuseKeyword(Where);
		return false;
	}
	return true;
}

/** Words that begin nothing in HLSL. */
void FParser::RefuseKeyword(EWhere Where)
{
	if (Is("enum") || Is("typename") || Is("unsigned") || Is("signed"))
	{
		return;
	}
	const std::string Word(At().Text);
	if (Word == "namespace" || Word == "cbuffer" || Word == "tbuffer")
	{
		Fail(At().Place,
			"X3000: syntax error: unexpected token '" + Word + "'; it stands outside of functions and structs");
	}
	if (Word == "interface" || Word == "union" || Word == "friend" || Word == "virtual" || Word == "auto" ||
		Word == "explicit" || Word == "mutable" || Word == "long" || Word == "short" || Word == "char")
	{
		Fail(At().Place,
			"X3000: syntax error: unexpected token '" + Word + "', which is reserved; " +
				(Word == "interface" ? "interfaces are not supported: write a template" : "HLSL has no " + Word));
	}
	Unexpected(Where == EWhere::Local ? "a statement" : "a declaration");
}

/** `struct S;` says that S is a type, and is nothing else. */
bool FParser::ParseForwardStruct(std::vector<FDeclaration*>& Out)
{
	if (!IsName(1) || !Is(";", 2))
	{
		return false;
	}
	Next();
	const bool bTemplate = std::exchange(bTemplateHead, false);
	if (!FindIn(GetScope(), At().Text).IsType())
	{
		Declare(At().Text, {bTemplate ? EName::TypeTemplate : EName::Type});
		if (!bTemplate)
		{
			FTypeName Type;
			Type.Struct = Tree.Make<FStruct>(At().Place); // without members, until it is defined
			Type.Struct->Name = At().Text;
			Type.Name.Parts.emplace_back().Text = At().Text;
			Type.Name.Parts.back().Place = At().Place;
			AddTypeDeclaration(Out, Type, 0);
		}
	}
	Next();
	Next();
	return true;
}

/** `namespace A::B { ... }` is a namespace in a namespace. */
void FParser::ParseNamespace(std::vector<FDeclaration*>& Out)
{
	const FLevel Level(*this);
	Next();
	if (!IsName())
	{
		Unexpected("the name of the namespace");
	}
	FDeclaration* Namespace = Tree.Make<FDeclaration>(At().Place);
	Namespace->Kind = EDeclaration::Namespace;
	FNamed Named = FindIn(GetScope(), At().Text);
	if (Named.Kind != EName::Namespace)
	{
		Named = {EName::Namespace, MakeScope()};
		Declare(At().Text, Named);
	}
	ParsePart(Namespace->Name);
	Out.push_back(Namespace);
	const FInside Inside(*this, Named.Scope);
	if (Is("::"))
	{
		ParseNamespace(Namespace->Members);
		return;
	}
	const FToken Open = At();
	Expect("{", "of the namespace");
	ParseDeclarationsUpTo(Namespace->Members, EWhere::File, Open);
}

/** `cbuffer B : register(b0) { ... }`: its members are names of the scope around it. */
void FParser::ParseBuffer(std::vector<FDeclaration*>& Out)
{
	const bool bTBuffer = Is("tbuffer");
	Next();
	if (!IsName())
	{
		Unexpected("the name of the buffer");
	}
	FDeclaration* Buffer = Tree.Make<FDeclaration>(At().Place);
	Buffer->Kind = EDeclaration::Buffer;
	Buffer->bTBuffer = bTBuffer;
	ParsePart(Buffer->Name);
	while (Take(":"))
	{
		ParseAnnotation(Buffer->Annotations);
	}
	Out.push_back(Buffer);
	const FToken Open = At();
	Expect("{", "of the buffer");
	ParseDeclarationsUpTo(Buffer->Members, EWhere::File, Open);
}

void FParser::ParseTemplate(std::vector<FDeclaration*>& Out, EWhere Where)
{
	const FPlace Place = Next().Place;
	FInside Inside(*this);
	Inside.Own.bTemplate = true;
	std::vector<FTemplateParameter> Parameters;
	ParseTemplateParameters(Parameters);
	if (Where == EWhere::Local)
	{
		Fail(Place, "X3000: syntax error: a template cannot be declared inside of a function");
	}
	const size_t First = Out.size();
	bTemplateHead = true;
	ParseDeclaration(Out, Where);
	bTemplateHead = false;
	for (size_t Index = First; Index < Out.size(); ++Index)
	{
		if (Out[Index]->Name.Parts.empty())
		{
			Fail(Place, "X3000: syntax error: a template needs a name, by which it is used");
		}
		Out[Index]->bTemplate = true;
		Out[Index]->Template = Parameters;
	}
}

/** `typedef float A, B[2];` */
void FParser::ParseTypedef(std::vector<FDeclaration*>& Out)
{
	Next();
	uint32_t Modifiers = 0;
	FTypeName* Type = ParseSpecifiers(Modifiers);
	const std::vector<FNamePart>& Parts = Type->Name.Parts;
	FNamed Target = {EName::Type};
	if (Parts.size() == 1 && Type->Enum == nullptr)
	{
		Target.Scope = FindDeclared(Parts[0].Text).Scope;
	}
	do
	{
		if (!IsName())
		{
			Unexpected("the name of the typedef");
		}
		FDeclaration* Typedef = Tree.Make<FDeclaration>(At().Place);
		Typedef->Kind = EDeclaration::Typedef;
		Typedef->Type = Type;
		Typedef->Modifiers = Modifiers;
		ParsePart(Typedef->Name);
		CheckModifiers(Modifiers, EDeclared::Typedef, Typedef->Place);
		ParseDimensions(Typedef->Dimensions);
		Declare(Typedef->Name.Last(), Target);
		Out.push_back(Typedef);
	} while (Take(","));
	Expect(";", "behind the typedef");
}

/** `using A = T;`, `using A::B;` and `using namespace A;`. */
void FParser::ParseUsing(std::vector<FDeclaration*>& Out)
{
	Next();
	const bool bTemplate = std::exchange(bTemplateHead, false);
	FDeclaration* Using = Tree.Make<FDeclaration>(At().Place);
	if (IsName() && Is("=", 1))
	{
		Using->Kind = EDeclaration::Typedef;
		ParsePart(Using->Name);
		Next();
		Using->Type = ParseTypeWithDimensions();
		Using->Modifiers = Using->Type->Modifiers & ~uint32_t(ModifierPacked);
		const std::vector<FNamePart>& Parts = Using->Type->Name.Parts;
		Declare(Using->Name.Last(), {bTemplate ? EName::TypeTemplate : EName::Type,
										Parts.size() == 1 ? FindDeclared(Parts[0].Text).Scope : nullptr});
	}
	else
	{
		Using->Kind = EDeclaration::Using;
		const bool bNamespace = Is("namespace");
		Using->Text = bNamespace ? Next().Text : std::string_view();
		const FNamed Named = ParseName(Using->Name);
		if (bNamespace && Named.Scope != nullptr)
		{
			GetScope().Usings.push_back(Named.Scope);
		}
		else if (!bNamespace && Named.Kind != EName::Unknown)
		{
			Declare(Using->Name.Last(), Named);
		}
	}
	Out.push_back(Using);
	Expect(";", "behind 'using'");
}

void FParser::ParseAssert(std::vector<FDeclaration*>& Out)
{
	FDeclaration* Assert = Tree.Make<FDeclaration>(Next().Place);
	Assert->Kind = EDeclaration::Assert;
	Expect("(", "behind 'static_assert'");
	Assert->Value = ParseAssignment();
	if (Take(","))
	{
		if (At().Kind != EToken::String)
		{
			Unexpected("the message of 'static_assert', a string");
		}
		Assert->Text = ParsePrimary()->Text;
	}
	Expect(")", "of 'static_assert'");
	Expect(";", "behind 'static_assert'");
	Out.push_back(Assert);
}

/** A struct or enum that is declared without a variable. */
void FParser::AddTypeDeclaration(std::vector<FDeclaration*>& Out, FTypeName& Type, uint32_t Modifiers)
{
	FDeclaration* Declaration = Tree.Make<FDeclaration>(Type.Struct != nullptr ? Type.Struct->Place : Type.Enum->Place);
	Declaration->Kind = Type.Struct != nullptr ? EDeclaration::Struct : EDeclaration::Enum;
	Declaration->Struct = Type.Struct;
	Declaration->Enum = Type.Enum;
	Declaration->Modifiers = Modifiers;
	Declaration->Name = Type.Name;
	Out.push_back(Declaration);
}

/** A type and what is declared with it. */
void FParser::ParseDeclarators(std::vector<FDeclaration*>& Out, EWhere Where)
{
	uint32_t Modifiers = 0;
	FTypeName* Type = ParseSpecifiers(Modifiers);
	const bool bTemplate = std::exchange(bTemplateHead, false);
	const bool bDefines = Type->Struct != nullptr || Type->Enum != nullptr;
	if (bDefines && !IsName() && !Is("operator"))
	{
		Expect(";", std::string("or a variable behind the ") + (Type->Struct != nullptr ? "struct" : "enum"));
		AddTypeDeclaration(Out, *Type, Modifiers);
		return;
	}
	do
	{
		FDeclaration* Declaration = ParseDeclarator(Type, Modifiers, Where, bTemplate);
		Out.push_back(Declaration);
		if (Declaration->Body != nullptr)
		{
			return;
		}
	} while (!bTemplate && Take(","));
	const bool bFunction = Out.back()->Kind == EDeclaration::Function;
	Expect(";", bFunction ? "or the body of the function"
						  : "behind the declaration of '" + std::string(Out.back()->Name.Last()) + "'");
}

} // namespace Drydock::Hlsl
