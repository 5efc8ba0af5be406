// Splits a preprocessed text into tokens.
#include "HlslParser.h"

#include <algorithm>
#include <unordered_map>

namespace Drydock::Hlsl
{

namespace
{

bool IsLexerDigit(char c)
{
	return c >= '0' && c <= '9';
}

bool IsLexerWord(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || IsLexerDigit(c);
}

bool IsLexerBlank(char c)
{
	return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

/** Letters that end a number behind its point: 1.f, 1.L. */
bool IsLexerSuffix(std::string_view Word)
{
	return Word.size() == 1 && std::string_view("fFhHlL").find(Word[0]) != std::string_view::npos;
}

/** The signs of more than one character, the longest first; `>` is always alone. */
constexpr std::string_view LexerSigns[] = {"<<=", "...", "<<", "<=", "::", "++", "--", "->",
	"+=", "-=", "*=", "/=", "%=", "&=", "|=", "^=", "&&", "||", "==", "!="};

class FLexer
{
public:
	FLexer(std::string_view InText, std::string_view VirtualPath, std::vector<std::string>& InFiles,
		std::vector<FDiagnostic>& InErrors)
		: Text(InText)
		, Files(InFiles)
		, Errors(InErrors)
	{
		Place = {FindFile(VirtualPath), 1, 1};
		Tokens.reserve(Text.size() / 3 + 1);
	}

	std::vector<FToken> Read();

private:
	char Peek(size_t Offset = 0) const { return At + Offset < Text.size() ? Text[At + Offset] : '\0'; }

	/** The text there, up to the end of words. */
	std::string_view PeekWord(size_t From) const
	{
		size_t End = From;
		while (End < Text.size() && IsLexerWord(Text[End]))
		{
			++End;
		}
		return Text.substr(From, End - From);
	}

	uint32_t FindFile(std::string_view Name);
	FPlace GetPlace(size_t Where);
	void StartLine(int32_t Line);
	void Report(size_t Where, const std::string& Message);
	void Add(EToken Kind, size_t Size);
	bool SkipComment();
	void ReadDirective();
	bool ReadLineDirective(std::string_view Line);
	void ReadString();
	void ReadSign();
	size_t MeasureNumber() const;
	size_t MeasureExponent(size_t From) const;

	const std::string_view Text;
	std::vector<std::string>& Files;
	std::vector<FDiagnostic>& Errors;
	std::unordered_map<std::string_view, uint32_t> FileIndices; // views of Text and of the caller's path
	std::vector<FToken> Tokens;
	size_t At = 0;
	FPlace Place;       // of PlaceAt
	size_t PlaceAt = 0; // places are counted as they are asked for, always forwards
	size_t LastEnd = std::string_view::npos;
	bool bLineStart = true;
};

uint32_t FLexer::FindFile(std::string_view Name)
{
	const auto [Found, bNew] = FileIndices.try_emplace(Name, uint32_t(Files.size()));
	if (bNew)
	{
		Files.emplace_back(Name);
	}
	return Found->second;
}

/** The place of a character in this line. */
FPlace FLexer::GetPlace(size_t Where)
{
	for (; PlaceAt < Where; ++PlaceAt)
	{
		Place.Column += (uint8_t(Text[PlaceAt]) & 0xc0) != 0x80; // bytes that go on with a character count nothing
	}
	return Place;
}

void FLexer::StartLine(int32_t Line)
{
	Place.Line = Line;
	Place.Column = 1;
	PlaceAt = At;
	bLineStart = true;
}

void FLexer::Report(size_t Where, const std::string& Message)
{
	if (Errors.size() < MaxErrors)
	{
		Errors.push_back(MakeError(Files, GetPlace(Where), Message));
	}
}

void FLexer::Add(EToken Kind, size_t Size)
{
	Tokens.push_back({Kind, At == LastEnd, Text.substr(At, Size), GetPlace(At)});
	At += Size;
	LastEnd = At;
}

/** Comments do not occur in a preprocessed text; they are blanks. */
bool FLexer::SkipComment()
{
	if (Peek() != '/' || (Peek(1) != '/' && Peek(1) != '*'))
	{
		return false;
	}
	if (Peek(1) == '/')
	{
		At = std::min(Text.find('\n', At), Text.size());
		return true;
	}
	const size_t Start = At;
	for (At += 2; At < Text.size() && !(Peek() == '*' && Peek(1) == '/'); ++At)
	{
		if (Peek() == '\n')
		{
			++At;
			StartLine(Place.Line + 1);
			--At;
		}
	}
	if (At >= Text.size())
	{
		Report(std::max(Start, PlaceAt), "X3000: syntax error: unexpected end of file; expected '*/' of the comment");
	}
	At = std::min(At + 2, Text.size());
	return true;
}

/** `line 12 "File"`: the next line is that. */
bool FLexer::ReadLineDirective(std::string_view Line)
{
	size_t Where = Line.find_first_not_of(" \t", 4);
	int64_t Number = 0;
	const size_t First = Where;
	while (Where < Line.size() && IsLexerDigit(Line[Where]) && Number < INT32_MAX / 2)
	{
		Number = Number * 10 + (Line[Where++] - '0');
	}
	if (Where == First || Number >= INT32_MAX / 2)
	{
		return false;
	}
	const size_t Open = Line.find('"', Where);
	if (Open != std::string_view::npos)
	{
		const size_t Close = Line.rfind('"');
		if (Close == Open)
		{
			return false;
		}
		Place.File = FindFile(Line.substr(Open + 1, Close - Open - 1));
	}
	Place.Line = int32_t(Number) - 1; // the end of this line counts it up
	return true;
}

void FLexer::ReadDirective()
{
	size_t Size = std::min(Text.find('\n', At), Text.size()) - At;
	while (Size > 0 && IsLexerBlank(Text[At + Size - 1]))
	{
		--Size;
	}
	const size_t NameAt = std::min(Text.find_first_not_of(" \t", At + 1), Text.size());
	const std::string_view Name = PeekWord(NameAt);
	if (Name == "pragma")
	{
		Add(EToken::Pragma, Size);
		return;
	}
	const size_t End = At + Size;
	if (Name == "line" && NameAt < End)
	{
		if (!ReadLineDirective(Text.substr(NameAt, End - NameAt)))
		{
			Report(At, "X3000: syntax error: expected #line and a number, then perhaps \"the file\"");
		}
	}
	else
	{
		Report(At, "X1506: unexpected directive '#" + std::string(Name.substr(0, 40)) +
					   "'; the text is preprocessed already, and only #line and #pragma are read here");
	}
	At = End;
}

void FLexer::ReadString()
{
	const char Quote = Peek();
	size_t Size = 1;
	while (At + Size < Text.size() && Peek(Size) != Quote && Peek(Size) != '\n')
	{
		Size += Peek(Size) == '\\' && Peek(Size + 1) != '\n' ? 2 : 1;
	}
	Size = std::min(Size, Text.size() - At);
	const bool bClosed = Peek(Size) == Quote;
	if (!bClosed)
	{
		Report(At, "X3000: syntax error: expected '" + std::string(1, Quote) + "' at the end of the " +
					   (Quote == '\'' ? "character" : "string"));
	}
	Add(Quote == '\'' ? EToken::Number : EToken::String, bClosed ? Size + 1 : Size);
}

/** The size of e10 or E-5; 0 where there is none. */
size_t FLexer::MeasureExponent(size_t From) const
{
	if (From >= Text.size() || (Text[From] != 'e' && Text[From] != 'E'))
	{
		return 0;
	}
	size_t End = From + 1;
	if (End < Text.size() && (Text[End] == '+' || Text[End] == '-'))
	{
		++End;
	}
	const size_t Digits = End;
	while (End < Text.size() && IsLexerDigit(Text[End]))
	{
		++End;
	}
	return End > Digits ? End - From : 0;
}

/** A number with the letters behind it. `1.xxx` is a 1 with a swizzle, and so is `1.f.xx`. */
size_t FLexer::MeasureNumber() const
{
	size_t End = At;
	const auto SkipDigits = [&]
	{
		while (End < Text.size() && IsLexerDigit(Text[End]))
		{
			++End;
		}
	};
	if (Peek() == '0' && (Peek(1) == 'x' || Peek(1) == 'X'))
	{
		return PeekWord(At).size();
	}
	SkipDigits();
	if (End < Text.size() && Text[End] == '.')
	{
		if (Text.substr(End + 1, 4) == "#INF")
		{
			return End + 5 - At + PeekWord(End + 5).size();
		}
		const std::string_view Word = PeekWord(End + 1);
		if (!Word.empty() && !IsLexerDigit(Word[0]) && !IsLexerSuffix(Word) && MeasureExponent(End + 1) == 0)
		{
			return End - At;
		}
		++End;
		SkipDigits();
	}
	End += MeasureExponent(End);
	return End - At + PeekWord(End).size();
}

void FLexer::ReadSign()
{
	const char c = Peek();
	if (std::string_view("+-*/%=<>!&|^~?:;,.()[]{}").find(c) == std::string_view::npos || c == '\0')
	{
		const bool bPrintable = c > ' ' && c < 0x7f;
		Report(At, "X3000: syntax error: unexpected character " +
					   (bPrintable ? "'" + std::string(1, c) + "'" : std::to_string(uint8_t(c))));
		while (At < Text.size() && (Text[At] == c || (uint8_t(Text[At]) & 0x80) != 0))
		{
			++At;
		}
		return;
	}
	for (const std::string_view Sign : LexerSigns)
	{
		if (Sign[0] == c && Text.substr(At, Sign.size()) == Sign)
		{
			Add(EToken::Sign, Sign.size());
			return;
		}
	}
	Add(EToken::Sign, 1);
}

std::vector<FToken> FLexer::Read()
{
	while (At < Text.size())
	{
		const char c = Peek();
		if (c == '\n')
		{
			++At;
			StartLine(Place.Line + 1);
		}
		else if (IsLexerBlank(c) || (c == '\\' && (Peek(1) == '\n' || Peek(1) == '\r')))
		{
			++At;
		}
		else if (SkipComment())
		{
		}
		else if (c == '#' && bLineStart)
		{
			ReadDirective();
		}
		else
		{
			bLineStart = false;
			if (IsLexerDigit(c) || (c == '.' && IsLexerDigit(Peek(1))))
			{
				Add(EToken::Number, MeasureNumber());
			}
			else if (IsLexerWord(c))
			{
				Add(EToken::Word, PeekWord(At).size());
			}
			else if (c == '"' || c == '\'')
			{
				ReadString();
			}
			else
			{
				ReadSign();
			}
		}
	}
	Add(EToken::End, 0);
	return std::move(Tokens);
}

} // namespace

std::vector<FToken> ReadTokens(const std::string& Text, const std::string& VirtualPath, std::vector<std::string>& Files,
	std::vector<FDiagnostic>& Errors)
{
	return FLexer(Text, VirtualPath, Files, Errors).Read();
}

FDiagnostic MakeError(const std::vector<std::string>& Files, const FPlace& Place, const std::string& Message)
{
	return {ESeverity::Error, 6010, Message, Place.File < Files.size() ? Files[Place.File] : std::string(), Place.Line,
		Place.Column, {}};
}

} // namespace Drydock::Hlsl
