// SHA-256, the name of a compiled shader in the cache. Source: NIST FIPS 180-4.
#pragma once

#include "DrydockAPI.h"

#include <array>
#include <cstdint>
#include <string>

namespace Drydock
{

/** Hash of everything added, in order. Pieces are length-prefixed, so ("ab", "c") differs from ("a", "bc"). */
class DRYDOCK_API FContentHash
{
public:
	FContentHash();
	void Add(const std::string& Piece);
	/** 64 hexadecimal digits. The object is used up. */
	std::string Finish();

	/** Adds bytes without a length in front. */
	void AddBytes(const void* Bytes, size_t Count);

private:
	void AddBlock(const uint8_t* Block);

	std::array<uint32_t, 8> State;
	std::array<uint8_t, 64> Pending;
	uint64_t Length = 0;
};

/** Plain SHA-256 of the bytes. */
DRYDOCK_API std::string HashBytes(const std::string& Bytes);

} // namespace Drydock
