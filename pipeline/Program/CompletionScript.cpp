// Writes the scripts: what is the same for all programs as text, verbs and options as cases.
#include "Program/CompletionScript.h"

#include "TextTools.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

constexpr const char* BashScript =
#include "Completion.bash.txt"
	;
constexpr const char* ZshScript =
#include "Completion.zsh.txt"
	;

enum class EValue
{
	Nothing, // a number, a name that is new
	Words,
	Config, // *.json
	Folder,
	File,
	Variable, // r.X, an = may follow
	Setting,  // an = may follow
	Effect,
	Pass, // of the config on the line
};

/** The kind of an option's value, by the word that --help shows for it. */
EValue GetValue(const FVerbModel& Verb, const FOptionModel& Option)
{
	if (!Option.Words.empty())
	{
		return EValue::Words;
	}
	static const std::map<std::string, EValue> Known = {{"CONFIG", EValue::Config}, {"DIR", EValue::Folder},
		{"PLUGIN_DIR", EValue::Folder}, {"FILE", EValue::File}, {"FILE.png", EValue::File}, {"PATH", EValue::File},
		{"FILE|scene", EValue::File}, {"SCENE.exr", EValue::File}, {"A", EValue::File}, {"B", EValue::File},
		{"FRAME", EValue::File}, {"PICTURE", EValue::File}, {"TEXT", EValue::File}, {"r.NAME=VALUE", EValue::Variable},
		{"\"A 1, B\"", EValue::Variable}, {"SETTING", EValue::Setting}, {"SETTING=VALUE", EValue::Setting},
		{"EFFECT", EValue::Effect}, {"PASS", EValue::Pass}};
	const auto Found = Known.find(Option.bPositional ? Option.GetName() : Option.Type);
	if (Found != Known.end())
	{
		return Found->second;
	}
	const bool bOfConfig = std::any_of(Verb.Options.begin(), Verb.Options.end(),
		[](const FOptionModel& Other) { return Other.GetName() == "CONFIG"; });
	return Option.Type == "PATTERN" && !Option.bPositional && bOfConfig ? EValue::Pass : EValue::Nothing;
}

std::vector<std::string> GetOptionNames(const FVerbModel& Verb)
{
	std::vector<std::string> Names;
	for (const FOptionModel& Option : Verb.Options)
	{
		if (!Option.bPositional)
		{
			Names.insert(Names.end(), Option.Names.begin(), Option.Names.end());
		}
	}
	return Names;
}

/** The command that completes a value without a list of words: in bash it fills COMPREPLY. */
std::string GetCommand(const FVerbModel& Verb, const FOptionModel& Option, bool bZsh)
{
	// In the order of EValue.
	constexpr const char* Commands[][2] = {{":", " "}, {"", ""}, {"_drydock_files json", "_files -g \"*.json(-.)\""},
		{"_drydock_folders", "_files -/"}, {"_drydock_files ''", "_files"},
		{"_drydock_names cvars =", "_drydock_names cvars ="}, {"_drydock_names settings", "_drydock_names settings"},
		{"_drydock_names effects", "_drydock_names effects"}, {"_drydock_passes", "_drydock_passes"}};
	const EValue Value = GetValue(Verb, Option);
	const bool bAssigned = Value == EValue::Setting && Option.Type == "SETTING=VALUE";
	return Commands[size_t(Value)][bZsh] + std::string(bAssigned ? " =" : "");
}

std::string MakeBashValue(const FVerbModel& Verb, const FOptionModel& Option)
{
	return Option.Words.empty()
			   ? GetCommand(Verb, Option, false)
			   : (Option.bList ? "_drydock_list '" : "_drydock_words '") + JoinText(Option.Words, " ") + "'";
}

/** Uses only the first argument that can be completed: if there are two, both are files. */
std::string MakeBashArguments(const FVerbModel& Verb)
{
	for (const FOptionModel& Option : Verb.Options)
	{
		if (Option.bPositional && GetValue(Verb, Option) != EValue::Nothing)
		{
			return MakeBashValue(Verb, Option);
		}
	}
	return ":";
}

std::string MakeBashVerb(const FVerbModel& Verb)
{
	std::string Text = "\t'" + Verb.Name + "')\n";
	Text += "\t\tcase $before in\n";
	for (const FOptionModel& Option : Verb.Options)
	{
		if (!Option.bPositional && !Option.Type.empty())
		{
			Text += "\t\t" + JoinText(Option.Names, " | ") + ") " + MakeBashValue(Verb, Option) + "; " +
					(Option.bValueOptional ? "[[ $now == -* ]] || return" : "return") + " ;;\n";
		}
	}
	Text += "\t\tesac\n";
	Text += "\t\tif [[ $now == -* ]]; then\n\t\t\t_drydock_words '" + JoinText(GetOptionNames(Verb), " ") + "'\n";
	Text += "\t\telse\n\t\t\t" +
			(Verb.Verbs.empty() ? MakeBashArguments(Verb) : "_drydock_words '" + JoinText(Verb.Verbs, " ") + "'") +
			"\n\t\tfi ;;\n";
	return Text;
}

