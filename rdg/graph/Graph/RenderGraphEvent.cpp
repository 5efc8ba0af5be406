// Formats the names of passes and scopes.
#include "RenderGraphEvent.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <string>

FRDGEventName::FRDGEventName(const TCHAR* Format, ...)
{
	if (!std::strchr(Format, '%'))
	{
		Name = Format;
		return;
	}
	char Short[128]; // holds nearly all names
	va_list Arguments;
	va_start(Arguments, Format);
	va_list Copy;
	va_copy(Copy, Arguments);
	const int Length = std::vsnprintf(Short, sizeof(Short), Format, Copy);
	va_end(Copy);
	if (Length >= 0 && size_t(Length) < sizeof(Short))
	{
		Name = Short;
	}
	else if (Length > 0)
	{
		std::string Text(size_t(Length) + 1, '\0');
		std::vsnprintf(Text.data(), Text.size(), Format, Arguments);
		Text.pop_back();
		Name = FString(std::move(Text));
	}
	va_end(Arguments);
}
