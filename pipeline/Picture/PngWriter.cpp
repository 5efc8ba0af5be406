// Has libpng pack rows into memory, then writes the file in one go.
#include "Picture/PngWriter.h"

#include "Picture/ImageErrors.h"
#include "Templates/UnrealTemplate.h"
#include "Text/TextFile.h"

#include <array>
#include <csetjmp>
#include <cstring>
#include <png.h>
#include <vector>
#include <zlib.h>

namespace Drydock
{

namespace
{

/** One file on its way. Its calls of the library are left by a long jump where they fail: they hold nothing that wants
 * destroying. */
class FPngWriter : private FNoncopyable
{
public:
	FPngWriter()
		: Png(png_create_write_struct(PNG_LIBPNG_VER_STRING, this, OnError, OnWarning))
		, Info(Png != nullptr ? png_create_info_struct(Png) : nullptr)
	{
	}

	~FPngWriter() { png_destroy_write_struct(&Png, &Info); }

	bool Begin(int Width, int Height, int NumChannels, EPngEffort Effort)
	{
		constexpr std::array<int, 5> Types = {
			0, PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
		if (Info == nullptr || setjmp(png_jmpbuf(Png)) != 0)
		{
			return false;
		}
		png_set_write_fn(Png, this, OnWrite, OnFlush);
		png_set_user_limits(Png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
		if (Effort == EPngEffort::Quick)
		{
			png_set_filter(Png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
			png_set_compression_strategy(Png, Z_RLE);
		}
		else
		{
			png_set_compression_level(Png, Z_BEST_COMPRESSION);
		}
		png_set_IHDR(Png, Info, static_cast<png_uint_32>(Width), static_cast<png_uint_32>(Height), 8,
			Types[static_cast<size_t>(NumChannels)], PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
			PNG_FILTER_TYPE_DEFAULT);
		png_set_sRGB(Png, Info, PNG_sRGB_INTENT_ABSOLUTE);
		png_write_info(Png, Info);
		return true;
	}

	bool WriteRow(const uint8_t* Row)
	{
		if (setjmp(png_jmpbuf(Png)) != 0)
		{
			return false;
		}
		png_write_row(Png, Row);
		return true;
	}

	bool End()
	{
		if (setjmp(png_jmpbuf(Png)) != 0)
		{
			return false;
		}
		png_write_end(Png, Info);
		return true;
	}

	std::string Bytes;
	char Message[256] = "no memory";

private:
	[[noreturn]] static void OnError(png_structp Png, png_const_charp Text)
	{
		FPngWriter& Writer = *static_cast<FPngWriter*>(png_get_error_ptr(Png));
		std::strncpy(Writer.Message, Text, sizeof(Writer.Message) - 1);
		png_longjmp(Png, 1);
	}

	static void OnWarning(png_structp, png_const_charp) {}
	static void OnFlush(png_structp) {}

	static void OnWrite(png_structp Png, png_bytep Data, size_t Count)
	{
		static_cast<FPngWriter*>(png_get_io_ptr(Png))->Bytes.append(reinterpret_cast<const char*>(Data), Count);
	}

	png_structp Png;
	png_infop Info;
};

} // namespace

void WritePngRows(
	const std::string& Path, int Width, int Height, int NumChannels, EPngEffort Effort, const FByteRowSource& Rows)
{
	FPngWriter Writer;
	std::vector<uint8_t> Row(static_cast<size_t>(Width) * static_cast<size_t>(NumChannels));
	bool bDone = Writer.Begin(Width, Height, NumChannels, Effort);
	for (int Y = 0; bDone && Y < Height; ++Y)
	{
		Rows(Y, Row.data());
		bDone = Writer.WriteRow(Row.data());
	}
	if (!bDone || !Writer.End())
	{
		throw MakeImageError(
			ErrorFileNotWritten, Path, std::string("the picture cannot be written: ") + Writer.Message);
	}
	WriteWholeFile(Path, Writer.Bytes);
}

} // namespace Drydock
