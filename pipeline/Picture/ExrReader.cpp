// Hands OpenEXR the planes that it fills.
#include "Picture/ExrReader.h"

#include "Picture/ExrStreams.h"
#include "Picture/ImagePlane.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <limits>

namespace Drydock
{

namespace
{

constexpr double GreatestUint = std::numeric_limits<uint32_t>::max();

/** Far enough that nothing is there, and near enough to be counted on with. */
int GetClampedDistance(int From, int To)
{
	constexpr int64_t Farthest = int64_t(1) << 30;
	return static_cast<int>(std::clamp(int64_t(To) - From, -Farthest, Farthest));
}

/** Layers by name; of each, colours in the order that they are spoken in, then the rest by name. */
bool ComesBefore(const std::string& One, const std::string& Other)
{
	const auto Split = [](const std::string& Name)
	{
		const size_t Dot = Name.rfind('.');
		return Dot == std::string::npos ? std::make_pair(std::string(), Name)
										: std::make_pair(Name.substr(0, Dot), Name.substr(Dot + 1));
	};
	const auto Rank = [](const std::string& Component)
	{
		constexpr std::array<const char*, 4> Colors = {"R", "G", "B", "A"};
		return std::find(Colors.begin(), Colors.end(), Component) - Colors.begin();
	};
	const auto [Layer, Component] = Split(One);
	const auto [OtherLayer, OtherComponent] = Split(Other);
	return std::make_tuple(Layer, Rank(Component), Component) <
		   std::make_tuple(OtherLayer, Rank(OtherComponent), OtherComponent);
}

FImagePart MakePart(const Imf::Header& Header)
{
	const Imath::Box2i& Data = Header.dataWindow();
	const Imath::Box2i& Display = Header.displayWindow();
	FImagePart Part;
	Part.Name = Header.hasName() ? Header.name() : "";
	Part.Width = Data.max.x - Data.min.x + 1;
	Part.Height = Data.max.y - Data.min.y + 1;
	Part.Window = {GetClampedDistance(Display.min.x, Data.min.x), GetClampedDistance(Display.min.y, Data.min.y),
		GetClampedDistance(Display.min.x, Display.max.x) + 1, GetClampedDistance(Display.min.y, Display.max.y) + 1};
	for (auto Channel = Header.channels().begin(); Channel != Header.channels().end(); ++Channel)
	{
		Part.Channels.push_back(Channel.name());
	}
	std::sort(Part.Channels.begin(), Part.Channels.end(), ComesBefore);
	for (const std::string& Name : Part.Channels)
	{
		Part.Greatest.push_back(Header.channels().findChannel(Name)->type == Imf::UINT ? GreatestUint : 0.0);
	}
	for (auto Attribute = Header.begin(); Attribute != Header.end(); ++Attribute)
	{
		if (const auto* Text = dynamic_cast<const Imf::StringAttribute*>(&Attribute.attribute()))
		{
			Part.Attributes[Attribute.name()] = Text->value();
		}
		if (const auto* Primaries = dynamic_cast<const Imf::ChromaticitiesAttribute*>(&Attribute.attribute()))
		{
			const Imf::Chromaticities& Of = Primaries->value();
			Part.Chromaticities = {
				Of.red.x, Of.red.y, Of.green.x, Of.green.y, Of.blue.x, Of.blue.y, Of.white.x, Of.white.y};
		}
	}
	const auto ColorSpace = Part.Attributes.find("oiio:ColorSpace"); // files that OpenImageIO wrote
	Part.bEncoded = ColorSpace != Part.Attributes.end() && ColorSpace->second == "sRGB";
	return Part;
}

class FExrReader final : public IImageReader
{
public:
	FExrReader(const std::string& Path, std::unique_ptr<std::istream> InStream)
		: Stream(MakeExrStream(Path, std::move(InStream)))
		, File(*Stream, CountExrThreads())
	{
		for (int Part = 0; Part < File.parts(); ++Part)
		{
			Parts.push_back(MakePart(File.header(Part)));
		}
	}

	const std::vector<FImagePart>& GetParts() const override { return Parts; }

	std::vector<FImagePlane> Read(int PartIndex, const std::vector<int>& Channels) override
	{
		const FImagePart& Part = Parts[static_cast<size_t>(PartIndex)];
		const Imf::Header& Header = File.header(PartIndex);
		const size_t NumPixels = static_cast<size_t>(Part.Width) * static_cast<size_t>(Part.Height);
		std::vector<FImagePlane> Planes(Channels.size());
		std::vector<std::vector<uint32_t>> Integers(Channels.size());
		Imf::FrameBuffer Buffer;
		for (size_t Index = 0; Index < Channels.size(); ++Index)
		{
			const std::string& Name = Part.Channels[static_cast<size_t>(Channels[Index])];
			const auto Take = [&](Imf::PixelType Type, auto& Values)
			{
				Values.resize(NumPixels);
				const size_t Size = sizeof(Values[0]);
				Buffer.insert(Name, Imf::Slice::Make(Type, Values.data(), Header.dataWindow(), Size,
										Size * static_cast<size_t>(Part.Width)));
			};
			switch (Header.channels().findChannel(Name)->type)
			{
			case Imf::HALF:
				Take(Imf::HALF, Planes[Index].Halves);
				break;
			case Imf::UINT:
				Take(Imf::UINT, Integers[Index]);
				break;
			default:
				Take(Imf::FLOAT, Planes[Index].Floats);
			}
		}
		Imf::InputPart Input(File, PartIndex);
		Input.setFrameBuffer(Buffer);
		Input.readPixels(Header.dataWindow().min.y, Header.dataWindow().max.y);
		for (size_t Index = 0; Index < Channels.size(); ++Index)
		{
			std::transform(Integers[Index].begin(), Integers[Index].end(), std::back_inserter(Planes[Index].Floats),
				[](uint32_t Value) { return static_cast<float>(Value) * (1.0f / static_cast<float>(GreatestUint)); });
		}
		return Planes;
	}

private:
	std::unique_ptr<Imf::IStream> Stream; // goes last: File reads from it
	Imf::MultiPartInputFile File;
	std::vector<FImagePart> Parts;
};

} // namespace

std::unique_ptr<IImageReader> MakeExrReader(const std::string& Path, std::unique_ptr<std::istream> Stream)
{
	return std::make_unique<FExrReader>(Path, std::move(Stream));
}

} // namespace Drydock
