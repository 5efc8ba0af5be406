// Rows of memory at a distance from each other: hashes, copies out and copies back, on all threads where they are many.
#pragma once

#include "CoreMinimal.h"

#include <type_traits>

namespace Drydock
{

/** A hash of 128 bits, which holds within one process. All zero: not known. */
struct FMemoryHash
{
	uint64 Low = 0;
	uint64 High = 0;

	bool IsKnown() const { return (Low | High) != 0; }
	auto operator<=>(const FMemoryHash&) const = default;
};

/** Hashes what is added, in its order and with the bounds between. */
class DRYDOCK_API FMemoryHasher
{
public:
	void Add(const void* Data, size_t NumBytes);

	/** Types without padding only. */
	template<typename T>
	void Add(const T& Value)
	{
		static_assert(
			std::is_arithmetic_v<T> || std::is_enum_v<T> || std::is_pointer_v<T> || std::is_same_v<T, FMemoryHash>);
		Add(&Value, sizeof(Value));
	}

	/** The hash of all so far, which is known. */
	FMemoryHash Get() const;

private:
	uint64 Sums[4] = {1, 2, 3, 4};
};

/** Rows of one mip, or the bytes of a buffer as one row. */
struct FTexelBlock
{
	uint8* Data = nullptr;
	size_t RowBytes = 0;
	int32 NumRows = 0;
	int32 NumSlices = 1;
	int64 RowPitch = 0;
	int64 SlicePitch = 0;

	size_t GetNumBytes() const { return RowBytes * size_t(NumRows) * size_t(NumSlices); }
};

/** The bytes between rows do not count. The same for any number of threads. */
DRYDOCK_API FMemoryHash HashTexels(const FTexelBlock& Block);

/** Kept: GetNumBytes() bytes without gaps. */
DRYDOCK_API void SaveTexels(const FTexelBlock& Block, uint8* Kept);
DRYDOCK_API void RestoreTexels(const FTexelBlock& Block, const uint8* Kept);

} // namespace Drydock
