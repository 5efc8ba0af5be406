// `drydock settings plan`: prints every place that an engine patch for some settings touches.
#include "NewSettingSheet.h"
#include "Overlay/OverlayFiles.h"
#include "PrintText.h"
#include "Program/ArgumentParser.h"
#include "Program/Verbs.h"
#include "RangeTools.h"
#include "Text/ConfigErrors.h"
#include "Text/GlobPattern.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <cstdio>
#include <memory>

namespace Drydock
{

namespace
{

struct FSettingsPlanOptions
{
	std::vector<std::string> Names; // or patterns
	std::string Type;               // of settings that the table does not have; empty: the table has all
	std::string Default;            // of such settings; empty: the plan chooses
	std::string Category;           // of such settings; empty: the plan chooses
	std::string Doc;                // of such settings; empty: the plan chooses
	std::string Form = "corrected";
	std::string DiffFile; // empty: none is written
	bool bJson = false;
};

FNewSetting MakeSetting(const std::string& Name, const FSettingsPlanOptions& Options)
{
	if (Name.find_first_of("*?") != Name.npos)
	{
		throw BadArgument("no setting fits " + Name + "; `drydock list settings` prints their names");
	}
	if (Options.Type.empty())
	{
		throw BadArgument("there is no setting " + Name + SuggestName(Name, GetSettingNames()) +
						  " For a new one give its type, such as --type float --default 0");
	}
	std::string Error;
	std::optional<FNewSetting> Setting = MakeNewSetting(Name, Options.Type, Options.Default, Error);
	if (!Setting)
	{
		throw BadArgument(Error);
	}
	Setting->Category = Options.Category.empty() ? Setting->Category : Options.Category;
	Setting->Doc = Options.Doc.empty() ? Setting->Doc : Options.Doc;
	return *Setting;
}

/** Those of the table that a name fits; from the arguments where the table has none. Each is there once. */
std::vector<FNewSetting> FindSettings(const FSettingsPlanOptions& Options)
{
	std::vector<FNewSetting> Settings;
	const auto Add = [&](const FNewSetting& Setting)
	{
		if (!Contains(Settings, Setting.Name, &FNewSetting::Name))
		{
			Settings.push_back(Setting);
		}
	};
	for (const std::string& Name : Options.Names)
	{
		bool bFound = false;
		for (const FSettingField& Field : GetSettingFields())
		{
			if (MatchesPattern(Name, Field.Name))
			{
				bFound = true;
				Add(DescribeNewSetting(Field));
			}
		}
		if (!bFound)
		{
			Add(MakeSetting(Name, Options));
		}
	}
	return Settings;
}

/** The plan's lines as `drydock overlay diff` prints changes. */
std::string MakePlanDiff(const FSettingsPlanOptions& Options, const std::vector<FSettingPlace>& Places)
{
	std::vector<FOverlayHunk> Hunks;
	for (const FSettingPlace& Place : Places)
	{
		FOverlayHunk& Hunk = Hunks.emplace_back(FOverlayHunk{Place.File, Place.Where, "", false});
		for (const std::string& Line : SplitText(Place.Text))
		{
			Hunk.Lines += "+" + Line + "\n";
		}
	}
	return "# " + JoinText(Options.Names, " ") +
		   ": lines to add, without lines around them, which are the engine's.\n" + FormatHunks(Hunks);
}

std::string MakePlanJson(const std::vector<FSettingPlace>& Places)
{
	FJsonWriter Writer('[');
	for (const FSettingPlace& Place : Places)
	{
		Writer.BeginObject();
		Writer.Members({{"file", Place.File}, {"where", Place.Where}, {"text", Place.Text}, {"why", Place.Why}});
		Writer.EndObject();
	}
	return Writer.GetText();
}

int PrintPlan(const FSettingsPlanOptions& Options)
{
	const std::vector<FNewSetting> Settings = FindSettings(Options);
	const ESettingPlanForm Form = Options.Form == "printed" ? ESettingPlanForm::Printed : ESettingPlanForm::Corrected;
	const std::vector<FSettingPlace> Places = MakeSettingPlan(Settings, Form);
	if (!Options.DiffFile.empty())
	{
		WriteTextFile(Options.DiffFile, MakePlanDiff(Options, Places));
	}
	PrintText(stdout, Options.bJson ? MakePlanJson(Places) : FormatSettingPlan(Settings, Form));
	return ExitDone;
}

} // namespace

FVerbCall AddSettingsPlanOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FSettingsPlanOptions>();
	Verb.Add("SETTING", Options->Names, "Names of settings, such as BloomToonIntensity, or patterns with * and ?")
		.Require();
	Verb.Add("--type", Options->Type, "Type of new settings: float, bool, int, color, ...").SetType("TYPE");
	Verb.Add("--default", Options->Default, "Default value of new settings (0)").SetType("VALUE");
	Verb.Add("--category", Options->Category, "Category of new settings").SetType("A|B");
	Verb.Add("--doc", Options->Doc, "Description of new settings").SetType("TEXT");
	Verb.Add("--form", Options->Form,
			"Mask of a strength of bloom: by full-resolution pixels (corrected, the default), or as the article prints "
			"it")
		.RequireOneOf({"corrected", "printed"});
	Verb.Add("--diff", Options->DiffFile, "Write the lines to this file too, as `drydock overlay diff` prints changes")
		.SetType("FILE");
	Verb.AddFlag("--json", Options->bJson, "Print an array of places");
	return CallWith(Options, PrintPlan);
}

} // namespace Drydock
