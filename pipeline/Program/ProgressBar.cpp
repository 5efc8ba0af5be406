// Source: drydock; escape sequences: ECMA-48.
#include "Program/ProgressBar.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <unistd.h>

namespace Drydock
{

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
	std::fprintf(stderr, "\r\x1b[2K[%s] %d/%d %.70s", Bar.c_str(), Done, Total, What.c_str());
	std::fflush(stderr);
	bShown = true;
}

void FProgressBar::Clear()
{
	if (bShown)
	{
		std::fputs("\r\x1b[2K", stderr);
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
	const long Whole = static_cast<long>(std::min(Left, 1e9) + 0.5);
	char Rate[32];
	std::snprintf(Rate, sizeof(Rate), "%.1f frames/s, ", Done / Seconds);
	const std::string Rest = Whole >= 3600
								 ? std::to_string(Whole / 3600) + " h " + std::to_string(Whole % 3600 / 60) + " min"
							 : Whole >= 60 ? std::to_string(Whole / 60) + " min " + std::to_string(Whole % 60) + " s"
										   : std::to_string(Whole) + " s";
	return Rate + Rest + " left";
}

bool IsColorful(int FileDescriptor)
{
	const char* NoColor = std::getenv("NO_COLOR");
	return isatty(FileDescriptor) != 0 && (NoColor == nullptr || NoColor[0] == '\0');
}

} // namespace Drydock
