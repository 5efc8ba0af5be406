// Writes the scripts: what is the same for all programs as text, verbs and options as cases.
#include "Program/CompletionScript.h"

#include "TextTools.h"

#include <algorithm>
#include <map>

namespace Drydock
{

namespace
{

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
		[](const FOptionModel& Other) { return Other.GetName() == "CONFIG" && Other.bRequired; });
	return Option.Type == "PATTERN" && bOfConfig ? EValue::Pass : EValue::Nothing;
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

/** A command of the bash script that fills COMPREPLY. */
std::string MakeBashValue(const FVerbModel& Verb, const FOptionModel& Option)
{
	switch (GetValue(Verb, Option))
	{
	case EValue::Words:
		return (Option.bList ? "_drydock_list '" : "_drydock_words '") + JoinText(Option.Words, " ") + "'";
	case EValue::Config:
		return "_drydock_files json";
	case EValue::Folder:
		return "_drydock_folders";
	case EValue::File:
		return "_drydock_files ''";
	case EValue::Variable:
		return "_drydock_names cvars =";
	case EValue::Setting:
		return std::string("_drydock_names settings") + (Option.Type == "SETTING=VALUE" ? " =" : "");
	case EValue::Effect:
		return "_drydock_names effects";
	case EValue::Pass:
		return "_drydock_passes";
	case EValue::Nothing:
		break;
	}
	return ":";
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
	switch (GetValue(Verb, Option))
	{
	case EValue::Words:
		return Option.bList ? "_values -s , word " + JoinText(Option.Words, " ")
							: "(" + JoinText(Option.Words, " ") + ")";
	case EValue::Config:
		return "_files -g \"*.json(-.)\"";
	case EValue::Folder:
		return "_files -/";
	case EValue::File:
		return "_files";
	case EValue::Variable:
		return "_drydock_names cvars =";
	case EValue::Setting:
		return std::string("_drydock_names settings") + (Option.Type == "SETTING=VALUE" ? " =" : "");
	case EValue::Effect:
		return "_drydock_names effects";
	case EValue::Pass:
		return "_drydock_passes";
	case EValue::Nothing:
		break;
	}
	return " ";
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

} // namespace

std::string MakeBashCompletion(const FProgramModel& Model)
{
	std::string Text = R"sh(# Completes drydock's command line in bash. Made by `drydock completion bash`.

_drydock_words() {
	mapfile -t COMPREPLY < <(compgen -W "$1" -- "$now")
}

# Words with commas between them; those before the last comma stay.
_drydock_list() {
	local head=
	[[ $now == *,* ]] && head=${now%,*},
	mapfile -t COMPREPLY < <(compgen -P "$head" -W "$1" -- "${now##*,}")
}

_drydock_folders() {
	compopt -o filenames 2> /dev/null
	mapfile -t COMPREPLY < <(compgen -d -- "$now")
}

# Folders, and files that end in .$1, or any where it is empty.
_drydock_files() {
	compopt -o filenames 2> /dev/null
	mapfile -t COMPREPLY < <(compgen -d -- "$now"; compgen -f -X "!*${1:+.$1}" -- "$now" | while IFS= read -r file; do
		[[ -d $file ]] || printf '%s\n' "$file"
	done)
}

# What the program lists, "list $1", with $2 behind each name.
_drydock_names() {
	[[ ${2:-} != = ]] || compopt -o nospace 2> /dev/null
	mapfile -t COMPREPLY < <(compgen -S "${2:-}" -W "$("${COMP_WORDS[0]}" list "$1" --names 2> /dev/null)" -- "$now")
}

# Passes of the config on the line.
_drydock_passes() {
	[[ -n $config ]] || return
	mapfile -t COMPREPLY < <(compgen -W "$("${COMP_WORDS[0]}" list passes --config "$config" --names 2> /dev/null)" -- "$now")
}

_drydock() {
	local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb= config= at=1 word
	COMPREPLY=()
	# An = is a word of its own: in --report=full both sides of it belong together.
	if [[ $now == = ]]; then
		now=
	elif [[ $before == = && COMP_CWORD -gt 2 ]]; then
		before=${COMP_WORDS[COMP_CWORD - 2]}
		[[ $before == --* ]] || return
	fi
	for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
		if [[ $at == 1 && $word != -* ]]; then
			verb=$word
			at=2
)sh";
	const std::string Upper = ListUpperVerbs(Model);
	if (!Upper.empty())
	{
		Text += "\t\telif [[ $at == 2 && $word != -* ]]; then\n\t\t\tcase $verb in " + Upper +
				") verb+=\" $word\" ;; esac\n\t\t\tat=3\n";
	}
	Text += R"sh(		fi
		[[ $word == *.json ]] && config=$word
	done
	case $verb in
)sh";
	for (const FVerbModel& Verb : Model)
	{
		Text += MakeBashVerb(Verb);
	}
	return Text + "\tesac\n}\n\ncomplete -F _drydock drydock\n";
}

std::string MakeZshCompletion(const FProgramModel& Model)
{
	std::string Text = R"sh(#compdef drydock
# Completes drydock's command line in zsh. Made by `drydock completion zsh`.

# What the program lists, "list $1", with $2 behind each name.
_drydock_names() {
	local -a names=(${(f)"$($drydock list $1 --names 2> /dev/null)"})
	compadd -S "${2:- }" -a names
}

# Passes of the config on the line.
_drydock_passes() {
	local config=${${(M)words:#*.json}[1]}
	[[ -n $config ]] || return 1
	local -a names=(${(f)"$($drydock list passes --config $config --names 2> /dev/null)"})
	compadd -a names
}

_drydock() {
	local drydock=$words[1] verb=
	if (( CURRENT > 2 )) && [[ $words[2] != -* ]]; then
		verb=$words[2]
		shift words
		(( CURRENT-- ))
)sh";
	const std::string Upper = ListUpperVerbs(Model);
	if (!Upper.empty())
	{
		Text += "\t\tif [[ $verb == (" + Upper + R"sh() ]] && (( CURRENT > 2 )) && [[ $words[2] != -* ]]; then
			verb+=" $words[2]"
			shift words
			(( CURRENT-- ))
		fi
)sh";
	}
	Text += "\tfi\n\tcase $verb in\n";
	for (const FVerbModel& Verb : Model)
	{
		Text += MakeZshVerb(Model, Verb);
	}
	return Text + "\tesac\n}\n\n_drydock \"$@\"\n";
}

} // namespace Drydock
