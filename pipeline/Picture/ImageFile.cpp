// Chooses the reader of an image file and looks at its header first; writes pictures row by row. Source of the sRGB
// curve: IEC 61966-2-1, and of the film curve: Kodak, "Conversion of 10-bit Log Film Data to 8-bit Linear or Video Data
// for the Cineon Digital Film System", 1995.
#include "Picture/ImageFile.h"

#include "DiagnosticList.h"
#include "Math/ToInteger.h"
#include "Picture/ExrReader.h"
#include "Picture/ExrWriter.h"
#include "Picture/ImageBytes.h"
#include "Picture/ImageErrors.h"
#include "Picture/ImageFormat.h"
#include "Picture/ImagePlane.h"
#include "Picture/OpenImageIOReader.h"
#include "Picture/PngReader.h"
#include "Picture/PngWriter.h"
#include "RegularFile.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <new>
#include <sstream>

namespace Drydock
{

namespace
{

float DecodeSrgbFloat(float Encoded)
{
	return Encoded <= 0.04045f ? Encoded / 12.92f : static_cast<float>(std::pow((Encoded + 0.055) / 1.055, 2.4));
}

/** Code 685 of 1023 is white, 1, and code 95 is black; a code is 0.002 of density, and film has a gamma of 0.6. */
float DecodeFilmLog(float Encoded)
{
	const auto Expose = [](double Code)
	{
		return std::pow(10.0, (Code - 685.0) * 0.002 / 0.6);
	};
	return static_cast<float>((Expose(static_cast<double>(Encoded) * 1023.0) - Expose(95.0)) / (1.0 - Expose(95.0)));
}

bool IsColorChannel(const std::string& Name)
{
	return Name == "R" || Name == "G" || Name == "B" || Name == "Y" || Name == "I";
}

/** Numbers that one read gives: 8 GB of them. */
constexpr size_t MaxImageValues = size_t(1) << 31;

std::unique_ptr<IImageReader> OpenImage(const std::string& Path)
{
	const std::string* const Bytes = FImageBytes::Find(Path);
	const FRegularFile Readable(Bytes == nullptr ? Path : "");
	if (Bytes == nullptr && !Readable.GetProblem().empty())
	{
		throw MakeImageError(ErrorFileMissing, Path, "the image file cannot be opened: " + Readable.GetProblem());
	}
	std::unique_ptr<std::istream> Stream =
		Bytes != nullptr ? std::unique_ptr<std::istream>(std::make_unique<std::istringstream>(*Bytes))
						 : std::make_unique<std::ifstream>(Path, std::ios::binary);
	FHeaderBytes Header(Path, *Stream);
	const std::string Format = CheckImageHeader(Path, Header); // OpenImageIO's name
	Header.SkipTo(0);
	try
	{
		return Format == "openexr" ? MakeExrReader(Path, std::move(Stream))
			   : Format == "png"   ? MakePngReader(std::move(Stream))
								   : MakeOpenImageIOReader(Path, Bytes, Format);
	}
	catch (const std::exception& Error)
	{
		throw MakeImageError(ErrorImageBroken, Path, std::string("the image file cannot be read: ") + Error.what());
	}
}

/** Checks that the data after a part's header have the size that the header states. */
void CheckImagePart(const std::string& Path, const FImagePart& Part)
{
	if (Part.Width < 1 || Part.Height < 1 || Part.Channels.empty())
	{
		throw MakeImageError(ErrorImageBroken, Path, "the image file holds no picture");
	}
	if (Part.Width > MaxImageSide || Part.Height > MaxImageSide || int64_t(Part.Width) * Part.Height > MaxImagePixels)
	{
		throw MakeImageError(ErrorImageTooLarge, Path,
			fmt::format("the image file has {} x {} pixels; the largest frame is {} a side and {} in all", Part.Width,
				Part.Height, MaxImageSide, MaxImagePixels));
	}
}

/** A part's values, of which there may be none, laid into its display window. */
template<typename T>
void LayInto(std::vector<T>& Values, const FImagePart& Part, int Width, int Height)
{
	if (Values.empty())
	{
		return;
	}
	std::vector<T> Laid(static_cast<size_t>(Width) * static_cast<size_t>(Height), T(0));
	const int BeginX = std::max(Part.Window.X, 0);
	const int EndX = std::min(Part.Window.X + Part.Width, Width);
	for (int Y = std::max(Part.Window.Y, 0); Y < std::min(Part.Window.Y + Part.Height, Height) && BeginX < EndX; ++Y)
	{
		const auto From = Values.begin() + std::ptrdiff_t(Y - Part.Window.Y) * Part.Width + (BeginX - Part.Window.X);
		std::copy(From, From + (EndX - BeginX), Laid.begin() + std::ptrdiff_t(Y) * Width + BeginX);
	}
	Values = std::move(Laid);
}

} // namespace

FImageFile::FImageFile(const std::string& InPath, EImageExtent Extent)
	: Path(InPath)
	, Reader(OpenImage(InPath))
{
	for (const FImagePart& Part : GetParts())
	{
		CheckImagePart(Path, Part);
	}
	FImagePart Shown = GetParts()[0];
	if (Extent == EImageExtent::Display && Shown.Window.FullWidth > 0)
	{
		Shown.Width = Shown.Window.FullWidth;
		Shown.Height = Shown.Window.FullHeight;
		CheckImagePart(Path, Shown);
	}
	Width = Shown.Width;
	Height = Shown.Height;
}

bool FImageFile::IsWhole() const
{
	const FImagePart& Part = GetParts()[0];
	return Width == Part.Width && Height == Part.Height && Part.Window.X == 0 && Part.Window.Y == 0;
}

std::string FImageFile::DescribeExtent() const
{
	const FImagePart& Part = GetParts()[0];
	const FImageWindow& At = Part.Window;
	if (IsWhole() || Width != At.FullWidth || Height != At.FullHeight)
	{
		return {};
	}
	const bool bOver = At.X < 0 || At.Y < 0 || At.X + Part.Width > Width || At.Y + Part.Height > Height;
	const bool bShort = At.X > 0 || At.Y > 0 || At.X + Part.Width < Width || At.Y + Part.Height < Height;
	return fmt::format("the picture is the display window, {} x {} pixels; the data window is {} x {} at ({}, {}){}{}",
		Width, Height, Part.Width, Part.Height, At.X, At.Y, bOver ? "; what reaches over the edges is cut" : "",
		bShort ? "; what is missing is 0" : "");
}

FImageFile::~FImageFile() = default;

int FImageFile::FindChannel(const std::string& Name) const
{
	const std::vector<std::string>& Channels = GetChannels();
	const auto Found = std::find(Channels.begin(), Channels.end(), Name);
	return Found == Channels.end() ? -1 : static_cast<int>(Found - Channels.begin());
}

std::string FImageFile::GetAttribute(const std::string& Name) const
{
	const auto Found = GetParts()[0].Attributes.find(Name);
	return Found == GetParts()[0].Attributes.end() ? "" : Found->second;
}

std::vector<FImagePlane> FImageFile::ReadPart(int PartIndex, const std::vector<int>& ChannelIndices)
{
	if (ChannelIndices.empty())
	{
		return {};
	}
	const FImagePart& Part = GetParts()[static_cast<size_t>(PartIndex)];
	const size_t NumPixels = static_cast<size_t>(Part.Width) * static_cast<size_t>(Part.Height);
	if (NumPixels * ChannelIndices.size() > MaxImageValues)
	{
		throw MakeImageError(ErrorImageTooLarge, Path,
			fmt::format("{} channels of {} x {} pixels are wanted of the image file; at most {} values are read",
				ChannelIndices.size(), Part.Width, Part.Height, MaxImageValues));
	}
	std::vector<int> Unique = ChannelIndices;
	std::sort(Unique.begin(), Unique.end());
	Unique.erase(std::unique(Unique.begin(), Unique.end()), Unique.end());
	try
	{
		std::vector<FImagePlane> Read = Reader->Read(PartIndex, Unique);
		if (Unique == ChannelIndices)
		{
			return Read;
		}
		std::vector<FImagePlane> Planes;
		for (const int Channel : ChannelIndices)
		{
			const auto At = std::lower_bound(Unique.begin(), Unique.end(), Channel) - Unique.begin();
			Planes.push_back(Read[static_cast<size_t>(At)]);
		}
		return Planes;
	}
	catch (const std::bad_alloc&)
	{
		throw MakeMemoryError(
			fmt::format("{} channels of {} x {} pixels of {}", ChannelIndices.size(), Part.Width, Part.Height, Path),
			NumPixels * ChannelIndices.size() * sizeof(float));
	}
	catch (const std::exception& Error)
	{
		throw MakeImageError(
			ErrorImageBroken, Path, std::string("the image file is truncated or corrupt: ") + Error.what());
	}
}

std::vector<FImagePlane> FImageFile::ReadPlanes(const std::vector<int>& ChannelIndices)
{
	std::vector<FImagePlane> Planes = ReadPart(0, ChannelIndices);
	const FImagePart& Part = GetParts()[0];
	if (!DescribeExtent().empty())
	{
		for (FImagePlane& Plane : Planes)
		{
			LayInto(Plane.Halves, Part, Width, Height);
			LayInto(Plane.Floats, Part, Width, Height);
		}
	}
	for (size_t Index = 0; (IsEncoded() || Part.bFilmLog) && Index < Planes.size(); ++Index)
	{
		if (IsColorChannel(GetChannels()[static_cast<size_t>(ChannelIndices[Index])]))
		{
			FImagePlane& Plane = Planes[Index];
			Plane.MakeFloats();
			std::transform(Plane.Floats.begin(), Plane.Floats.end(), Plane.Floats.begin(),
				Part.bFilmLog ? DecodeFilmLog : DecodeSrgbFloat);
		}
	}
	return Planes;
}

std::vector<std::vector<float>> FImageFile::Read(const std::vector<int>& ChannelIndices)
{
	std::vector<std::vector<float>> Floats;
	for (FImagePlane& Plane : ReadPlanes(ChannelIndices))
	{
		Plane.MakeFloats();
		Floats.push_back(std::move(Plane.Floats));
	}
	return Floats;
}

void WriteExr(const std::string& Path, const FImage& Image, const std::vector<std::string>& ChannelNames,
	const std::map<std::string, std::string>& Attributes, const FImageWindow& Window)
{
	// Half floats where they lose nothing: half the size, and faster to compress.
	const bool bHalf = std::all_of(Image.Values.begin(), Image.Values.end(), IsExactHalf);
	const FExrDescription Description = {.Width = Image.Width,
		.Height = Image.Height,
		.Channels = ChannelNames,
		.Half = std::vector<bool>(ChannelNames.size(), bHalf),
		.Attributes = Attributes,
		.Window = Window};
	const std::ptrdiff_t RowSize = std::ptrdiff_t(Image.Width) * Image.NumChannels;
	WriteExrRows(Path, Description,
		[&](int Y, float* Row)
		{
			const auto Begin = Image.Values.begin() + Y * RowSize;
			std::transform(Begin, Begin + RowSize, Row, [](double Value) { return static_cast<float>(Value); });
		});
}

void WritePng(const std::string& Path, const FImage& Image, EPngEffort Effort)
{
	const std::ptrdiff_t RowSize = std::ptrdiff_t(Image.Width) * Image.NumChannels;
	WritePngRows(Path, Image.Width, Image.Height, Image.NumChannels, Effort,
		[&](int Y, uint8_t* Row)
		{
			const auto Begin = Image.Values.begin() + Y * RowSize;
			std::transform(Begin, Begin + RowSize, Row,
				[](double Value)
				{ return ToInteger<uint8_t>(std::round((Value > 0.0 ? std::min(Value, 1.0) : 0.0) * 255.0)); });
		});
}

} // namespace Drydock
