// `drydock list`: lists what there is of passes, settings, console variables, effects, extensions and hooks.
#include <CLI/CLI.hpp>

#include "Config/SettingList.h"
#include "Effects/Effects.h"
#include "GlobalShader.h"
#include "PostProcessSettingsReflection.h"
#include "Program/ProgramOutput.h"
#include "Program/ExtensionList.h"
#include "Program/VariableList.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "Run/RunSetup.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <strings.h>

namespace Drydock
{

namespace
{

struct FListOptions
{
	FRunOptions Run; // for cvars: a config and variables to be set
	std::string Things;
	std::string Filter; // only names that contain it; for hooks a config, whose chain is listed
	bool bJson = false;
};

bool ContainsIgnoringCase(const std::string& Text, const std::string& Part)
{
	const auto Same = [](char A, char B)
	{
		return std::tolower(static_cast<unsigned char>(A)) == std::tolower(static_cast<unsigned char>(B));
	};
	return std::search(Text.begin(), Text.end(), Part.begin(), Part.end(), Same) != Text.end();
}

FListTable ListPasses()
{
	FListTable Table{{"shader", "file", "entry", "stage"}, {}, ""};
	ForEachGlobalShader(
		[&](const FGlobalShaderType& Type)
		{
			const EShaderFrequency Stage = Type.GetFrequency();
			Table.Rows.push_back({Type.GetName(), Type.GetShaderFilename(), Type.GetFunctionName(),
				Stage == SF_Compute ? "compute"
				: Stage == SF_Pixel ? "pixel"
									: "vertex"});
		});
	return Table;
}

FListTable ListEffects()
{
	FListTable Table{{"name", "what it is", "settings"}, {}, ""};
	for (const FEffect* const Effect : GetEffects())
	{
		std::string Settings;
		for (const FSettingClaim& Claim : *Effect->Settings)
		{
			const bool bActs = Claim.NotBuilt[0] == '\0';
			Settings += bActs ? (Settings.empty() ? "" : " ") + std::string(Claim.Beginning) + "*" : "";
		}
		Table.Rows.push_back({*Effect->Name, *Effect->Doc, Settings.empty() ? "-" : Settings});
	}
	return Table;
}

bool MakeTable(const std::string& Things, FListTable& OutTable)
{
	if (Things == "passes")
	{
		OutTable = ListPasses();
	}
	else if (Things == "effects")
	{
		OutTable = ListEffects();
	}
	else if (Things == "extensions")
	{
		OutTable = ListExtensions();
	}
	else if (Things == "hooks")
	{
		OutTable = ListHooks();
	}
	else
	{
		return false;
	}
	return true;
}

std::string FormatText(const FListTable& Table)
{
	std::vector<std::vector<std::string>> Rows = {Table.Header};
	Rows.insert(Rows.end(), Table.Rows.begin(), Table.Rows.end());
	return AlignColumns(Rows, [](size_t) { return true; });
}

std::string FormatJson(const FListTable& Table)
{
	FJsonWriter Writer;
	Writer.BeginArray();
	for (const std::vector<std::string>& Row : Table.Rows)
	{
		Writer.BeginObject(true);
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			Writer.Member(Table.Header[Column], Row[Column]);
		}
		Writer.EndObject();
	}
	Writer.EndArray();
	return Writer.GetText();
}

int PrintList(const FListOptions& ListOptions)
{
	const auto& [Run, Things, Filter, bJson] = ListOptions;
	if (Things == "cvars")
	{
		return PrintVariables(Run, Filter, bJson);
	}
	if (Things == "settings")
	{
		// Its plugins may bring settings.
		std::optional<FRunSetup> Setup;
		if (!Run.ConfigFile.empty())
		{
			Setup.emplace(Run);
			PrintDiagnostics(Setup->Diagnostics);
		}
		const std::vector<const FSettingField*> Fields = FindSettingFields(Filter);
		if (Fields.empty())
		{
			const std::string Nearest = FindNearestName(Filter, GetSettingNames());
			std::fprintf(stderr, "drydock list: no setting matches \"%s\"%s\n", Filter.c_str(),
				(Nearest.empty() ? "" : "; did you mean " + Nearest + "?").c_str());
		}
		std::fputs((bJson ? FormatSettingsJson(Fields) : FormatSettings(Fields)).c_str(), stdout);
		return ExitDone;
	}
	FListTable Table;
	const bool bOfConfig = Things == "hooks" && !Filter.empty();
	if (bOfConfig)
	{
		FRunOptions Options;
		Options.ConfigFile = Filter;
		Options.bNoPlugins = Run.bNoPlugins;
		Table = ListHooks(Options);
	}
	else if (!MakeTable(Things, Table))
	{
		const std::string Nearest =
			FindNearestName(Things, {"passes", "settings", "cvars", "effects", "extensions", "hooks"});
		std::fprintf(stderr, "drydock list: there is no list of \"%s\"%s\n", Things.c_str(),
			(Nearest.empty() ? "; there are passes, settings, cvars, effects, extensions, hooks"
							 : "; did you mean " + Nearest + "?")
				.c_str());
		return ExitUsage;
	}
	const auto IsFilteredOut = [&](const std::vector<std::string>& Row)
	{
		return !bOfConfig && !ContainsIgnoringCase(Row[0], Filter);
	};
	Table.Rows.erase(std::remove_if(Table.Rows.begin(), Table.Rows.end(), IsFilteredOut), Table.Rows.end());
	if (bJson)
	{
		std::fputs(FormatJson(Table).c_str(), stdout);
	}
	else
	{
		std::fputs((Table.Remark.empty() ? FormatText(Table) : Table.Remark + "\n").c_str(), stdout);
	}
	return ExitDone;
}

FVerbCall AddOptions(CLI::App& Verb)
{
	const auto Options = std::make_shared<FListOptions>();
	Verb.add_option("THINGS", Options->Things, "passes, settings, cvars, effects, extensions or hooks")->required();
	Verb.add_option("FILTER", Options->Filter,
		"Only names that contain this, or match it where it has * or ? (settings, cvars), ignoring case; for hooks a "
		"config, whose chain is listed");
	Verb.add_option(
			"--config", Options->Run.ConfigFile, "cvars: as this config sets them; settings: with those of its plugins")
		->type_name("CONFIG");
	AddVariables(Verb, Options->Run);
	AddTrust(Verb, Options->Run);
	Verb.add_flag("--json", Options->bJson, "Print an array of objects");
	return [Options]
	{
		return PrintList(*Options);
	};
}

const FVerbRegistration GRegistration({
	.Name = "list",
	.Place = 80,
	.Doc = "List what there is: passes, settings, cvars, effects, extensions, hooks",
	.AddOptions = AddOptions,
});

} // namespace

} // namespace Drydock
