// Keeps one counter per operation; a pack that is counted takes long enough for an atomic addition not to show.
#include "LanesScalarCalls.h"

#include <array>
#include <atomic>
#include <cstddef>

namespace Drydock
{

namespace
{

constexpr size_t GNumCalls = size_t(EScalarCall::Count);
std::array<std::atomic<uint64_t>, GNumCalls> GCalls = {};

} // namespace

const char* GetScalarCallName(EScalarCall Call)
{
	constexpr std::array<const char*, GNumCalls> Names = {"sample", "gather", "load", "store", "buffer", "nan"};
	return Names[size_t(Call)];
}

uint64_t GetScalarCalls(EScalarCall Call)
{
	return GCalls[size_t(Call)].load(std::memory_order_relaxed);
}

uint64_t GetScalarCalls()
{
	uint64_t Sum = 0;
	for (uint8_t Index = 0; Index < uint8_t(EScalarCall::NaN); ++Index)
	{
		Sum += GetScalarCalls(EScalarCall(Index));
	}
	return Sum;
}

void AddScalarCall(EScalarCall Call)
{
	GCalls[size_t(Call)].fetch_add(1, std::memory_order_relaxed);
}

} // namespace Drydock