/** As the text of one spec of zsh's _arguments, in single quotes. */
std::string EscapeZsh(const std::string& Text)
{
	std::string Escaped;
	for (const char Character : Text)
	{
		Escaped += Character == '\'' ? "'\\''"
				   : Character == ':' || Character == '[' || Character == ']' || Character == '\\'
					   ? std::string("\\") + Character
					   : std::string(1, Character);
	}
	return Escaped;
}

std::string MakeZshValue(const FVerbModel& Verb, const FOptionModel& Option)
{
	const std::string Words = JoinText(Option.Words, " ");
	return Option.Words.empty() ? GetCommand(Verb, Option, true)
		   : Option.bList       ? "_values -s , word " + Words
								: "(" + Words + ")";
}

/** Specs of _arguments, one a line. */
std::string MakeZshOption(const FVerbModel& Verb, const FOptionModel& Option)
{
	std::string Label = Option.bPositional || Option.Type.empty() ? Option.GetName() : Option.Type;
	if (Option.bPositional)
	{
		return " \\\n\t\t\t'" +
			   std::string(Option.bRepeats    ? "*:"
						   : Option.bRequired ? ":"
											  : "::") +
			   EscapeZsh(Label) + ":" + MakeZshValue(Verb, Option) + "'";
	}
	std::string Text;
	for (const std::string& Name : Option.Names)
	{
		Text += " \\\n\t\t\t'" + std::string(Option.bRepeats ? "*" : "") + Name + "[" + EscapeZsh(Option.Doc) + "]";
		if (!Option.Type.empty())
		{
			Text +=
				std::string(Option.bValueOptional ? "::" : ":") + EscapeZsh(Label) + ":" + MakeZshValue(Verb, Option);
		}
		Text += "'";
	}
	return Text;
}

std::string MakeZshVerb(const FProgramModel& Model, const FVerbModel& Verb)
{
	std::string Text = "\t'" + Verb.Name + "')\n";
	if (!Verb.Verbs.empty())
	{
		Text += "\t\tlocal -a verbs=(";
		for (const std::string& Name : Verb.Verbs)
		{
			const std::string Full = (Verb.Name.empty() ? "" : Verb.Name + " ") + Name;
			Text += "\n\t\t\t'" + Name + ":" + EscapeZsh(FindVerb(Model, Full)->Doc) + "'";
		}
		Text += ")\n\t\tif [[ $PREFIX != -* ]]; then\n\t\t\t_describe verb verbs\n\t\t\treturn\n\t\tfi\n";
	}
	Text += "\t\t_arguments -S";
	for (const FOptionModel& Option : Verb.Options)
	{
		Text += MakeZshOption(Verb, Option);
	}
	return Text + " ;;\n";
}

/** Pattern of the verbs that have verbs under them. */
std::string ListUpperVerbs(const FProgramModel& Model)
{
	std::vector<std::string> Names;
	for (const FVerbModel& Verb : Model)
	{
		if (!Verb.Name.empty() && !Verb.Verbs.empty())
		{
			Names.push_back(Verb.Name);
		}
	}
	return JoinText(Names, " | ");
}

/** The script with its two marks replaced. */
std::string FillIn(std::string Script, const std::string& Upper, const std::string& Verbs)
{
	Script.replace(Script.find("@upper@"), 7, Upper);
	return Script.replace(Script.find("@verbs@"), 7, Verbs);
}

} // namespace

std::string MakeBashCompletion(const FProgramModel& Model)
{
	const std::string Upper = ListUpperVerbs(Model);
	const std::string Case = Upper.empty() ? ""
										   : "\t\telif [[ $at == 2 && $word != -* ]]; then\n\t\t\tcase $verb in " +
												 Upper + ") verb+=\" $word\" ;; esac\n\t\t\tat=3\n";
	return FillIn(BashScript, Case, JoinText(Model, "", MakeBashVerb));
}

std::string MakeZshCompletion(const FProgramModel& Model)
{
	const std::string Upper = ListUpperVerbs(Model);
	const std::string Case = Upper.empty()
								 ? ""
								 : "\t\tif [[ $verb == (" + Upper +
									   ") ]] && (( CURRENT > 2 )) && [[ $words[2] != -* ]]; then\n\t\t\tverb+=\" "
									   "$words[2]\"\n\t\t\tshift words\n\t\t\t(( CURRENT-- ))\n\t\tfi\n";
	return FillIn(
		ZshScript, Case, JoinText(Model, "", [&](const FVerbModel& Verb) { return MakeZshVerb(Model, Verb); }));
}

} // namespace Drydock
