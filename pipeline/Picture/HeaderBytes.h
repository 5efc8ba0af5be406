// Gives the bytes of an image file to code that checks its header: read in order, from anywhere, and never behind the
// end.
#pragma once

#include "RHIDefinitions.h"
#include "Text/ConfigErrors.h"

#include <cstdint>
#include <istream>
#include <string>

namespace Drydock
{

/** No frame is larger: a texture holds it. In pixels: along a side, and in all. */
constexpr int64_t MaxImageSide = GMaxTextureDimensions;
constexpr int64_t MaxImagePixels = int64_t(1) << 28;

/** Multi-byte numbers are read as they lie in memory, least byte first, unless a function's name states another order.
 */
class FHeaderBytes
{
public:
	/** InPath names the file in messages. Stream must outlive this. */
	FHeaderBytes(const std::string& InPath, std::istream& InStream);

	/** Throws FError (exit code 3). Message: goes on after "the image file ". */
	[[noreturn]] void Fail(const std::string& Message, EConfigError Code = ErrorImageBroken) const;

	/** Fails for a picture without pixels, and for one that is larger than any frame. */
	void CheckSize(int64_t Width, int64_t Height) const;

	int64_t GetSize() const { return Size; }
	int64_t GetPosition() const { return Position; }
	int64_t GetLeft() const { return Size - Position; }
	/** Behind the end, the next reading fails. */
	void SkipTo(int64_t InPosition);

	template<typename T>
	T Read()
	{
		T Value{};
		Take(&Value, sizeof(T));
		return Value;
	}

	/** Most significant byte first. */
	uint32_t ReadBigEndian(int NumBytes);

	/** A text that a 0 ends, 255 bytes long at most. */
	std::string ReadText();

	/** The first Count bytes, or all where there are fewer; the position is where it was. */
	std::string Peek(int64_t Count);

private:
	void Take(void* Data, int64_t Count);

	const std::string Path;
	std::istream& Stream;
	int64_t Size = 0;
	int64_t Position = 0;
};

} // namespace Drydock
