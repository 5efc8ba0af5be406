// The module that reads images by OpenImageIO: a library of its own, which libdrydock_pipeline loads when it has to.
#include "Picture/ImagePlane.h"
#include "Picture/OpenImageIOReader.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace Drydock
{

namespace
{

/** As the library's own reader of memory, which also reads before the first byte where a header sends it there. */
class FMemoryReader final : public OIIO::Filesystem::IOProxy
{
public:
	explicit FMemoryReader(const std::string& InBytes)
		: IOProxy("", Read)
		, Bytes(InBytes)
	{
	}

	const char* proxytype() const override { return "memory"; }
	size_t size() const override { return Bytes.size(); }

	size_t pread(void* To, size_t Count, int64_t Offset) override
	{
		if (Offset < 0 || static_cast<size_t>(Offset) > Bytes.size())
		{
			return 0;
		}
		const size_t NumRead = std::min(Count, Bytes.size() - static_cast<size_t>(Offset));
		std::memcpy(To, Bytes.data() + Offset, NumRead);
		return NumRead;
	}

	size_t read(void* To, size_t Count) override
	{
		const size_t NumRead = pread(To, Count, m_pos);
		m_pos += static_cast<int64_t>(NumRead);
		return NumRead;
	}

private:
	const std::string& Bytes;
};

double GetGreatest(const OIIO::TypeDesc& Type)
{
	return Type == OIIO::TypeDesc::UINT8    ? 255.0
		   : Type == OIIO::TypeDesc::UINT16 ? 65535.0
		   : Type == OIIO::TypeDesc::UINT32 ? 4294967295.0
											: 0.0;
}

/** Colour without a statement is sRGB where it is stored as whole numbers, and linear where it is stored as floats. */
void SetEncoding(FImagePart& Part, const std::string& ColorSpace)
{
	Part.bEncoded = ColorSpace == "sRGB" || (ColorSpace.empty() && Part.Greatest.at(0) > 0.0);
	Part.bFilmLog = ColorSpace == "KodakLog";
	if (!Part.bEncoded && !Part.bFilmLog && !ColorSpace.empty() && !OIIO::Strutil::iequals(ColorSpace, "linear"))
	{
		throw std::runtime_error("its colour is encoded as " + ColorSpace + "; linear, sRGB and KodakLog are read");
	}
}

FImagePart MakePart(const OIIO::ImageSpec& Spec)
{
	if (Spec.tile_width > 0)
	{
		throw std::runtime_error(
			"its pixels are stored in tiles, and only rows are read; oiiotool makes rows of them with "
			"--scanline");
	}
	FImagePart Part;
	Part.Width = Spec.depth > 1 ? 0 : Spec.width; // a volume is not a picture
	Part.Height = Spec.height;
	Part.Window = {Spec.x - Spec.full_x, Spec.y - Spec.full_y, Spec.full_width, Spec.full_height};
	Part.Channels = Spec.channelnames;
	for (int Channel = 0; Channel < Spec.nchannels; ++Channel)
	{
		Part.Greatest.push_back(GetGreatest(Spec.channelformat(Channel)));
	}
	for (const OIIO::ParamValue& Value : Spec.extra_attribs)
	{
		if (Value.type() == OIIO::TypeDesc::STRING)
		{
			Part.Attributes[Value.name().string()] = Value.get_string();
		}
	}
	SetEncoding(Part, Spec.get_string_attribute("oiio:ColorSpace").str());
	return Part;
}

class FOpenImageIOReader final : public IImageReader
{
public:
	FOpenImageIOReader(const char* Path, FImageBytesPointer Bytes, const char* Format)
		: Memory(Bytes != nullptr ? std::make_unique<FMemoryReader>(*Bytes) : nullptr)
		, File(OIIO::ImageInput::create(Format))
	{
		OIIO::ImageSpec Spec;
		if (!File || (Memory && !File->set_ioproxy(Memory.get())) || !File->open(Path, Spec))
		{
			throw std::runtime_error(File ? File->geterror() : OIIO::geterror());
		}
		Parts.push_back(MakePart(File->spec()));
	}

	const std::vector<FImagePart>& GetParts() const override { return Parts; }

	std::vector<FImagePlane> Read(int, const std::vector<int>& Channels) override
	{
		const FImagePart& Part = Parts[0];
		const size_t NumChannels = Part.Channels.size();
		const size_t NumPixels = static_cast<size_t>(Part.Width) * static_cast<size_t>(Part.Height);
		std::vector<float> Values(NumPixels * NumChannels);
		if (!ReadAll(Values.data()))
		{
			throw std::runtime_error(File->geterror());
		}
		std::vector<FImagePlane> Planes(Channels.size());
		for (size_t Index = 0; Index < Channels.size(); ++Index)
		{
			std::vector<float>& Plane = Planes[Index].Floats;
			Plane.reserve(NumPixels);
			for (size_t At = static_cast<size_t>(Channels[Index]); At < Values.size(); At += NumChannels)
			{
				Plane.push_back(Values[At]);
			}
		}
		return Planes;
	}

private:
	/** Rows are read as they are stored and converted here: the library's own conversion takes 16 MB for every call,
	 * however small the picture is. */
	bool ReadAll(float* To)
	{
		const OIIO::ImageSpec& Spec = File->spec();
		std::vector<std::byte> Stored(Spec.image_bytes(true));
		return File->read_native_scanlines(0, 0, Spec.y, Spec.y + Spec.height, 0, 0, Spec.nchannels, Stored.data()) &&
			   OIIO::convert_image(Spec.nchannels, Spec.width, Spec.height, 1, Stored.data(), Spec.format,
				   OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride, To, OIIO::TypeDesc::FLOAT, OIIO::AutoStride,
				   OIIO::AutoStride, OIIO::AutoStride);
	}

	std::unique_ptr<FMemoryReader> Memory;  // of bytes that stand for a file
	std::unique_ptr<OIIO::ImageInput> File; // goes first: it reads from Memory
	std::vector<FImagePart> Parts;
};

} // namespace

} // namespace Drydock

extern "C" __attribute__((visibility("default"))) Drydock::IImageReader* DrydockMakeOpenImageIOReader(
	const char* Path, Drydock::FImageBytesPointer Bytes, const char* Format, std::string& OutFault)
{
	try
	{
		return new Drydock::FOpenImageIOReader(Path, Bytes, Format);
	}
	catch (const std::exception& Error)
	{
		OutFault = Error.what();
		return nullptr;
	}
}
