// libFuzzer's entry for texts that are neither configs nor settings nor shaders.
#include "FuzzOtherChecks.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	const std::string Problem = Drydock::CheckOtherText(std::string(reinterpret_cast<const char*>(Data), Size));
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
