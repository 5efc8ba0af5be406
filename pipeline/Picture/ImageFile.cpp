// Reads and writes image files by OpenImageIO. Source of the sRGB curve: IEC 61966-2-1.
#include <fmt/format.h>

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "Picture/ImageFile.h"

#include "DiagnosticList.h"
#include "Math/ToInteger.h"
#include "Picture/ImageBytes.h"
#include "Picture/ImageFormat.h"
#include "RegularFile.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>
#include <sstream>

namespace Drydock
{

namespace
{

FError MakeError(EConfigError Code, const std::string& Path, const std::string& Message)
{
	return FError({.Code = Code, .Message = Message, .File = Path}, ExitFiles);
}

/** The library's messages may run over several lines; ours are one. */
std::string OneLine(std::string Text)
{
	std::replace(Text.begin(), Text.end(), '\n', ' ');
	while (!Text.empty() && std::isspace(static_cast<unsigned char>(Text.back())))
	{
		Text.pop_back();
	}
	return Text.empty() ? "unknown error" : Text;
}

float DecodeSrgb(float Encoded)
{
	return Encoded <= 0.04045f ? Encoded / 12.92f : static_cast<float>(std::pow((Encoded + 0.055) / 1.055, 2.4));
}

bool IsColorChannel(const std::string& Name)
{
	return Name == "R" || Name == "G" || Name == "B" || Name == "Y" || Name == "I";
}

/** Far enough that nothing is there, and near enough to be counted on with. */
int GetDistance(int From, int To)
{
	constexpr int64_t Farthest = int64_t(1) << 30;
	return static_cast<int>(std::clamp(int64_t(To) - From, -Farthest, Farthest));
}

/** Numbers that one read gives: 8 GB of them. */
constexpr size_t MaxImageValues = size_t(1) << 31;

/** Rows that are read at once, so that no second copy of the whole picture is held. Tiles are read all at once. */
int GetBandHeight(const OIIO::ImageSpec& Spec, size_t NumChannels)
{
	constexpr size_t MaxBandValues = size_t(1) << 22;
	constexpr size_t LargestChunk = 256; // rows that OpenEXR packs together
	if (Spec.tile_width > 0)
	{
		return Spec.height;
	}
	const size_t RowValues = static_cast<size_t>(Spec.width) * NumChannels;
	const size_t NumRows = std::max(MaxBandValues / RowValues / LargestChunk, size_t(1)) * LargestChunk;
	return static_cast<int>(std::min(NumRows, static_cast<size_t>(Spec.height)));
}

/** Rows Y to EndY, counted from the first, of the channels Begin to End. Rows are read as they are stored and converted
 * here: the library's own conversion takes 16 MB for every call, however small the picture is. */
bool ReadBand(OIIO::ImageInput& File, int Y, int EndY, int Begin, int End, float* To)
{
	const OIIO::ImageSpec& Spec = File.spec();
	if (Spec.tile_width > 0)
	{
		return File.read_image(0, 0, Begin, End, OIIO::TypeDesc::FLOAT, To);
	}
	const int NumRows = EndY - Y;
	const size_t PixelBytes = Spec.pixel_bytes(Begin, End, true);
	std::vector<std::byte> Stored(PixelBytes * static_cast<size_t>(Spec.width) * static_cast<size_t>(NumRows));
	if (!File.read_native_scanlines(0, 0, Spec.y + Y, Spec.y + EndY, 0, Begin, End, Stored.data()))
	{
		return false;
	}
	const auto PixelStride = static_cast<OIIO::stride_t>(PixelBytes);
	const auto FloatStride = static_cast<OIIO::stride_t>(sizeof(float)) * (End - Begin);
	for (int Channel = Begin; Channel < End; ++Channel)
	{
		const size_t Offset = Spec.pixel_bytes(Begin, Channel, true);
		if (!OIIO::convert_image(1, Spec.width, NumRows, 1, Stored.data() + Offset, Spec.channelformat(Channel),
				PixelStride, OIIO::AutoStride, OIIO::AutoStride, To + (Channel - Begin), OIIO::TypeDesc::FLOAT,
				FloatStride, OIIO::AutoStride, OIIO::AutoStride))
		{
			return false;
		}
	}
	return true;
}

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

} // namespace

struct FImageFile::FInput
{
	std::unique_ptr<FMemoryReader> Memory;  // of bytes that stand for a file
	std::unique_ptr<OIIO::ImageInput> File; // goes first: it reads from Memory

