// Adds --report to a verb, and reads it.
#include "Program/ReportOption.h"

#include "Config/ReadConfig.h"
#include "Program/ProgramOutput.h"
#include "Program/VerbOptions.h"

namespace Drydock
{

void AddReport(FVerbOptions& Verb, std::string& Word, const std::string& Page, bool bDefault)
{
	Verb.Add("--report", Word,
			"Write " + Page + ": on or off; --report alone means on; the default is " +
				(bDefault ? "on, but off with --json" : "off"))
		.SetValueWhereNoneFollows("on")
		.RequireOneOf({"on", "off"});
}

bool WantsReport(const std::string& Word, bool bJson)
{
	return Word.empty() ? !bJson : Word != "off";
}

EReport ChooseRunReport(const std::string& Word, const std::string& ConfigFile, bool bDefault)
{
	std::string Chosen = Word;
	try
	{
		std::vector<FDiagnostic> Ignored; // the run reports them
		Chosen = Chosen.empty() ? LoadConfig(ConfigFile, Ignored).Report.Value : Chosen;
	}
	catch (const FError&)
	{
	}
	return !Chosen.empty() ? ParseReport(Chosen) : bDefault ? EReport::On : EReport::Off;
}

void PrintPage(const std::filesystem::path& File)
{
	PrintResult("page     " + File.string() + "\n");
}

} // namespace Drydock
