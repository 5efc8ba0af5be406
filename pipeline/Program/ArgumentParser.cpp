// Adds options to CLI11's parser, parses, and reads verbs and options out of it.
#include "Program/ArgumentParser.h"

#include "Program/ProgramModel.h"
#include "RangeTools.h"
#include "Text/ConfigErrors.h"
#include "TextTools.h"

#include <sstream>

#pragma push_macro("check") // the library has a function of this name
#undef check
#include <CLI/CLI.hpp>

namespace Drydock
{

namespace
{

/** Prints only the type of an option's value: exclusions are reported when they are violated. */
class FHelpFormatter : public CLI::Formatter
{
public:
	std::string make_option_opts(const CLI::Option* Option) const override
	{
		const bool bArgument = Option->get_positional(); // its own name describes it
		const std::string Type = Option->get_type_size() == 0 ? ""
								 : bArgument                  ? get_label(Option->get_type_name())
															  : Option->get_type_name();
		const bool bMany = bArgument && Option->get_expected_max() > 1;
		return (Type.empty() ? "" : " " + Type) + (bMany ? " ..." : "");
	}
};

/** Translates CLI11's words to ours. */
void SetLabels(CLI::App& Program)
{
	Program.formatter(std::make_shared<FHelpFormatter>());
	Program.get_formatter()->label("SUBCOMMAND", "VERB ...");
	Program.get_formatter()->label("REQUIRED", "");
	Program.get_formatter()->label("TEXT", "");
	Program.get_formatter()->column_width(28);
}

/** The examples of a verb, and of a verb that has only verbs under it those of these. */
std::string ListExamples(const std::string& Verb)
{
	std::string Text;
	for (const FVerbExample& Example : GetVerbExamples())
	{
		const bool bBelow = !Verb.empty() && std::string(Example.Verb).starts_with(Verb + " ");
		Text += Example.Verb == Verb || bBelow ? "\n  " + Example.GetCommand() : "";
	}
	return "Examples:" + Text;
}

/** Adds the verb where its name says: "settings plan" under "settings", which has a lower place. */
void AddVerb(CLI::App& Program, const FVerb& Verb, int& ExitCode)
{
	CLI::App* Above = &Program;
	std::string Name = Verb.Name;
	for (size_t Space = Name.find(' '); Space != std::string::npos; Space = Name.find(' '))
	{
		Above = Above->get_subcommand(Name.substr(0, Space));
		Name = Name.substr(Space + 1);
	}
	CLI::App* const Added = Above->add_subcommand(Name, Verb.Doc);
	Added->footer(ListExamples(Verb.Name));
	FVerbOptions Options(Added);
	if (const FVerbCall Call = Verb.AddOptions != nullptr ? Verb.AddOptions(Options) : nullptr)
	{
		Added->callback([&ExitCode, Call] { ExitCode = Call(); });
	}
}

FOptionModel ReadOption(const CLI::Option& Option)
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
	Model.Doc = Option.get_description();
	Model.Group = Model.bPositional ? "" : Option.get_group();
	Model.bRequired = Option.get_required();
	Model.bRepeats = Option.get_items_expected_max() > Option.get_type_size_max() ||
					 Option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll ||
					 Option.get_trigger_on_parse();
	Model.bValueOptional = !bFlag && Option.get_expected_min() == 0;
	return Model;
}

void ReadVerb(const CLI::App& App, const std::string& Name, FProgramModel& Model)
{
	FVerbModel Verb;
	Verb.Name = Name;
	Verb.Doc = App.get_description();
	for (const CLI::Option* const Option : App.get_options())
	{
		Verb.Options.push_back(ReadOption(*Option));
	}
	const std::vector<const CLI::App*> Below = App.get_subcommands([](const CLI::App*) { return true; });
	for (const CLI::App* const Sub : Below)
	{
		Verb.Verbs.push_back(Sub->get_name());
	}
	Model.push_back(std::move(Verb));
	for (const CLI::App* const Sub : Below)
	{
		ReadVerb(*Sub, (Name.empty() ? "" : Name + " ") + Sub->get_name(), Model);
	}
}

} // namespace

