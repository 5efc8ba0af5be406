// Does what follows a failed check or ensure.
#include "Misc/AssertionMacros.h"

#include "PrintText.h"
#include "RunningCode.h"

#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <utility>

namespace Drydock
{

namespace
{

std::atomic<uint64> GEnsureCount{0};

std::mutex& GetEnsureMutex()
{
	static std::mutex Mutex;
	return Mutex;
}

FEnsureHandler& GetEnsureHandler()
{
	static FEnsureHandler Handler;
	return Handler;
}

std::string FormatFailure(
	const char* Kind, const char* Expression, const char* File, int Line, const char* Format, va_list Arguments)
{
	std::string Text =
		std::string(Kind) + ": " + Expression + " [File:" + File + "] [Line: " + std::to_string(Line) + "]";
	if (Format != nullptr && *Format != '\0')
	{
		va_list Copy;
		va_copy(Copy, Arguments);
		const int Length = std::vsnprintf(nullptr, 0, Format, Copy);
		va_end(Copy);
		std::string Message(Length > 0 ? Length + 1 : 1, '\0');
		std::vsnprintf(Message.data(), Message.size(), Format, Arguments);
		Message.pop_back();
		Text += " " + Message;
	}
	return Text;
}

} // namespace

FCheckFailure::FCheckFailure(const std::string& Message, bool bInOfPlugin)
	: std::runtime_error(Message)
	, bOfPlugin(bInOfPlugin)
{
}

FCheckFailure::~FCheckFailure() = default;

void FailCheck(const char* Expression, const char* File, int Line, const char* Format, ...)
{
	va_list Arguments;
	va_start(Arguments, Format);
	const std::string Text = FormatFailure("Assertion failed", Expression, File, Line, Format, Arguments);
	va_end(Arguments);
	if (!IsForeignCodeRunning())
	{
		PrintText(stderr, Text + "\n");
	}
	uint64 Offset = 0;
	throw FCheckFailure(Text, FindPluginCode(__builtin_return_address(0), Offset) != nullptr);
}

bool FailEnsure(std::atomic<bool>& bReported, bool bAlways, const char* Expression, const char* File, int Line,
	const char* Format, ...)
{
	++GEnsureCount;
	const bool bPrint = !bReported.exchange(true) || bAlways;
	std::lock_guard Lock(GetEnsureMutex());
	if (!bPrint && !GetEnsureHandler())
	{
		return false;
	}
	va_list Arguments;
	va_start(Arguments, Format);
	const std::string Text = FormatFailure("Ensure condition failed", Expression, File, Line, Format, Arguments);
	va_end(Arguments);
	if (GetEnsureHandler())
	{
		GetEnsureHandler()(Text);
	}
	else
	{
		PrintText(stderr, Text + "\n");
	}
	return false;
}

uint64 GetEnsureCount()
{
	return GEnsureCount;
}

FEnsureHandler SetEnsureHandler(FEnsureHandler Handler)
{
	std::lock_guard Lock(GetEnsureMutex());
	return std::exchange(GetEnsureHandler(), std::move(Handler));
}

} // namespace Drydock
