// Rewrites words of a preprocessed shader.
#include "ShaderRewrites.h"

#include "TextTools.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

/** Goes through a text word by word; what lies between is skipped. */
class FWords
{
public:
	explicit FWords(const std::string& InText)
		: Text(InText)
	{
	}

	/** False at the end. The word lies from Begin to End. */
	bool Next()
	{
		Begin = End;
		while (Begin < Text.size() && !IsWordCharacter(Text[Begin]))
		{
			const char c = Text[Begin];
			const bool bComment =
				c == '/' && Begin + 1 < Text.size() && (Text[Begin + 1] == '/' || Text[Begin + 1] == '*');
			if (bComment)
			{
				const bool bBlock = Text[Begin + 1] == '*';
				const size_t Close = Text.find(bBlock ? "*/" : "\n", Begin + 2);
				Begin = Close == std::string::npos ? Text.size() : Close + (bBlock ? 2 : 0);
			}
			else if (c == '"')
			{
				const size_t Close = Text.find_first_of("\"\n", Begin + 1);
				Begin = Close == std::string::npos ? Text.size() : Close + (Text[Close] == '"');
			}
			else
			{
				++Begin;
			}
		}
		End = Begin;
		while (End < Text.size() && IsWordCharacter(Text[End]))
		{
			++End;
		}
		return Begin < Text.size();
	}

	std::string Get() const { return Text.substr(Begin, End - Begin); }

	/** The first character from From on that is not a blank. */
	size_t SkipBlanks(size_t From) const { return std::min(Text.find_first_not_of(" \t\n", From), Text.size()); }
	char Behind() const
	{
		const size_t At = SkipBlanks(End);
		return At < Text.size() ? Text[At] : '\0';
	}
	/** The last character before the word that is not a blank. */
	char Before() const
	{
		const size_t At = Begin == 0 ? std::string::npos : Text.find_last_not_of(" \t\n", Begin - 1);
		return At == std::string::npos ? '\0' : Text[At];
	}

	const std::string& Text;
	size_t Begin = 0;
	size_t End = 0;
};

/** Whether the text has a variable, parameter or type of this name: "FParams View;". */
bool Declares(const std::string& Text, const std::string& Name)
{
	static const std::set<std::string> NoTypes = {"cbuffer", "tbuffer", "return", "else", "do", "case", "in", "out"};
	FWords Words(Text);
	std::string Last;
	size_t LastEnd = 0;
	while (Words.Next())
	{
		const std::string Word = Words.Get();
		const bool bAdjacent = Words.SkipBlanks(LastEnd) == Words.Begin && Words.Begin > LastEnd;
		const bool bTyped =
			bAdjacent && !Last.empty() && IsWordCharacter(Last.back()) && !NoTypes.count(Last) && !IsDigit(Last[0]);
		if (Word == Name && bTyped && Words.Behind() != '.')
		{
			return true;
		}
		Last = Word;
		LastEnd = Words.End;
	}
	return false;
}

struct FEnum
{
	std::string Type = "int";
	bool bScoped = false;
};

/** Reads enums, replaces them by constants, and remembers them. */
class FEnumRewriter
{
public:
	std::string Run(const std::string& Text) { return ReplaceUses(ReplaceDeclarations(Text)); }

private:
	std::string ReplaceDeclarations(const std::string& Text)
	{
		std::string Result;
		FWords Words(Text);
		size_t Copied = 0;
		while (Words.Next())
		{
			const size_t Start = Words.Begin;
			FEnum Enum;
			std::string Name;
			if (Words.Get() != "enum" || !ReadHead(Words, Name, Enum))
			{
				continue;
			}
			const size_t Close = Text.find('}', Words.End);
			if (Close == std::string::npos)
			{
				break;
			}
			Result.append(Text, Copied, Start - Copied);
			Result += MakeConstants(Text.substr(Words.End + 1, Close - Words.End - 1), Name, Enum);
			const size_t Behind = Words.SkipBlanks(Close + 1);
			const bool bEnds = Behind < Text.size() && Text[Behind] == ';';
			Copied = bEnds ? Behind + 1 : Close + 1;
			Result += bEnds ? "" : " " + Enum.Type; // enum { ... } Variable;
			Result.append(
				size_t(std::count(Text.begin() + std::ptrdiff_t(Start), Text.begin() + std::ptrdiff_t(Copied), '\n')),
				'\n');
			Words.End = Copied;
			if (!Name.empty())
			{
				Enums[Name] = Enum;
			}
		}
		Result.append(Text, Copied, std::string::npos);
		return Result;
	}

