// Finds the calls, with their arguments.
#include "ShaderPrints.h"

#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** From an opening quote to behind the closing one. */
size_t SkipQuoted(const std::string& Text, size_t At)
{
	for (++At; At < Text.size() && Text[At] != '"' && Text[At] != '\n'; ++At)
	{
		At += Text[At] == '\\' ? 1 : 0;
	}
	return std::min(At + 1, Text.size());
}

/** Arguments of a call whose parenthesis opens at Open. End: behind the closing one, or npos where there is none. */
std::vector<std::string> SplitArguments(const std::string& Text, size_t Open, size_t& End)
{
	std::vector<std::string> Arguments(1);
	int Depth = 0;
	for (size_t At = Open; At < Text.size();)
	{
		const char c = Text[At];
		const size_t Next = c == '"' ? SkipQuoted(Text, At) : At + 1;
		const bool bOpens = c == '(' || c == '[' || c == '{';
		const bool bCloses = c == ')' || c == ']' || c == '}';
		Depth += bOpens ? 1 : bCloses ? -1 : 0;
		if (Depth == 0)
		{
			End = Next;
			return Arguments;
		}
		if (c == ',' && Depth == 1)
		{
			Arguments.emplace_back();
		}
		else if (At != Open)
		{
			Arguments.back().append(Text, At, Next - At);
		}
		At = Next;
	}
	End = std::string::npos;
	return {};
}

/** The text between quotes; adjacent literals are one, as in C. */
std::string Unquote(const std::string& Text)
{
	std::string Result;
	for (size_t At = Text.find('"'); At < Text.size();)
	{
		const size_t End = SkipQuoted(Text, At);
		for (size_t i = At + 1; i + 1 < End; ++i)
		{
			const bool bEscape = Text[i] == '\\' && i + 2 < End;
			const char c = bEscape ? Text[++i] : Text[i];
			Result += bEscape && c == 'n' ? '\n' : bEscape && c == 't' ? '\t' : c;
		}
		At = Text.find('"', End);
	}
	return Result;
}

class FPrintRewriter
{
public:
	FPrintRewriter(const std::string& InText, bool bInKeep, std::vector<std::string>& OutStrings)
		: Text(InText)
		, bKeep(bInKeep)
		, Strings(OutStrings)
	{
	}

	std::string Run()
	{
		std::string Result;
		size_t At = 0;
		while (At < Text.size())
		{
			if (Text[At] == '"')
			{
				const size_t End = SkipQuoted(Text, At);
				Result.append(Text, At, End - At);
				At = End;
				continue;
			}
			size_t End = At;
			while (End < Text.size() && IsWordCharacter(Text[End]))
			{
				++End;
			}
			const std::string Word = Text.substr(At, End - At);
			const size_t Open = Text.find_first_not_of(" \t\n", End);
			const bool bOurs = Word == "DrydockPrint" || Word == "DrydockAssert" || Word == "DrydockText";
			size_t Behind = std::string::npos;
			if (bOurs && Open < Text.size() && Text[Open] == '(')
			{
				const std::vector<std::string> Arguments = SplitArguments(Text, Open, Behind);
				const bool bDeclared =
					Word == "DrydockText" && Behind != std::string::npos && Arguments[0].find('"') == std::string::npos;
				Behind = bDeclared ? std::string::npos : Behind; // ShaderPrint.ush's own
				if (Behind != std::string::npos)
				{
					Result += Rewrite(Word, Arguments);
					AddLines(At, Behind, Result);
				}
			}
			if (Behind != std::string::npos)
			{
				At = Behind;
				continue;
			}
			End = std::max(End, At + 1);
			Result.append(Text, At, End - At);
			At = End;
		}
		return Result;
	}

private:
	std::string AddString(std::string String)
	{
		Strings.push_back(std::move(String));
		return std::to_string(Strings.size() - 1) + "u";
	}

	/** The newlines of what was replaced, so that what follows stays on its line. */
	void AddLines(size_t Begin, size_t End, std::string& Result) const
	{
		const auto From = Text.begin();
		Result.append(size_t(std::count(From + std::ptrdiff_t(Begin), From + std::ptrdiff_t(End), '\n')), '\n');
	}

	std::string Rewrite(const std::string& Word, const std::vector<std::string>& Arguments)
	{
		if (Word == "DrydockText")
		{
			return "DrydockText(" + AddString(Unquote(Arguments[0])) + ")";
		}
		if (!bKeep)
		{
			return {};
		}
		if (Word == "DrydockAssert")
		{
			std::string Condition = JoinText(Arguments, ",");
			Condition = Trim(Condition);
			std::replace(Condition.begin(), Condition.end(), '\n', ' ');
			return "DrydockAssertValue(" + AddString(Condition) + ", (" + Condition + "))";
		}
		std::string Calls;
		for (size_t i = 0; i < Arguments.size(); ++i)
		{
			std::string Argument = Trim(Arguments[i]);
			std::replace(Argument.begin(), Argument.end(), '\n', ' ');
			const bool bText = !Argument.empty() && Argument[0] == '"';
			Calls += bText              ? "DrydockPrintText(" + AddString(Unquote(Argument)) + "); "
					 : Argument.empty() ? std::string()
										: "DrydockPrintValue(" + Argument + "); ";
		}
		return "do { " + Calls + "DrydockPrintEnd(); } while (false)"; // one statement, before an else as well
	}

	const std::string& Text;
	const bool bKeep;
	std::vector<std::string>& Strings;
};

} // namespace

std::string RewritePrints(const std::string& Text, bool bKeep, std::vector<std::string>& Strings)
{
	return FPrintRewriter(Text, bKeep, Strings).Run();
}

std::string DeclarePrints(const std::string& Rewritten)
{
	std::string Declared;
	if (Rewritten.find("DrydockAssertValue(") != std::string::npos)
	{
		Declared += "void DrydockAssertValue(uint Text, bool Condition) {} ";
	}
	if (Rewritten.find("DrydockPrintEnd(") != std::string::npos)
	{
		Declared += "void DrydockPrintText(uint Text) {} void DrydockPrintEnd() {} ";
		for (const char* Scalar : {"float", "int", "uint", "bool"})
		{
			for (const char* Size : {"", "2", "3", "4"})
			{
				Declared += std::string("void DrydockPrintValue(") + Scalar + Size + " Value) {} ";
			}
		}
		Declared += "void DrydockPrintValue(float2x2 Value) {} void DrydockPrintValue(float3x3 Value) {} "
					"void DrydockPrintValue(float4x4 Value) {} ";
	}
	return Declared.empty() ? Declared : Declared + "\n";
}

} // namespace Drydock
