// Reads statements and attributes.
#include "HlslParserImpl.h"

#include <algorithm>
#include <string>

namespace Drydock::Hlsl
{

namespace
{

constexpr size_t ParserMaxAttributes = 64;

} // namespace

/** A block with its braces. */
FStatement* FParser::ParseBlock(bool bSwitch)
{
	const FToken Open = At();
	Expect("{");
	const FInside Inside(*this);
	FStatement* Block = Tree.Make<FStatement>(Open.Place);
	Block->Kind = EStatement::Block;
	while (!Is("}") && !IsEnd())
	{
		const size_t Start = Pos;
		try
		{
			Block->Body.push_back(ParseStatement(bSwitch));
		}
		catch (const FParserFault&)
		{
			Recover(Start);
		}
	}
	Block->End = At().Place;
	Expect("}", "of the '{' in line " + std::to_string(Open.Place.Line));
	return Block;
}

/** The statement that an if or a loop runs: its declarations end with it. */
FStatement* FParser::ParseSubstatement()
{
	const FInside Inside(*this);
	return ParseStatement();
}

FStatement* FParser::ParseStatement(bool bInSwitch)
{
	const FLevel Level(*this);
	std::vector<FAttribute> Attributes = ParseAttributes();
	if (Is("{"))
	{
		FStatement* Block = ParseBlock();
		Block->Attributes = std::move(Attributes);
		return Block;
	}
	FStatement* Statement = nullptr;
	if (IsKeyword())
	{
		Statement = Tree.Make<FStatement>(At().Place);
		Statement->Attributes = Attributes;
		if (ParseKeywordStatement(*Statement, bInSwitch))
		{
			return Statement;
		}
	}
	Statement = ParseSimple();
	Statement->Attributes = std::move(Attributes);
	return Statement;
}

/** A declaration, an expression or nothing, with its `;`. */
FStatement* FParser::ParseSimple()
{
	FStatement* Statement = Tree.Make<FStatement>(At().Place);
	if (Take(";"))
	{
		return Statement;
	}
	if (IsDeclaration())
	{
		Statement->Kind = EStatement::Declaration;
		ParseDeclaration(Statement->Declarations, EWhere::Local);
		return Statement;
	}
	Statement->Kind = EStatement::Expression;
	Statement->Value = ParseExpression();
	Expect(";", "behind the expression");
	return Statement;
}

/** A statement that a word begins; false where it does not, with nothing read. */
bool FParser::ParseKeywordStatement(FStatement& Statement, bool bInSwitch)
{
	const auto TakeAlone = [&](std::string_view Word, EStatement Kind)
	{
		if (!Take(Word))
		{
			return false;
		}
		Statement.Kind = Kind;
		Expect(";", "behind '" + std::string(Word) + "'");
		return true;
	};
	if (Is("if"))
	{
		ParseIf(Statement);
	}
	else if (Is("for"))
	{
		ParseFor(Statement);
	}
	else if (Take("while"))
	{
		Statement.Kind = EStatement::While;
		Statement.Value = ParseCondition("while");
		Statement.Body.push_back(ParseSubstatement());
	}
	else if (Is("do"))
	{
		ParseDo(Statement);
	}
	else if (Is("switch"))
	{
		ParseSwitch(Statement);
	}
	else if (Is("case") || Is("default"))
	{
		ParseLabel(Statement, bInSwitch);
	}
	else if (Take("return"))
	{
		Statement.Kind = EStatement::Return;
		Statement.Value = Is(";") ? nullptr : ParseExpression();
		Expect(";", "behind the value that is returned");
	}
	else if (Is("else"))
	{
		Fail(At().Place,
			"X3000: syntax error: unexpected token 'else'; no 'if' stands before it: an 'if' has one statement, or "
			"several in braces");
	}
	else
	{
		return TakeAlone("break", EStatement::Break) || TakeAlone("continue", EStatement::Continue) ||
			   TakeAlone("discard", EStatement::Discard);
	}
	return true;
}

FExpression* FParser::ParseCondition(const char* Of)
{
	Expect("(", std::string("behind '") + Of + "'");
	const FPlace Place = At().Place;
	if (IsDeclaration())
	{
		Fail(Place, std::string("X3000: syntax error: a variable cannot be declared in the condition of '") + Of +
						"'; declare it before");
	}
	FExpression* Condition = ParseExpression();
	Expect(")", std::string("behind the condition of '") + Of + "'");
	return Condition;
}

void FParser::ParseIf(FStatement& Statement)
{
	const FInside Inside(*this);
	Statement.Kind = EStatement::If;
	Next();
	Expect("(", "behind 'if'");
	if (IsDeclaration())
	{
		uint32_t Modifiers = 0;
		FTypeName* Type = ParseSpecifiers(Modifiers);
		Statement.Condition = ParseDeclarator(Type, Modifiers, EWhere::Local);
		if (Statement.Condition->Value == nullptr)
		{
			Unexpected("'=' and a value of the variable that is the condition");
		}
	}
	else
	{
		Statement.Value = ParseExpression();
	}
	Expect(")", "behind the condition of 'if'");
	Statement.Body.push_back(ParseSubstatement());
	if (Take("else"))
	{
		Statement.Body.push_back(ParseSubstatement());
	}
}

/** `(init; condition; step)`. */
void FParser::ParseForHeader(FStatement& Statement)
{
	Expect("(", "behind 'for'");
	Statement.Body[0] = Is(";") ? nullptr : ParseSimple();
	if (Statement.Body[0] == nullptr)
	{
		Next();
	}
	Statement.Value = Is(";") ? nullptr : ParseExpression();
	Expect(";", "behind the condition of 'for'");
	Statement.Step = Is(")") ? nullptr : ParseExpression();
	Expect(")", "behind the step of 'for'");
}

void FParser::ParseFor(FStatement& Statement)
{
	const FInside Inside(*this);
	Statement.Kind = EStatement::For;
	Statement.Body.push_back(nullptr);
	Next();
	const size_t Open = Pos;
	try
	{
		ParseForHeader(Statement);
	}
	catch (const FParserFault&)
	{
		if (!Tokens[Open].Is("("))
		{
			throw;
		}
		RecoverBehind(Open); // its semicolons end no statement
	}
	Statement.Body.push_back(ParseSubstatement());
}

void FParser::ParseDo(FStatement& Statement)
{
	Statement.Kind = EStatement::Do;
	Next();
	Statement.Body.push_back(ParseSubstatement());
	if (!Take("while"))
	{
		Unexpected("'while' and the condition of the 'do' in line " + std::to_string(Statement.Place.Line));
	}
	Statement.Value = ParseCondition("while");
	Expect(";", "behind the condition of 'do'");
}

void FParser::ParseSwitch(FStatement& Statement)
{
	Statement.Kind = EStatement::Switch;
	Next();
	Statement.Value = ParseCondition("switch");
	if (!Is("{"))
	{
		Unexpected("'{' behind 'switch (...)'");
	}
	Statement.Body.push_back(ParseBlock(true));
}

void FParser::ParseLabel(FStatement& Statement, bool bInSwitch)
{
	const FToken Word = At();
	if (!bInSwitch)
	{
		Fail(Word.Place, "X3000: syntax error: unexpected token '" + std::string(Word.Text) +
							 "'; labels stand right in the braces of a 'switch'");
	}
	Next();
	Statement.Kind = Word.Text == "case" ? EStatement::Case : EStatement::Default;
	Statement.Value = Statement.Kind == EStatement::Case ? ParseConditional() : nullptr;
	Expect(":", "behind the label");
}

/** `[unroll(4)]` and what else stands in front; `[[vk::binding(0)]]` is skipped. */
std::vector<FAttribute> FParser::ParseAttributes()
{
	std::vector<FAttribute> Attributes;
	while (Is("["))
	{
		if (Is("[", 1))
		{
			SkipBalanced();
			continue;
		}
		Next();
		do
		{
			ParseAttribute(Attributes);
		} while (Take(","));
		Expect("]", "behind the attribute");
	}
	return Attributes;
}

void FParser::ParseAttribute(std::vector<FAttribute>& Attributes)
{
	FAttribute Attribute;
	Attribute.Place = At().Place;
	do
	{
		if (!IsWord())
		{
			Unexpected("the name of an attribute");
		}
		Attribute.Name += (Attribute.Name.empty() ? "" : "::") + std::string(Next().Text);
	} while (Take("::"));
	for (char& c : Attribute.Name)
	{
		c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
	}
	if (Is("("))
	{
		FExpression Arguments;
		Arguments.Place = Attribute.Place;
		ParseArguments(Arguments);
		Attribute.Arguments = std::move(Arguments.Operands);
	}
	Attributes.push_back(std::move(Attribute));
	if (Attributes.size() > ParserMaxAttributes)
	{
		Fail(Attributes.back().Place, "more than " + std::to_string(ParserMaxAttributes) + " attributes in a row");
	}
}

} // namespace Drydock::Hlsl
