// Compares what is listed before a run with what is listed after it, so that a change during the run counts.
#include "Program/WatchLoop.h"

#include "PrintText.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "Run/RunFiles.h"

#include <cstdio>
#include <utility>

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
	FWatchedFiles Before = ListNow(Loop);
	for (bool bFirst = true;; bFirst = false)
	{
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
		PrintText(stderr, "watching; Ctrl+C ends it\n");
		FWatchedFiles After = ListNow(Loop);
		while (After == Before)
		{
			if (!Loop.Wait())
			{
				return;
			}
			After = ListNow(Loop);
		}
		ForgetEdited(Before, After);
		Before = std::move(After);
	}
}

} // namespace Drydock
