// Makes the list of verbs from its rows.
#include "Program/Verbs.h"

namespace Drydock
{

const char* ToString(EVerbGroup Group)
{
	constexpr const char* Titles[] = {"Run", "Ask what happens in a frame, and why", "Measure and compare",
		"Look up, import and export", "Make patches and plugins", "For shells and editors"};
	return Titles[size_t(Group)];
}

const std::vector<FVerb>& GetVerbs()
{
	static const std::vector<FVerb> Verbs = {
#define DRYDOCK_VERB(Name, Group, AddOptions, Doc) {Name, EVerbGroup::Group, Doc, AddOptions},
#if DRYDOCK_TOOLS
#define DRYDOCK_TOOL DRYDOCK_VERB
#else
#define DRYDOCK_TOOL(Name, Group, AddOptions, Doc) {Name, EVerbGroup::Group, Doc, nullptr},
#endif
#include "Program/VerbTable.inl"
#undef DRYDOCK_TOOL
#undef DRYDOCK_VERB
	};
	return Verbs;
}

const std::vector<FVerbExample>& GetVerbExamples()
{
	static const std::vector<FVerbExample> Examples = {
#define DRYDOCK_EXAMPLE(Verb, Arguments) {Verb, Arguments},
#include "Program/VerbExamples.inl"
#undef DRYDOCK_EXAMPLE
	};
	return Examples;
}

std::string FVerbExample::GetCommand() const
{
	return std::string("drydock ") + Verb + (*Verb != '\0' ? " " : "") + Arguments;
}

} // namespace Drydock
