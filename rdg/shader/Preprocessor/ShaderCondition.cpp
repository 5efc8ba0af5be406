// Evaluates the expressions of #if.
#include "ShaderCondition.h"

#include "TextTools.h"

#include <cstdlib>

namespace Drydock
{

namespace
{

constexpr int MaxConditionDepth = 200;

struct FOperator
{
	const char* Sign;
	int Level; // binds tighter when higher
};

constexpr FOperator Operators[] = {{"||", 1}, {"&&", 2}, {"|", 3}, {"^", 4}, {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},
	{">", 7}, {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9}, {"*", 10}, {"/", 10}, {"%", 10}};

class FEvaluation
{
public:
	FEvaluation(FShaderTokens InTokens, std::string& InProblem)
		: Tokens(std::move(InTokens))
		, Problem(InProblem)
	{
	}

	std::optional<int64_t> Run()
	{
		const int64_t Value = Choice(true);
		if (Problem.empty() && At < Tokens.size())
		{
			Fail("'" + Tokens[At].Text + "' is not expected");
		}
		return Problem.empty() ? std::optional(Value) : std::nullopt;
	}

private:
	int64_t Fail(const std::string& Why)
	{
		Problem = Problem.empty() ? "the condition cannot be evaluated: " + Why : Problem;
		At = Tokens.size();
		return 0;
	}
	bool Take(const char* Sign)
	{
		const bool bFound = At < Tokens.size() && Tokens[At].Kind == EShaderToken::Sign && Tokens[At].Text == Sign;
		At += bFound ? 1 : 0;
		return bFound;
	}

	/** bCounts: the value is used, so that dividing by zero is a fault. */
	int64_t Choice(bool bCounts)
	{
		if (++Depth > MaxConditionDepth)
		{
			return Fail("it is nested too deeply");
		}
		int64_t Value = Binary(1, bCounts);
		if (Take("?"))
		{
			const int64_t Yes = Choice(bCounts && Value);
			if (!Take(":"))
			{
				return Fail("'?' without ':'");
			}
			const int64_t No = Choice(bCounts && !Value);
			Value = Value ? Yes : No;
		}
		--Depth;
		return Value;
	}

	int64_t Binary(int Level, bool bCounts)
	{
		int64_t Left = Unary(bCounts);
		while (At < Tokens.size())
		{
			const FOperator* Found = nullptr;
			for (const FOperator& Operator : Operators)
			{
				Found = Tokens[At].Kind == EShaderToken::Sign && Tokens[At].Text == Operator.Sign ? &Operator : Found;
			}
			if (!Found || Found->Level < Level)
			{
				break;
			}
			++At;
			const std::string Sign = Found->Sign;
			const bool bSkipsRight = (Sign == "&&" && !Left) || (Sign == "||" && Left);
			const bool bRightCounts = bCounts && !bSkipsRight;
			Left = Apply(Sign, Left, Binary(Found->Level + 1, bRightCounts), bCounts);
		}
		return Left;
	}

	int64_t Apply(const std::string& Sign, int64_t A, int64_t B, bool bCounts)
	{
		const uint64_t UA = uint64_t(A); // wraps around instead of overflowing
		const uint64_t UB = uint64_t(B);
		if (Sign == "/" || Sign == "%")
		{
			if (B == 0)
			{
				return bCounts ? Fail("a division by zero") : 0;
			}
			return B == -1 ? (Sign == "/" ? int64_t(0 - UA) : 0) : Sign == "/" ? A / B : A % B;
		}
		return Sign == "||"   ? (A || B)
			   : Sign == "&&" ? (A && B)
			   : Sign == "|"  ? (A | B)
			   : Sign == "^"  ? (A ^ B)
			   : Sign == "&"  ? (A & B)
			   : Sign == "==" ? A == B
			   : Sign == "!=" ? A != B
			   : Sign == "<"  ? A < B
			   : Sign == ">"  ? A > B
			   : Sign == "<=" ? A <= B
			   : Sign == ">=" ? A >= B
			   : Sign == "<<" ? int64_t(UA << (UB & 63))
			   : Sign == ">>" ? A >> (UB & 63)
			   : Sign == "+"  ? int64_t(UA + UB)
			   : Sign == "-"  ? int64_t(UA - UB)
							  : int64_t(UA * UB);
	}

