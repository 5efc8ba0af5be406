// Matches a name against a pattern with * and ?, in linear memory and without recursion.
#include "Text/GlobPattern.h"

namespace Drydock
{

bool MatchesPattern(const std::string& Pattern, const std::string& Text)
{
	// The last star takes one character more whenever what follows it does not fit.
	size_t P = 0;
	size_t T = 0;
	size_t Star = std::string::npos;
	size_t StarText = 0;
	while (T < Text.size())
	{
		if (P < Pattern.size() && Pattern[P] == '*')
		{
			Star = P++;
			StarText = T;
		}
		else if (P < Pattern.size() && (Pattern[P] == '?' || Pattern[P] == Text[T]))
		{
			++P;
			++T;
		}
		else if (Star != std::string::npos)
		{
			P = Star + 1;
			T = ++StarText;
		}
		else
		{
			return false;
		}
	}
	return Pattern.find_first_not_of('*', P) == std::string::npos;
}

} // namespace Drydock
