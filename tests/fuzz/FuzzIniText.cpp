// libFuzzer's entry for ini files of plugins.
#include "FuzzIniChecks.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	const std::string Problem = Drydock::CheckIniText(std::string(reinterpret_cast<const char*>(Data), Size));
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
