// Reads from each format's header how many pixels it claims. Sources: the PNG specification (W3C), ITU T.81 (JPEG),
// "Truevision TGA File Format Specification 2.0", Greg Ward's "Real Pixels" (Radiance), Microsoft's BITMAPINFOHEADER,
// TIFF 6.0 (Adobe), SMPTE 268M (DPX).
#include "Picture/ImageFormat.h"

#include "Picture/ExrHeader.h"
#include "Text/Fmt.inl"
#include "TextTools.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace Drydock
{

namespace
{

/** The picture as a header describes it. */
struct FImageClaim
{
	int64_t Width = 0;
	int64_t Height = 0;
	int64_t BitsPerPixel = 0;  // unpacked, as the format defines them
	int64_t GreatestRatio = 1; // bytes of pixels that one byte of the file can hold at most
};

/** Deflate copies 258 bytes by two bits at best. */
constexpr int64_t DeflateRatio = 1032;

/** Memory is taken for the size that a chunk claims. */
void CheckPngChunks(FHeaderBytes& Bytes)
{
	constexpr int64_t NumBytesAround = 12; // its length, type and checksum
	Bytes.SkipTo(8);
	while (Bytes.GetLeft() >= NumBytesAround)
	{
		const int64_t Length = Bytes.ReadBigEndian(4);
		Bytes.ReadBigEndian(4);
		if (Length > Bytes.GetLeft())
		{
			Bytes.Fail(fmt::format("is truncated or corrupt: a chunk says that it has {} bytes, and {} are left",
				Length, Bytes.GetLeft()));
		}
		Bytes.SkipTo(Bytes.GetPosition() + Length + 4);
	}
}

FImageClaim ReadPngClaim(FHeaderBytes& Bytes)
{
	CheckPngChunks(Bytes);
	Bytes.SkipTo(8);
	Bytes.ReadBigEndian(4);                   // length of the first chunk
	if (Bytes.ReadBigEndian(4) != 0x49484452) // IHDR
	{
		Bytes.Fail("is corrupt: its first chunk is not IHDR");
	}
	FImageClaim Claim;
	Claim.Width = Bytes.ReadBigEndian(4);
	Claim.Height = Bytes.ReadBigEndian(4);
	const int64_t Depth = Bytes.Read<uint8_t>();
	const uint8_t ColorType = Bytes.Read<uint8_t>(); // bits: palette, colour, alpha
	const bool bColor = (ColorType & 3) == 2;
	const bool bAlpha = (ColorType & 4) != 0;
	Claim.BitsPerPixel = Depth * ((bColor ? 3 : 1) + (bAlpha ? 1 : 0));
	Claim.GreatestRatio = DeflateRatio;
	return Claim;
}

/** A block of 8 x 8 values takes a bit in the first scan of a progressive picture, and a pixel may have 3 blocks less
 * than a sixteenth each: 1 to 1365. */
FImageClaim ReadJpegClaim(FHeaderBytes& Bytes)
{
	constexpr int64_t BlockRatio = 2048;
	Bytes.SkipTo(2);
	for (;;)
	{
		if (Bytes.Read<uint8_t>() != 0xFF)
		{
			Bytes.Fail("is corrupt: there is no marker where one should be");
		}
		uint8_t Marker = Bytes.Read<uint8_t>();
		while (Marker == 0xFF)
		{
			Marker = Bytes.Read<uint8_t>();
		}
		if (Marker == 0x01 || (Marker >= 0xD0 && Marker <= 0xD8))
		{
			continue; // stands alone
		}
		const int64_t Begin = Bytes.GetPosition();
		const int64_t Length = Bytes.ReadBigEndian(2);
		const bool bFrame = Marker >= 0xC0 && Marker <= 0xCF && Marker != 0xC4 && Marker != 0xC8 && Marker != 0xCC;
		if (bFrame)
		{
			FImageClaim Claim;
			const int64_t Depth = Bytes.Read<uint8_t>();
			Claim.Height = Bytes.ReadBigEndian(2);
			Claim.Width = Bytes.ReadBigEndian(2);
			Claim.BitsPerPixel = Depth * Bytes.Read<uint8_t>();
			Claim.GreatestRatio = BlockRatio;
			return Claim;
		}
		if (Length < 2)
		{
			Bytes.Fail("is corrupt: a part of its header has no length");
		}
		Bytes.SkipTo(Begin + Length);
	}
}

/** Lines of text, an empty one, and "-Y 480 +X 640". A run of 127 equal bytes takes two. */
FImageClaim ReadRadianceClaim(FHeaderBytes& Bytes)
{
	constexpr int64_t MaxHeader = 1 << 16;
	std::istringstream Lines(Bytes.Peek(MaxHeader));
	std::string Line;
	while (std::getline(Lines, Line) && !Line.empty())
	{
	}
	FImageClaim Claim;
	for (int Axis = 0; Axis < 2; ++Axis)
	{
		std::string Direction;
		int64_t Count = 0;
		if (!(Lines >> Direction >> Count) || Direction.size() != 2)
		{
			Bytes.Fail("is corrupt: its header has no size");
		}
		(Direction[1] == 'X' ? Claim.Width : Claim.Height) = Count;
	}
	Claim.BitsPerPixel = 32;
	Claim.GreatestRatio = 64;
	return Claim;
}

/** A run of 128 pixels takes one and a byte. */
FImageClaim ReadTargaClaim(FHeaderBytes& Bytes)
{
	Bytes.SkipTo(2);
	const uint8_t Type = Bytes.Read<uint8_t>();
	Bytes.SkipTo(12);
	FImageClaim Claim;
	Claim.Width = Bytes.Read<uint16_t>();
	Claim.Height = Bytes.Read<uint16_t>();
	Claim.BitsPerPixel = Bytes.Read<uint8_t>();
	Claim.GreatestRatio = Type >= 9 ? 128 : 1;
	return Claim;
}

/** A run of 255 pixels takes two bytes. */
FImageClaim ReadBmpClaim(FHeaderBytes& Bytes)
{
	Bytes.SkipTo(14);
	FImageClaim Claim;
	if (Bytes.Read<uint32_t>() == 12) // OS/2
	{
		Claim.Width = Bytes.Read<uint16_t>();
		Claim.Height = Bytes.Read<uint16_t>();
		Bytes.Read<uint16_t>(); // planes
		Claim.BitsPerPixel = Bytes.Read<uint16_t>();
		return Claim;
	}
	Claim.Width = Bytes.Read<int32_t>();
	Claim.Height = std::abs(int64_t(Bytes.Read<int32_t>())); // below 0: from the top
	Bytes.Read<uint16_t>();
	Claim.BitsPerPixel = Bytes.Read<uint16_t>();
	const uint32_t Compression = Bytes.Read<uint32_t>();
	Claim.GreatestRatio = Compression == 1 || Compression == 2 ? 255 : 1;
	return Claim;
}

uint32_t ReadNumber(FHeaderBytes& Bytes, bool bBigEndian, int NumBytes)
{
	return bBigEndian ? Bytes.ReadBigEndian(NumBytes) : NumBytes == 2 ? Bytes.Read<uint16_t>() : Bytes.Read<uint32_t>();
}

/** The first directory. The longest string of LZW, 3838 bytes, takes a code of 12 bits. */
FImageClaim ReadTiffClaim(FHeaderBytes& Bytes)
{
	constexpr int64_t LzwRatio = 2560;
	constexpr uint32_t Short = 3;
	const bool bBigEndian = Bytes.Peek(1) == "M";
	const auto Read = [&](int NumBytes)
	{
		return ReadNumber(Bytes, bBigEndian, NumBytes);
	};
	FImageClaim Claim;
	int64_t Depth = 1, NumSamples = 1;
	Bytes.SkipTo(4);
	Bytes.SkipTo(Read(4));
	for (uint32_t NumLeft = Read(2); NumLeft > 0; --NumLeft)
	{
		const int64_t Begin = Bytes.GetPosition();
		const uint32_t Tag = Read(2), Type = Read(2), Count = Read(4);
		if (Tag == 258 && Count > 2) // the samples' depths lie elsewhere; they are alike
		{
			Bytes.SkipTo(Read(4));
		}
		const uint32_t Value = Read(Type == Short ? 2 : 4);
		switch (Tag)
		{
		case 256:
			Claim.Width = Value;
			break;
		case 257:
			Claim.Height = Value;
			break;
		case 258:
			Depth = Value;
			break;
		case 259:
			Claim.GreatestRatio = Value == 1 ? 1 : LzwRatio;
			break;
		case 277:
			NumSamples = Value;
			break;
		default:
			break;
		}
		Bytes.SkipTo(Begin + 12);
	}
	Claim.BitsPerPixel = Depth * NumSamples;
	return Claim;
}

/** The first picture. A run has a count of 15 bits at most. */
FImageClaim ReadDpxClaim(FHeaderBytes& Bytes)
{
	const bool bBigEndian = Bytes.Peek(1) == "S";
	FImageClaim Claim;
	Bytes.SkipTo(772);
	Claim.Width = ReadNumber(Bytes, bBigEndian, 4);
	Claim.Height = ReadNumber(Bytes, bBigEndian, 4);
	Bytes.SkipTo(800);
	const uint8_t Descriptor = Bytes.Read<uint8_t>();
	Bytes.SkipTo(803);
	Claim.BitsPerPixel = Bytes.Read<uint8_t>() * (Descriptor == 51 ? 4 : Descriptor == 50 ? 3 : 1);
	Bytes.SkipTo(806);
	Claim.GreatestRatio = ReadNumber(Bytes, bBigEndian, 2) == 0 ? 1 : 1 << 15;
	return Claim;
}

/** Targa has no first bytes of its own: fields that no other format fills so. */
bool BeginsAsTarga(std::string_view First)
{
	const auto Byte = [First](size_t Index)
	{
		return static_cast<unsigned char>(First[Index]);
	};
	constexpr std::string_view Types("\x01\x02\x03\x09\x0A\x0B", 6);
	constexpr std::string_view Depths("\x08\x0F\x10\x18\x20", 5);
	return First.size() >= 18 && Byte(1) <= 1 && Types.find(First[2]) != std::string_view::npos &&
		   Depths.find(First[16]) != std::string_view::npos;
}

struct FImageFormat
{
	const char* Name;
	const char* Reader; // OpenImageIO's name
	std::vector<std::string> Extensions;
	std::vector<std::string_view> Firsts;              // bytes of every file, one of these; none: BeginsAsTarga
	FImageClaim (*ReadClaim)(FHeaderBytes&) = nullptr; // none: CheckExrHeader

	bool Begins(const std::string& Bytes) const
	{
		return Firsts.empty() ? BeginsAsTarga(Bytes)
							  : std::any_of(Firsts.begin(), Firsts.end(),
									[&](std::string_view First) { return Bytes.starts_with(First); });
	}
};

/** Those that configs/README.md lists. */
const std::vector<FImageFormat>& GetFormats()
{
	static const std::vector<FImageFormat> Formats = {
		{"OpenEXR", "openexr", {".exr"}, {"\x76\x2F\x31\x01"}},
		{"PNG", "png", {".png"}, {"\x89PNG\r\n\x1A\n"}, ReadPngClaim},
		{"Radiance HDR", "hdr", {".hdr"}, {"#?"}, ReadRadianceClaim},
		{"JPEG", "jpeg", {".jpg", ".jpeg"}, {"\xFF\xD8\xFF"}, ReadJpegClaim},
		{"Targa", "targa", {".tga"}, {}, ReadTargaClaim},
		{"BMP", "bmp", {".bmp"}, {"BM"}, ReadBmpClaim},
		{"TIFF", "tiff", {".tif", ".tiff"}, {std::string_view("II*\0", 4), std::string_view("MM\0*", 4)},
			ReadTiffClaim},
		{"DPX", "dpx", {".dpx"}, {"SDPX", "XPDS"}, ReadDpxClaim},
	};
	return Formats;
}

std::string GetExtension(const std::string& Path)
{
	return ToLowerCase(std::filesystem::path(Path).extension().string());
}

void CheckClaim(const FImageClaim& Claim, const FHeaderBytes& Bytes)
{
	Bytes.CheckSize(Claim.Width, Claim.Height);
	const int64_t NumBytes = (Claim.Width * Claim.BitsPerPixel + 7) / 8 * Claim.Height;
	if (NumBytes / Claim.GreatestRatio > Bytes.GetSize())
	{
		Bytes.Fail(fmt::format("is truncated or corrupt: its {} bytes cannot hold {} x {} pixels of {} bits",
			Bytes.GetSize(), Claim.Width, Claim.Height, Claim.BitsPerPixel));
	}
}

} // namespace

const std::vector<std::string>& GetImageExtensions()
{
	static const std::vector<std::string> Extensions = []
	{
		std::vector<std::string> All;
		for (const FImageFormat& Format : GetFormats())
		{
			All.insert(All.end(), Format.Extensions.begin(), Format.Extensions.end());
		}
		return All;
	}();
	return Extensions;
}

bool IsImagePath(const std::string& Path)
{
	const std::vector<std::string>& Known = GetImageExtensions();
	return std::ranges::find(Known, GetExtension(Path)) != Known.end();
}

std::string CheckImageHeader(const std::string& Path, FHeaderBytes& Bytes)
{
	const std::string Extension = GetExtension(Path);
	const std::string First = Bytes.Peek(18);
	const std::vector<FImageFormat>& Formats = GetFormats();
	const auto Format = std::ranges::find_if(Formats, [&](const FImageFormat& Known)
		{ return std::ranges::find(Known.Extensions, Extension) != Known.Extensions.end(); });
	if (Format == Formats.end())
	{
		Bytes.Fail("is of a format that is not read: the end of its name is none of " + JoinText(GetImageExtensions()));
	}
	if (!Format->Begins(First))
	{
		const auto Real = std::ranges::find_if(
			Formats, [&](const FImageFormat& Known) { return !Known.Firsts.empty() && Known.Begins(First); });
		Bytes.Fail(std::string("cannot be read: by its name it is ") + Format->Name + ", by its first bytes " +
				   (Real == Formats.end() ? "it is not" : Real->Name));
	}
	if (Format->ReadClaim == nullptr)
	{
		CheckExrHeader(Bytes);
	}
	else
	{
		CheckClaim(Format->ReadClaim(Bytes), Bytes);
	}
	return Format->Reader;
}

} // namespace Drydock
