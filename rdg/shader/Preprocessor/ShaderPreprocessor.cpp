// Reads a shader line by line. Source of the directives: C, of the paths: the engine's shader preprocessor.
#include "ShaderPreprocessor.h"

#include "ShaderCondition.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr size_t MaxText = 32u << 20;
constexpr size_t MaxOpen = 64;
constexpr int MaxIncludes = 10000;
constexpr size_t MaxErrors = 64;
constexpr int MaxCallLines = 1000; // of one macro call

std::string QuotedPath(const std::string& Text)
{
	if (Text.empty() || (Text[0] != '"' && Text[0] != '<'))
	{
		return {};
	}
	const size_t Close = Text.find(Text[0] == '"' ? '"' : '>', 1);
	return Close == std::string::npos ? std::string() : Text.substr(1, Close - 1);
}

/** "include" of ` # include "x"`, and what follows it; empty if the line is not a directive. */
std::pair<std::string, std::string> SplitDirective(const std::string& Line)
{
	size_t i = Line.find_first_not_of(" \t");
	if (i == std::string::npos || Line[i] != '#')
	{
		return {};
	}
	i = std::min(Line.find_first_not_of(" \t", i + 1), Line.size());
	size_t End = i;
	while (End < Line.size() && IsWordCharacter(Line[End]))
	{
		++End;
	}
	const size_t Rest = Line.find_first_not_of(" \t", End);
	return {End == i ? "#" : Line.substr(i, End - i), Rest == std::string::npos ? std::string() : Line.substr(Rest)};
}

bool IsDirective(const std::string& Line)
{
	const size_t i = Line.find_first_not_of(" \t");
	return i != std::string::npos && Line[i] == '#';
}

} // namespace

std::string FindQuotedInclude(const std::string& Line)
{
	const auto [Directive, Rest] = SplitDirective(Line);
	return Directive == "include" ? QuotedPath(Rest) : std::string();
}

/** The logical lines of a file: joined where a backslash ends one, without comments. */
struct FShaderPreprocessor::FLines
{
	explicit FLines(const std::string& InText)
		: Text(InText)
	{
	}

	/** False at the end. First and Next are the numbers of the line and of the one behind it. */
	bool Read(std::string& Line)
	{
		if (bHeld)
		{
			Line = std::move(Held);
			First = HeldFirst;
			bHeld = false;
			return true;
		}
		if (At >= Text.size())
		{
			return false;
		}
		First = Next;
		std::string Raw;
		bool bJoined = true;
		while (bJoined && At < Text.size())
		{
			const size_t End = std::min(Text.find('\n', At), Text.size());
			bJoined = End > At && Text[End - 1] == '\\';
			Raw.append(Text, At, End - At - (bJoined ? 1 : 0));
			At = End + 1;
			++Next;
		}
		Line = Strip(Raw);
		return true;
	}

	/** Puts the line that Read gave last back. */
	void Hold(std::string&& Line)
	{
		Held = std::move(Line);
		HeldFirst = First;
		bHeld = true;
	}

	int First = 1;
	int Next = 1;

private:
	/** Comments become a blank; one may begin in an earlier line and end in a later one. */
	std::string Strip(const std::string& Raw)
	{
		std::string Result;
		for (size_t i = 0; i < Raw.size(); ++i)
		{
			const char c = Raw[i];
			const char Behind = i + 1 < Raw.size() ? Raw[i + 1] : '\0';
			if (bInComment)
			{
				bInComment = !(c == '*' && Behind == '/');
				i += bInComment ? 0 : 1;
			}
			else if (c == '/' && Behind == '*')
			{
				bInComment = true;
				Result += ' ';
				++i;
			}
			else if (c == '/' && Behind == '/')
			{
				break;
			}
			else if (c == '"')
			{
				const size_t End = std::min(Raw.find('"', i + 1), Raw.size() - 1) + 1;
				Result.append(Raw, i, End - i);
				i = End - 1;
			}
			else
			{
				Result += c;
			}
		}
		Result.erase(Result.find_last_not_of(" \t") + 1);
		return Result;
	}

	const std::string& Text;
	size_t At = 0;
	bool bInComment = false;
	std::string Held;
	int HeldFirst = 1;
	bool bHeld = false;
};

