// Finds the groups of verbs and the words that options take.
#include "Program/ProgramModel.h"

#include "RangeTools.h"
#include "TextTools.h"

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
	return bWords ? SplitText(Words, '|') : std::vector<std::string>();
}

} // namespace

void AddGroupsAndWords(FProgramModel& Model)
{
	for (FVerbModel& Verb : Model)
	{
		for (const FVerb& Registered : GetVerbs())
		{
			Verb.Group = Registered.Name == Verb.Name ? Registered.Group : Verb.Group;
		}
		for (FOptionModel& Option : Verb.Options)
		{
			Option.Words = FindWords(Option.Type);
			Option.bList = EndsInList(Option.Type);
		}
	}
}

const FVerbModel* FindVerb(const FProgramModel& Model, const std::string& Name)
{
	return FindItem(Model, Name, &FVerbModel::Name);
}

} // namespace Drydock
