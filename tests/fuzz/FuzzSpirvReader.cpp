// libFuzzer's entry for SPIR-V modules, and a mutator that keeps them modules: bytes changed anywhere seldom get past
// the first instruction.
#include "FuzzSpirvChecks.h"
#include "FuzzSpirvMutate.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" size_t LLVMFuzzerMutate(uint8_t* Data, size_t Size, size_t MaxSize);

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* Data, size_t Size, size_t MaxSize, unsigned int Seed)
{
	std::mt19937 Random(Seed);
	if (Size < 4 * Drydock::NumSpirvHeaderWords || Random() % 8 == 0)
	{
		return LLVMFuzzerMutate(Data, Size, MaxSize);
	}
	std::vector<uint32_t> Words(Size / 4);
	std::memcpy(Words.data(), Data, Words.size() * 4);
	Drydock::MutateSpirv(Words, Random);
	const size_t NewSize = std::min(Words.size(), MaxSize / 4) * 4;
	std::memcpy(Data, Words.data(), NewSize);
	return NewSize;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* Data, size_t Size)
{
	const std::string Problem = Drydock::CheckSpirvBytes(std::string(reinterpret_cast<const char*>(Data), Size));
	if (!Problem.empty())
	{
		std::fprintf(stderr, "%s\n", Problem.c_str());
		std::abort();
	}
	return 0;
}