	/** Why the file cannot be read, or nothing. Only the reader that the header calls for is asked: the library would
	 * try them all. */
	std::string Open(const std::string& Path);
};

std::string FImageFile::FInput::Open(const std::string& Path)
{
	std::string Reader;
	if (const std::string* const Bytes = FImageBytes::Find(Path))
	{
		std::istringstream Stream(*Bytes);
		FHeaderBytes Header(Path, Stream);
		Reader = CheckImageHeader(Path, Header);
		Memory = std::make_unique<FMemoryReader>(*Bytes);
	}
	else
	{
		const FRegularFile Readable(Path);
		if (!Readable.GetProblem().empty())
		{
			throw MakeError(ErrorFileMissing, Path, "the image file cannot be opened: " + Readable.GetProblem());
		}
		std::ifstream Stream(Path, std::ios::binary);
		FHeaderBytes Header(Path, Stream);
		Reader = CheckImageHeader(Path, Header);
	}
	File = OIIO::ImageInput::create(Reader);
	OIIO::ImageSpec Spec;
	if (!File || (Memory && !File->set_ioproxy(Memory.get())) || !File->open(Path, Spec))
	{
		return OneLine(File ? File->geterror() : OIIO::geterror());
	}
	return "";
}

FImageFile::FImageFile(const std::string& InPath)
	: Path(InPath)
	, Input(std::make_unique<FInput>())
{
	if (const std::string Fault = Input->Open(Path); !Fault.empty())
	{
		throw MakeError(ErrorImageBroken, Path, "the image file cannot be read: " + Fault);
	}
	const OIIO::ImageSpec& Spec = Input->File->spec();
	Width = Spec.width;
	Height = Spec.height;
	Window = {GetDistance(Spec.full_x, Spec.x), GetDistance(Spec.full_y, Spec.y), Spec.full_width, Spec.full_height};
	Channels = Spec.channelnames;
	bEncoded = Spec.get_string_attribute("oiio:ColorSpace") == "sRGB";
	if (Width < 1 || Height < 1 || Spec.depth > 1 || Channels.empty())
	{
		throw MakeError(ErrorImageBroken, Path, "the image file holds no picture");
	}
	if (Width > MaxImageSide || Height > MaxImageSide || int64_t(Width) * Height > MaxImagePixels)
	{
		throw MakeError(ErrorImageTooLarge, Path,
			fmt::format("the image file says {} x {} pixels; the largest frame is {} a side and {} in all", Width,
				Height, MaxImageSide, MaxImagePixels));
	}
}

FImageFile::~FImageFile() = default;

int FImageFile::FindChannel(const std::string& Name) const
{
	const auto Found = std::find(Channels.begin(), Channels.end(), Name);
	return Found == Channels.end() ? -1 : static_cast<int>(Found - Channels.begin());
}

std::string FImageFile::GetAttribute(const std::string& Name) const
{
	return Input->File->spec().get_string_attribute(Name);
}

std::vector<std::vector<float>> FImageFile::Read(const std::vector<int>& ChannelIndices)
{
	std::vector<std::vector<float>> Planes(ChannelIndices.size());
	if (ChannelIndices.empty())
	{
		return Planes;
	}
	const auto [First, Last] = std::minmax_element(ChannelIndices.begin(), ChannelIndices.end());
	const int Begin = *First;
	const int End = *Last + 1;
	const size_t NumRead = static_cast<size_t>(End - Begin);
	const size_t NumPixels = static_cast<size_t>(Width) * static_cast<size_t>(Height);
	if (NumPixels * Planes.size() > MaxImageValues)
	{
		throw MakeError(ErrorImageTooLarge, Path,
			fmt::format("{} channels of {} x {} pixels are wanted of the image file; at most {} values are read",
				Planes.size(), Width, Height, MaxImageValues));
	}
	try
	{
		const int BandHeight = GetBandHeight(Input->File->spec(), NumRead);
		std::vector<float> Band(static_cast<size_t>(Width) * static_cast<size_t>(BandHeight) * NumRead);
		for (std::vector<float>& Plane : Planes)
		{
			Plane.resize(NumPixels);
		}
		for (int Y = 0; Y < Height; Y += BandHeight)
		{
			const int BandEnd = std::min(Y + BandHeight, Height);
			if (!ReadBand(*Input->File, Y, BandEnd, Begin, End, Band.data()))
			{
				throw MakeError(ErrorImageBroken, Path,
					"the image file is truncated or corrupt: " + OneLine(Input->File->geterror()));
			}
			const size_t At = static_cast<size_t>(Y) * static_cast<size_t>(Width);
			const size_t NumInBand = static_cast<size_t>(BandEnd - Y) * static_cast<size_t>(Width);
			for (size_t Plane = 0; Plane < Planes.size(); ++Plane)
			{
				const size_t Channel = static_cast<size_t>(ChannelIndices[Plane] - Begin);
				const bool bDecode = bEncoded && IsColorChannel(Channels[static_cast<size_t>(ChannelIndices[Plane])]);
				for (size_t Pixel = 0; Pixel < NumInBand; ++Pixel)
				{
					const float Value = Band[Pixel * NumRead + Channel];
					Planes[Plane][At + Pixel] = bDecode ? DecodeSrgb(Value) : Value;
				}
			}
		}
	}
	catch (const std::bad_alloc&)
	{
		throw MakeMemoryError(fmt::format("{} channels of {} x {} pixels of {}", Planes.size(), Width, Height, Path),
			NumPixels * Planes.size() * sizeof(float));
	}
	return Planes;
}

namespace
{

bool IsExactHalf(double Value)
{
	return std::isfinite(Value) && static_cast<double>(static_cast<float>(half(static_cast<float>(Value)))) == Value;
}

void WriteImage(const std::string& Path, OIIO::ImageSpec& Spec, OIIO::TypeDesc PixelType, const void* Pixels)
{
	// No date in the header: an empty one keeps the library from adding today's.
	Spec.attribute("DateTime", "");
	OIIO::Filesystem::IOVecOutput Memory; // the library does not notice a full disk in PNG and in small EXR files
	const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
	const bool bInMemory = Output && Output->supports("ioproxy") && Output->set_ioproxy(&Memory);
	if (!Output || !Output->open(Path, Spec) || !Output->write_image(PixelType, Pixels) || !Output->close())
	{
		throw MakeError(ErrorFileNotWritten, Path,
			"the picture cannot be written: " + OneLine(Output ? Output->geterror() : OIIO::geterror()));
	}
	if (bInMemory)
	{
		WriteWholeFile(Path, std::string(Memory.buffer().begin(), Memory.buffer().end()));
	}
}

} // namespace

void WriteExr(const std::string& Path, const FImage& Image, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes, const FImageWindow& Window)
{
	// Half floats where they lose nothing: half the size, and faster to compress.
	const bool bHalf = std::all_of(Image.Values.begin(), Image.Values.end(), IsExactHalf);
	OIIO::ImageSpec Spec(
		Image.Width, Image.Height, Image.NumChannels, bHalf ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
	Spec.channelnames = ChannelNames;
	Spec.attribute("compression", "zip");
	if (Window.FullWidth > 0)
	{
		Spec.x = Window.X;
		Spec.y = Window.Y;
		Spec.full_width = Window.FullWidth;
		Spec.full_height = Window.FullHeight;
	}
	for (const auto& [Name, Text] : Attributes)
	{
		Spec.attribute(Name, Text);
	}
	const std::vector<float> Pixels(Image.Values.begin(), Image.Values.end());
	WriteImage(Path, Spec, OIIO::TypeDesc::FLOAT, Pixels.data());
}

void WritePng(const std::string& Path, const FImage& Image, int Compression)
{
	OIIO::ImageSpec Spec(Image.Width, Image.Height, Image.NumChannels, OIIO::TypeDesc::UINT8);
	Spec.attribute("oiio:ColorSpace", "sRGB");
	Spec.attribute("oiio:UnassociatedAlpha", 1);
	Spec.attribute("png:compressionLevel", Compression);
	std::vector<uint8_t> Pixels(Image.Values.size());
	std::transform(Image.Values.begin(), Image.Values.end(), Pixels.begin(),
		[](double Value)
		{ return ToInteger<uint8_t>(std::round((Value > 0.0 ? std::min(Value, 1.0) : 0.0) * 255.0)); });
	WriteImage(Path, Spec, OIIO::TypeDesc::UINT8, Pixels.data());
}

} // namespace Drydock
