// Console variables of the engine's post processing that nothing in drydock reads: known by name, type and default, so
// that a project's settings and the presets of Scalability.cpp are understood; setting one warns. When a pass registers
// one of these names, that registration takes its place and the row of the table may go.
#include "HAL/IConsoleManager.h"
#include "TextTools.h"

#include <list>

namespace
{

constexpr const char* NotSimulatedText =
#include "NotSimulatedVariables.txt"
	;

const std::list<FAutoConsoleVariable> NotSimulated = []
{
	std::list<FAutoConsoleVariable> Variables;
	for (const std::vector<std::string>& Columns : Drydock::SplitRows(NotSimulatedText))
	{
		const auto Flags =
			Columns[2] == "scaled" ? ECVF_NotSimulated | ECVF_Scalability : EConsoleVariableFlags(ECVF_NotSimulated);
		const bool bFloat = Columns[1].find('.') != std::string::npos;
		bFloat ? Variables.emplace_back(Columns[0].c_str(), std::stof(Columns[1]), Columns[3].c_str(), Flags)
			   : Variables.emplace_back(Columns[0].c_str(), std::stoi(Columns[1]), Columns[3].c_str(), Flags);
	}
	return Variables;
}();

} // namespace
