// Walks to the place where the parser stopped. Source of what may stand where: RFC 8259.
#include "Text/JsonMistake.h"

#include "Text/JsonScan.h"
#include "TextPositions.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <vector>

namespace Drydock
{

namespace
{

/** The tokens up to a place, the brackets that are open there, and whether a key may stand there. */
class FJsonWalk
{
public:
	FJsonWalk(const std::string& InText, size_t Stopped)
		: Text(InText)
	{
		for (size_t Next = Text.starts_with("\xEF\xBB\xBF") ? 3 : 0; Next < Text.size() && Next <= Stopped;)
		{
			const size_t End = std::max(SkipComment(Text, Next), Next);
			if (std::isspace(static_cast<unsigned char>(Text[Next])) || End > Next)
			{
				Next = std::max(End, Next + 1);
				continue;
			}
			if (At < Text.size())
			{
				Pass();
			}
			At = Next;
			Next = GetTokenEnd(Next);
		}
		if (Stopped >= Text.size())
		{
			At < Text.size() ? Pass() : void();
			At = Text.size();
		}
	}

	const std::string& Text;
	size_t At = std::string::npos;     // the token at the place; the text's size at its end
	size_t Before = std::string::npos; // the token before it
	std::vector<size_t> Open;          // brackets
	bool bKeyBefore = false;           // the token before is a key

	size_t GetTokenEnd(size_t Begin) const
	{
		size_t End = Begin + 1;
		while (IsBareCharacter(Text[Begin]) && End < Text.size() && IsBareCharacter(Text[End]))
		{
			++End;
		}
		return Text[Begin] == '"' ? SkipString(Text, Begin) : End;
	}
	char GetBefore() const { return Before < Text.size() ? Text[Before] : '\0'; }
	bool IsInObject() const { return !Open.empty() && Text[Open.back()] == '{'; }
	bool IsKeyPlace() const { return IsInObject() && (GetBefore() == '{' || GetBefore() == ','); }
	std::string GetLine(size_t Offset) const { return std::to_string(FTextPositions(Text).Find(Offset).Line); }

private:
	void Pass()
	{
		bKeyBefore = Text[At] == '"' && IsKeyPlace();
		if (Text[At] == '{' || Text[At] == '[')
		{
			Open.push_back(At);
		}
		else if ((Text[At] == '}' || Text[At] == ']') && !Open.empty())
		{
			Open.pop_back();
		}
		Before = At;
	}
};

std::string DescribeString(const std::string& Token)
{
	for (size_t At = 1; At < Token.size(); ++At)
	{
		if (Token[At] == '\\' && std::strchr("\"\\/bfnrtu", At + 1 < Token.size() ? Token[At + 1] : ' ') == nullptr)
		{
			return "a backslash stands twice in a text (\\\\); paths take / as well";
		}
		At += Token[At] == '\\' ? 1 : 0;
	}
	return Token.size() < 2 || Token.back() != '"' ? "this text has no closing quotation mark on its line" : "";
}

std::string DescribeBareWord(const std::string& Word, bool bKey)
{
	std::string Lower = Word;
	std::ranges::transform(Lower, Lower.begin(), [](unsigned char C) { return static_cast<char>(std::tolower(C)); });
	const bool bNumber = std::isdigit(static_cast<unsigned char>(Word[0])) || std::strchr("+-.", Word[0]) != nullptr;
	return bKey                                  ? "a key stands in double quotes: \"" + Word + "\""
		   : bNumber                             ? "this is not a number of JSON, such as -0.5 or 1e3"
		   : Lower == "true" || Lower == "false" ? "write " + Lower
		   : Lower == "null" || Lower == "none"  ? "write null"
												 : "a text stands in double quotes: \"" + Word + "\"";
}

std::string DescribeToken(const FJsonWalk& Walk)
{
	const char Token = Walk.Text[Walk.At];
	const char Before = Walk.GetBefore();
	const std::string Whole = Walk.Text.substr(Walk.At, Walk.GetTokenEnd(Walk.At) - Walk.At);
	const bool bValueBefore = Walk.Before < Walk.Text.size() && std::strchr("{[:,", Before) == nullptr;
	const bool bBegins = std::strchr("\"{[", Token) != nullptr || IsBareCharacter(Token);
	if (Token == '"' && DescribeString(Whole) != "")
	{
		return DescribeString(Whole);
	}
	if (Token == '#')
	{
		return "# does not begin a comment here; write // or /* */";
	}
	if (Token == '\'' || Token == '`' || Whole[0] == '\xE2')
	{
		return "a text stands in straight double quotes: \"...\"";
	}
	if (Walk.bKeyBefore && Token != ':')
	{
		return "a colon is missing between key and value";
	}
	if (bBegins && bValueBefore)
	{
		return Walk.Open.empty() ? "the text goes on behind its last bracket" : "a comma is missing before this";
	}
	if ((Token == '}' || Token == ']') && !Walk.Open.empty() && (Token == '}') != (Walk.Text[Walk.Open.back()] == '{'))
	{
		return std::string(1, Token) + " closes the " + Walk.Text[Walk.Open.back()] + " of line " +
			   Walk.GetLine(Walk.Open.back());
	}
	return IsBareCharacter(Token) ? DescribeBareWord(Whole, Walk.IsKeyPlace())
		   : Token == ','         ? "a comma stands where a value is expected"
								  : "";
}

} // namespace

FJsonMistake DescribeJsonMistake(const std::string& Text, size_t Stopped)
{
	const FJsonWalk Walk(Text, Stopped);
	if (Walk.Before == std::string::npos && Walk.At >= Text.size())
	{
		return {0, "the file is empty; an empty config is {}"};
	}
	if (Walk.At >= Text.size())
	{
		return {Text.size() - 1, Walk.Open.empty()
									 ? ""
									 : std::string("the file ends, and the ") + Text[Walk.Open.back()] + " of line " +
										   Walk.GetLine(Walk.Open.back()) + " is not closed"};
	}
	if ((Text[Walk.At] == '}' || Text[Walk.At] == ']') && Walk.GetBefore() == ',')
	{
		return {Walk.Before, std::string("a comma stands before the closing ") + Text[Walk.At] + "; delete the comma"};
	}
	return {Walk.At, DescribeToken(Walk)};
}

} // namespace Drydock
