// Reads the allowances of the files that have findings.
#include "LintAllowances.h"

#include "ShaderSource.h"
#include "TextTools.h"

namespace Drydock
{

namespace
{

std::set<std::pair<std::string, int>> ReadAllowances(const std::string& Text)
{
	const std::string Marker = "// drydock-lint: allow ";
	std::set<std::pair<std::string, int>> Result;
	int Number = 0;
	for (const std::string& Line : SplitText(Text))
	{
		++Number;
		const size_t At = Line.find(Marker);
		if (At != std::string::npos)
		{
			const size_t First = At + Marker.size();
			const std::string Rule = Line.substr(First, Line.find_first_of(": \t", First) - First);
			Result.insert({Rule, Number});
			Result.insert({Rule, 0});
		}
	}
	return Result;
}

} // namespace

bool FLintAllowances::Allows(const std::string& Rule, const std::string& File, int Line)
{
	const auto [Known, bNew] = Files.emplace(File, std::set<std::pair<std::string, int>>());
	if (bNew)
	{
		Known->second = ReadAllowances(ReadShaderText(File, Request));
	}
	return Known->second.count({Rule, Line}) || (Line > 1 && Known->second.count({Rule, Line - 1}));
}

} // namespace Drydock
