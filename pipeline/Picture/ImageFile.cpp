// Reads and writes image files by OpenImageIO. Source of the sRGB curve: IEC 61966-2-1.
#include <fmt/format.h>

#include <Imath/half.h>
#include <OpenImageIO/imageio.h>

#include "Picture/ImageFile.h"

#include "Picture/ExrHeader.h"
#include "Text/ConfigErrors.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

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

} // namespace

namespace
{

/** Null with a reason. OpenEXR's reader alone gets its files: others would be asked about a broken one, too. */
std::unique_ptr<OIIO::ImageInput> Open(const std::string& Path, std::string& Fault)
{
	if (!IsExrFile(Path))
	{
		std::unique_ptr<OIIO::ImageInput> File = OIIO::ImageInput::open(Path);
		Fault = File ? std::string() : OIIO::geterror();
		return File;
	}
	CheckExrHeader(Path);
	std::unique_ptr<OIIO::ImageInput> File = OIIO::ImageInput::create("openexr");
	OIIO::ImageSpec Spec;
	if (!File || !File->open(Path, Spec))
	{
		Fault = File ? File->geterror() : OIIO::geterror();
		return nullptr;
	}
	return File;
}

/** Far enough that nothing is there, and near enough to be counted on with. */
int GetDistance(int From, int To)
{
	constexpr int64_t Farthest = int64_t(1) << 30;
	return static_cast<int>(std::clamp(int64_t(To) - From, -Farthest, Farthest));
}

} // namespace

struct FImageFile::FInput
{
	std::unique_ptr<OIIO::ImageInput> File;
};

FImageFile::FImageFile(const std::string& InPath)
	: Path(InPath)
	, Input(std::make_unique<FInput>())
{
	if (!std::filesystem::is_regular_file(Path))
	{
		throw MakeError(ErrorFileMissing, Path, "the image file cannot be opened: there is no such file");
	}
	std::string Fault;
	Input->File = Open(Path, Fault);
	if (!Input->File)
	{
		throw MakeError(ErrorImageBroken, Path, "the image file cannot be read: " + OneLine(Fault));
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
	const size_t NumRead = static_cast<size_t>(*Last - Begin + 1);
	const size_t NumPixels = static_cast<size_t>(Width) * static_cast<size_t>(Height);
	std::vector<float> Pixels(NumPixels * NumRead);
	if (!Input->File->read_image(0, 0, Begin, *Last + 1, OIIO::TypeDesc::FLOAT, Pixels.data()))
	{
		throw MakeError(
			ErrorImageBroken, Path, "the image file is truncated or corrupt: " + OneLine(Input->File->geterror()));
	}
	for (size_t Plane = 0; Plane < Planes.size(); ++Plane)
	{
		const size_t Channel = static_cast<size_t>(ChannelIndices[Plane] - Begin);
		const bool bDecode = bEncoded && IsColorChannel(Channels[static_cast<size_t>(ChannelIndices[Plane])]);
		Planes[Plane].resize(NumPixels);
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			const float Value = Pixels[Pixel * NumRead + Channel];
			Planes[Plane][Pixel] = bDecode ? DecodeSrgb(Value) : Value;
		}
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
	const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
	if (!Output || !Output->open(Path, Spec) || !Output->write_image(PixelType, Pixels) || !Output->close())
	{
		throw MakeError(ErrorFileNotWritten, Path,
			"the picture cannot be written: " + OneLine(Output ? Output->geterror() : OIIO::geterror()));
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
		{ return static_cast<uint8_t>(std::lround((Value > 0.0 ? std::min(Value, 1.0) : 0.0) * 255.0)); });
	WriteImage(Path, Spec, OIIO::TypeDesc::UINT8, Pixels.data());
}

} // namespace Drydock
