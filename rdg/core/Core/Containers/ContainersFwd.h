// Forward declarations of the containers. Source: engine Containers/ContainersFwd.h.
#pragma once

#include "Containers/ContainerAllocationPolicies.h"

template<typename T, typename Allocator = FDefaultAllocator>
class TArray;
template<typename T>
class TArrayView;
template<typename T>
using TConstArrayView = TArrayView<const T>;
template<typename KeyType, typename ValueType, typename SetAllocator = FDefaultSetAllocator>
class TMap;
template<typename T, typename SetAllocator = FDefaultSetAllocator>
class TSet;
template<typename T, uint32 NumElements>
class TStaticArray;
class FString;
class FName;
