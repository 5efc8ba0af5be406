// Reads a stream and keeps count, so that nothing depends on its state after a failure.
#include "Picture/HeaderBytes.h"

#include "Diagnostics.h"
#include "Text/Fmt.inl"

#include <algorithm>

namespace Drydock
{

namespace
{

constexpr size_t MaxName = 255;

} // namespace

FHeaderBytes::FHeaderBytes(const std::string& InPath, std::istream& InStream)
	: Path(InPath)
	, Stream(InStream)
{
	Stream.seekg(0, std::ios::end);
	Size = std::max<int64_t>(0, Stream.tellg());
	Stream.seekg(0);
}

void FHeaderBytes::Fail(const std::string& Message, EConfigError Code) const
{
	throw FError({.Code = Code, .Message = "the image file " + Message, .File = Path}, ExitFiles);
}

void FHeaderBytes::CheckSize(int64_t Width, int64_t Height) const
{
	if (Width < 1 || Height < 1)
	{
		Fail("holds no picture");
	}
	if (Width > MaxImageSide || Height > MaxImageSide || Width * Height > MaxImagePixels)
	{
		Fail(fmt::format("has {} x {} pixels; the largest frame is {} a side and {} in all", Width, Height,
				 MaxImageSide, MaxImagePixels),
			ErrorImageTooLarge);
	}
}

void FHeaderBytes::SkipTo(int64_t InPosition)
{
	Position = InPosition;
	Stream.clear();
	Stream.seekg(Position);
}

uint32_t FHeaderBytes::ReadBigEndian(int NumBytes)
{
	uint32_t Number = 0;
	for (int Index = 0; Index < NumBytes; ++Index)
	{
		Number = Number << 8 | Read<uint8_t>();
	}
	return Number;
}

std::string FHeaderBytes::ReadText()
{
	std::string Text;
	for (char Character = Read<char>(); Character != '\0'; Character = Read<char>())
	{
		Text += Character;
		if (Text.size() > MaxName || static_cast<unsigned char>(Character) < ' ')
		{
			Fail("is corrupt: a name in its header is none");
		}
	}
	return Text;
}

std::string FHeaderBytes::Peek(int64_t Count)
{
	const int64_t Before = Position;
	std::string Bytes(static_cast<size_t>(std::clamp<int64_t>(Count, 0, Size)), '\0');
	SkipTo(0);
	Take(Bytes.data(), static_cast<int64_t>(Bytes.size()));
	SkipTo(Before);
	return Bytes;
}

void FHeaderBytes::Take(void* Data, int64_t Count)
{
	if (Position < 0 || Count > GetLeft() || !Stream.read(static_cast<char*>(Data), Count))
	{
		Fail("is truncated or corrupt: it ends inside its header");
	}
	Position += Count;
}

} // namespace Drydock
