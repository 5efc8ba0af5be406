// Reads and writes parts by OpenImageIO. What is read was looked at by FImageFile before.
#include <fmt/format.h>

#include <Imath/half.h>
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "Picture/ImageParts.h"

#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace Drydock
{

namespace
{

FError MakeError(EConfigError Code, const std::string& Path, std::string Message)
{
	std::replace(Message.begin(), Message.end(), '\n', ' '); // the library's may run over several lines
	return FError({.Code = Code, .Message = Message, .File = Path}, ExitFiles);
}

/** The header of the first part is checked, and with it those of all others. */
std::unique_ptr<OIIO::ImageInput> Open(const std::string& Path)
{
	const FImageFile Checked(Path);
	std::unique_ptr<OIIO::ImageInput> Input = OIIO::ImageInput::open(Path);
	if (!Input)
	{
		throw MakeError(ErrorImageBroken, Path, "the image file cannot be read: " + OIIO::geterror());
	}
	return Input;
}

int GetDistance(int From, int To)
{
	constexpr int64_t Farthest = int64_t(1) << 30;
	return static_cast<int>(std::clamp(int64_t(To) - From, -Farthest, Farthest));
}

double GetGreatest(OIIO::TypeDesc Type)
{
	return Type == OIIO::TypeDesc::UINT8    ? 255.0
		   : Type == OIIO::TypeDesc::UINT16 ? 65535.0
		   : Type == OIIO::TypeDesc::UINT32 ? 4294967295.0
											: 0.0;
}

FImagePart MakePart(const OIIO::ImageSpec& Spec)
{
	FImagePart Part;
	Part.Name = Spec.get_string_attribute("oiio:subimagename");
	Part.Width = Spec.width;
	Part.Height = Spec.height;
	Part.Window = {
		GetDistance(Spec.full_x, Spec.x), GetDistance(Spec.full_y, Spec.y), Spec.full_width, Spec.full_height};
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
		const OIIO::TypeDesc Type = Value.type();
		if (Value.name().string() == "chromaticities" && Type.basetype == OIIO::TypeDesc::FLOAT &&
			Type.basevalues() == 8)
		{
			const float* const Numbers = static_cast<const float*>(Value.data());
			Part.Chromaticities.assign(Numbers, Numbers + 8);
		}
	}
	return Part;
}

bool IsExactHalf(float Value)
{
	return std::isfinite(Value) && static_cast<float>(half(Value)) == Value;
}

} // namespace

std::vector<FImagePart> ReadImageParts(const std::string& Path)
{
	const std::unique_ptr<OIIO::ImageInput> Input = Open(Path);
	std::vector<FImagePart> Parts;
	while (Input->seek_subimage(static_cast<int>(Parts.size()), 0))
	{
		Parts.push_back(MakePart(Input->spec()));
	}
	Input->geterror(); // that there are no more
	return Parts;
}

std::vector<std::vector<float>> ReadImagePlanes(
	const std::string& Path, int Part, const std::vector<int>& ChannelIndices)
{
	std::vector<std::vector<float>> Planes(ChannelIndices.size());
	if (ChannelIndices.empty())
	{
		return Planes;
	}
	const std::unique_ptr<OIIO::ImageInput> Input = Open(Path);
	if (!Input->seek_subimage(Part, 0))
	{
		throw MakeError(ErrorImageBroken, Path, fmt::format("the image file has no part {}", Part));
	}
	const OIIO::ImageSpec& Spec = Input->spec();
	const auto [First, Last] = std::minmax_element(ChannelIndices.begin(), ChannelIndices.end());
	const size_t NumRead = static_cast<size_t>(*Last + 1 - *First);
	const size_t NumPixels = static_cast<size_t>(Spec.width) * static_cast<size_t>(Spec.height);
	std::vector<float> Values(NumPixels * NumRead);
	if (!Input->read_image(Part, 0, *First, *Last + 1, OIIO::TypeDesc::FLOAT, Values.data()))
	{
		throw MakeError(ErrorImageBroken, Path, "the image file is truncated or corrupt: " + Input->geterror());
	}
	for (size_t Plane = 0; Plane < Planes.size(); ++Plane)
	{
		const size_t Channel = static_cast<size_t>(ChannelIndices[Plane] - *First);
		Planes[Plane].resize(NumPixels);
		for (size_t Pixel = 0; Pixel < NumPixels; ++Pixel)
		{
			Planes[Plane][Pixel] = Values[Pixel * NumRead + Channel];
		}
	}
	return Planes;
}

void WriteExrPlanes(const std::string& Path, int Width, int Height, const std::vector<std::vector<float>>& Planes,
	const std::vector<std::string>& ChannelNames, const std::map<std::string, std::string>& Attributes)
{
	OIIO::ImageSpec Spec(Width, Height, static_cast<int>(Planes.size()), OIIO::TypeDesc::FLOAT);
	Spec.channelnames = ChannelNames;
	Spec.attribute("compression", "zip");
	Spec.attribute("DateTime", ""); // else the library adds today's
	for (const auto& [Name, Text] : Attributes)
	{
		Spec.attribute(Name, Text);
	}
	std::vector<float> Pixels(static_cast<size_t>(Width) * static_cast<size_t>(Height) * Planes.size());
	for (size_t Channel = 0; Channel < Planes.size(); ++Channel)
	{
		const std::vector<float>& Plane = Planes[Channel];
		const bool bHalf = std::all_of(Plane.begin(), Plane.end(), IsExactHalf);
		Spec.channelformats.push_back(bHalf ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
		for (size_t Pixel = 0; Pixel < Plane.size(); ++Pixel)
		{
			Pixels[Pixel * Planes.size() + Channel] = Plane[Pixel];
		}
	}
	OIIO::Filesystem::IOVecOutput Memory; // the library does not notice a full disk
	const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
	if (!Output || !Output->set_ioproxy(&Memory) || !Output->open(Path, Spec) ||
		!Output->write_image(OIIO::TypeDesc::FLOAT, Pixels.data()) || !Output->close())
	{
		throw MakeError(ErrorFileNotWritten, Path,
			"the picture cannot be written: " + (Output ? Output->geterror() : OIIO::geterror()));
	}
	WriteWholeFile(Path, std::string(Memory.buffer().begin(), Memory.buffer().end()));
}

} // namespace Drydock
