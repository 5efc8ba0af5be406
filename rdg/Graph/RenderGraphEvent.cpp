// Formats the names of passes and scopes.
#include "RenderGraphEvent.h"

#include <cstdarg>
#include <cstdio>
#include <string>

FRDGEventName::FRDGEventName(const TCHAR* Format, ...)
{
	va_list Arguments;
	va_start(Arguments, Format);
	va_list Copy;
	va_copy(Copy, Arguments);
	const int Length = std::vsnprintf(nullptr, 0, Format, Copy);
	va_end(Copy);
	std::string Text(size_t(Length > 0 ? Length : 0) + 1, '\0');
	std::vsnprintf(Text.data(), Text.size(), Format, Arguments);
	va_end(Arguments);
	Text.pop_back();
	Name = FString(std::move(Text));
}