	/** Up to the opening brace, at which Words then ends; false if this is not a definition. */
	bool ReadHead(FWords& Words, std::string& Name, FEnum& Enum)
	{
		FWords Head = Words;
		size_t Brace = Head.SkipBlanks(Head.End);
		bool bType = false;
		while (Brace < Head.Text.size() && Head.Text[Brace] != '{')
		{
			if (Head.Text[Brace] == ':')
			{
				bType = true;
				Brace = Head.SkipBlanks(Brace + 1);
				continue;
			}
			if (!IsWordCharacter(Head.Text[Brace]))
			{
				return false;
			}
			Head.End = Brace;
			Head.Next();
			const std::string Word = Head.Get();
			Enum.bScoped = Enum.bScoped || (!bType && (Word == "class" || Word == "struct"));
			Enum.Type = bType ? (Word[0] == 'u' ? "uint" : "int") : Enum.Type;
			Name = bType || Word == "class" || Word == "struct" ? Name : Word;
			Brace = Head.SkipBlanks(Head.End);
		}
		Words.End = Brace;
		return Brace < Head.Text.size();
	}

	/** "A, B = 4" -> "static const int A = 0; static const int B = 4;", in one line. */
	std::string MakeConstants(std::string List, const std::string& Name, const FEnum& Enum)
	{
		std::replace(List.begin(), List.end(), '\n', ' ');
		const std::string Prefix = Enum.bScoped ? Name + "_" : std::string();
		std::string Result;
		std::string Last;
		std::set<std::string> Known;
		for (size_t At = 0; At < List.size();)
		{
			const size_t End = FindElementEnd(List, At);
			const std::string Element = List.substr(At, End - At);
			At = End + 1;
			FWords Words(Element);
			if (!Words.Next())
			{
				continue;
			}
			const std::string Enumerator = Words.Get();
			const size_t Equal = Element.find('=', Words.End);
			std::string Value = Last.empty() ? "0" : Prefix + Last + " + 1";
			if (Equal != std::string::npos)
			{
				Value = QualifySiblings(Element.substr(Equal + 1), Prefix, Known);
			}
			Result += "static const " + Enum.Type + " " + Prefix + Enumerator + " = " + Enum.Type + "(" + Value + "); ";
			Last = Enumerator;
			Known.insert(Enumerator);
		}
		return Result;
	}

	static size_t FindElementEnd(const std::string& List, size_t At)
	{
		int Depth = 0;
		for (; At < List.size() && (Depth > 0 || List[At] != ','); ++At)
		{
			Depth += List[At] == '(' ? 1 : List[At] == ')' ? -1 : 0;
		}
		return At;
	}

	static std::string QualifySiblings(
		const std::string& Value, const std::string& Prefix, const std::set<std::string>& Known)
	{
		std::string Result;
		FWords Words(Value);
		size_t Copied = 0;
		while (Words.Next())
		{
			Result.append(Value, Copied, Words.Begin - Copied);
			const bool bSibling = Known.count(Words.Get()) && Words.Before() != ':';
			Result += (bSibling ? Prefix : "") + Words.Get();
			Copied = Words.End;
		}
		return Result.append(Value, Copied, std::string::npos);
	}

	std::string ReplaceUses(const std::string& Text)
	{
		if (Enums.empty())
		{
			return Text;
		}
		std::string Result;
		FWords Words(Text);
		size_t Copied = 0;
		while (Words.Next())
		{
			const auto Enum = Enums.find(Words.Get());
			if (Enum == Enums.end() || Words.Before() == '.')
			{
				continue;
			}
			Result.append(Text, Copied, Words.Begin - Copied);
			const size_t Colons = Words.SkipBlanks(Words.End);
			const bool bQualified = Text.compare(Colons, 2, "::") == 0;
			Result += !bQualified ? Enum->second.Type : Enum->second.bScoped ? Enum->first + "_" : std::string();
			Copied = bQualified ? Words.SkipBlanks(Colons + 2) : Words.End;
			Words.End = Copied;
		}
		return Result.append(Text, Copied, std::string::npos);
	}

	std::map<std::string, FEnum> Enums;
};

} // namespace

