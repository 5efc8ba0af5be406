// Draws the bar with escape sequences of ECMA-48, and puts a rate into words.
#include "Program/ProgressBar.h"

#include "Math/ToInteger.h"
#include "PrintText.h"
#include "Text/Fmt.inl"
#include "Text/Terminal.h"
#include "Text/TextTable.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace Drydock
{

namespace
{

constexpr const char* ClearLine = "\r\x1b[2K";

} // namespace

FProgressBar::FProgressBar()
	: bTerminal(isatty(STDERR_FILENO) != 0)
{
}

void FProgressBar::Show(int Done, int Total, const std::string& What)
{
	constexpr int Width = 24;
	if (!bTerminal || Total <= 0)
	{
		return;
	}
	const int Filled = std::clamp(Done * Width / Total, 0, Width);
	const std::string Bar =
		std::string(static_cast<size_t>(Filled), '#') + std::string(static_cast<size_t>(Width - Filled), '.');
	// A line that wraps could not be taken back.
	const std::string Line = fmt::format("[{}] {}/{} {}", Bar, Done, Total, What);
	const size_t Columns = static_cast<size_t>(GetTerminalWidth(STDERR_FILENO));
	std::fputs(ClearLine, stderr);
	PrintText(stderr, ShortenMiddle(MakePrintable(Line), Columns - 1));
	std::fflush(stderr);
	bShown = true;
}

void FProgressBar::Clear()
{
	if (bShown)
	{
		std::fputs(ClearLine, stderr);
		std::fflush(stderr);
		bShown = false;
	}
}

std::string DescribeRate(int Done, int NumLeft, double Seconds)
{
	if (Done <= 0 || !(Seconds > 0.0))
	{
		return "";
	}
	const double Left = Seconds / Done * NumLeft;
	const long Whole = ToInteger<long>(std::min(Left, 1e9) + 0.5);
	const std::string Rest = Whole >= 3600 ? fmt::format("{} h {} min", Whole / 3600, Whole % 3600 / 60)
							 : Whole >= 60 ? fmt::format("{} min {} s", Whole / 60, Whole % 60)
										   : fmt::format("{} s", Whole);
	return fmt::format("{:.1f} frames/s, {} left", Done / Seconds, Rest);
}

bool IsColorful(int FileDescriptor)
{
	const char* NoColor = std::getenv("NO_COLOR");
	return isatty(FileDescriptor) != 0 && (NoColor == nullptr || NoColor[0] == '\0');
}

} // namespace Drydock
