// GetTypeHash for the basic types: what TMap and TSet use for their keys. A user type gives its own GetTypeHash beside
// itself. The values are drydock's own but the same on every run. Source: engine Templates/TypeHash.h.
#pragma once

#include "CoreTypes.h"

#include <bit>
#include <type_traits>

/** Mixes two hashes; the order of the two matters. */
constexpr uint32 HashCombine(uint32 A, uint32 B)
{
	uint64 Mixed = (static_cast<uint64>(A) << 32 | B) * 0x9E3779B97F4A7C15ull;
	Mixed ^= Mixed >> 32;
	Mixed *= 0xD6E8FEB86659FD93ull;
	return static_cast<uint32>(Mixed >> 32);
}

constexpr uint32 HashCombineFast(uint32 A, uint32 B)
{
	return HashCombine(A, B);
}

template<typename T>
requires(std::is_integral_v<T> || std::is_enum_v<T>) constexpr uint32 GetTypeHash(T Value)
{
	const uint64 Wide = static_cast<uint64>(Value);
	return HashCombine(static_cast<uint32>(Wide >> 32), static_cast<uint32>(Wide));
}

inline uint32 GetTypeHash(double Value)
{
	// 0 and -0 are equal keys, so they need one hash.
	return GetTypeHash(std::bit_cast<uint64>(Value == 0.0 ? 0.0 : Value));
}

inline uint32 GetTypeHash(float Value)
{
	return GetTypeHash(static_cast<double>(Value));
}

template<typename T>
uint32 GetTypeHash(T* Value)
{
	return GetTypeHash(reinterpret_cast<UPTRINT>(Value));
}
