// Matches a name against a pattern with * and ?, in linear memory and without recursion.
#include "Text/GlobPattern.h"

#include "Containers/UnrealString.h"

namespace Drydock
{

bool MatchesPattern(const std::string& Pattern, const std::string& Text)
{
	return FString(Text).MatchesWildcard(FString(Pattern), ESearchCase::CaseSensitive);
}

} // namespace Drydock
