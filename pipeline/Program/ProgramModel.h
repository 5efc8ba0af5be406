// Describes the program's command line, as the parser holds it: completion, the man page and tests are made from it.
#pragma once

#include "DrydockAPI.h"
#include "Program/Verbs.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FOptionModel
{
	std::vector<std::string> Names; // "-h" and "--help"; of an argument its name alone, "CONFIG"
	std::string Type;               // of its value as --help shows it, "r.NAME=VALUE"; empty: a flag
	std::vector<std::string> Words; // the values that it takes, where they are few
	std::string Doc;
	std::string Group; // as --help heads it; of arguments empty
	bool bPositional = false;
	bool bRequired = false;
	bool bRepeats = false;
	bool bList = false;          // several words in one value, with commas
	bool bValueOptional = false; // "--report" and "--report full"

	/** The long name where there is one. */
	const std::string& GetName() const { return Names.back(); }
};

struct FVerbModel
{
	std::string Name; // "settings plan"; empty: the program itself
	std::string Doc;
	EVerbGroup Group = EVerbGroup::Run;
	std::vector<FOptionModel> Options; // arguments too, in their order
	std::vector<std::string> Verbs;    // under it, "plan"
};

/** The program itself, then its verbs in the order of --help, those under a verb behind it. */
using FProgramModel = std::vector<FVerbModel>;

/** Fills in what a parser does not know: the groups of verbs, and the words that options take, by their types. */
void AddGroupsAndWords(FProgramModel& Model);

/** Null where there is no such verb. */
DRYDOCK_API const FVerbModel* FindVerb(const FProgramModel& Model, const std::string& Name);

} // namespace Drydock
