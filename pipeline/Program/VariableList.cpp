// `drydock list cvars`: prints console variables as a config and the command line set them.
#include "Program/VariableList.h"

#include "Config/ConsoleVariableText.h"
#include "PrintText.h"
#include "Program/ProgramOutput.h"
#include "Run/RunSetup.h"

#include <cstdio>
#include <optional>

namespace Drydock
{

int PrintVariables(const FRunOptions& Options, const std::string& Filter, bool bJson)
{
	// While it lives, the variables are as the config and the command line set them.
	std::optional<FRunSetup> Setup;
	FRunOptions Run = Options;
	if (!Run.ConfigFile.empty() || !Run.Variables.empty() || !Run.Exec.empty())
	{
		if (Run.ConfigFile.empty())
		{
			Run.ConfigText = "{}";
		}
		Setup.emplace(Run);
		PrintDiagnostics(Setup->Diagnostics);
	}
	std::vector<FConsoleVariableInfo> All;
	std::vector<std::string> Names;
	for (const FConsoleVariableInfo& Info : ListConsoleVariables())
	{
		All.push_back(Info);
		Names.emplace_back(*Info.Name);
	}
	const std::vector<FConsoleVariableInfo> Infos = FilterConsoleVariables(All, Filter);
	if (bJson)
	{
		PrintText(stdout, FormatConsoleVariablesAsJson(Infos));
	}
	else if (Infos.empty())
	{
		PrintText(
			stderr, "drydock list: no console variable matches \"" + Filter + "\"" + SuggestName(Filter, Names) + "\n");
	}
	else
	{
		PrintResult(Infos.size() == 1 ? FormatConsoleVariableHelp(Infos[0], GetOutputWidth())
									  : FormatConsoleVariables(Infos, GetOutputWidth()));
	}
	return ExitDone;
}

} // namespace Drydock
