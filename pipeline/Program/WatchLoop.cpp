// Compares what is listed before a run with what is listed after it, so that a change during the run counts.
#include "Program/WatchLoop.h"

#include "PrintText.h"
#include "Program/ProgramFailure.h"
#include "Program/ProgramOutput.h"
#include "ShaderCompilation.h"

#include <algorithm>
#include <cstdio>
#include <optional>
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

/** All shaders are forgotten, or where nothing but shader files was edited, those that read them. */
void ForgetEdited(const FWatchedFiles& Before, const FWatchedFiles& After)
{
	const std::optional<std::vector<std::string>> Edited = After.FindEdited(Before);
	const auto IsShader = [](const std::string& Path)
	{
		return Path.ends_with(".usf") || Path.ends_with(".ush") || Path.ends_with(".spv");
	};
	if (Edited && std::all_of(Edited->begin(), Edited->end(), IsShader))
	{
		ForgetShadersOf(*Edited);
	}
	else
	{
		ForgetShaders();
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
