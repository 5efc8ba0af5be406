// Computes a fast digest that shows whether bytes are the same: of pictures, scene files and the state kept between
// frames, some ten gigabytes a second. It is not a defence against somebody who wants two digests to agree: names in
// the shader cache are SHA-256 (ContentHash.h). It multiplies and rotates as in FNV-1a and xxHash.
#pragma once

#include "DrydockAPI.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace Drydock
{

class DRYDOCK_API FFingerprint
{
public:
	/** Cuts do not matter: two pieces give what both together give. */
	void Add(const void* Bytes, size_t Count);
	/** The text with its length, so that ("ab", "c") differs from ("a", "bc"). */
	void AddText(const std::string& Text);

	/** 32 hexadecimal digits. More may be added afterwards. */
	std::string Get() const;

private:
	static constexpr size_t BlockSize = 32;

	void AddBlock(const uint8_t* Block);

	std::array<uint64_t, 4> Lanes = {
		0x9E3779B97F4A7C15u, 0xC2B2AE3D27D4EB4Fu, 0x165667B19E3779F9u, 0x27D4EB2F165667C5u};
	std::array<uint8_t, BlockSize> Pending = {};
	uint64_t Length = 0;
};

/** Digest of a file's bytes. Throws FError (exit code 3) when the file cannot be read. */
DRYDOCK_API std::string FingerprintFile(const std::string& Path);

} // namespace Drydock
