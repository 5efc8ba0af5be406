// Reads "TYPE<...> A : register(u0), B" word by word, and lines with their #line directives.
#include "SpirvDeclaration.h"

#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace Drydock
{

namespace
{

/** A place in a text; at its end every look sees 0. */
struct FTextPlace
{
	const std::string& Text;
	size_t At;

	char Look() const { return At < Text.size() ? Text[At] : '\0'; }
	void SkipSpace() { At = std::min(Text.find_first_not_of(" \t\n", At), Text.size()); }

	std::string ReadWord()
	{
		SkipSpace();
		const size_t First = At;
		while (IsWordCharacter(Look()))
		{
			++At;
		}
		const std::string Word = Text.substr(First, At - First);
		SkipSpace();
		return Word;
	}

	/** Behind the sign that closes the one here. */
	void SkipPair(char Open, char Close)
	{
		int Depth = 0;
		do
		{
			Depth += Look() == Open ? 1 : Look() == Close ? -1 : 0;
			++At;
		} while (Depth > 0 && At < Text.size());
		SkipSpace();
	}
};

} // namespace

bool IsDeclaredAs(const std::string& Text, const std::string& Type, const std::string& Name)
{
	for (size_t Found = Text.find(Type); Found != std::string::npos; Found = Text.find(Type, Found + 1))
	{
		FTextPlace Place{Text, Found + Type.size()};
		if ((Found > 0 && IsWordCharacter(Text[Found - 1])) || IsWordCharacter(Place.Look()))
		{
			continue;
		}
		Place.SkipSpace();
		if (Place.Look() == '<')
		{
			Place.SkipPair('<', '>');
		}
		for (bool bMore = true; bMore; ++Place.At)
		{
			if (Place.ReadWord() == Name)
			{
				return true;
			}
			if (Place.Look() == ':') // : register(u0)
			{
				++Place.At;
				Place.ReadWord();
				Place.SkipPair('(', ')');
			}
			bMore = Place.Look() == ',';
		}
	}
	return false;
}

FTextLine FindSemantic(const std::string& Text, const std::string& Name, const std::string& Semantic)
{
	const auto HasSemantic = [&](const std::string& Row)
	{
		for (size_t Found = Row.find(Name); Found != std::string::npos; Found = Row.find(Name, Found + 1))
		{
			FTextPlace Place{Row, Found};
			const bool bWhole = (Found == 0 || !IsWordCharacter(Row[Found - 1])) && Place.ReadWord() == Name;
			if (bWhole && Place.Look() == ':')
			{
				++Place.At;
				const std::string Word = Place.ReadWord();
				const auto Same = [](unsigned char A, unsigned char B)
				{
					return std::toupper(A) == std::toupper(B);
				};
				if (std::equal(Word.begin(), Word.end(), Semantic.begin(), Semantic.end(), Same))
				{
					return true;
				}
			}
		}
		return false;
	};
	FTextLine At{{}, 1};
	for (const std::string& Row : SplitText(Text))
	{
		const size_t Quote = Row.starts_with("#line ") ? Row.find('"') : std::string::npos;
		if (Quote != std::string::npos)
		{
			At = {Row.substr(Quote + 1, Row.rfind('"') - Quote - 1), std::atoi(Row.c_str() + 6)};
			continue;
		}
		if (HasSemantic(Row))
		{
			return At;
		}
		++At.Line;
	}
	return {};
}

} // namespace Drydock