FVerbOption::FVerbOption(CLI::Option* Option)
	: Option(Option)
{
}

FVerbOption FVerbOption::SetType(const std::string& Name) const
{
	return FVerbOption(Option->type_name(Name));
}

FVerbOption FVerbOption::SetGroup(const std::string& Heading) const
{
	return FVerbOption(Option->group(Heading));
}

FVerbOption FVerbOption::Require() const
{
	return FVerbOption(Option->required());
}

FVerbOption FVerbOption::Exclude(const FVerbOption& Other) const
{
	return FVerbOption(Option->excludes(Other.Option));
}

FVerbOption FVerbOption::Need(const FVerbOption& Other) const
{
	return FVerbOption(Option->needs(Other.Option));
}

FVerbOption FVerbOption::SetValueWhereNoneFollows(const std::string& Value) const
{
	return FVerbOption(Option->expected(0, 1)->default_str(Value));
}

FVerbOption FVerbOption::SplitAtCommas() const
{
	return FVerbOption(Option->delimiter(','));
}

FVerbOption FVerbOption::SplitAtCommas(int NumValues) const
{
	return FVerbOption(Option->delimiter(',')->type_size(NumValues));
}

// Without the descriptions that CLI11 would add to the help.

FVerbOption FVerbOption::RequireRange(int Least, int Most) const
{
	return FVerbOption(Option->check(CLI::Range(Least, Most).description("")));
}

FVerbOption FVerbOption::RequireRange(double Least, double Most) const
{
	return FVerbOption(Option->check(CLI::Range(Least, Most).description("")));
}

FVerbOption FVerbOption::RequireNonNegative() const
{
	return FVerbOption(Option->check(CLI::NonNegativeNumber.description("")));
}

FVerbOption FVerbOption::RequireOneOf(const std::vector<std::string>& Words) const
{
	const auto Explain = [Words](const std::string& Word)
	{
		if (Contains(Words, Word))
		{
			return std::string();
		}
		return '"' + Word + "\" is not one of " + JoinText(Words) + SuggestName(Word, Words);
	};
	return FVerbOption(Option->check(Explain)->type_name(JoinText(Words, "|")));
}

FVerbOption FVerbOption::RequireSomeOf(const std::vector<std::string>& Words) const
{
	return RequireOneOf(Words).SplitAtCommas().SetType(JoinText(Words, "|") + ",...");
}

FVerbOptions::FVerbOptions(CLI::App* Verb)
	: Verb(Verb)
{
}

template<typename T>
FVerbOption FVerbOptions::Add(const std::string& Name, T& Value, const std::string& Doc)
{
	return FVerbOption(Verb->add_option(Name, Value, Doc));
}

#define DRYDOCK_OPTION(...) \
	template FVerbOption FVerbOptions::Add(const std::string& Name, __VA_ARGS__& Value, const std::string& Doc);
DRYDOCK_OPTION(std::string)
DRYDOCK_OPTION(int)
DRYDOCK_OPTION(double)
DRYDOCK_OPTION(std::optional<std::string>)
DRYDOCK_OPTION(std::optional<int>)
DRYDOCK_OPTION(std::optional<double>)
DRYDOCK_OPTION(std::vector<std::string>)
DRYDOCK_OPTION(std::vector<int>)
#undef DRYDOCK_OPTION

FVerbOption FVerbOptions::Add(
	const std::string& Name, const std::function<void(const std::string&)>& Take, const std::string& Doc)
{
	return FVerbOption(Verb->add_option_function<std::string>(Name, Take, Doc));
}

FVerbOption FVerbOptions::Add(
	const std::string& Name, const std::function<void(const std::vector<std::string>&)>& Take, const std::string& Doc)
{
	return FVerbOption(Verb->add_option_function<std::vector<std::string>>(Name, Take, Doc));
}

