// Compares what is listed before a run with what is listed after it, so that a change during the run counts.
#include "Program/WatchLoop.h"

#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "ShaderCompilation.h"

#include <cstdio>

namespace Drydock
{

namespace
{

FWatchedFiles ListNow(const FWatchLoop& Loop)
{
	try
	{
		return Loop.List();
	}
	catch (...)
	{
		return {}; // what is half there now is listed at the next look
	}
}

} // namespace

void RunWatchLoop(const FWatchLoop& Loop)
{
	for (bool bFirst = true;; bFirst = false)
	{
		FWatchedFiles Before = ListNow(Loop);
		try
		{
			Loop.Run();
		}
		catch (...)
		{
			PrintDiagnostics(ExplainFailure(std::current_exception()).GetDiagnostics());
		}
		if (bFirst)
		{
			Before.AddUnknown(ListNow(Loop)); // a plugin's shaders are known once it is loaded
		}
		std::fputs("watching; Ctrl+C ends it\n", stderr);
		while (ListNow(Loop) == Before)
		{
			if (!Loop.Wait())
			{
				return;
			}
		}
		ForgetShaders();
	}
}

} // namespace Drydock
