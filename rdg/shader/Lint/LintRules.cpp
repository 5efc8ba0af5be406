// Reads the table of the portability lint.
#include "LintRules.h"

#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

const std::vector<std::string>& GetLintPlatforms()
{
	static const std::vector<std::string> Names = {"d3d11", "sm6", "vulkan", "metal", "mobile"};
	return Names;
}

std::string DescribeLintPlatforms(uint8_t Platforms)
{
	std::string Text;
	for (size_t i = 0; i < GetLintPlatforms().size(); ++i)
	{
		Text += (Platforms >> i & 1) ? (Text.empty() ? "" : ", ") + GetLintPlatforms()[i] : "";
	}
	return Text;
}

namespace
{

constexpr const char* RulesText =
#include "LintRules.txt"
	;

FLintRule ReadRule(const std::vector<std::string>& Columns)
{
	const ESeverity Severity = Columns[1] == "error" ? ESeverity::Error : ESeverity::Warning;
	uint8_t Platforms = 0;
	for (const std::string& Platform : SplitText(Columns[2], ','))
	{
		const std::vector<std::string>& Names = GetLintPlatforms();
		Platforms |= uint8_t(1 << (std::ranges::find(Names, Trim(Platform)) - Names.begin()));
	}
	return {Columns[0], Severity, Platforms, Columns[3], Columns[4], Columns[5]};
}

} // namespace

const std::vector<FLintRule>& GetLintRules()
{
	static const std::vector<FLintRule> Rules = ToVector<FLintRule>(SplitRows(RulesText), ReadRule);
	return Rules;
}

} // namespace Drydock