void FShaderPreprocessor::Define(const std::string& Name, const std::string& Value)
{
	const std::string Problem = Macros.Define(Name + " " + Value);
	if (!Problem.empty())
	{
		Error(6002, Problem + " (a define of the shader class)");
	}
}

void FShaderPreprocessor::Error(int Code, const std::string& Message)
{
	if (Errors.size() < MaxErrors)
	{
		Errors.push_back({ESeverity::Error, Code, Message, Path, Number, 0, {}});
	}
}

void FShaderPreprocessor::Emit(const std::string& Line, int LineNumber)
{
	if (TextPath != Path || LineNumber < TextNumber || LineNumber > TextNumber + GMaxBlankLines)
	{
		Text += "#line " + std::to_string(LineNumber) + " \"" + Path + "\"\n";
		TextPath = Path;
		TextNumber = LineNumber;
	}
	Text.append(size_t(LineNumber - TextNumber), '\n');
	Text += Line;
	Text += '\n';
	TextNumber = LineNumber + 1;
}

void FShaderPreprocessor::AppendText(const std::string& Line, FLines& Lines)
{
	FShaderTokens Tokens = SplitTokens(Line);
	const bool bMacros = std::ranges::any_of(Tokens, [this](const FShaderToken& Token)
		{ return Token.Kind == EShaderToken::Word && (Macros.Find(Token.Text) || Token.Text == "__LINE__"); });
	if (!bMacros)
	{
		if (!Tokens.empty())
		{
			Emit(Line, Number);
		}
		return;
	}
	std::string Problem;
	bool bNeedsMore = false;
	bool bComplete = false;
	for (FShaderToken& Token : Tokens)
	{
		Token.Text = Token.Kind == EShaderToken::Word && Token.Text == "__LINE__" ? std::to_string(Number) : Token.Text;
	}
	FShaderTokens Expanded = Macros.Expand(Tokens, bComplete, Problem, bNeedsMore);
	for (int NumLines = 1; bNeedsMore && Problem.empty(); ++NumLines)
	{
		std::string Following;
		const bool bRead = NumLines < MaxCallLines && Lines.Read(Following);
		if (!bRead)
		{
			bComplete = true;
		}
		else if (IsDirective(Following))
		{
			Lines.Hold(std::move(Following));
			bComplete = true;
		}
		else if (!bComplete)
		{
			FShaderTokens More = SplitTokens(Following);
			if (!More.empty())
			{
				More.front().bSpaceBefore = true;
			}
			Tokens.insert(Tokens.end(), More.begin(), More.end());
		}
		Expanded = Macros.Expand(Tokens, bComplete, Problem, bNeedsMore);
	}
	if (!Problem.empty())
	{
		Error(6002, Problem);
		return;
	}
	if (!Expanded.empty())
	{
		const size_t Indent = std::min(Line.find_first_not_of(" \t"), Line.size());
		Emit(Line.substr(0, Indent) + JoinTokens(Expanded), Number);
	}
}

void FShaderPreprocessor::AppendInclude(const std::string& Rest)
{
	std::string Target = QuotedPath(Rest);
	if (Target.empty())
	{
		std::string Problem;
		bool bNeedsMore = false;
		Target = QuotedPath(JoinTokens(Macros.Expand(SplitTokens(Rest), true, Problem, bNeedsMore)));
	}
	if (Target.empty())
	{
		Error(6003, "#include needs a path in quotes");
		return;
	}
	const FShaderInclude Found = FindInclude(Target, Path, Number);
	if (!Found.Text || Once.count(Found.Path))
	{
		return;
	}
	if (Open.size() >= MaxOpen || ++NumIncludes > MaxIncludes)
	{
		Error(6003, Open.size() >= MaxOpen ? "includes are nested too deeply" : "there are more than 10000 includes");
		bSpent = true; // each level may include the next one twice
		return;
	}
	Append(Found.Path, *Found.Text);
}

