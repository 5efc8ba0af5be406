// Reads how a compiler ended, and what it printed, for signs that it was not its input's fault.
#include "ToolFault.h"

#include "FileDescriptor.h"
#include "TextTools.h"

#include <csignal>
#include <cstring>
#include <sys/stat.h>

namespace Drydock
{

namespace
{

/** Number of the signal that a driver's message says has ended the program it called; 0: none. */
int FindSignal(const std::string& Output)
{
	for (int Signal = 1; Signal < 32; ++Signal)
	{
		const char* const Name = strsignal(Signal);
		const std::string OfGcc = std::string(Name) + " signal terminated program";
		const std::string OfClang = std::string("unable to execute command: ") + Name;
		if (Output.find(OfGcc) != std::string::npos || Output.find(OfClang) != std::string::npos)
		{
			return Signal;
		}
	}
	return 0;
}

/** The first line that says of what the machine ran short. */
std::string FindShortage(const std::string& Output)
{
	static const char* const Signs[] = {"No space left on device", "Disk quota exceeded", "Read-only file system",
		"File too large", "Cannot allocate memory", "out of memory", "memory exhausted", "Too many open files",
		"Resource temporarily unavailable"};
	for (const std::string& Line : SplitText(Output))
	{
		for (const char* const Sign : Signs)
		{
			if (Line.find(Sign) != std::string::npos)
			{
				return Line;
			}
		}
	}
	return {};
}

} // namespace

std::string DescribeSignal(int Signal)
{
	return "signal " + std::to_string(Signal) +
		   (Signal == SIGKILL ? " (out of memory?)" : std::string(" (") + strsignal(Signal) + ")");
}

bool IsSignalFromOutside(int Signal)
{
	switch (Signal)
	{
	case SIGHUP:
	case SIGINT:
	case SIGQUIT:
	case SIGKILL:
	case SIGTERM:
	case SIGXCPU:
	case SIGXFSZ:
		return true;
	default:
		return false;
	}
}

std::string FindToolFault(const FChildResult& Child)
{
	if (!Child.bStarted)
	{
		return "could not be started: " + DescribeSystemError(Child.StartError);
	}
	if (Child.bTimedOut || Child.Succeeded())
	{
		return {};
	}
	const int Signal = Child.Signal ? Child.Signal : FindSignal(Child.Output);
	if (Signal)
	{
		return "was killed by " + DescribeSignal(Signal);
	}
	const std::string Shortage = FindShortage(Child.Output);
	return Shortage.empty() ? Shortage : "ended with: " + Shortage;
}

std::vector<std::string> MakeToolEnvironment(const FTemporaryFolder& Folder)
{
	const std::string Place = Folder.Reserve("tools");
	mkdir(Place.c_str(), 0700); // is there already for the second tool
	return {"LC_ALL=C", "TMPDIR=" + Place};
}

} // namespace Drydock