	int64_t Unary(bool bCounts)
	{
		if (++Depth > MaxConditionDepth)
		{
			return Fail("it is nested too deeply");
		}
		const int64_t Value = Take("!")   ? !Unary(bCounts)
							  : Take("-") ? int64_t(0 - uint64_t(Unary(bCounts)))
							  : Take("+") ? Unary(bCounts)
							  : Take("~") ? ~Unary(bCounts)
										  : Primary(bCounts);
		--Depth;
		return Value;
	}

	int64_t Primary(bool bCounts)
	{
		if (Take("("))
		{
			const int64_t Value = Choice(bCounts);
			return Take(")") ? Value : Fail("a parenthesis is not closed");
		}
		if (At == Tokens.size())
		{
			return Fail("it ends where a value is expected");
		}
		const FShaderToken& Token = Tokens[At++];
		if (Token.Kind == EShaderToken::Number)
		{
			return Number(Token.Text);
		}
		if (Token.Kind != EShaderToken::Word)
		{
			return Fail("'" + Token.Text + "' stands where a value is expected");
		}
		if (At < Tokens.size() && Tokens[At].Text == "(")
		{
			return Fail("'" + Token.Text + "' is not a macro");
		}
		return Token.Text == "true" ? 1 : 0;
	}

	int64_t Number(const std::string& Text)
	{
		char* End = nullptr;
		const uint64_t Value = std::strtoull(Text.c_str(), &End, 0);
		for (; *End; ++End)
		{
			const char Suffix = ToLowerCase(*End);
			if (Suffix != 'u' && Suffix != 'l')
			{
				return Fail("'" + Text + "' is not an integer");
			}
		}
		return int64_t(Value);
	}

	FShaderTokens Tokens;
	std::string& Problem;
	size_t At = 0;
	int Depth = 0;
};

/** defined(X) and defined X by 1 or 0, before macros are replaced. */
FShaderTokens ReplaceDefined(const FShaderTokens& Tokens, const FShaderMacros& Macros, std::string& Problem)
{
	FShaderTokens Result;
	for (size_t i = 0; i < Tokens.size(); ++i)
	{
		if (Tokens[i].Kind != EShaderToken::Word || Tokens[i].Text != "defined")
		{
			Result.push_back(Tokens[i]);
			continue;
		}
		const bool bParenthesis = i + 1 < Tokens.size() && Tokens[i + 1].Text == "(";
		const size_t Name = i + (bParenthesis ? 2 : 1);
		const bool bWhole = Name < Tokens.size() && Tokens[Name].Kind == EShaderToken::Word &&
							(!bParenthesis || (Name + 1 < Tokens.size() && Tokens[Name + 1].Text == ")"));
		if (!bWhole)
		{
			Problem = "defined needs the name of a macro";
			return {};
		}
		Result.push_back({EShaderToken::Number, Macros.Find(Tokens[Name].Text) ? "1" : "0", true, false});
		i = Name + (bParenthesis ? 1 : 0);
	}
	return Result;
}

} // namespace

std::optional<int64_t> EvaluateCondition(
	const std::string& Expression, const FShaderMacros& Macros, std::string& Problem)
{
	Problem.clear();
	FShaderTokens Tokens = ReplaceDefined(SplitTokens(Expression), Macros, Problem);
	if (Problem.empty())
	{
		bool bNeedsMore = false;
		// A macro may itself ask whether something is defined.
		Tokens = ReplaceDefined(Macros.Expand(Tokens, true, Problem, bNeedsMore), Macros, Problem);
	}
	return Problem.empty() ? FEvaluation(std::move(Tokens), Problem).Run() : std::nullopt;
}

} // namespace Drydock
