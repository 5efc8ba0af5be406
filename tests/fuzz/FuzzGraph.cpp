// libFuzzer's entry for calls on the render graph.
#include "fuzz/FuzzGraphChecks.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	// One thread, and nobody who watches it.
	static const Drydock::FScopedConsoleVariable Threads("r.Drydock.Threads", 1);
	static const Drydock::FScopedConsoleVariable Seconds("r.Drydock.PluginSeconds", 0);
	const std::string Problem = Drydock::CheckGraphCalls(Data, Size);
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