void FShaderPreprocessor::AppendCondition(const std::string& Name, const std::string& Rest)
{
	const bool bOpens = Name == "if" || Name == "ifdef" || Name == "ifndef";
	if (!bOpens && Conditions.empty())
	{
		Error(6002, "#" + Name + " without #if");
		return;
	}
	const auto Evaluate = [&]
	{
		if (Name == "ifdef" || Name == "ifndef")
		{
			const FShaderTokens Tokens = SplitTokens(Rest);
			const bool bParenthesis = Tokens.size() > 2 && Tokens[0].Text == "(" && Tokens[2].Text == ")"; // #ifdef(X)
			const size_t At = bParenthesis ? 1 : 0;
			if (At >= Tokens.size() || Tokens[At].Kind != EShaderToken::Word)
			{
				Error(6002, "#" + Name + " needs the name of a macro");
				return false;
			}
			return (Macros.Find(Tokens[At].Text) != nullptr) == (Name == "ifdef");
		}
		std::string Problem;
		const std::optional<int64_t> Value = EvaluateCondition(Rest, Macros, Problem);
		if (!Value)
		{
			Error(6002, Problem);
		}
		return Value.value_or(0) != 0;
	};
	if (bOpens)
	{
		const bool bOuter = IsActive();
		const bool bTrue = bOuter && Evaluate();
		Conditions.push_back({Number, bTrue, bTrue, bOuter, false});
		return;
	}
	FCondition& Condition = Conditions.back();
	if (Name == "endif")
	{
		Conditions.pop_back();
		return;
	}
	if (Condition.bElse)
	{
		Error(6002, "#" + Name + " behind the #else of the #if in line " + std::to_string(Condition.Line));
		return;
	}
	Condition.bElse = Name == "else";
	Condition.bActive = Condition.bOuter && !Condition.bTaken && (Condition.bElse || Evaluate());
	Condition.bTaken = Condition.bTaken || Condition.bActive;
}

void FShaderPreprocessor::AppendDirective(const std::string& Name, const std::string& Rest)
{
	if (Name == "if" || Name == "ifdef" || Name == "ifndef" || Name == "elif" || Name == "else" || Name == "endif")
	{
		AppendCondition(Name, Rest);
		return;
	}
	if (!IsActive())
	{
		return;
	}
	if (Name == "include")
	{
		AppendInclude(Rest);
	}
	else if (Name == "define")
	{
		const std::string Problem = Macros.Define(Rest);
		if (!Problem.empty())
		{
			Error(6002, Problem);
		}
	}
	else if (Name == "undef")
	{
		const FShaderTokens Tokens = SplitTokens(Rest);
		Macros.Undefine(Tokens.empty() ? std::string() : Tokens[0].Text);
	}
	else if (Name == "error")
	{
		Error(6002, "#error " + Rest);
	}
	else if (Name == "pragma" && Rest.starts_with("pack_matrix"))
	{
		Emit("#pragma " + Rest, Number);
	}
	else if (Name == "pragma" && Rest == "once")
	{
		Once.insert(Path);
	}
	else if (Name != "pragma" && Name != "warning" && Name != "line" && Name != "#")
	{
		Error(6002, "there is no directive #" + Name);
	}
}

void FShaderPreprocessor::Append(const std::string& FilePath, const std::string& FileText)
{
	const std::string Includer = Path;
	const int IncluderNumber = Number;
	const size_t NumConditions = Conditions.size();
	Open.push_back(FilePath);
	Path = FilePath;
	FLines Lines(FileText);
	std::string Line;
	while (!IsSpent() && Lines.Read(Line))
	{
		Number = Lines.First;
		if (Text.size() > MaxText)
		{
			Error(6003, "the shader with its includes and macros is larger than 32 MiB");
			break;
		}
		const auto [Name, Rest] = SplitDirective(Line);
		if (!Name.empty())
		{
			AppendDirective(Name, Rest);
		}
		else if (IsActive())
		{
			AppendText(Line, Lines);
		}
	}
	if (Conditions.size() > NumConditions)
	{
		Number = Conditions.back().Line;
		if (!IsSpent()) // what follows has not been read
		{
			Error(6002, "this #if has no #endif");
		}
		Conditions.resize(NumConditions);
	}
	Open.pop_back();
	Path = Includer;
	Number = IncluderNumber;
}

} // namespace Drydock
