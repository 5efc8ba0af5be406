// Allocator names that container types may carry. All containers here live on the heap, so they select nothing.
// Source: engine Containers/ContainerAllocationPolicies.h, ContainersFwd.h.
#pragma once

#include "CoreTypes.h"

class FDefaultAllocator
{
};

class FDefaultSetAllocator
{
};

class FHeapAllocator
{
};

template<int IndexSize>
class TSizedDefaultAllocator
{
};

template<uint32 NumInlineElements, typename SecondaryAllocator = FDefaultAllocator>
class TInlineAllocator
{
};

template<uint32 NumInlineElements>
class TFixedAllocator
{
};

using SceneRenderingAllocator = FDefaultAllocator;
using FConcurrentLinearArrayAllocator = FDefaultAllocator;

/** Whether removing elements may give memory back. It never does here. */
enum class EAllowShrinking : uint8
{
	No,
	Yes,
	Default = Yes,
};

/** Converts from the bool that engines before 5.4 take in its place. */
struct FAllowShrinking
{
	FAllowShrinking(EAllowShrinking) {}
	FAllowShrinking(bool) {}
};
