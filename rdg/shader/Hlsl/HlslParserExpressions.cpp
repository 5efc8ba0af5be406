// Reads expressions.
#include "HlslParserImpl.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace Drydock::Hlsl
{

namespace
{

/** Binary operators, and how strong they bind. */
constexpr std::pair<std::string_view, int> ParserBinaries[] = {{"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4}, {"&", 5},
	{"==", 6}, {"!=", 6}, {"<", 7}, {">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9}, {"*", 10},
	{"/", 10}, {"%", 10}};

int GetParserStrength(std::string_view Text)
{
	const auto Found = std::find_if(
		std::begin(ParserBinaries), std::end(ParserBinaries), [&](const auto& Each) { return Each.first == Text; });
	return Found == std::end(ParserBinaries) ? 0 : Found->second;
}

bool IsParserAssignment(std::string_view Text)
{
	return Text == "=" || Text == "<<=" || Text == ">>=" ||
		   (Text.size() == 2 && Text[1] == '=' && std::string_view("+-*/%&|^").find(Text[0]) != std::string_view::npos);
}

/** The operator that begins there: `>` `>` `=` that touch are one. */
std::string_view JoinParserOperator(const FToken* Token)
{
	std::string_view Text = Token[0].Text;
	if (Text == ">" && Token[1].bTouches && (Token[1].Is(">") || Token[1].Is("=")))
	{
		const bool bThree = Token[1].Is(">") && Token[2].bTouches && Token[2].Is("=");
		Text = {Text.data(), bThree ? 3u : 2u}; // they stand in one text
	}
	return Text;
}

} // namespace

FExpression* FParser::Make(EExpression Kind, const FPlace& Place)
{
	FExpression* Expression = Tree.Make<FExpression>(Place);
	Expression->Kind = Kind;
	return Expression;
}

FExpression* FParser::Make(EExpression Kind, const FToken& Token)
{
	FExpression* Expression = Make(Kind, Token.Place);
	Expression->Text = Token.Text;
	return Expression;
}

void FParser::Raise(FExpression& Parent, uint32_t Height)
{
	Parent.Height = std::max(Parent.Height, Height + 1);
	if (Parent.Height > MaxHeight)
	{
		Fail(Parent.Place, "the expression has more than " + std::to_string(MaxHeight) +
							   " operators in a row; write it as several statements");
	}
}

void FParser::AddOperand(FExpression& Parent, FExpression* Operand)
{
	Parent.Operands.push_back(Operand);
	Raise(Parent, Operand->Height);
}

/** With commas. */
FExpression* FParser::ParseExpression()
{
	FExpression* Left = ParseAssignment();
	while (Is(","))
	{
		FExpression* Comma = Make(EExpression::Comma, Next());
		AddOperand(*Comma, Left);
		AddOperand(*Comma, ParseAssignment());
		Left = Comma;
	}
	return Left;
}

/** A binary operator that binds at least as strong as Least; 0: one that assigns. Empty, with nothing read: there is
 * none. */
std::string_view FParser::TakeOperator(int Least)
{
	if (At().Kind != EToken::Sign || (bInAngles && Is(">")))
	{
		return {};
	}
	const std::string_view Text = JoinParserOperator(&Tokens[Pos]);
	if (Least == 0 ? !IsParserAssignment(Text) : GetParserStrength(Text) < Least)
	{
		return {};
	}
	for (size_t Size = 0; Size < Text.size();)
	{
		Size += Next().Text.size();
	}
	return Text;
}

FExpression* FParser::ParseAssignment()
{
	FExpression* Left = ParseConditional();
	const FPlace Place = At().Place;
	const std::string_view Operator = TakeOperator(0);
	if (Operator.empty())
	{
		return Left;
	}
	const FLevel Level(*this);
	FExpression* Assign = Make(EExpression::Assign, Place);
	Assign->Text = Operator;
	AddOperand(*Assign, Left);
	AddOperand(*Assign, ParseAssignment());
	return Assign;
}

FExpression* FParser::ParseConditional()
{
	FExpression* Condition = ParseBinary(1);
	if (!Is("?"))
	{
		return Condition;
	}
	const FLevel Level(*this);
	FExpression* Conditional = Make(EExpression::Conditional, Next());
	AddOperand(*Conditional, Condition);
	AddOperand(*Conditional, ParseExpression());
	Expect(":", "of the '?' before it");
	AddOperand(*Conditional, ParseAssignment());
	return Conditional;
}

/** Operators that bind at least as strong as Least. */
FExpression* FParser::ParseBinary(int Least)
{
	FExpression* Left = ParseUnary();
	for (;;)
	{
		const FPlace Place = At().Place;
		const std::string_view Operator = TakeOperator(Least);
		if (Operator.empty())
		{
			return Left;
		}
		FExpression* Binary = Make(EExpression::Binary, Place);
		Binary->Text = Operator;
		AddOperand(*Binary, Left);
		AddOperand(*Binary, ParseBinary(GetParserStrength(Operator) + 1));
		Left = Binary;
	}
}

FExpression* FParser::ParseUnary()
{
	const bool bCast = Is("(") && IsTypeAt(Pos + 1);
	const bool bSign = Is("+") || Is("-") || Is("!") || Is("~") || Is("++") || Is("--");
	if (!bCast && !bSign)
	{
		return ParsePostfix();
	}
	const FLevel Level(*this);
	FExpression* Unary = Make(bCast ? EExpression::Cast : EExpression::Unary, Next());
	if (bCast)
	{
		const FAngles Angles(*this, false);
		Unary->Type = ParseTypeWithDimensions();
		Raise(*Unary, Unary->Type->Name.Height);
		Expect(")", "behind the type of the cast");
	}
	AddOperand(*Unary, ParseUnary());
	return Unary;
}

FExpression* FParser::ParsePostfix()
{
	FExpression* Value = ParsePrimary();
	for (;;)
	{
		if (Is("."))
		{
			Value = ParseMember(Value);
		}
		else if (Is("["))
		{
			const FLevel Level(*this);
			const FAngles Angles(*this, false);
			FExpression* Index = Make(EExpression::Index, Next());
			AddOperand(*Index, Value);
			AddOperand(*Index, ParseExpression());
			Expect("]", "behind the index");
			Value = Index;
		}
		else if (Is("("))
		{
			FExpression* Call = Make(EExpression::Call, Value->Place);
			AddOperand(*Call, Value);
			ParseArguments(*Call);
			Value = Call;
		}
		else if (Is("++") || Is("--"))
		{
			FExpression* Postfix = Make(EExpression::Postfix, Next());
			AddOperand(*Postfix, Value);
			Value = Postfix;
		}
		else if (Is("->"))
		{
			Fail(At().Place, "X3000: syntax error: unexpected token '->'; HLSL has no pointers: write '.'");
		}
		else
		{
			return Value;
		}
	}
}

/** `.Name`, and `.Name<T>(` of a method. */
FExpression* FParser::ParseMember(FExpression* Object)
{
	Next();
	(void)(Is("template") && IsName(1) && Take("template"));
	FExpression* Member = Make(EExpression::Member, At().Place);
	AddOperand(*Member, Object);
	for (;;)
	{
		if (!IsWord() || IsKeyword())
		{
			Unexpected("a member's name or a swizzle behind '.'");
		}
		ParsePart(Member->Name);
		if (Is("<") && IsTypeAt(Pos + 1, false))
		{
			const size_t End = FindAngleEnd(Pos);
			if (End != 0 && Tokens[End].Is("("))
			{
				ParseTemplateArguments(Member->Name);
			}
		}
		if (!Take("::"))
		{
			break;
		}
	}
	Raise(*Member, Member->Name.Height);
	return Member;
}

/** `(a, b)` of a call. */
void FParser::ParseArguments(FExpression& Call)
{
	const FLevel Level(*this);
	const FAngles Angles(*this, false);
	Expect("(");
	if (!Is(")"))
	{
		do
		{
			AddOperand(Call, ParseAssignment());
		} while (Take(","));
	}
	Expect(")", "or ',' behind the argument");
}

FExpression* FParser::ParsePrimary()
{
	const FToken& Token = At();
	if (Is("("))
	{
		return ParseParenthesized();
	}
	if (Token.Kind == EToken::Number)
	{
		return Make(EExpression::Number, Next());
	}
	if (Token.Kind == EToken::String)
	{
		FExpression* String = Make(EExpression::String, Next());
		while (At().Kind == EToken::String) // from the first quote to the last
		{
			const std::string_view Last = Next().Text;
			String->Text = {String->Text.data(), size_t(Last.data() + Last.size() - String->Text.data())};
		}
		return String;
	}
	if (IsKeyword())
	{
		if (Is("true") || Is("false"))
		{
			return Make(EExpression::Boolean, Next());
		}
		if (Is("this"))
		{
			return Make(EExpression::This, Next());
		}
		if (Is("sizeof"))
		{
			return ParseSizeOf();
		}
	}
	else if (Is("::") || (Token.Kind == EToken::Word && WordAt(Pos).Kind != EWord::Modifier))
	{
		return ParseNameOrConstruct();
	}
	if (Is("{"))
	{
		Unexpected("an expression; a list in braces stands only behind the '=' of a declaration");
	}
	Unexpected("an expression");
}

/** A value in parentheses. A name with a value behind it is a cast to a type that is not known here, such as a member
 * of a template's parameter. */
FExpression* FParser::ParseParenthesized()
{
	const FLevel Level(*this);
	const FAngles Angles(*this, false);
	const FPlace Place = Next().Place;
	FExpression* Value = ParseExpression();
	Expect(")", "of the '(' in line " + std::to_string(Place.Line) + ", column " + std::to_string(Place.Column));
	const bool bCast =
		Value->Kind == EExpression::Name && !Value->bParenthesized &&
		(At().Kind == EToken::Number || (IsWord() && (!IsKeyword() || Is("this") || Is("true") || Is("false"))));
	Value->bParenthesized = true;
	if (!bCast)
	{
		return Value;
	}
	FExpression* Cast = Make(EExpression::Cast, Place);
	Cast->Type = Tree.Make<FTypeName>(Value->Place);
	Cast->Type->Name = std::move(Value->Name);
	Raise(*Cast, Cast->Type->Name.Height);
	AddOperand(*Cast, ParseUnary());
	return Cast;
}

FExpression* FParser::ParseNameOrConstruct()
{
	const FPlace Place = At().Place;
	const bool bMatrix = WordAt(Pos).Kind == EWord::Matrix;
	FName Name;
	const bool bWord = bNumberNames && IsNumberName(At().Text);
	const bool bType = ParseName(Name).IsType() && !(bWord && !Is("("));
	if (bType && !Is("("))
	{
		Unexpected("'(' behind the type '" + std::string(Name.Last()) + "', which is not a value");
	}
	FExpression* Value = Make(bType ? EExpression::Construct : EExpression::Name, Place);
	Raise(*Value, Name.Height);
	if (!bType)
	{
		Value->Name = std::move(Name);
		return Value;
	}
	Value->Type = Tree.Make<FTypeName>(Place);
	Value->Type->Name = std::move(Name);
	Value->Type->Modifiers = bMatrix && Pack != 0 ? ModifierPacked | Pack : 0;
	ParseArguments(*Value);
	return Value;
}

FExpression* FParser::ParseSizeOf()
{
	const FLevel Level(*this);
	FExpression* SizeOf = Make(EExpression::SizeOf, Next());
	if (!Is("(") || !IsTypeAt(Pos + 1))
	{
		AddOperand(*SizeOf, ParseUnary());
		return SizeOf;
	}
	const FAngles Angles(*this, false);
	Next();
	SizeOf->Type = ParseTypeWithDimensions();
	Raise(*SizeOf, SizeOf->Type->Name.Height);
	Expect(")", "behind the type");
	return SizeOf;
}

/** `{1, {2, 3},}`. */
FExpression* FParser::ParseList()
{
	const FLevel Level(*this);
	const FAngles Angles(*this, false);
	const FPlace Place = At().Place;
	FExpression* List = Make(EExpression::List, Place);
	Expect("{");
	while (!Is("}"))
	{
		AddOperand(*List, ParseInitializer());
		if (!Take(","))
		{
			break;
		}
	}
	Expect("}", "or ',' in the list that begins in line " + std::to_string(Place.Line));
	return List;
}

/** A list or a value. */
FExpression* FParser::ParseInitializer()
{
	return Is("{") ? ParseList() : ParseAssignment();
}

} // namespace Drydock::Hlsl
