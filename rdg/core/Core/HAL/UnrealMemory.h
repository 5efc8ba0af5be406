// FMemory: memory functions under the engine's names. Source: engine HAL/UnrealMemory.h.
#pragma once

#include "CoreTypes.h"

#include <cstdlib>
#include <cstring>

struct FMemory
{
	static void* Memcpy(void* Target, const void* Source, SIZE_T Count)
	{
		return Count != 0 ? std::memcpy(Target, Source, Count) : Target;
	}
	template<typename T>
	static void Memcpy(T& Target, const T& Source)
	{
		std::memcpy(&Target, &Source, sizeof(T));
	}
	static void* Memmove(void* Target, const void* Source, SIZE_T Count)
	{
		return Count != 0 ? std::memmove(Target, Source, Count) : Target;
	}
	static int32 Memcmp(const void* A, const void* B, SIZE_T Count)
	{
		return Count != 0 ? std::memcmp(A, B, Count) : 0;
	}
	static void* Memset(void* Target, uint8 Value, SIZE_T Count)
	{
		return Count != 0 ? std::memset(Target, Value, Count) : Target;
	}
	template<typename T>
	static void Memset(T& Target, uint8 Value)
	{
		std::memset(static_cast<void*>(&Target), Value, sizeof(T));
	}
	static void* Memzero(void* Target, SIZE_T Count) { return Memset(Target, 0, Count); }
	template<typename T>
	static void Memzero(T& Target)
	{
		std::memset(static_cast<void*>(&Target), 0, sizeof(T));
	}
	/** Alignment: a power of two. Free gives back what Malloc and MallocZeroed returned. */
	static void* Malloc(SIZE_T Count, uint32 Alignment = 16)
	{
		const SIZE_T Step = Alignment < 16 ? 16 : Alignment;
		return std::aligned_alloc(Step, (Count + Step - 1) / Step * Step);
	}
	static void* MallocZeroed(SIZE_T Count, uint32 Alignment = 16) { return Memzero(Malloc(Count, Alignment), Count); }
	static void Free(void* Pointer) { std::free(Pointer); }
};
