// `drydock settings plan`: prints every place that an engine patch for one setting touches.
#include "NewSettingSheet.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/Verbs.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"

#include <cstdio>
#include <memory>

namespace Drydock
{

namespace
{

struct FSettingsPlanOptions
{
	std::string Name;
	std::string Type;     // of a setting that the table does not have; empty: the table has it
	std::string Default;  // of such a setting; empty: the plan chooses
	std::string Category; // of such a setting; empty: the plan chooses
	std::string Doc;      // of such a setting; empty: the plan chooses
	bool bJson = false;
};

/** From the table, or from the arguments where the table does not have it. */
FNewSetting FindSetting(const FSettingsPlanOptions& Options)
{
	if (const FSettingField* Field = FindSettingField(Options.Name))
	{
		return DescribeNewSetting(*Field);
	}
	if (Options.Type.empty())
	{
		throw BadArgument("there is no setting " + Options.Name + SuggestName(Options.Name, GetSettingNames()) +
						  " For a new one give its type, such as --type float --default 0");
	}
	std::string Error;
	std::optional<FNewSetting> Setting = MakeNewSetting(Options.Name, Options.Type, Options.Default, Error);
	if (!Setting)
	{
		throw BadArgument(Error);
	}
	Setting->Category = Options.Category.empty() ? Setting->Category : Options.Category;
	Setting->Doc = Options.Doc.empty() ? Setting->Doc : Options.Doc;
	return *Setting;
}

std::string MakePlanJson(const std::vector<FSettingPlace>& Places)
{
	FJsonWriter Writer;
	Writer.BeginArray();
	for (const FSettingPlace& Place : Places)
	{
		Writer.BeginObject();
		Writer.Members({{"file", Place.File}, {"where", Place.Where}, {"text", Place.Text}, {"why", Place.Why}});
		Writer.EndObject();
	}
	Writer.EndArray();
	return Writer.GetText();
}

int PrintPlan(const FSettingsPlanOptions& Options)
{
	const FNewSetting Setting = FindSetting(Options);
	const std::string Text = Options.bJson ? MakePlanJson(MakeSettingPlan(Setting)) : FormatSettingPlan(Setting);
	PrintText(stdout, Text);
	return ExitDone;
}

FVerbCall AddSettingsPlanOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSettingsPlanOptions>();
	Verb.Add("SETTING", Options->Name, "Name of the setting, such as BloomToonIntensity").Require();
	Verb.Add("--type", Options->Type, "Type of a new setting: float, bool, int, color, ...").SetType("TYPE");
	Verb.Add("--default", Options->Default, "Default value of a new setting (0)").SetType("VALUE");
	Verb.Add("--category", Options->Category, "Category of a new setting").SetType("A|B");
	Verb.Add("--doc", Options->Doc, "Description of a new setting").SetType("TEXT");
	Verb.AddFlag("--json", Options->bJson, "Print an array of places");
	return CallWith(Options, PrintPlan);
}

const FVerbRegistration GSettingsPlanRegistration({
	.Name = "settings plan",
	.Place = 103,
	.Group = EVerbGroup::LookUp,
	.Doc = "List every place that an engine patch for one setting changes",
	.AddOptions = AddSettingsPlanOptions,
});

} // namespace

} // namespace Drydock
