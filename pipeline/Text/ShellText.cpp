// Quotes words as POSIX shells read them.
#include "Text/ShellText.h"

namespace Drydock
{

std::string QuoteForShell(const std::string& Word)
{
	constexpr const char* Plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./+~";
	if (!Word.empty() && Word.find_first_not_of(Plain) == std::string::npos)
	{
		return Word;
	}
	std::string Quoted = "'";
	for (const char Letter : Word)
	{
		Quoted += Letter == '\'' ? "'\\''" : std::string(1, Letter);
	}
	return Quoted + "'";
}

} // namespace Drydock
