// `drydock list`: lists what there is of passes, shaders, settings, console variables, effects, extensions and hooks.
#include "Config/ConsoleVariableText.h"
#include "Config/SettingList.h"
#include "Effects/Effects.h"
#include "GlobalShader.h"
#include "NativeKernels.h"
#include "PassCounters.h"
#include "PostProcessSettingsReflection.h"
#include "PrintText.h"
#include "Program/ProgramOutput.h"
#include "Program/ExtensionList.h"
#include "Program/VariableList.h"
#include "Program/VerbOptions.h"
#include "Program/Verbs.h"
#include "RangeTools.h"
#include "Run/RunDump.h"
#include "Run/RunSetup.h"
#include "Text/ConfigErrors.h"
#include "Text/JsonWriter.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <set>
#include <strings.h>
#include <utility>

namespace Drydock
{

namespace
{

struct FListOptions
{
	FRunOptions Run; // for cvars: a config and variables to be set
	std::string Things;
	std::string Filter;  // only names that contain it; for hooks a config, whose chain is listed
	bool bNames = false; // nothing but the names
	bool bJson = false;
};

bool ContainsIgnoringCase(const std::string& Text, const std::string& Part)
{
	return ToLowerCase(Text).find(ToLowerCase(Part)) != std::string::npos;
}

/** By the text of one permutation: a hand-written kernel is for all of them. */
std::string DescribeRun(const FGlobalShaderType& Type)
{
	if (Type.GetFrequency() == SF_Vertex)
	{
		return DescribeShaderRun(EShaderRun::Interpreter);
	}
	int32 Permutation = 0;
	while (Permutation + 1 < Type.GetPermutationCount() && !Type.ShouldCompilePermutation(Permutation))
	{
		++Permutation;
	}
	const bool bNative = Type.ShouldCompilePermutation(Permutation) &&
						 FindNativeKernel(FShaderRef(Type.FindOrCreateShader(Permutation))) == ENativeChoice::Native;
	return DescribeShaderRun(bNative ? EShaderRun::NativeKernel : EShaderRun::Shader);
}

FListTable ListShaders()
{
	constexpr ETextColumn Name = ETextColumn::Name;
	FListTable Table{{"shader", "file", "entry", "stage", "runs as"}, {}, "",
		{{Name}, {Name}, {Name, 1}, {ETextColumn::Text}, {ETextColumn::Text}}};
	ForEachGlobalShader(
		[&](const FGlobalShaderType& Type)
		{
			const EShaderFrequency Stage = Type.GetFrequency();
			Table.Rows.push_back({Type.GetName(), Type.GetShaderFilename(), Type.GetFunctionName(),
				Stage == SF_Compute ? "compute"
				: Stage == SF_Pixel ? "pixel"
									: "vertex",
				DescribeRun(Type)});
		});
	return Table;
}

FListTable ListEffects()
{
	FListTable Table{
		{"name", "what it is", "settings"}, {}, "", {{ETextColumn::Name}, {ETextColumn::Text}, {ETextColumn::Text}}};
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

const std::vector<std::string>& GetLists()
{
	static const std::vector<std::string> Lists = {
		"passes", "shaders", "settings", "cvars", "effects", "extensions", "hooks"};
	return Lists;
}

/** "a|b", which --help shows and completion offers. */
std::string GetListTypes()
{
	return JoinText(GetLists(), "|");
}

/** The table of every kind of list but settings and variables. */
FListTable MakeListTable(const FListOptions& Options)
{
	if (Options.Things == "passes")
	{
		return Options.Run.ConfigFile.empty() ? ListPasses() : ListPasses(Options.Run);
	}
	if (Options.Things == "shaders")
	{
		return ListShaders();
	}
	if (Options.Things == "effects")
	{
		return ListEffects();
	}
	if (Options.Things == "extensions")
	{
		return ListExtensions();
	}
	if (Options.Things == "hooks")
	{
		FRunOptions Run;
		Run.ConfigFile = Options.Filter;
		Run.bNoPlugins = Options.Run.bNoPlugins;
		return Options.Filter.empty() ? ListHooks() : ListHooks(Run);
	}
	const std::string Nearest = FindNearestName(Options.Things, GetLists());
	throw BadArgument("there is no list of " + Options.Things +
						  (Nearest.empty() ? "; there are " + GetListTypes() : "; did you mean " + Nearest + "?"),
		"THINGS");
}

std::string MakeListText(const FListTable& Table)
{
	if (!Table.Remark.empty())
	{
		return Table.Remark + "\n";
	}
	FTextTable Text{Table.Columns, {Table.Header}};
	Text.Columns.resize(Table.Header.size());
	Text.Rows.insert(Text.Rows.end(), Table.Rows.begin(), Table.Rows.end());
	return Text.Format(GetOutputWidth());
}

/** The first column, each name once, a line each. */
void PrintNames(const std::vector<std::string>& Names)
{
	std::set<std::string> Printed;
	for (const std::string& Name : Names)
	{
		if (Printed.insert(Name).second)
		{
			PrintText(stdout, Name + "\n");
		}
	}
}

std::string MakeListJson(const FListTable& Table)
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

int PrintSettings(const FListOptions& Options)
{
	// Its plugins may bring settings.
	std::optional<FRunSetup> Setup;
	if (!Options.Run.ConfigFile.empty())
	{
		Setup.emplace(Options.Run);
		PrintDiagnostics(Setup->Diagnostics);
	}
	const std::vector<const FSettingField*> Fields = FindSettingFields(Options.Filter);
	if (Options.bNames)
	{
		PrintNames(ToVector<std::string>(Fields, &FSettingField::Name));
		return ExitDone;
	}
	if (Fields.empty())
	{
		PrintText(stderr, "drydock list: no setting matches \"" + Options.Filter + "\"" +
							  SuggestName(Options.Filter, GetSettingNames()) + "\n");
	}
	PrintResult(Options.bJson ? FormatSettingsJson(Fields) : FormatSettings(Fields), Options.bJson);
	return ExitDone;
}

int PrintList(const FListOptions& Options)
{
	if (Options.Things == "cvars" && !Options.bNames)
	{
		return PrintVariables(Options.Run, Options.Filter, Options.bJson);
	}
	if (Options.Things == "cvars")
	{
		const auto All = ListConsoleVariables();
		PrintNames(ToVector<std::string>(FilterConsoleVariables({All.begin(), All.end()}, Options.Filter),
			[](const FConsoleVariableInfo& Info) { return *Info.Name; }));
		return ExitDone;
	}
	if (Options.Things == "settings" && Options.Run.ConfigFile.empty() && Options.Filter.ends_with(".json"))
	{
		FListOptions OfConfig = Options; // no setting's name has a dot
		OfConfig.Run.ConfigFile = std::exchange(OfConfig.Filter, "");
		return PrintSettings(OfConfig);
	}
	if (Options.Things == "settings")
	{
		return PrintSettings(Options);
	}
	FListTable Table = MakeListTable(Options);
	const auto IsFilteredOut = [&](const std::vector<std::string>& Row)
	{
		return Options.Things != "hooks" && !ContainsIgnoringCase(Row[0], Options.Filter);
	};
	Table.Rows.erase(std::remove_if(Table.Rows.begin(), Table.Rows.end(), IsFilteredOut), Table.Rows.end());
	if (Options.bNames)
	{
		// A pass is listed without its size, because that is its name on the command line.
		PrintNames(ToVector<std::string>(Table.Rows, [&](const std::vector<std::string>& Row)
			{ return Options.Things == "passes" ? GetShortPassName(Row[0]) : Row[0]; }));
		return ExitDone;
	}
	PrintResult(Options.bJson ? MakeListJson(Table) : MakeListText(Table), Options.bJson);
	return ExitDone;
}

} // namespace

FVerbCall AddListOptions(FVerbOptions& Verb)
{
	const auto Options = std::make_shared<FListOptions>();
	Verb.Add("THINGS", Options->Things, "Kind of things to list").Require().SetType(GetListTypes());
	Verb.Add("FILTER", Options->Filter,
		"List only names that contain this text, ignoring case; with * or ? only names that match it (settings, "
		"cvars). For hooks: list the chain of this config; for settings: those of this config, too");
	Verb.Add("--config", Options->Run.ConfigFile,
			"List the passes of this config's frame, its values of cvars, or the settings of its plugins too")
		.SetType("CONFIG");
	AddVariables(Verb, Options->Run);
	AddTrust(Verb, Options->Run);
	Verb.AddFlag("--names", Options->bNames, "Print only names, one a line, for shell completion");
	Verb.AddFlag("--json", Options->bJson, "Print an array of objects");
	return CallWith(Options, PrintList);
}

} // namespace Drydock
