// Converts rows to the types of their channels, and hands OpenEXR a band at a time.
#include "Picture/ExrWriter.h"

#include "DiagnosticList.h"
#include "Picture/ExrStreams.h"
#include "Picture/ImageErrors.h"
#include "Text/Fmt.inl"
#include "Text/TextFile.h"
#include "TileExecutor.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** By measurement (docs/performance.md): PIZ is smaller than ZIP on half floats, and faster; on 32-bit floats ZIP is,
 * and its lower levels take half the time of its usual one for a tenth more. */
constexpr int ZipLevel = 2;

/** ITU-R BT.2020: red, green, blue, white D65. */
Imf::Chromaticities MakeRec2020()
{
	return Imf::Chromaticities(Imath::V2f(0.708f, 0.292f), Imath::V2f(0.170f, 0.797f), Imath::V2f(0.131f, 0.046f),
		Imath::V2f(0.3127f, 0.3290f));
}

Imf::Header MakeHeader(const FExrDescription& Description)
{
	const FImageWindow& Window = Description.Window;
	const int FullWidth = Window.FullWidth > 0 ? Window.FullWidth : Description.Width;
	const int FullHeight = Window.FullHeight > 0 ? Window.FullHeight : Description.Height;
	const Imath::V2i Corner(Window.X, Window.Y);
	Imf::Header Header(Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(FullWidth - 1, FullHeight - 1)),
		Imath::Box2i(Corner, Corner + Imath::V2i(Description.Width - 1, Description.Height - 1)));
	const bool bHalf = std::all_of(Description.Half.begin(), Description.Half.end(), [](bool bOne) { return bOne; });
	Header.compression() = bHalf ? Imf::PIZ_COMPRESSION : Imf::ZIP_COMPRESSION;
	Header.zipCompressionLevel() = ZipLevel;
	for (size_t Channel = 0; Channel < Description.Channels.size(); ++Channel)
	{
		Header.channels().insert(
			Description.Channels[Channel], Imf::Channel(Description.Half[Channel] ? Imf::HALF : Imf::FLOAT));
	}
	for (const auto& [Name, Text] : Description.Attributes)
	{
		if (Name == ChromaticitiesName)
		{
			Imf::addChromaticities(Header, Text == "Rec.2020" ? MakeRec2020() : Imf::Chromaticities()); // else Rec.709
			continue;
		}
		Header.insert(Name, Imf::StringAttribute(Text));
	}
	return Header;
}

/** Rows of a picture on their way into the file, each channel for itself. */
class FBand
{
public:
	FBand(const FExrDescription& InDescription, int InHeight)
		: Description(InDescription)
		, Height(InHeight)
		, Halves(InDescription.Channels.size())
		, Floats(InDescription.Channels.size())
	{
		const size_t NumPixels = static_cast<size_t>(Description.Width) * static_cast<size_t>(Height);
		for (size_t Channel = 0; Channel < Halves.size(); ++Channel)
		{
			Description.Half[Channel] ? Halves[Channel].resize(NumPixels) : Floats[Channel].resize(NumPixels);
		}
	}

	/** From row First of the picture on, as many as there are. */
	void Fill(int First, const FRowSource& Rows)
	{
		const int NumRows = std::min(Height, Description.Height - First);
		const size_t NumChannels = Halves.size();
		ForEachTile(FKernelTile{0, 0, 0, Description.Width, NumRows, 1}, FIntPoint(Description.Width, 8),
			[&](const FKernelTile& Tile)
			{
				std::vector<float> Row(static_cast<size_t>(Description.Width) * NumChannels);
				for (int Y = Tile.MinY; Y < Tile.MaxY; ++Y)
				{
					Rows(First + Y, Row.data());
					for (size_t Channel = 0; Channel < NumChannels; ++Channel)
					{
						Take(Row, Channel, static_cast<size_t>(Y) * static_cast<size_t>(Description.Width));
					}
				}
			});
	}

	/** As OpenEXR wants it, where the first row of the band is row First of the picture. */
	Imf::FrameBuffer MakeBuffer(int First)
	{
		Imf::FrameBuffer Buffer;
		const Imath::V2i Corner(Description.Window.X, Description.Window.Y + First);
		const Imath::Box2i Window(Corner, Corner + Imath::V2i(Description.Width - 1, Height - 1));
		for (size_t Channel = 0; Channel < Halves.size(); ++Channel)
		{
			const bool bHalf = Description.Half[Channel];
			const size_t Size = bHalf ? sizeof(uint16_t) : sizeof(float);
			const void* const Data = bHalf ? static_cast<const void*>(Halves[Channel].data()) : Floats[Channel].data();
			Buffer.insert(Description.Channels[Channel], Imf::Slice::Make(bHalf ? Imf::HALF : Imf::FLOAT, Data, Window,
															 Size, Size * static_cast<size_t>(Description.Width)));
		}
		return Buffer;
	}

private:
	void Take(const std::vector<float>& Row, size_t Channel, size_t At)
	{
		const size_t NumChannels = Halves.size();
		for (size_t From = Channel; From < Row.size(); From += NumChannels, ++At)
		{
			if (Description.Half[Channel])
			{
				Halves[Channel][At] = imath_float_to_half(Row[From]);
			}
			else
			{
				Floats[Channel][At] = Row[From];
			}
		}
	}

	const FExrDescription& Description;
	const int Height;
	std::vector<std::vector<uint16_t>> Halves;
	std::vector<std::vector<float>> Floats;
};

} // namespace

void WriteExrRows(const std::string& Path, const FExrDescription& Description, const FRowSource& Rows)
{
	constexpr int BandHeight = 128; // a multiple of what is packed together
	FExrOutput Output;
	try
	{
		Imf::OutputFile File(Output, MakeHeader(Description), CountExrThreads());
		FBand Band(Description, std::min(BandHeight, Description.Height));
		for (int First = 0; First < Description.Height; First += BandHeight)
		{
			Band.Fill(First, Rows);
			File.setFrameBuffer(Band.MakeBuffer(First));
			File.writePixels(std::min(BandHeight, Description.Height - First));
		}
	}
	catch (const FError&)
	{
		throw;
	}
	catch (const std::exception& Error)
	{
		throw MakeImageError(ErrorFileNotWritten, Path, std::string("the picture cannot be written: ") + Error.what());
	}
	WriteWholeFile(Path, Output.GetBytes());
}

bool IsExactHalf(double Value)
{
	const float Narrow = static_cast<float>(Value);
	return std::isfinite(Value) && static_cast<double>(imath_half_to_float(imath_float_to_half(Narrow))) == Value;
}

void WriteExrPlanes(const std::string& Path, int Width, int Height, const std::vector<std::vector<float>>& Planes,
	const std::vector<std::string>& ChannelNames, const std::map<std::string, std::string>& Attributes)
{
	FExrDescription Description;
	Description.Width = Width;
	Description.Height = Height;
	Description.Channels = ChannelNames;
	Description.Attributes = Attributes;
	for (const std::vector<float>& Plane : Planes)
	{
		Description.Half.push_back(std::all_of(Plane.begin(), Plane.end(), IsExactHalf));
	}
	WriteExrRows(Path, Description,
		[&](int Y, float* Row)
		{
			const size_t First = static_cast<size_t>(Y) * static_cast<size_t>(Width);
			for (size_t X = 0; X < static_cast<size_t>(Width); ++X)
			{
				for (const std::vector<float>& Plane : Planes)
				{
					*Row++ = Plane[First + X];
				}
			}
		});
}

} // namespace Drydock
