// Writes roff.
#include "Program/ManPage.h"

#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Text that roff prints as it is: hyphens stay hyphens, and no line begins with a sign that it takes for a request. */
std::string Escape(const std::string& Text)
{
	std::string Escaped;
	for (const char Character : Text)
	{
		Escaped += Character == '\\' ? "\\e" : Character == '-' ? "\\-" : std::string(1, Character);
	}
	const bool bRequest = !Escaped.empty() && (Escaped[0] == '.' || Escaped[0] == '\'');
	return (bRequest ? "\\&" : "") + Escaped;
}

/** "--frames LIST", bold and italic. */
std::string MakeTag(const FOptionModel& Option)
{
	std::string Text = JoinText(Option.Names, ", ",
		[&](const std::string& Name) { return (Option.bPositional ? "\\fI" : "\\fB") + Escape(Name) + "\\fR"; });
	const bool bValue = !Option.bPositional && !Option.Type.empty();
	const std::string Type = "\\fI" + Escape(Option.Type) + "\\fR";
	return Text + (!bValue ? "" : Option.bValueOptional ? " [" + Type + "]" : " " + Type);
}

std::string MakeSynopsis(const FVerbModel& Verb)
{
	std::string Text = "\\fBdrydock " + Escape(Verb.Name) + "\\fR";
	bool bOptions = false;
	for (const FOptionModel& Option : Verb.Options)
	{
		if (Option.bPositional || Option.bRequired)
		{
			const std::string Tag = MakeTag(Option) + (Option.bPositional && Option.bRepeats ? " ..." : "");
			Text += Option.bRequired ? " " + Tag : " [" + Tag + "]";
		}
		bOptions = bOptions || !Option.bPositional;
	}
	return Text + (bOptions ? " [\\fIoptions\\fR]" : "");
}

std::string MakeVerb(const FVerbModel& Verb)
{
	std::string Text = ".SS " + Escape(Verb.Name) + "\n" + MakeSynopsis(Verb) + "\n.PP\n" + Escape(Verb.Doc) + ".\n";
	for (const FOptionModel& Option : Verb.Options)
	{
		Text += ".TP\n" + MakeTag(Option) + "\n" + Escape(Option.Doc) + ".\n";
	}
	return Text;
}

constexpr const char* Ending =
#include "ManPage.txt"
	;

} // namespace

std::string MakeManPage(const FProgramModel& Model)
{
	std::string Text = std::string(".\\\" Made by `drydock man`.\n.TH DRYDOCK 1 \"\" \"drydock ") + GetVersion() +
					   "\" \"User Commands\"\n.SH NAME\ndrydock \\- " +
					   "run Unreal\\-style post\\-process passes on a rendered frame, on the CPU\n";
	Text += ".SH SYNOPSIS\n\\fBdrydock\\fR \\fIVERB\\fR ...\n";
	Text += ".SH DESCRIPTION\nVerbs read a config, a JSON file that names a scene, settings and passes. With "
			"\\fB\\-\\-json\\fR they print JSON. A verb that fails prints its messages as JSON.\n";
	for (const FOptionModel& Option : Model[0].Options)
	{
		Text += ".TP\n" + MakeTag(Option) + "\n" + Escape(Option.Doc) + ".\n";
	}
	std::vector<const FVerbModel*> Verbs;
	for (const FVerbModel& Verb : Model)
	{
		if (!Verb.Name.empty())
		{
			Verbs.push_back(&Verb);
		}
	}
	std::ranges::stable_sort(Verbs, [](const FVerbModel* A, const FVerbModel* B) { return A->Group < B->Group; });
	const FVerbModel* Last = nullptr;
	for (const FVerbModel* const Verb : Verbs)
	{
		if (Last == nullptr || Last->Group != Verb->Group)
		{
			std::string Heading = ToString(Verb->Group);
			std::ranges::transform(
				Heading, Heading.begin(), [](unsigned char Letter) { return static_cast<char>(std::toupper(Letter)); });
			Text += ".SH VERBS: " + Heading + "\n";
		}
		Text += MakeVerb(*Verb);
		Last = Verb;
	}
	return Text + Ending;
}

} // namespace Drydock
