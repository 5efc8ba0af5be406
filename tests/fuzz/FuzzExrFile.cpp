// libFuzzer's entry for the bytes of EXR files.
#include "FuzzImageChecks.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	const std::string Problem = Drydock::CheckExrBytes(std::string(reinterpret_cast<const char*>(Data), Size));
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