std::string RewriteUniformBuffers(
	const std::string& Text, const std::vector<FShaderUniformBuffer>& Buffers, std::set<std::string>& Used)
{
	std::map<std::string, const FShaderUniformBuffer*> ByName;
	std::map<std::string, bool> bOwn; // the text declares the name itself; looked up when it matters
	for (const FShaderUniformBuffer& Buffer : Buffers)
	{
		ByName.emplace(Buffer.Name, &Buffer);
	}
	std::string Result;
	Result.reserve(Text.size() + Text.size() / 64);
	FWords Words(Text);
	size_t Copied = 0;
	while (Words.Next())
	{
		const auto Buffer = ByName.find(Words.Get());
		if (Buffer == ByName.end() || Words.Before() == '.' ||
			Words.Behind() != '.') // In.View.X is a struct's own member
		{
			continue;
		}
		const size_t Begin = Words.SkipBlanks(Words.SkipBlanks(Words.End) + 1);
		size_t End = Begin;
		while (End < Text.size() && IsWordCharacter(Text[End]))
		{
			++End;
		}
		const std::string Member = Text.substr(Begin, End - Begin);
		const std::vector<std::string>& Members = Buffer->second->Members;
		if (std::find(Members.begin(), Members.end(), Member) == Members.end())
		{
			const auto Known = bOwn.find(Buffer->first);
			const bool bDeclared =
				Known != bOwn.end() ? Known->second : (bOwn[Buffer->first] = Declares(Text, Buffer->first));
			if (bDeclared)
			{
				continue;
			}
		}
		Result.append(Text, Copied, Words.End - Copied);
		Result += "_" + Member;
		Result.append(
			size_t(std::count(Text.begin() + std::ptrdiff_t(Words.End), Text.begin() + std::ptrdiff_t(End), '\n')),
			'\n');
		Copied = End;
		Words.End = End;
		Used.insert(Buffer->first);
	}
	return Result.append(Text, Copied, std::string::npos);
}

std::string DeclareUniformBuffers(const std::string& Text, const std::vector<FShaderUniformBuffer>& Buffers)
{
	std::set<std::string> Used;
	const std::string Rewritten = RewriteUniformBuffers(Text, Buffers, Used);
	std::string Declarations;
	for (const FShaderUniformBuffer& Buffer : Buffers)
	{
		Declarations += Used.erase(Buffer.Name) ? Buffer.Declaration : std::string();
	}
	return (Declarations.empty() ? std::string()
								 : "#line 1 \"/Engine/Generated/GeneratedUniformBuffers.ush\"\n" + Declarations) +
		   Rewritten;
}

std::string RewriteEnums(const std::string& Text)
{
	return FEnumRewriter().Run(Text);
}

std::string RewriteLoads(const std::string& Text)
{
	std::set<std::string> Textures;
	FWords Declarations(Text);
	while (Declarations.Next())
	{
		if (Declarations.Get() != "RWTexture2D")
		{
			continue;
		}
		const size_t Open = Declarations.SkipBlanks(Declarations.End);
		const size_t Close = Open < Text.size() && Text[Open] == '<' ? Text.find('>', Open) : Open - 1;
		Declarations.End = Close == std::string::npos ? Declarations.End : Close + 1;
		if (Declarations.Next())
		{
			Textures.insert(Declarations.Get());
		}
	}
	std::string Result;
	FWords Words(Text);
	size_t Copied = 0;
	while (!Textures.empty() && Words.Next())
	{
		const size_t Dot = Words.SkipBlanks(Words.End);
		if (!Textures.count(Words.Get()) || Words.Before() == '.' || Text.compare(Dot, 5, ".Load") != 0)
		{
			continue;
		}
		const size_t Open = Words.SkipBlanks(Dot + 5);
		int NumOpen = 0;
		int NumCommas = 0;
		size_t Close = Open;
		for (; Close < Text.size() && Text[Open] == '('; ++Close)
		{
			NumOpen += Text[Close] == '(' ? 1 : Text[Close] == ')' ? -1 : 0;
			NumCommas += NumOpen == 1 && Text[Close] == ',' ? 1 : 0;
			if (NumOpen == 0)
			{
				break;
			}
		}
		if (Close > Open && Close < Text.size() && NumCommas == 0)
		{
			Result.append(Text, Copied, Open + 1 - Copied);
			Result += "(int2)(" + Text.substr(Open + 1, Close - Open - 1) + ")";
			Copied = Close;
			Words.End = Close;
		}
	}
	return Result.append(Text, Copied, std::string::npos);
}

} // namespace Drydock
