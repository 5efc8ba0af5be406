// Counts the packs of lanes whose texels were read or written one by one: the slow way, which no picture should need.
#pragma once

#include "DrydockAPI.h"

#include <cstdint>

namespace Drydock
{

/** The operation that a pack asked for. */
enum class EScalarCall : uint8_t
{
	Sample,
	Gather,
	Load,
	Store, // to render targets too
	Buffer,
	NaN, // a sample whose result is none: data decides, also that of lanes which nobody looks at
	Count
};

/** "sample", "gather", ... */
DRYDOCK_API const char* GetScalarCallName(EScalarCall Call);

/** Since the start of the process, over all threads. Float lanes only: double ones know no other way. Formats of 64
 * bits a channel count. */
DRYDOCK_API uint64_t GetScalarCalls(EScalarCall Call);

/** The sum of all but NaN: what a format or an operation has no other way for. */
DRYDOCK_API uint64_t GetScalarCalls();

DRYDOCK_API void AddScalarCall(EScalarCall Call);

} // namespace Drydock
