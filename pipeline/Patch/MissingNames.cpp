// Recognises the compilers' sentences about unknown names.
#include "Patch/MissingNames.h"

#include "Patch/LogLines.h"
#include "RangeTools.h"
#include "Text/TextTable.h"

#include <algorithm>
#include <regex>

namespace Drydock
{

namespace
{

constexpr size_t MostNameColumns = 48;

struct FSentence
{
	const char* Kind;
	const char* Name; // by the pattern's groups
	const char* Pattern;
};

#define DRYDOCK_TYPE "'(?:const )?(?:class |struct |union |enum )*([^']+)'"

/** The sentences of g++ 12 and clang 14, whose quotes are all '. The first one that fits counts. */
constexpr FSentence Sentences[] = {
	{"base class", "$1", "^no base class '([^']+)'"},
	{"member", "$1::$2", DRYDOCK_TYPE " has no member named '([^']+)'"},
	{"member", "$2::$1", "^'([^']+)' is not a member of " DRYDOCK_TYPE},
	{"member", "$2::$1", "^no (?:member|type) named '([^']+)' in " DRYDOCK_TYPE},
	{"type", "$2::$1", "^'([^']+)' in (?:namespace )?" DRYDOCK_TYPE " does not name a "},
	{"type", "$1", "^'([^']+)' does not name a "},
	{"type", "$1", "^unknown type name '([^']+)'"},
	{"type", "$1", "^no (?:template|type) named '([^']+)'"},
	{"type", "$1", "^'([^']+)' is not a (?:class, namespace, or enumeration|template|type)"},
	{"type", "$1", "(?:invalid use of|member access into) incomplete type " DRYDOCK_TYPE},
	{"type", "$1", "incomplete type " DRYDOCK_TYPE " (?:used|named) in"},
	{"name", "$1", "^'([^']+)' (?:was not declared|has not been declared)"},
	{"name", "$1", "^use of undeclared (?:identifier )?'([^']+)'"},
	{"header", "$1", "^([^ ]+): No such file or directory"},
	{"header", "$1", "^'([^']+)' file not found"},
	{"override", "$1", "^'(?:[^'(]* )?([^' (]+)[(][^']*' marked '(?:override|final)',? but does not override"},
	{"arguments", "$1", "^no matching (?:member )?function for call to '([^']+)'"},
	{"definition", "$1", "^undefined reference to '([^']+)'"},
};

/** The text with the quotes of C for those of other languages, and of the linker. */
std::string MakePlainQuotes(std::string Text)
{
	for (const char* const Quote : {"\u2018", "\u2019", "`"})
	{
		for (size_t At = Text.find(Quote); At != std::string::npos; At = Text.find(Quote, At + 1))
		{
			Text.replace(At, std::string_view(Quote).size(), "'");
		}
	}
	return Text;
}

/** The header taken as empty that has the name by its own name, in a sentence; empty: none. */
std::string FindEmptyHeader(const std::string& Name, const std::vector<std::string>& Notes)
{
	static const std::regex Empty("^there is no (.*/)?([A-Za-z0-9_]+)[.](h|inl) here");
	for (const std::string& Note : Notes)
	{
		std::smatch Match;
		if (std::regex_search(Note, Match, Empty) &&
			std::regex_search(Name, std::regex("(^|::)[A-Z]?" + Match[2].str() + "(::|$)")))
		{
			return Match.format("neither drydock nor the plugin has $1$2.$3");
		}
	}
	return "";
}

} // namespace

std::vector<FMissingName> FindMissingNames(const std::vector<FCompilerMessage>& Errors,
	const std::vector<std::string>& Notes, std::vector<FCompilerMessage>& OutOthers)
{
	static const auto Patterns =
		ToVector<std::regex>(Sentences, [](const FSentence& Item) { return std::regex(Item.Pattern); });
	static const std::regex Nearest("did you mean '([^']+)'");
	std::vector<FMissingName> Names;
	for (const FCompilerMessage& Error : Errors)
	{
		const std::string Text = MakePlainQuotes(CutLine(Error.Text));
		std::smatch Match;
		size_t Index = 0;
		while (Index < Patterns.size() && !std::regex_search(Text, Match, Patterns[Index]))
		{
			++Index;
		}
		if (Index == Patterns.size())
		{
			OutOthers.push_back(Error);
			continue;
		}
		const std::string Name = Match.format(Sentences[Index].Name);
		FMissingName* Known = FindItem(Names, Name, &FMissingName::Name);
		if (Known == nullptr)
		{
			const std::string Place = Error.File + (Error.Line > 0 ? ":" + std::to_string(Error.Line) : "");
			Names.push_back({Name, Sentences[Index].Kind, 0, Place, FindEmptyHeader(Name, Notes)});
			Known = &Names.back();
		}
		++Known->Count;
		std::smatch Suggestion;
		if (Known->Instead.empty() && std::regex_search(Text, Suggestion, Nearest))
		{
			Known->Instead = Suggestion.format("did you mean $1?");
		}
	}
	std::ranges::stable_partition(Names, [](const FMissingName& Name) { return Name.Kind == "base class"; });
	return Names;
}

std::string FormatMissingNames(const std::vector<FMissingName>& Names, const std::string& Indent)
{
	FTextTable Table{{{}, {}, {ETextColumn::Number}, {}, {}}, {{"missing", "kind", "uses", "first place", ""}}};
	for (const FMissingName& Name : Names)
	{
		Table.Rows.push_back({ShortenMiddle(Name.Name, MostNameColumns), Name.Kind, std::to_string(Name.Count),
			Name.Place, Name.Instead});
	}
	return Table.Format(0, Indent);
}

} // namespace Drydock
