// Reads an OpenEXR header and refuses what the file cannot hold. Source: "OpenEXR File Layout", ASWF.
#include "Picture/ExrHeader.h"

#include "Text/Fmt.inl"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace Drydock
{

namespace
{

constexpr uint32_t Magic = 20000630;
constexpr uint32_t MultiPartFlag = 0x1000;
constexpr size_t MaxParts = 1024;
/** Tiles larger than the window are legal, up to this many pixels a side. */
constexpr int64_t MaxTileSide = 512;

struct FCompression
{
	int64_t LinesPerChunk;
	/** Bytes of pixels that one byte of the file can hold at most. Deflate: 1032. A PIZ symbol repeated 256 times takes
	 * ten bits. A DWA block of 8 x 8 floats is two words and a run, deflated. */
	int64_t GreatestRatio;
};

/** By the number in the header: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB. */
constexpr std::array<FCompression, 10> Compressions = {
	{{1, 1}, {1, 64}, {1, 1032}, {16, 1032}, {32, 1032}, {16, 1376}, {32, 16}, {32, 16}, {32, 70000}, {256, 70000}}};

struct FFixedType
{
	std::string_view Name;
	int64_t Size;
};

/** OpenEXR takes from values of these types what the type needs, whatever size stands before them, and reads on behind
 * that: where the two differ, it sees another header than the one that is checked here. */
constexpr std::array<FFixedType, 24> FixedTypes = {{{"box2f", 16}, {"box2i", 16}, {"chromaticities", 32},
	{"compression", 1}, {"deepImageState", 1}, {"double", 8}, {"envmap", 1}, {"float", 4}, {"int", 4}, {"keycode", 28},
	{"lineOrder", 1}, {"m33d", 72}, {"m33f", 36}, {"m44d", 128}, {"m44f", 64}, {"rational", 8}, {"tiledesc", 9},
	{"timecode", 8}, {"v2d", 16}, {"v2f", 8}, {"v2i", 8}, {"v3d", 24}, {"v3f", 12}, {"v3i", 12}}};

/** The fields of a part's header that determine the memory it needs. */
struct FPart
{
	int64_t Width = 0;
	int64_t Height = 0;
	int64_t TileWidth = 0; // 0: lines
	int64_t TileHeight = 0;
	int64_t NumChunks = 0; // 0: not said
	size_t Compression = 0;
	int64_t NumChannels = 0;
	int64_t BytesPerPixel = 0;
	bool bDeep = false;
};

void ReadWindow(FHeaderBytes& Bytes, FPart& Part)
{
	const int64_t MinX = Bytes.Read<int32_t>();
	const int64_t MinY = Bytes.Read<int32_t>();
	const int64_t MaxX = Bytes.Read<int32_t>();
	const int64_t MaxY = Bytes.Read<int32_t>();
	Part.Width = MaxX - MinX + 1;
	Part.Height = MaxY - MinY + 1;
	Bytes.CheckSize(Part.Width, Part.Height);
}

void ReadChannels(FHeaderBytes& Bytes, FPart& Part)
{
	Part.NumChannels = 0;
	Part.BytesPerPixel = 0;
	for (std::string Name = Bytes.ReadText(); !Name.empty(); Name = Bytes.ReadText())
	{
		const uint32_t Type = Bytes.Read<uint32_t>(); // 0: uint, 1: half, 2: float
		Bytes.Read<uint32_t>();                       // how it is best quantised
		const int32_t SamplingX = Bytes.Read<int32_t>();
		const int32_t SamplingY = Bytes.Read<int32_t>();
		if (Type > 2)
		{
			Bytes.Fail("is corrupt: its channel \"" + Name + "\" is of no known type");
		}
		if (SamplingX != 1 || SamplingY != 1)
		{
			Bytes.Fail("cannot be read: its channel \"" + Name + "\" has fewer pixels than the picture");
		}
		++Part.NumChannels;
		Part.BytesPerPixel += Type == 1 ? 2 : 4;
	}
}

void ReadAttribute(FHeaderBytes& Bytes, const std::string& Name, FPart& Part)
{
	if (Name == "dataWindow")
	{
		ReadWindow(Bytes, Part);
	}
	else if (Name == "channels")
	{
		ReadChannels(Bytes, Part);
	}
	else if (Name == "compression")
	{
		Part.Compression = Bytes.Read<uint8_t>();
		if (Part.Compression >= Compressions.size())
		{
			Bytes.Fail("is corrupt: its compression has the number " + std::to_string(Part.Compression));
		}
	}
	else if (Name == "tiles")
	{
		Part.TileWidth = Bytes.Read<uint32_t>();
		Part.TileHeight = Bytes.Read<uint32_t>();
		if (Part.TileWidth < 1 || Part.TileHeight < 1)
		{
			Bytes.Fail("is corrupt: its tiles have no pixels");
		}
	}
	else if (Name == "chunkCount")
	{
		Part.NumChunks = std::max<int64_t>(0, Bytes.Read<int32_t>());
	}
	else if (Name == "type")
	{
		const auto Start = Bytes.Read<std::array<char, 4>>();
		Part.bDeep = std::string(Start.begin(), Start.end()) == "deep";
	}
}

/** Texts, each behind its length, up to End exactly. Leaves the position where it was. */
bool IsStringVector(FHeaderBytes& Bytes, int64_t End)
{
	const int64_t Begin = Bytes.GetPosition();
	int64_t At = Begin;
	while (At + 4 <= End)
	{
		Bytes.SkipTo(At);
		const int64_t Length = Bytes.Read<int32_t>();
		At = Length < 0 ? End + 1 : At + 4 + Length;
	}
	Bytes.SkipTo(Begin);
	return At == End;
}

/** False: the empty header that ends the list of parts. */
bool ReadPart(FHeaderBytes& Bytes, FPart& Part)
{
	bool bAny = false;
	for (std::string Name = Bytes.ReadText(); !Name.empty(); Name = Bytes.ReadText())
	{
		bAny = true;
		const std::string Type = Bytes.ReadText();
		const int64_t Size = Bytes.Read<int32_t>();
		const int64_t End = Bytes.GetPosition() + Size;
		if (Size < 0 || Size > Bytes.GetLeft())
		{
			Bytes.Fail(fmt::format("is truncated or corrupt: its attribute \"{}\" says {} bytes", Name, Size));
		}
		const auto Fixed = std::ranges::find(FixedTypes, Type, &FFixedType::Name);
		const bool bFits = Fixed != FixedTypes.end() ? Size == Fixed->Size
						   : Type == "floatvector"   ? Size % 4 == 0
						   : Type == "stringvector"  ? IsStringVector(Bytes, End)
													 : true;
		ReadAttribute(Bytes, Name, Part);
		if (!bFits || Bytes.GetPosition() > End || (Type == "chlist" && Bytes.GetPosition() != End))
		{
			Bytes.Fail("is corrupt: its attribute \"" + Name + "\" has another size than it states");
		}
		Bytes.SkipTo(End);
	}
	return bAny;
}

int64_t DivideUp(int64_t Value, int64_t By)
{
	return (Value + By - 1) / By;
}

/** Chunks of the part, of the largest level only where it is tiled. */
int64_t CountChunks(const FPart& Part)
{
	const int64_t Computed = Part.TileWidth != 0
								 ? DivideUp(Part.Width, Part.TileWidth) * DivideUp(Part.Height, Part.TileHeight)
								 : DivideUp(Part.Height, Compressions[Part.Compression].LinesPerChunk);
	return std::max(Computed, Part.NumChunks);
}

void CheckPart(const FPart& Part, const FHeaderBytes& Bytes)
{
	if (Part.Width == 0 || Part.NumChannels == 0)
	{
		Bytes.Fail("holds no picture");
	}
	if (Part.bDeep)
	{
		Bytes.Fail("cannot be read: it is a deep picture, with several values to a pixel");
	}
	if (Part.TileWidth > std::max(Part.Width, MaxTileSide) || Part.TileHeight > std::max(Part.Height, MaxTileSide))
	{
		Bytes.Fail("is corrupt: its tiles are larger than the picture");
	}
	const std::string Size = fmt::format("{} bytes cannot hold", Bytes.GetSize());
	if (CountChunks(Part) > Bytes.GetLeft() / 8)
	{
		Bytes.Fail("is truncated or corrupt: its " + Size + " the table of its chunks");
	}
	const int64_t Raw = Part.Width * Part.Height * Part.BytesPerPixel;
	if (Raw / Compressions[Part.Compression].GreatestRatio > Bytes.GetSize())
	{
		Bytes.Fail(fmt::format("is truncated or corrupt: its {} {} x {} pixels of {} channels", Size, Part.Width,
			Part.Height, Part.NumChannels));
	}
}

} // namespace

void CheckExrHeader(FHeaderBytes& Bytes)
{
	Bytes.SkipTo(0);
	if (Bytes.Read<uint32_t>() != Magic)
	{
		Bytes.Fail("cannot be read: it is not an OpenEXR file");
	}
	const bool bMultiPart = (Bytes.Read<uint32_t>() & MultiPartFlag) != 0;
	std::vector<FPart> Parts;
	for (FPart Part; Parts.size() < MaxParts && ReadPart(Bytes, Part); Part = FPart())
	{
		Parts.push_back(Part);
		if (!bMultiPart)
		{
			break;
		}
	}
	if (Parts.empty())
	{
		Bytes.Fail("holds no picture");
	}
	for (const FPart& Part : Parts)
	{
		CheckPart(Part, Bytes);
	}
}

} // namespace Drydock
