// Reads verbs and options out of CLI11's parser.
#include <CLI/CLI.hpp>

#include "Program/ProgramModel.h"

#include "Config/ConfigKeys.h"
#include "Program/CommandLine.h"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr const char* ListEnding = ",...";

bool EndsInList(const std::string& Type)
{
	return Type.size() > 4 && Type.compare(Type.size() - 4, 4, ListEnding) == 0;
}

/** "float" and "double" of "float|double"; none of a type that stands for other words, such as "FILE|scene". */
std::vector<std::string> FindWords(const std::string& Type)
{
	const std::string Words = EndsInList(Type) ? Type.substr(0, Type.size() - 4) : Type;
	const bool bWords = Words.find('|') != std::string::npos &&
						Words.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789.-|") == std::string::npos;
	return bWords ? SplitAlternatives(Words) : std::vector<std::string>();
}

FOptionModel MakeOption(const CLI::Option& Option)
{
	FOptionModel Model;
	Model.bPositional = Option.get_positional();
	for (const std::string& Name : Option.get_snames())
	{
		Model.Names.push_back("-" + Name);
	}
	for (const std::string& Name : Option.get_lnames())
	{
		Model.Names.push_back("--" + Name);
	}
	if (Model.bPositional)
	{
		Model.Names = {Option.get_name(true)};
	}
	const bool bFlag = Option.get_expected_max() == 0 || Option.get_items_expected_max() == 0;
	Model.Type = bFlag ? "" : Option.get_type_name();
	Model.Words = FindWords(Model.Type);
	Model.bList = EndsInList(Model.Type);
	Model.Doc = Option.get_description();
	Model.Group = Model.bPositional ? "" : Option.get_group();
	Model.bRequired = Option.get_required();
	Model.bRepeats = Option.get_items_expected_max() > Option.get_type_size_max() ||
					 Option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll ||
					 Option.get_trigger_on_parse();
	Model.bValueOptional = !bFlag && Option.get_expected_min() == 0;
	return Model;
}

void AddVerb(const CLI::App& App, const std::string& Name, FProgramModel& Model)
{
	FVerbModel Verb;
	Verb.Name = Name;
	Verb.Doc = App.get_description();
	for (const FVerb& Registered : GetVerbs())
	{
		Verb.Group = Registered.Name == Name ? Registered.Group : Verb.Group;
	}
	for (const CLI::Option* const Option : App.get_options())
	{
		Verb.Options.push_back(MakeOption(*Option));
	}
	const std::vector<const CLI::App*> Below = App.get_subcommands([](const CLI::App*) { return true; });
	for (const CLI::App* const Sub : Below)
	{
		Verb.Verbs.push_back(Sub->get_name());
	}
	Model.push_back(std::move(Verb));
	for (const CLI::App* const Sub : Below)
	{
		AddVerb(*Sub, (Name.empty() ? "" : Name + " ") + Sub->get_name(), Model);
	}
}

} // namespace

FProgramModel MakeProgramModel(const CLI::App& App)
{
	FProgramModel Model;
	AddVerb(App, "", Model);
	return Model;
}

FProgramModel MakeProgramModel()
{
	int ExitCode = ExitDone;
	return MakeProgramModel(*MakeProgram(ExitCode));
}

const FVerbModel* FindVerb(const FProgramModel& Model, const std::string& Name)
{
	const auto Found =
		std::find_if(Model.begin(), Model.end(), [&Name](const FVerbModel& Verb) { return Verb.Name == Name; });
	return Found == Model.end() ? nullptr : &*Found;
}

} // namespace Drydock