FVerbOption FVerbOptions::AddRepeated(
	const std::string& Name, const std::string& Type, std::vector<std::string>& Values, const std::string& Doc)
{
	return FVerbOption(Verb->add_option(Name, Values, Doc)
						   ->expected(1)
						   ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
						   ->allow_extra_args(false)
						   ->type_name(Type));
}

FVerbOption FVerbOptions::AddInOrder(const std::string& Name, const std::string& Type,
	const std::function<void(const std::string&)>& Take, const std::string& Doc)
{
	return FVerbOption(Verb->add_option_function<std::string>(Name, Take, Doc)
						   ->expected(1)
						   ->multi_option_policy(CLI::MultiOptionPolicy::TakeLast)
						   ->trigger_on_parse()
						   ->type_name(Type));
}

FVerbOption FVerbOptions::AddFlag(const std::string& Name, bool& bGiven, const std::string& Doc)
{
	return FVerbOption(Verb->add_flag(Name, bGiven, Doc));
}

FVerbOption FVerbOptions::AddFlag(const std::string& Name, const std::function<void()>& Act, const std::string& Doc)
{
	return FVerbOption(Verb->add_flag_callback(Name, Act, Doc));
}

FVerbOption FVerbOptions::Find(const std::string& Name) const
{
	return FVerbOption(Verb->get_option(Name));
}

void FVerbOptions::RequireVerb()
{
	Verb->require_subcommand(1);
}

FArgumentParser::FArgumentParser(const FProgramText& Text, const std::vector<FVerb>& Verbs)
	: Program(std::make_unique<CLI::App>(Text.Doc, Text.Name))
{
	Program->set_version_flag("--version", Text.Version);
	Program->require_subcommand(1);
	SetLabels(*Program);
	Program->footer(Text.Footer + "\n\n" + ListExamples(""));
	for (const FVerb& Verb : Verbs)
	{
		AddVerb(*Program, Verb, ExitCode);
	}
	for (const FVerb& Verb : Verbs) // once all are there: those under a verb would take it over
	{
		const bool bBelow = std::string(Verb.Name).find(' ') != std::string::npos;
		if (!bBelow)
		{
			Program->get_subcommand(Verb.Name)->group(ToString(Verb.Group));
		}
	}
}

FArgumentParser::~FArgumentParser() = default;

FParsedArguments FArgumentParser::Parse(const std::vector<std::string>& Arguments)
{
	try
	{
		std::vector<std::string> FromTheEnd(Arguments.rbegin(), Arguments.rend()); // as CLI11 takes them
		for (std::string& Argument : FromTheEnd)
		{
			const bool bPlural = Argument == "--passes" || Argument.starts_with("--passes=");
			Argument = bPlural ? "--pass" + Argument.substr(sizeof("--passes") - 1) : Argument;
		}
		Program->parse(std::move(FromTheEnd));
		return {EParsed::Called, ExitCode, ""};
	}
	catch (const CLI::Success& Success)
	{
		std::ostringstream Text;
		const int Code = Program->exit(Success, Text, Text);
		return {EParsed::Asked, Code, Text.str()};
	}
	catch (const CLI::ParseError& Error)
	{
		return {EParsed::Mistaken, ExitUsage, Error.what()};
	}
}

bool FArgumentParser::IsGiven(const std::string& Option) const
{
	const CLI::App* Chosen = Program.get();
	while (!Chosen->get_subcommands().empty())
	{
		Chosen = Chosen->get_subcommands().front();
	}
	const CLI::Option* const Found = Chosen->get_option_no_throw(Option);
	return Found != nullptr && Found->count() > 0;
}

std::vector<FVerbModel> FArgumentParser::Read() const
{
	FProgramModel Model;
	ReadVerb(*Program, "", Model);
	AddGroupsAndWords(Model);
	return Model;
}

} // namespace Drydock

#pragma pop_macro("check")
