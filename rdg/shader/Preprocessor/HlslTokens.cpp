// Splits preprocessed text by lines and joins it again.
#include "HlslTokens.h"

#include <algorithm>
#include <cstdlib>

namespace Drydock
{

namespace
{

constexpr int MaxNesting = 256; // of statements without braces
constexpr size_t MaxListTokens = 256;

/** `#line 12 "/X.usf"` -> 12 and /X.usf; false for other lines. */
bool ReadLineDirective(const std::string& Line, int& Number, std::string& File)
{
	if (!Line.starts_with("#line "))
	{
		return false;
	}
	Number = std::atoi(Line.c_str() + 6);
	const size_t Quote = Line.find('"');
	if (Quote != std::string::npos)
	{
		File = Line.substr(Quote + 1, Line.rfind('"') - Quote - 1);
	}
	return true;
}

} // namespace

FHlslText::FHlslText(const std::string& Text, const std::string& VirtualPath)
{
	std::string File = VirtualPath;
	int Number = 1;
	for (size_t At = 0; At < Text.size();)
	{
		const size_t End = std::min(Text.find('\n', At), Text.size());
		const std::string Line = Text.substr(At, End - At);
		At = End + 1;
		if (ReadLineDirective(Line, Number, File))
		{
			continue;
		}
		const uint32_t FileIndex = uint32_t(std::find(Files.begin(), Files.end(), File) - Files.begin());
		if (FileIndex == Files.size())
		{
			Files.push_back(File);
		}
		if (Line.starts_with('#'))
		{
			Tokens.push_back({{EShaderToken::Sign, Line}, FileIndex, Number++, 1});
			continue;
		}
		size_t Column = 0;
		for (FShaderToken& Token : SplitTokens(Line))
		{
			Column = Line.find(Token.Text, Column);
			const size_t Behind = Column + Token.Text.size();
			Tokens.push_back({std::move(Token), FileIndex, Number, int(Column) + 1});
			Column = Behind;
		}
		++Number;
	}
	Match();
}

std::string FHlslText::Join() const
{
	std::string Text;
	uint32_t File = ~0u;
	int Line = 0;
	for (size_t At = 0; At < Tokens.size();)
	{
		const FHlslToken& First = Tokens[At];
		if (First.File != File || First.Line < Line || First.Line > Line + GMaxBlankLines)
		{
			Text += "#line " + std::to_string(First.Line) + " \"" + Files[First.File] + "\"\n";
		}
		else
		{
			Text.append(size_t(First.Line - Line), '\n');
		}
		FShaderTokens Row;
		for (; At < Tokens.size() && Tokens[At].File == First.File && Tokens[At].Line == First.Line; ++At)
		{
			const bool bDirective = Tokens[At].Text[0] == '#' || (!Row.empty() && Row.back().Text[0] == '#');
			if (bDirective && !Row.empty())
			{
				break; // a line of its own
			}
			Row.push_back(Tokens[At]);
		}
		Text += JoinTokens(Row) + "\n";
		File = First.File;
		Line = First.Line + 1;
	}
	return Text;
}

FDiagnostic FHlslText::MakeError(size_t At, const std::string& Message) const
{
	const FHlslToken& Token = Tokens[std::min(At, Tokens.size() - 1)];
	return {ESeverity::Error, 6010, Message, Files[Token.File], Token.Line, Token.Column, {}};
}

void FHlslText::Match()
{
	Closes.resize(Tokens.size());
	std::vector<size_t> Open;
	for (size_t At = 0; At < Tokens.size(); ++At)
	{
		Closes[At] = At;
		const bool bBracket = Tokens[At].Kind == EShaderToken::Sign && Tokens[At].Text.size() == 1;
		const char c = bBracket ? Tokens[At].Text[0] : ' ';
		if (c == '(' || c == '[' || c == '{')
		{
			Closes[At] = Tokens.size();
			Open.push_back(At);
		}
		else if ((c == ')' || c == ']' || c == '}') && !Open.empty())
		{
			Closes[Open.back()] = At;
			Open.pop_back();
		}
	}
}

size_t FHlslText::FindListEnd(size_t Open) const
{
	int Depth = 0;
	for (size_t At = Open; At < std::min(Tokens.size(), Open + MaxListTokens); ++At)
	{
		const FHlslToken& Token = Tokens[At];
		Depth += Token.Is("<") ? 1 : Token.Is(">") ? -1 : Token.Is(">>") ? -2 : 0;
		if (Depth <= 0)
		{
			return Depth == 0 ? At + 1 : 0;
		}
		const bool bFits = Token.IsWord() || Token.Kind == EShaderToken::Number || Token.Is("<") || Token.Is(">") ||
						   Token.Is(">>") || Token.Is(",") || Token.Is("::") || Token.Is("-") || Token.Is("+") ||
						   Token.Is("*");
		if (!bFits)
		{
			return 0;
		}
	}
	return 0;
}

size_t FHlslText::FindDeclaration(size_t At) const
{
	size_t Start = Size();
	for (size_t i = 0; i < At; ++i)
	{
		if (Is(i, "{"))
		{
			const size_t Close = FindClose(i);
			if (Close > At)
			{
				return Start;
			}
			i = Close;
			Start = i + 1;
		}
		else if (Is(i, ";"))
		{
			Start = i + 1;
		}
		else if (Start > i)
		{
			Start = i;
		}
	}
	return Size();
}

size_t FHlslText::FindStatementEnd(size_t At, int Depth) const
{
	// "if (A) for (...) while (...) F();": what stands before a statement is skipped until the statement itself is met.
	std::vector<bool> Ifs; // what is being skipped, an if or not
	for (int Nesting = Depth; At < Tokens.size() && Nesting < MaxNesting; ++Nesting)
	{
		while (Is(At, "["))
		{
			At = FindClose(At) + 1;
		}
		const bool bHead = Is(At, "if") || Is(At, "for") || Is(At, "while") || Is(At, "switch");
		if (bHead && Is(At + 1, "("))
		{
			Ifs.push_back(Is(At, "if"));
			At = FindClose(At + 1) + 1;
			continue;
		}
		if (Is(At, "do"))
		{
			At = FindStatementEnd(At + 1, Nesting + 1);
			At = Is(At, "while") && Is(At + 1, "(") ? FindClose(At + 1) + 2 : At;
		}
		else if (Is(At, "{"))
		{
			At = FindClose(At) + 1;
		}
		else
		{
			while (At < Tokens.size() && !Is(At, ";") && !Is(At, "}"))
			{
				At = Is(At, "(") || Is(At, "[") || Is(At, "{") ? FindClose(At) + 1 : At + 1;
			}
			At += Is(At, ";") ? 1 : 0;
		}
		while (!Ifs.empty() && !(Ifs.back() && Is(At, "else")))
		{
			Ifs.pop_back();
		}
		if (Ifs.empty())
		{
			break;
		}
		Ifs.pop_back();
		++At; // the else, and then its statement
	}
	return std::min(At, Tokens.size());
}

std::string FHlslText::GetText(size_t First, size_t End) const
{
	return JoinTokens(FShaderTokens(Tokens.begin() + std::ptrdiff_t(First), Tokens.begin() + std::ptrdiff_t(End)));
}

void FHlslEdits::Replace(size_t First, size_t End, const std::string& Words)
{
	Edits.push_back({First, End, Words, {}});
	LastEnd = std::max(LastEnd, End);
}

void FHlslEdits::Move(size_t Before, FHlslTokens Moved)
{
	Edits.push_back({Before, Before, {}, std::move(Moved)});
}

bool FHlslEdits::Apply(FHlslText& Text, const std::map<std::string, std::string>& Before)
{
	std::string Prelude;
	for (const auto& [Key, Declaration] : Before)
	{
		Prelude += Declaration + " ";
	}
	if (!Prelude.empty())
	{
		Insert(0, Prelude);
	}
	const bool bChanged = !IsEmpty();
	Apply(Text);
	return bChanged;
}

void FHlslEdits::Apply(FHlslText& Text)
{
	if (Edits.empty())
	{
		LastEnd = 0;
		return;
	}
	std::stable_sort(Edits.begin(), Edits.end(), [](const FEdit& A, const FEdit& B) { return A.First < B.First; });
	FHlslTokens Result;
	Result.reserve(Text.Size() + Edits.size());
	size_t At = 0;
	for (FEdit& Edit : Edits)
	{
		for (; At < Edit.First && At < Text.Size(); ++At)
		{
			Result.push_back(std::move(Text.Tokens[At]));
		}
		const FHlslToken Place = !Edit.Moved.empty() || Text.Tokens.empty() ? FHlslToken()
								 : Edit.First < Edit.End || At == 0 ? Text.Tokens[std::min(Edit.First, Text.Size() - 1)]
																	: Result.back();
		FHlslTokens New = Edit.Moved.empty() ? MakeHlslTokens(Edit.Words, Place) : std::move(Edit.Moved);
		if (Edit.First == Edit.End && !New.empty())
		{
			New.front().bSpaceBefore = true;
		}
		std::move(New.begin(), New.end(), std::back_inserter(Result));
		At = std::max(At, Edit.End);
	}
	for (; At < Text.Size(); ++At)
	{
		Result.push_back(std::move(Text.Tokens[At]));
	}
	Text.Tokens = std::move(Result);
	Text.Match();
	Edits.clear();
	LastEnd = 0;
}

FHlslTokens MakeHlslTokens(const std::string& Words, const FHlslToken& Place)
{
	FHlslTokens Result;
	for (FShaderToken& Token : SplitTokens(Words))
	{
		Result.push_back({std::move(Token), Place.File, Place.Line, Place.Column});
	}
	if (!Result.empty())
	{
		Result.front().bSpaceBefore = Place.bSpaceBefore;
	}
	return Result;
}

} // namespace Drydock
