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

} // namespace Drydock
