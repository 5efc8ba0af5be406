// Reads the lines that errors point at, upwards to the class or the function that they stand in.
#include "Patch/MissingBases.h"

#include "Patch/LogLines.h"
#include "RangeTools.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>

namespace Drydock
{

namespace
{

struct FDeclaredClass
{
	std::string Name;
	std::string Base; // empty: none on that line
};

std::optional<FDeclaredClass> ReadClass(const std::string& Line)
{
	static const std::regex Class("^\\s*(?:class|struct)\\s+(?:\\w+_API\\s+)?(\\w+)\\s*(?:final\\s*)?"
								  "(?::\\s*(?:(?:public|private|protected|virtual)\\s+)*([\\w:]+)|[^;]*$)");
	std::smatch Match;
	const std::string Cut = CutLine(Line);
	return std::regex_search(Cut, Match, Class) ? std::optional(FDeclaredClass{Match[1], Match[2]}) : std::nullopt;
}

/** The class that a line belongs to: of the function that is defined around it, or the one that is declared there. */
FDeclaredClass FindClass(const std::vector<std::string>& Lines, int Number)
{
	static const std::regex Function("^(?:[\\w<>*&:,]+\\s+)*(\\w+)::~?\\w+\\(");
	for (size_t At = std::min(Lines.size(), static_cast<size_t>(std::max(Number, 0))); At > 0; --At)
	{
		const std::string Line = CutLine(Lines[At - 1]);
		std::smatch Match;
		if (const std::optional<FDeclaredClass> Class = ReadClass(Line))
		{
			return *Class;
		}
		if (std::regex_search(Line, Match, Function))
		{
			return {Match[1], ""};
		}
	}
	return {};
}

bool IsGenerated(const std::string& File)
{
	return File.ends_with(".generated.h") || File.ends_with(".gen.cpp");
}

/** Whether a sentence may follow from a base class of Class that lacks. */
bool MayFollow(const FCompilerMessage& Error, const std::string& Class)
{
	static const std::regex Undeclared(
		"(?:only virtual member|was not declared|has not been declared|use of undeclared identifier|does not "
		"override|non-virtual member "
		"function marked|cannot convert|cannot initialize|invalid new-expression|expected primary-expression)");
	static const std::regex EngineType("^\\W*(?:use of undeclared identifier \\W*)?[UAFTESI][A-Z]\\w*[a-z]");
	const std::string Text = CutLine(Error.Text);
	return Text.find(Class) != Text.npos ||
		   (std::regex_search(Text, Undeclared) && !std::regex_search(Text, EngineType));
}

} // namespace

void NameMissingBases(
	std::vector<FCompilerMessage>& Errors, const FLineReader& ReadLines, std::vector<FCompilerMessage>& OutFollowing)
{
	static const std::regex NoBase("^(?:expected class-name before|expected class name|unknown class name)");
	std::map<std::string, std::vector<std::string>> Files;
	const auto FindClassOf = [&](const FCompilerMessage& Error)
	{
		if (!Files.contains(Error.File))
		{
			Files[Error.File] = ReadLines(Error.File);
		}
		return FindClass(Files[Error.File], Error.Line);
	};
	std::vector<std::string> Classes; // whose base lacks
	std::vector<std::string> Bases;
	for (FCompilerMessage& Error : Errors)
	{
		const std::string Text = CutLine(Error.Text);
		const FDeclaredClass Class = std::regex_search(Text, NoBase) ? FindClassOf(Error) : FDeclaredClass();
		if (!Class.Base.empty())
		{
			Error.Text = "no base class '" + Class.Base + "'";
			AddUnique(Classes, Class.Name);
			AddUnique(Bases, Class.Base);
		}
	}
	const auto Follows = [&](const FCompilerMessage& Error)
	{
		if (Error.Text.starts_with("no base class '"))
		{
			return false;
		}
		if (IsGenerated(Error.File))
		{
			return !Classes.empty();
		}
		const std::string Class = Error.File.empty() ? "" : FindClassOf(Error).Name;
		return Contains(Classes, Class) && MayFollow(Error, Class);
	};
	const auto First = std::stable_partition(
		Errors.begin(), Errors.end(), [&](const FCompilerMessage& Error) { return !Follows(Error); });
	OutFollowing.insert(OutFollowing.end(), First, Errors.end());
	Errors.erase(First, Errors.end());
}

} // namespace Drydock
