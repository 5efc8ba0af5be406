// Lets libpng expand what a file holds, and takes it apart into planes. Source: the PNG specification (W3C).
#include "Picture/PngReader.h"

#include "Picture/ImagePlane.h"
#include "Templates/UnrealTemplate.h"

#include <png.h>

#include <cmath>
#include <csetjmp>
#include <cstring>
#include <istream>
#include <stdexcept>

namespace Drydock
{

namespace
{

class FPngReader final : public IImageReader, private FNoncopyable
{
public:
	explicit FPngReader(std::unique_ptr<std::istream> InStream)
		: Stream(std::move(InStream))
		, Png(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, OnError, OnWarning))
		, Info(Png != nullptr ? png_create_info_struct(Png) : nullptr)
		, Parts(1)
	{
		if (Info == nullptr)
		{
			Destroy();
			throw std::bad_alloc();
		}
		try
		{
			ReadHeader();
		}
		catch (...)
		{
			Destroy();
			throw;
		}
	}

	~FPngReader() override { Destroy(); }

	const std::vector<FImagePart>& GetParts() const override { return Parts; }

	/** Once only: the library reads forward. */
	std::vector<FImagePlane> Read(int, const std::vector<int>& Channels) override
	{
		if (Values.empty())
		{
			ReadPixels();
		}
		const size_t NumChannels = Parts[0].Channels.size();
		std::vector<FImagePlane> Planes(Channels.size());
		for (size_t Index = 0; Index < Channels.size(); ++Index)
		{
			std::vector<float>& Plane = Planes[Index].Floats;
			Plane.reserve(Values.size() / NumChannels);
			for (size_t At = static_cast<size_t>(Channels[Index]); At < Values.size(); At += NumChannels)
			{
				Plane.push_back(static_cast<float>(Values[At]) * Scale);
			}
		}
		return Planes;
	}

private:
	[[noreturn]] static void OnError(png_structp Png, png_const_charp Text)
	{
		FPngReader& Reader = *static_cast<FPngReader*>(png_get_error_ptr(Png));
		std::strncpy(Reader.Message, Text, sizeof(Reader.Message) - 1);
		png_longjmp(Png, 1);
	}

	static void OnWarning(png_structp, png_const_charp) {}

	static void OnRead(png_structp Png, png_bytep To, size_t Count)
	{
		FPngReader& Reader = *static_cast<FPngReader*>(png_get_io_ptr(Png));
		Reader.Stream->read(reinterpret_cast<char*>(To), static_cast<std::streamsize>(Count));
		if (static_cast<size_t>(Reader.Stream->gcount()) != Count)
		{
			png_error(Png, "the file ends early");
		}
	}

	/** Calls into the library. It leaves by a long jump where it fails: Calls must hold nothing that wants destroying.
	 */
	template<typename TCalls>
	void Guard(TCalls Calls)
	{
		if (setjmp(png_jmpbuf(Png)) != 0)
		{
			throw std::runtime_error(Message);
		}
		Calls();
	}

	void ReadHeader()
	{
		Guard(
			[this]
			{
				png_set_user_limits(Png, PNG_UINT_31_MAX, PNG_UINT_31_MAX); // CheckImageHeader knows the limit
				png_set_read_fn(Png, this, OnRead);
				png_read_info(Png, Info);
				png_set_expand(Png);
				png_set_interlace_handling(Png);
				if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
				{
					png_set_swap(Png);
				}
				png_read_update_info(Png, Info);
			});
		FImagePart& Part = Parts[0];
		Part.Width = static_cast<int>(png_get_image_width(Png, Info));
		Part.Height = static_cast<int>(png_get_image_height(Png, Info));
		Part.Window = {0, 0, Part.Width, Part.Height};
		const int NumChannels = png_get_channels(Png, Info);
		Part.Channels =
			NumChannels <= 2 ? std::vector<std::string>{"Y", "A"} : std::vector<std::string>{"R", "G", "B", "A"};
		Part.Channels.resize(static_cast<size_t>(NumChannels));
		bWide = png_get_bit_depth(Png, Info) == 16;
		Part.Greatest.assign(static_cast<size_t>(NumChannels), bWide ? 65535.0 : 255.0);
		Scale = 1.0f / static_cast<float>(Part.Greatest[0]);
		png_textp Texts = nullptr;
		int NumTexts = 0;
		png_get_text(Png, Info, &Texts, &NumTexts);
		for (int Index = 0; Index < NumTexts; ++Index)
		{
			Part.Attributes[Texts[Index].key] = Texts[Index].text;
		}
		int Intent = 0;
		double FileGamma = 0.0;
		const bool bGamma = png_get_sRGB(Png, Info, &Intent) == 0 && png_get_gAMA(Png, Info, &FileGamma) != 0;
		Part.bEncoded = !bGamma;
		Gamma = bGamma ? std::round(100.0f * static_cast<float>(1.0 / FileGamma)) / 100.0f : 1.0f;
	}

	void ReadPixels()
	{
		const FImagePart& Part = Parts[0];
		const size_t RowBytes = png_get_rowbytes(Png, Info);
		std::vector<png_byte> Bytes(RowBytes * static_cast<size_t>(Part.Height));
		std::vector<png_bytep> Rows;
		for (size_t Y = 0; Y < static_cast<size_t>(Part.Height); ++Y)
		{
			Rows.push_back(Bytes.data() + Y * RowBytes);
		}
		Guard(
			[this, &Rows]
			{
				png_read_image(Png, Rows.data());
				png_read_end(Png, nullptr);
			});
		if (bWide)
		{
			Values.resize(Bytes.size() / 2);
			std::memcpy(Values.data(), Bytes.data(), Bytes.size());
		}
		else
		{
			Values.assign(Bytes.begin(), Bytes.end());
		}
		if (Part.Channels.back() == "A")
		{
			MultiplyByAlpha();
		}
	}

	/** Light is what is multiplied; where the file is sRGB the encoded value is, as OpenImageIO does. */
	void MultiplyByAlpha()
	{
		const size_t NumChannels = Parts[0].Channels.size();
		const uint32_t Greatest = bWide ? 65535 : 255;
		for (size_t Pixel = 0; Pixel < Values.size(); Pixel += NumChannels)
		{
			const uint32_t Alpha = Values[Pixel + NumChannels - 1];
			const float Factor = std::pow(static_cast<float>(Alpha) / static_cast<float>(Greatest), Gamma);
			for (size_t At = Pixel; At + 1 < Pixel + NumChannels; ++At)
			{
				Values[At] = Gamma == 1.0f ? static_cast<uint16_t>(Values[At] * Alpha / Greatest)
										   : static_cast<uint16_t>(static_cast<float>(Values[At]) * Factor);
			}
		}
	}

	void Destroy() { png_destroy_read_struct(&Png, &Info, nullptr); }

	std::unique_ptr<std::istream> Stream;
	png_structp Png;
	png_infop Info;
	char Message[256] = {};
	std::vector<FImagePart> Parts;
	bool bWide = false;
	float Scale = 1.0f;
	float Gamma = 1.0f;
	std::vector<uint16_t> Values; // of all channels, interleaved
};

} // namespace

std::unique_ptr<IImageReader> MakePngReader(std::unique_ptr<std::istream> Stream)
{
	return std::make_unique<FPngReader>(std::move(Stream));
}

} // namespace Drydock
