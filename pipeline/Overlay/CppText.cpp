// Finds names, brackets and definitions in text of C++.
#include "Overlay/CppText.h"

#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** The place after the comment, the string or the character that begins at At; At itself where none begins. */
size_t SkipHidden(std::string_view Text, size_t At)
{
	const std::string_view Rest = Text.substr(At);
	if (Rest.starts_with("//"))
	{
		return std::min(Text.find('\n', At), Text.size());
	}
	if (Rest.starts_with("/*"))
	{
		const size_t End = Text.find("*/", At + 2);
		return End == Text.npos ? Text.size() : End + 2;
	}
	const char Quote = Text[At];
	// Between digits ' parts a number.
	if (Quote != '"' && (Quote != '\'' || (At > 0 && IsWordCharacter(Text[At - 1]))))
	{
		return At;
	}
	for (size_t End = At + 1; End < Text.size() && Text[End] != '\n'; ++End)
	{
		if (Text[End] == '\\')
		{
			++End;
		}
		else if (Text[End] == Quote)
		{
			return End + 1;
		}
	}
	return At;
}

} // namespace

std::string BlankComments(std::string_view Text)
{
	std::string Blanked(Text);
	for (size_t At = 0; At < Text.size();)
	{
		const size_t End = SkipHidden(Text, At);
		for (size_t Place = At; Place < End; ++Place)
		{
			Blanked[Place] = Text[Place] == '\n' ? '\n' : ' ';
		}
		At = std::max(End, At + 1);
	}
	return Blanked;
}

std::vector<size_t> FindWord(std::string_view Text, std::string_view Name)
{
	std::vector<size_t> Places;
	for (size_t At = Text.find(Name); At != Text.npos; At = Text.find(Name, At + Name.size()))
	{
		const size_t End = At + Name.size();
		if ((At == 0 || !IsWordCharacter(Text[At - 1])) && (End == Text.size() || !IsWordCharacter(Text[End])))
		{
			Places.push_back(At);
		}
	}
	return Places;
}

std::optional<size_t> FindClosing(std::string_view Text, size_t Open)
{
	std::string Closing;
	for (size_t At = Open; At < Text.size(); ++At)
	{
		const char Character = Text[At];
		if (Character == '(' || Character == '{' || Character == '[')
		{
			Closing += Character == '(' ? ')' : Character == '{' ? '}' : ']';
		}
		else if (!Closing.empty() && Character == Closing.back())
		{
			Closing.pop_back();
			if (Closing.empty())
			{
				return At + 1;
			}
		}
	}
	return std::nullopt;
}

std::optional<size_t> FindDefinition(std::string_view Text, std::string_view Name)
{
	const size_t Scope = Name.rfind("::");
	const std::string_view Plain = Scope == Name.npos ? Name : Name.substr(Scope + 2);
	if (Scope != Name.npos && FindWord(Text, Name.substr(0, Scope)).empty())
	{
		return std::nullopt;
	}
	for (const size_t At : FindWord(Text, Plain))
	{
		const size_t Open = SkipBlanks(Text, At + Plain.size());
		const std::optional<size_t> End =
			Open < Text.size() && Text[Open] == '(' ? FindClosing(Text, Open) : std::nullopt;
		const size_t Body = End ? SkipBlanks(Text, *End) : Text.size();
		if (Body < Text.size() && Text[Body] == '{')
		{
			return At;
		}
	}
	return std::nullopt;
}

int GetLineOf(std::string_view Text, size_t Place)
{
	return static_cast<int>(std::count(Text.begin(), Text.begin() + static_cast<std::ptrdiff_t>(Place), '\n')) + 1;
}

size_t SkipBlanks(std::string_view Text, size_t At)
{
	return std::min(Text.find_first_not_of(" \t\r\n", At), Text.size());
}

} // namespace Drydock
