// Splits text into tokens and replaces macros in them.
#include "ShaderMacros.h"

#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <deque>
#include <set>
#include <string_view>

namespace Drydock
{

namespace
{

constexpr int MaxMacroDepth = 200;

/** A token's share of the bounds, so that they bound the text as well. */
size_t GetCost(const FShaderToken& Token)
{
	return 1 + Token.Text.size() / 64;
}

size_t GetCost(const FShaderTokens& Tokens)
{
	size_t Cost = 0;
	for (const FShaderToken& Token : Tokens)
	{
		Cost += GetCost(Token);
	}
	return Cost;
}

bool IsWordStart(char c)
{
	return std::isalpha(static_cast<unsigned char>(c)) || c == '_';
}

size_t FindNumberEnd(const std::string& Text, size_t i)
{
	const bool bHexadecimal = Text[i] == '0' && i + 1 < Text.size() && (Text[i + 1] | 0x20) == 'x';
	while (i < Text.size())
	{
		const bool bExponent = !bHexadecimal && (Text[i] | 0x20) == 'e' && i + 2 < Text.size() &&
							   (Text[i + 1] == '+' || Text[i + 1] == '-') && IsDigit(Text[i + 2]);
		if (!IsWordCharacter(Text[i]) && Text[i] != '.')
		{
			break;
		}
		i += bExponent ? 2 : 1;
	}
	return i;
}

size_t FindSignEnd(const std::string& Text, size_t i)
{
	static constexpr std::string_view Signs[] = {"...", "<<=", ">>=", "&&", "||", "==", "!=", "<=", ">=", "<<", ">>",
		"##", "::", "+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "++", "--", "->"};
	for (const std::string_view Sign : Signs)
	{
		if (Text[i] == Sign[0] && Text.compare(i, Sign.size(), Sign) == 0)
		{
			return i + Sign.size();
		}
	}
	return i + 1;
}

bool IsSign(const FShaderToken& Token, const char* Text)
{
	return Token.Kind == EShaderToken::Sign && Token.Text == Text;
}

/** Whether two neighbours written without a blank would be read as something else. */
bool WouldMerge(const FShaderToken& A, const FShaderToken& B)
{
	if (A.Kind == EShaderToken::Quoted || B.Kind == EShaderToken::Quoted || A.Text.empty() || B.Text.empty())
	{
		return false;
	}
	const char Last = A.Text.back();
	const char First = B.Text.front();
	if (A.Kind != EShaderToken::Sign && B.Kind != EShaderToken::Sign)
	{
		return true;
	}
	if (A.Kind == EShaderToken::Sign && B.Kind == EShaderToken::Sign)
	{
		return First == '=' || (Last == First && std::string("+-&|<>:#/").find(First) != std::string::npos) ||
			   (Last == '/' && First == '*') || (Last == '-' && First == '>');
	}
	return A.Kind == EShaderToken::Number && First == '.'; // "1" and ".x"
}

/** The expansion of one list of tokens. */
class FExpansion
{
public:
	FExpansion(const FShaderMacros& InMacros, bool bInComplete, std::string& InProblem, bool& bInNeedsMore,
		size_t& InNumAllTokens)
		: Macros(InMacros)
		, Problem(InProblem)
		, bNeedsMore(bInNeedsMore)
		, NumAllTokens(InNumAllTokens)
		, bComplete(bInComplete)
	{
	}

	FShaderTokens Run(const FShaderTokens& Tokens)
	{
		Spend(GetCost(Tokens));
		std::deque<FShaderToken> Input(Tokens.begin(), Tokens.end());
		FShaderTokens Result;
		while (!Input.empty() && Problem.empty() && !bNeedsMore)
		{
			FShaderToken Token = std::move(Input.front());
			const size_t Cost = GetCost(Token);
			Spend(Cost);
			Input.pop_front();
			if (Token.Kind == EShaderToken::Ended)
			{
				Open.erase(Open.find(Token.Text));
				continue;
			}
			const FShaderMacro* Macro =
				Token.Kind == EShaderToken::Word && !Token.bPainted ? Macros.Find(Token.Text) : nullptr;
			if (Macro && Open.count(Token.Text))
			{
				Token.bPainted = true;
				Macro = nullptr;
			}
			if (!Macro || !Replace(Token, *Macro, Input))
			{
				Result.push_back(std::move(Token));
			}
			NumTokens += Cost;
			if (NumTokens > FShaderMacros::MaxLineTokens || Input.size() > FShaderMacros::MaxLineTokens)
			{
				RefuseLine();
			}
		}
		return Result;
	}

private:
	void RefuseLine()
	{
		Problem =
			"the macros of this line expand to more than " + std::to_string(FShaderMacros::MaxLineTokens) + " tokens";
	}

	void Spend(size_t Cost)
	{
		NumAllTokens += Cost;
		if (NumAllTokens > FShaderMacros::MaxTokens && Problem.empty())
		{
			Problem = "the macros of this shader expand to more than " + std::to_string(FShaderMacros::MaxTokens) +
					  " tokens, with calls over several lines once for each line";
		}
	}

	/** Puts the expansion before the rest of Input; false if the name of a function-like macro is not called. */
	bool Replace(const FShaderToken& Name, const FShaderMacro& Macro, std::deque<FShaderToken>& Input)
	{
		std::vector<FShaderTokens> Arguments;
		if (Macro.bFunction && !TakeArguments(Name, Macro, Input, Arguments))
		{
			return false;
		}
		FShaderTokens Body = Macro.bFunction ? Substitute(Macro, Arguments) : Macro.Body;
		Paste(Body);
		if (!Body.empty())
		{
			Body.front().bSpaceBefore = Name.bSpaceBefore;
		}
		Open.insert(Name.Text);
		Input.push_front({EShaderToken::Ended, Name.Text, false, false});
		Input.insert(Input.begin(), Body.begin(), Body.end());
		return true;
	}

	bool TakeArguments(const FShaderToken& Name, const FShaderMacro& Macro, std::deque<FShaderToken>& Input,
		std::vector<FShaderTokens>& Arguments)
	{
		size_t i = 0;
		while (i < Input.size() && Input[i].Kind == EShaderToken::Ended)
		{
			++i;
		}
		if (i < Input.size() && !IsSign(Input[i], "("))
		{
			return false;
		}
		if (i == Input.size())
		{
			bNeedsMore = !bComplete;
			return false;
		}
		std::vector<std::string> Ended;
		Arguments.emplace_back();
		int NumOpen = 0;
		for (i = 0; i < Input.size(); ++i)
		{
			FShaderToken& Token = Input[i];
			if (Token.Kind == EShaderToken::Ended)
			{
				Ended.push_back(Token.Text);
				continue;
			}
			const bool bOpens = IsSign(Token, "(");
			NumOpen += bOpens ? 1 : IsSign(Token, ")") ? -1 : 0;
			if (NumOpen == 0)
			{
				break;
			}
			Spend(GetCost(Token));
			const bool bSplits =
				NumOpen == 1 && IsSign(Token, ",") && !(Macro.bVariadic && Arguments.size() == Macro.Parameters.size());
			if (bSplits)
			{
				Arguments.emplace_back();
			}
			else if (!(bOpens && NumOpen == 1))
			{
				Arguments.back().push_back(Token);
			}
		}
		if (i == Input.size())
		{
			bNeedsMore = !bComplete;
			Problem = bComplete ? "the call of macro '" + Name.Text + "' has no closing parenthesis" : Problem;
			return false;
		}
		Input.erase(Input.begin(), Input.begin() + std::ptrdiff_t(i) + 1);
		for (const std::string& Closed : Ended)
		{
			Open.erase(Open.find(Closed));
		}
		if (Macro.Parameters.empty() && Arguments.size() == 1 && Arguments[0].empty())
		{
			Arguments.clear();
		}
		if (Macro.bVariadic && Arguments.size() + 1 == Macro.Parameters.size())
		{
			Arguments.emplace_back();
		}
		if (Arguments.size() != Macro.Parameters.size())
		{
			Problem = "macro '" + Name.Text + "' takes " + std::to_string(Macro.Parameters.size()) +
					  (Macro.Parameters.size() == 1 ? " argument" : " arguments") + " and is given " +
					  std::to_string(Arguments.size());
			Arguments.resize(Macro.Parameters.size());
		}
		return true;
	}

	FShaderTokens Substitute(const FShaderMacro& Macro, const std::vector<FShaderTokens>& Arguments)
	{
		FShaderTokens Result;
		std::vector<FShaderTokens> Expanded(Arguments.size());
		std::vector<bool> bExpanded(Arguments.size());
		size_t Cost = 0;
		for (size_t i = 0; i < Macro.Body.size() && Problem.empty(); ++i)
		{
			const FShaderToken& Token = Macro.Body[i];
			const bool bStringize = IsSign(Token, "#") && i + 1 < Macro.Body.size();
			const size_t Parameter = FindParameter(Macro, bStringize ? Macro.Body[i + 1] : Token);
			if (Parameter == Macro.Parameters.size())
			{
				Result.push_back(Token);
				continue;
			}
			if (bStringize)
			{
				AddCost(GetCost(Arguments[Parameter]), Cost);
				Result.push_back(
					{EShaderToken::Quoted, "\"" + JoinTokens(Arguments[Parameter]) + "\"", Token.bSpaceBefore, false});
				++i;
				continue;
			}
			const bool bPasted = (i + 1 < Macro.Body.size() && IsSign(Macro.Body[i + 1], "##")) ||
								 (i > 0 && IsSign(Macro.Body[i - 1], "##"));
			if (!bPasted && !bExpanded[Parameter])
			{
				Expanded[Parameter] = ExpandArgument(Arguments[Parameter]);
				bExpanded[Parameter] = true;
			}
			const FShaderTokens& Value = bPasted ? Arguments[Parameter] : Expanded[Parameter];
			AddCost(GetCost(Value), Cost);
			const size_t First = Result.size();
			Result.insert(Result.end(), Value.begin(), Value.end());
			if (Value.empty())
			{
				Result.push_back({EShaderToken::Sign, "", Token.bSpaceBefore, false}); // ## pastes to nothing
			}
			Result[First].bSpaceBefore = Token.bSpaceBefore;
		}
		return Result;
	}

	/** Adds to the tokens put in for one call, which are refused before they fill the memory. */
	void AddCost(size_t More, size_t& Cost)
	{
		Spend(More);
		Cost += More;
		if (Cost > FShaderMacros::MaxLineTokens && Problem.empty())
		{
			RefuseLine();
		}
	}

	FShaderTokens ExpandArgument(const FShaderTokens& Argument)
	{
		if (Depth >= MaxMacroDepth)
		{
			Problem = "macro calls are nested more than " + std::to_string(MaxMacroDepth) + " deep";
			return {};
		}
		const bool bOuter = bComplete;
		bComplete = true;
		++Depth;
		FShaderTokens Result = Run(Argument);
		--Depth;
		bComplete = bOuter;
		return Result;
	}

	static size_t FindParameter(const FShaderMacro& Macro, const FShaderToken& Token)
	{
		const auto Found =
			Token.Kind == EShaderToken::Word ? std::ranges::find(Macro.Parameters, Token.Text) : Macro.Parameters.end();
		return size_t(Found - Macro.Parameters.begin());
	}

	/** Joins the neighbours of every ## and drops the marks of empty arguments. */
	static void Paste(FShaderTokens& Tokens)
	{
		FShaderTokens Result;
		for (size_t i = 0; i < Tokens.size(); ++i)
		{
			if (IsSign(Tokens[i], "##") && i + 1 == Tokens.size())
			{
				continue; // the engine's preprocessor pastes nothing at a macro's end
			}
			if (IsSign(Tokens[i], "##") && !Result.empty())
			{
				const FShaderToken Left = Result.back();
				Result.pop_back();
				// ", ## __VA_ARGS__" without arguments takes the comma with it.
				const bool bCommaGoes = IsSign(Left, ",") && Tokens[i + 1].Text.empty();
				const bool bCommaStays = IsSign(Left, ",") && !bCommaGoes;
				FShaderTokens Joined = bCommaGoes    ? FShaderTokens()
									   : bCommaStays ? FShaderTokens{Left, Tokens[i + 1]}
													 : SplitTokens(Left.Text + Tokens[i + 1].Text);
				if (!Joined.empty())
				{
					Joined.front().bSpaceBefore = Left.bSpaceBefore;
				}
				else
				{
					Joined.push_back({EShaderToken::Sign, "", Left.bSpaceBefore, false});
				}
				Result.insert(Result.end(), Joined.begin(), Joined.end());
				++i;
			}
			else
			{
				Result.push_back(std::move(Tokens[i]));
			}
		}
		std::erase_if(Result, [](const FShaderToken& Token) { return Token.Text.empty(); });
		Tokens = std::move(Result);
	}

	const FShaderMacros& Macros;
	std::string& Problem;
	bool& bNeedsMore;
	size_t& NumAllTokens;
	std::multiset<std::string> Open; // macros whose expansion is being read
	size_t NumTokens = 0;
	bool bComplete; // nothing can be appended
	int Depth = 0;  // of arguments in arguments
};

} // namespace

FShaderTokens SplitTokens(const std::string& Text)
{
	FShaderTokens Tokens;
	bool bSpace = false;
	for (size_t i = 0; i < Text.size();)
	{
		const char c = Text[i];
		if (std::isspace(static_cast<unsigned char>(c)))
		{
			bSpace = true;
			++i;
			continue;
		}
		const bool bNumber = IsDigit(c) || (c == '.' && i + 1 < Text.size() && IsDigit(Text[i + 1]));
		FShaderToken Token;
		Token.bSpaceBefore = bSpace;
		size_t End;
		if (IsWordStart(c))
		{
			Token.Kind = EShaderToken::Word;
			End =
				size_t(std::find_if_not(Text.begin() + std::ptrdiff_t(i), Text.end(), IsWordCharacter) - Text.begin());
		}
		else if (bNumber)
		{
			Token.Kind = EShaderToken::Number;
			End = FindNumberEnd(Text, i);
		}
		else if (c == '"' || c == '\'')
		{
			Token.Kind = EShaderToken::Quoted;
			for (End = i + 1; End < Text.size() && Text[End] != c; ++End)
			{
				End += Text[End] == '\\' && End + 1 < Text.size() ? 1 : 0;
			}
			End = std::min(End + 1, Text.size());
		}
		else
		{
			End = FindSignEnd(Text, i);
		}
		Token.Text = Text.substr(i, End - i);
		Tokens.push_back(std::move(Token));
		bSpace = false;
		i = End;
	}
	return Tokens;
}

std::string JoinTokens(const FShaderTokens& Tokens)
{
	std::string Text;
	for (size_t i = 0; i < Tokens.size(); ++i)
	{
		const bool bSpace = i > 0 && (Tokens[i].bSpaceBefore || WouldMerge(Tokens[i - 1], Tokens[i]));
		Text += (bSpace ? " " : "") + Tokens[i].Text;
	}
	return Text;
}

std::string FShaderMacros::Define(const std::string& Text)
{
	const FShaderTokens Tokens = SplitTokens(Text);
	if (Tokens.empty() || Tokens[0].Kind != EShaderToken::Word)
	{
		return "#define needs a name";
	}
	FShaderMacro Macro;
	size_t i = 1;
	Macro.bFunction = Tokens.size() > 1 && IsSign(Tokens[1], "(") && !Tokens[1].bSpaceBefore;
	if (Macro.bFunction)
	{
		for (i = 2; i < Tokens.size() && !IsSign(Tokens[i], ")"); ++i)
		{
			if (IsSign(Tokens[i], "..."))
			{
				Macro.bVariadic = true;
				Macro.Parameters.push_back("__VA_ARGS__");
			}
			else if (Tokens[i].Kind == EShaderToken::Word)
			{
				Macro.Parameters.push_back(Tokens[i].Text);
			}
			else if (!IsSign(Tokens[i], ","))
			{
				return "the parameters of macro '" + Tokens[0].Text + "' are names with commas between them";
			}
		}
		if (i == Tokens.size())
		{
			return "the parameters of macro '" + Tokens[0].Text + "' have no closing parenthesis";
		}
		++i;
	}
	Macro.Body.assign(Tokens.begin() + std::ptrdiff_t(std::min(i, Tokens.size())), Tokens.end());
	Macros[Tokens[0].Text] = std::move(Macro);
	return {};
}

FShaderTokens FShaderMacros::Expand(
	const FShaderTokens& Tokens, bool bComplete, std::string& Problem, bool& bNeedsMore) const
{
	bNeedsMore = false;
	return FExpansion(*this, bComplete, Problem, bNeedsMore, NumTokens).Run(Tokens);
}

} // namespace Drydock
