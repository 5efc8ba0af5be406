// Reads what stands behind the type of a declaration: variables, functions and their parameters.
#include "HlslParserImpl.h"

#include <algorithm>
#include <optional>
#include <string>

namespace Drydock::Hlsl
{

FDeclaration* FParser::ParseDeclarator(FTypeName* Type, uint32_t Modifiers, EWhere Where, bool bTemplate)
{
	FDeclaration* Declaration = Tree.Make<FDeclaration>(At().Place);
	Declaration->Type = Type;
	Declaration->Modifiers = Modifiers;
	const bool bGap = Where == EWhere::Member && Is(":"); // bits without a name
	FScope* Owner = bGap ? nullptr : ParseDeclaredName(*Declaration, bTemplate);
	if (bGap)
	{
		Declaration->Name.Parts.emplace_back().Place = At().Place;
	}
	const bool bFunction = Is("(");
	const FNamePart& Part = Declaration->Name.Parts.back();
	if (!bGap && Declaration->Name.Parts.size() == 1 && !Part.bArguments && Declaration->Operator.empty())
	{
		if (bFunction && bTemplate)
		{
			Declare(Part.Text, {EName::FunctionTemplate});
		}
		else
		{
			DeclareOther(Part.Text);
		}
	}
	const EDeclared Declared = bFunction ? (Where == EWhere::Member ? EDeclared::Method : EDeclared::Function)
							   : Where == EWhere::File || (Where == EWhere::Member && Modifiers & ModifierStatic)
								   ? EDeclared::Global
							   : Where == EWhere::Member ? EDeclared::Field
														 : EDeclared::Local;
	CheckModifiers(Modifiers, Declared, Declaration->Place);
	if (bFunction)
	{
		ParseFunction(*Declaration, Where, Owner);
	}
	else
	{
		ParseVariable(*Declaration, Where);
	}
	return Declaration;
}

/** The name that is declared, also `S::F`, `F<int>` and `operator+`. Returns the names of what stands before the last
 * ::. */
FScope* FParser::ParseDeclaredName(FDeclaration& Declaration, bool bTemplate)
{
	FName& Name = Declaration.Name;
	FScope* Owner = nullptr;
	bool bOwner = false;
	for (;;)
	{
		Declaration.Place = At().Place;
		if (Is("operator"))
		{
			ParseOperator(Declaration);
			return Owner;
		}
		constexpr std::string_view Behind = ";=,:[)";
		const bool bNumber =
			IsNumberName(At().Text) && Pos + 1 < Tokens.size() && Behind.find(Tokens[Pos + 1].Text) != Behind.npos;
		if (!IsName() && !bNumber)
		{
			Unexpected("a name to declare");
		}
		bNumberNames = bNumberNames || bNumber;
		const FNamed Named = !bOwner            ? FindDeclared(At().Text)
							 : Owner != nullptr ? FindIn(*Owner, At().Text)
												: FNamed{};
		ParsePart(Name);
		if (Is("<") && (Named.IsTemplate() || bTemplate))
		{
			ParseTemplateArguments(Name);
		}
		if (!Take("::"))
		{
			return Owner;
		}
		Owner = Named.Scope;
		bOwner = true;
	}
}

void FParser::ParseOperator(FDeclaration& Declaration)
{
	ParsePart(Declaration.Name);
	if ((Is("(") && Is(")", 1)) || (Is("[") && Is("]", 1)))
	{
		Declaration.Operator = Is("(") ? "()" : "[]";
		Next();
		Next();
		return;
	}
	const FAngles Angles(*this, false);
	Declaration.Operator = TakeOperator(1);
	if (Declaration.Operator.empty())
	{
		Declaration.Operator = TakeOperator(0);
	}
	if (Declaration.Operator.empty())
	{
		if (!Is("!") && !Is("~") && !Is("++") && !Is("--") && !Is(","))
		{
			Unexpected("an operator such as '+' or '[]' behind 'operator'");
		}
		Declaration.Operator = Next().Text;
	}
	static constexpr std::string_view Refused[] = {
		"=", "+=", "-=", "*=", "/=", "%=", "^=", "&=", "|=", "<<", ">>", "<<=", ">>=", "++", "--"};
	if (std::ranges::find(Refused, Declaration.Operator) != std::end(Refused))
	{
		Fail(Declaration.Place, "X3000: overloading 'operator" + std::string(Declaration.Operator) +
									"' is not allowed; write a method with a name");
	}
}

/** Whether what stands in these parentheses can be parameters: not so in `float4 X(1, 2, 3, 4)`. */
bool FParser::IsParameterList() const
{
	const FToken& First = At(1);
	if (First.Kind == EToken::Word)
	{
		return !Is("this", 1) && !Is("true", 1) && !Is("false", 1);
	}
	return First.Kind == EToken::End || First.Is(")") || First.Is("[") || First.Is("::") || First.Is("...");
}

/** From its `(` on. */
void FParser::ParseFunction(FDeclaration& Function, EWhere Where, FScope* Owner)
{
	Function.Kind = EDeclaration::Function;
	if (!IsParameterList())
	{
		Fail(At(1).Place, "X3000: syntax error: unexpected token '" + std::string(At(1).Text.substr(0, 40)) +
							  "'; expected a parameter's type; a variable's value stands behind '=': T " +
							  std::string(Function.Name.Last()) + " = T(...)");
	}
	std::optional<FInside> InOwner;
	if (Owner != nullptr)
	{
		InOwner.emplace(*this, Owner);
	}
	const FInside Inside(*this);
	ParseParameters(Function);
	Function.bConstMethod = Take("const");
	while (Take(":"))
	{
		ParseAnnotation(Function.Annotations);
	}
	if (!Is("{"))
	{
		return;
	}
	if (Where == EWhere::Local)
	{
		Fail(
			At().Place, "X3000: syntax error: unexpected token '{'; a function cannot be defined inside of a function");
	}
	Function.Body = ParseBlock();
}

void FParser::ParseParameters(FDeclaration& Function)
{
	const FAngles Angles(*this, false);
	bool bDefault = false;
	Expect("(");
	if (Is("void") && Is(")", 1))
	{
		Next();
	}
	if (!Is(")"))
	{
		do
		{
			Function.Parameters.push_back(ParseParameter());
			const FDeclaration& Last = *Function.Parameters.back();
			if (bDefault && Last.Value == nullptr)
			{
				Fail(Last.Place, "X3000: the parameter '" + std::string(Last.Name.Last()) +
									 "' needs a default value: one before it has one");
			}
			bDefault = Last.Value != nullptr;
		} while (Take(","));
	}
	Expect(")", "or ',' behind the parameter");
}

FDeclaration* FParser::ParseParameter()
{
	const FLevel Level(*this);
	std::vector<FAttribute> Attributes = ParseAttributes();
	FDeclaration* Parameter = Tree.Make<FDeclaration>(At().Place);
	Parameter->Attributes = std::move(Attributes);
	Parameter->Type = ParseSpecifiers(Parameter->Modifiers);
	if (IsName())
	{
		Parameter->Place = At().Place;
		ParsePart(Parameter->Name);
		DeclareOther(Parameter->Name.Last());
	}
	else
	{
		Parameter->Name.Parts.emplace_back().Place = At().Place;
	}
	CheckModifiers(Parameter->Modifiers, EDeclared::Parameter, Parameter->Place);
	ParseVariable(*Parameter, EWhere::Parameter);
	return Parameter;
}

/** Reads the text behind the name of a variable, a member or a parameter. */
void FParser::ParseVariable(FDeclaration& Variable, EWhere Where)
{
	ParseDimensions(Variable.Dimensions);
	for (;;)
	{
		if (Is(":"))
		{
			Next();
			if (Where == EWhere::Member && (At().Kind == EToken::Number || Is("(")))
			{
				Variable.Width = ParseConditional();
			}
			else
			{
				ParseAnnotation(Variable.Annotations);
			}
		}
		else if (Is("<") && Where != EWhere::Local && Where != EWhere::Parameter)
		{
			SkipAnnotations();
		}
		else if (Variable.Value == nullptr && Is("=") && Is("sampler_state", 1))
		{
			Next();
			Next();
			SkipState();
		}
		else if (Variable.Value == nullptr && Take("="))
		{
			Variable.Value = ParseInitializer();
		}
		else if (Variable.Value == nullptr && Is("{") && IsStateBlock(Variable))
		{
			SkipState();
		}
		else if (Variable.Value == nullptr && Is("{") && Where != EWhere::Parameter)
		{
			Variable.bConstructed = true;
			Variable.Value = ParseList();
		}
		else
		{
			return;
		}
	}
}

/** Objects have no values: what stands in braces behind one is its state. */
bool FParser::IsStateBlock(const FDeclaration& Variable) const
{
	const FName& Name = Variable.Type->Name;
	return Name.Parts.size() == 1 && FindWord(Name.Last()).Kind == EWord::Object;
}

/** `{ Filter = ...; }`: the engine sets these. */
void FParser::SkipState()
{
	if (!Is("{"))
	{
		Unexpected("'{' of the state");
	}
	SkipBalanced();
	if (!Tokens[Pos - 1].Is("}"))
	{
		Unexpected("'}' of the state");
	}
}

/** Behind the `:`: `SV_Target0`, `register(t0, space1)`. */
void FParser::ParseAnnotation(std::vector<FAnnotation>& Annotations)
{
	if (!IsWord())
	{
		Unexpected("a semantic, 'register(...)' or 'packoffset(...)' behind ':'");
	}
	FAnnotation Annotation;
	Annotation.Place = At().Place;
	Annotation.Name = Next().Text;
	if (Take("("))
	{
		size_t First = Pos;
		while (!Is(")"))
		{
			if (IsEnd() || Is(";") || Is("{") || Is("}"))
			{
				Unexpected("')' behind '" + std::string(Annotation.Name.substr(0, 40)) + "(...'");
			}
			Next();
			if ((Is(",") || Is(")")) && Pos > First) // c0.x is one
			{
				const std::string_view From = Tokens[First].Text;
				const std::string_view To = Tokens[Pos - 1].Text;
				Annotation.Arguments.emplace_back(From.data(), size_t(To.data() + To.size() - From.data()));
				First = Pos + 1;
			}
		}
		Next();
	}
	Annotations.push_back(std::move(Annotation));
}

/** `< string Name = "x"; >` behind a variable, which the editors of effects read. */
void FParser::SkipAnnotations()
{
	const FPlace Place = At().Place;
	while (!Is(">"))
	{
		if (IsEnd() || Is("{") || Is("}"))
		{
			Unexpected("'>' of the annotations that begin in line " + std::to_string(Place.Line));
		}
		Next();
	}
	Next();
}

} // namespace Drydock::Hlsl
