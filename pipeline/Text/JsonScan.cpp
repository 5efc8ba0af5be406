// Finds the places of keys and values, and numbers that overflow. Source of the token shapes: RFC 8259.
#include "Text/JsonScan.h"

#include "RangeTools.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace Drydock
{

namespace
{

bool IsNonFiniteNumber(const std::string& Token)
{
	const size_t Sign = Token[0] == '-' || Token[0] == '+' ? 1 : 0;
	const std::string Unsigned = Token.substr(Sign);
	if (Contains(std::array{"NaN", "nan", "NAN", "Infinity", "infinity", "INFINITY", "Inf", "inf", "INF"}, Unsigned))
	{
		return true;
	}
	if (Unsigned.empty() || !std::isdigit(static_cast<unsigned char>(Unsigned[0])) ||
		Unsigned.find_first_of("xXpP") != std::string::npos)
	{
		return false;
	}
	char* End = nullptr;
	const double Number = std::strtod(Token.c_str(), &End);
	return End == Token.c_str() + Token.size() && std::isinf(Number);
}

} // namespace

bool IsBareCharacter(char Character)
{
	return Character != '\0' &&
		   (std::isalnum(static_cast<unsigned char>(Character)) || std::strchr("+-._", Character) != nullptr);
}

size_t SkipString(const std::string& Text, size_t Begin)
{
	size_t At = Begin + 1;
	while (At < Text.size() && Text[At] != '"' && Text[At] != '\n')
	{
		At += Text[At] == '\\' ? 2 : 1;
	}
	return std::min(At + 1, Text.size());
}

size_t SkipComment(const std::string& Text, size_t Begin)
{
	if (Text.compare(Begin, 2, "//") == 0)
	{
		return std::min(Text.find('\n', Begin), Text.size());
	}
	if (Text.compare(Begin, 2, "/*") == 0)
	{
		const size_t End = Text.find("*/", Begin + 2);
		return End == std::string::npos ? Text.size() : End + 2;
	}
	return Begin;
}

FJsonScan ScanJson(const std::string& Text, size_t MaxTokens)
{
	FJsonScan Scan;
	Scan.Text = Text;
	for (size_t At = 0; At < Text.size() && Scan.Tokens.size() < MaxTokens;)
	{
		const char Character = Text[At];
		if (Character == '"')
		{
			Scan.Tokens.push_back({At, false});
			At = SkipString(Text, At);
		}
		else if (Character == '{' || Character == '[')
		{
			Scan.Tokens.push_back({At++, false});
		}
		else if (IsBareCharacter(Character))
		{
			size_t End = At;
			while (End < Text.size() && IsBareCharacter(Text[End]))
			{
				++End;
			}
			const bool bNotFinite = IsNonFiniteNumber(Text.substr(At, End - At));
			Scan.Tokens.push_back({At, bNotFinite});
			if (bNotFinite)
			{
				std::fill(Scan.Text.begin() + At, Scan.Text.begin() + End, ' ');
				Scan.Text[At] = '0';
			}
			At = End;
		}
		else
		{
			At = std::max(At + 1, SkipComment(Text, At));
		}
	}
	return Scan;
}

} // namespace Drydock
