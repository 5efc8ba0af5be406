// Which files are opened as pictures: by the end of their name and their first bytes, and only where the file can hold
// what its header claims. Headers are written here byte by byte, from the formats' specifications.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "Picture/ImageBytes.h"
#include "Picture/ImageFile.h"
#include "Picture/ImageFormat.h"
#include "Text/ConfigErrors.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <unistd.h>

using namespace Drydock;

namespace
{

class ImageFormat : public testing::Test
{
protected:
	ImageFormat()
		: Folder(std::filesystem::temp_directory_path() / ("drydock_format_" + std::to_string(getpid())))
	{
		std::filesystem::create_directories(Folder);
	}
	~ImageFormat() override { std::filesystem::remove_all(Folder); }

	std::string Write(const std::string& Name, const std::string& Bytes) const
	{
		std::ofstream(Folder / Name, std::ios::binary) << Bytes;
		return (Folder / Name).string();
	}

	const std::filesystem::path Folder;
};

/** The message, without the path, of opening and reading all of a file; empty where that succeeds. */
std::string ErrorOf(const std::string& Path)
{
	try
	{
		FImageFile File(Path);
		std::vector<int> All(File.GetChannels().size());
		std::iota(All.begin(), All.end(), 0);
		File.Read(All);
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitFiles, Error.GetExitCode());
		const FDiagnostic& Found = Error.GetDiagnostics()[0];
		return "DD" + std::to_string(Found.Code) + " " + Found.Message;
	}
	return "";
}

bool Begins(const std::string& Text, const std::string& With)
{
	return Text.compare(0, With.size(), With) == 0;
}

std::string LittleEndian(uint32_t Number, int NumBytes)
{
	std::string Bytes;
	for (int Index = 0; Index < NumBytes; ++Index)
	{
		Bytes += static_cast<char>(Number >> (8 * Index) & 255);
	}
	return Bytes;
}

std::string BigEndian(uint32_t Number, int NumBytes)
{
	const std::string Bytes = LittleEndian(Number, NumBytes);
	return std::string(Bytes.rbegin(), Bytes.rend());
}

/** Annex D of the PNG specification. */
uint32_t GetCrc(const std::string& Bytes)
{
	uint32_t Crc = 0xFFFFFFFF;
	for (const char Byte : Bytes)
	{
		Crc ^= static_cast<unsigned char>(Byte);
		for (int Bit = 0; Bit < 8; ++Bit)
		{
			Crc = Crc & 1 ? 0xEDB88320 ^ Crc >> 1 : Crc >> 1;
		}
	}
	return ~Crc;
}

std::string MakeChunk(const std::string& Type, const std::string& Data)
{
	return BigEndian(static_cast<uint32_t>(Data.size()), 4) + Type + Data + BigEndian(GetCrc(Type + Data), 4);
}

/** With a header that is right in every bit, RGBA of 8 bits, and as many bytes of zeros as said in the place of pixels.
 */
std::string MakePng(uint32_t Width, uint32_t Height, size_t NumBytes)
{
	const std::string Kind("\x08\x06\0\0\0", 5);
	return "\x89PNG\r\n\x1A\n" + MakeChunk("IHDR", BigEndian(Width, 4) + BigEndian(Height, 4) + Kind) +
		   MakeChunk("IDAT", "\x78\x9C" + std::string(NumBytes, '\0')) + MakeChunk("IEND", "");
}

std::string MakeAttribute(const std::string& Name, const std::string& Type, const std::string& Value)
{
	return Name + '\0' + Type + '\0' + LittleEndian(static_cast<uint32_t>(Value.size()), 4) + Value;
}

/** Scanlines of four halves, without compression, and a table of offsets as long as the header asks for. */
std::string MakeExr(uint32_t Width, uint32_t Height)
{
	std::string Channels;
	for (const char Name : {'A', 'B', 'G', 'R'})
	{
		Channels += Name + std::string(1, '\0') + LittleEndian(1, 4) + std::string(4, '\0') + LittleEndian(1, 4) +
					LittleEndian(1, 4);
	}
	const std::string Window = std::string(8, '\0') + LittleEndian(Width - 1, 4) + LittleEndian(Height - 1, 4);
	const std::string One = LittleEndian(0x3F800000, 4);
	return LittleEndian(20000630, 4) + LittleEndian(2, 4) + MakeAttribute("channels", "chlist", Channels + '\0') +
		   MakeAttribute("compression", "compression", std::string(1, '\0')) +
		   MakeAttribute("dataWindow", "box2i", Window) + MakeAttribute("displayWindow", "box2i", Window) +
		   MakeAttribute("lineOrder", "lineOrder", std::string(1, '\0')) +
		   MakeAttribute("pixelAspectRatio", "float", One) +
		   MakeAttribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
		   MakeAttribute("screenWindowWidth", "float", One) + std::string(1 + size_t(8) * Height, '\0');
}

std::string MakeTarga(uint32_t Width, uint32_t Height, char Type)
{
	return std::string(2, '\0') + Type + std::string(9, '\0') + LittleEndian(Width, 2) + LittleEndian(Height, 2) +
		   "\x18" + std::string(1, '\0');
}

std::string MakeBmp(uint32_t Width, uint32_t Height, uint32_t Compression)
{
	return "BM" + std::string(8, '\0') + LittleEndian(54, 4) + LittleEndian(40, 4) + LittleEndian(Width, 4) +
		   LittleEndian(Height, 4) + LittleEndian(1, 2) + LittleEndian(Compression == 1 ? 8 : 24, 2) +
		   LittleEndian(Compression, 4) + std::string(20, '\0');
}

std::string MakeJpeg(uint32_t Width, uint32_t Height)
{
	const std::string Comment = "\xFF\xFE" + BigEndian(5, 2) + "abc";
	return "\xFF\xD8" + Comment + "\xFF\xC2" + BigEndian(17, 2) + "\x08" + BigEndian(Height, 2) + BigEndian(Width, 2) +
		   "\x03" + std::string(9, '\1');
}

std::string MakeRadiance(uint32_t Width, uint32_t Height)
{
	return "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(Height) + " +X " + std::to_string(Width) + "\n";
}

/** A directory of five entries: RGBA of 16 bits. */
std::string MakeTiff(uint32_t Width, uint32_t Height, uint32_t Compression)
{
	std::string Bytes = "II*" + std::string(1, '\0') + LittleEndian(8, 4) + LittleEndian(5, 2);
	for (const auto& [Tag, Value] : std::vector<std::pair<uint32_t, uint32_t>>{
			 {256, Width}, {257, Height}, {258, 16}, {259, Compression}, {277, 4}})
	{
		Bytes += LittleEndian(Tag, 2) + LittleEndian(4, 2) + LittleEndian(1, 4) + LittleEndian(Value, 4);
	}
	return Bytes + std::string(4, '\0');
}

/** RGB of 10 bits, most significant byte first. */
std::string MakeDpx(uint32_t Width, uint32_t Height, uint32_t Encoding)
{
	std::string Bytes = "SDPX" + std::string(2044, '\0');
	Bytes.replace(772, 8, BigEndian(Width, 4) + BigEndian(Height, 4));
	Bytes[800] = 50;
	Bytes[803] = 10;
	return Bytes.replace(806, 2, BigEndian(Encoding, 2));
}

/** Most memory that this process has held; 0 where the system does not say. */
int64_t GetPeakKilobytes()
{
	std::ifstream Status("/proc/self/status");
	for (std::string Line; std::getline(Status, Line);)
	{
		if (Begins(Line, "VmHWM:"))
		{
			return std::atoll(Line.c_str() + 6);
		}
	}
	return 0;
}

} // namespace

TEST_F(ImageFormat, AHeaderThatTheFileCannotHoldIsRefusedBeforeMemoryIsTaken)
{
	const std::vector<std::pair<std::string, std::string>> Liars = {
		{"a.png", MakePng(16384, 16384, 1000)},
		{"a.exr", MakeExr(16384, 16384)},
		{"a.tga", MakeTarga(16384, 16384, 10) + std::string(1000, '\xFF')},
		{"a.bmp", MakeBmp(16384, 16384, 1) + std::string(1000, '\xFF')},
		{"b.bmp", MakeBmp(16384, 16384, 0) + std::string(1'000'000, '\xFF')},
		{"a.jpg", MakeJpeg(16384, 16384) + std::string(1000, '\x7F')},
		{"a.hdr", MakeRadiance(16384, 16384) + std::string(1000, '\2')},
		{"a.tif", MakeTiff(16384, 16384, 1)},
		{"b.tif", MakeTiff(16384, 16384, 5)},
		{"a.dpx", MakeDpx(16384, 16384, 0)},
		{"b.dpx", MakeDpx(16384, 16384, 1)},
	};
	std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins anew
	const int64_t Before = GetPeakKilobytes();
	for (const auto& [Name, Bytes] : Liars)
	{
		const std::string Error = ErrorOf(Write(Name, Bytes));
		EXPECT_TRUE(Begins(Error, "DD5002 the image file is truncated or corrupt: its ")) << Name << ": " << Error;
		EXPECT_NE(std::string::npos, Error.find("cannot hold")) << Name << ": " << Error;
	}
	EXPECT_LT(GetPeakKilobytes() - Before, 100'000); // of the gigabytes that they ask for
}

TEST_F(ImageFormat, AChunkLongerThanTheFileIsRefusedBeforeMemoryIsTaken)
{
	std::string Bytes = MakePng(1, 1, 10);
	const size_t End = Bytes.size() - 12; // IEND
	std::ofstream("/proc/self/clear_refs") << "5";
	const int64_t Before = GetPeakKilobytes();
	for (const char* Type : {"eXIf", "zTXt", "iCCP", "IDAT", "vpAg"})
	{
		const std::string Long = BigEndian(1'500'000'000, 4) + Type + "1234";
		EXPECT_EQ(
			"DD5002 the image file is truncated or corrupt: a chunk says that it has 1500000000 bytes, and 16 are "
			"left",
			ErrorOf(Write("a.png", Bytes.substr(0, End) + Long + Bytes.substr(End))))
			<< Type;
	}
	EXPECT_LT(GetPeakKilobytes() - Before, 100'000);
}

TEST_F(ImageFormat, LargerThanAnyFrameIsRefusedWhateverTheFileHolds)
{
	for (const auto& [Name, Bytes] : std::vector<std::pair<std::string, std::string>>{
			 {"a.png", MakePng(32769, 1, 1000)}, {"b.png", MakePng(20000, 20000, 1000)},
			 {"c.png", MakePng(0xFFFFFFFF, 0xFFFFFFFF, 1000)}, {"a.tga", MakeTarga(20000, 20000, 2)},
			 {"a.bmp", MakeBmp(1, 0x80000000, 0)}, {"a.jpg", MakeJpeg(65535, 65535)}, {"a.hdr", MakeRadiance(40000, 1)},
			 {"a.tif", MakeTiff(20000, 20000, 5)}, {"a.dpx", MakeDpx(40000, 1, 0)}})
	{
		EXPECT_TRUE(Begins(ErrorOf(Write(Name, Bytes)), "DD5005 ")) << Name << ": " << ErrorOf(Write(Name, Bytes));
	}
	EXPECT_EQ("DD5002 the image file holds no picture", ErrorOf(Write("a.png", MakePng(0, 5, 10))));
}

TEST_F(ImageFormat, OtherFormatsAreNotOpened)
{
	const std::string List = ".exr, .png, .hdr, .jpg, .jpeg, .tga, .bmp, .tif, .tiff, .dpx";
	for (const char* Name : {"a.gif", "a.psd", "a.dds", "a.ico", "a.pnm", "a.txt", "a", "a.exr.bak"})
	{
		EXPECT_EQ("DD5002 the image file is of a format that is not read: the end of its name is none of " + List,
			ErrorOf(Write(Name, MakeExr(1, 1))))
			<< Name;
	}
}

TEST_F(ImageFormat, NameAndFirstBytesMustAgree)
{
	EXPECT_EQ("DD5002 the image file cannot be read: by its name it is OpenEXR, by its first bytes PNG",
		ErrorOf(Write("a.exr", MakePng(1, 1, 10))));
	EXPECT_EQ("DD5002 the image file cannot be read: by its name it is PNG, by its first bytes OpenEXR",
		ErrorOf(Write("a.png", MakeExr(1, 1))));
	EXPECT_EQ("DD5002 the image file cannot be read: by its name it is Targa, by its first bytes JPEG",
		ErrorOf(Write("a.tga", MakeJpeg(8, 8))));
	// Portable bitmaps and icons are what the library would find these to be.
	EXPECT_EQ("DD5002 the image file cannot be read: by its name it is Radiance HDR, by its first bytes it is not",
		ErrorOf(Write("a.hdr", "P6 1 1 255\nabc")));
	EXPECT_EQ("DD5002 the image file cannot be read: by its name it is BMP, by its first bytes it is not",
		ErrorOf(Write("a.bmp", std::string("\0\0\1\0\1\0", 6))));
}

TEST_F(ImageFormat, EveryFormatThatIsListedIsRead)
{
	const std::vector<float> Pixels = {0.25f, 0.5f, 0.75f, 1.0f, 0.0f, 0.5f};
	for (const std::string& Extension : GetImageExtensions())
	{
		const std::string Path = (Folder / ("a" + Extension)).string();
		const OIIO::ImageSpec Spec(2, 1, 3, OIIO::TypeDesc::FLOAT);
		const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
		ASSERT_TRUE(Output && Output->open(Path, Spec)) << Extension;
		ASSERT_TRUE(Output->write_image(OIIO::TypeDesc::FLOAT, Pixels.data()) && Output->close()) << Extension;
		EXPECT_TRUE(IsImagePath(Path)) << Extension;
		EXPECT_EQ("", ErrorOf(Path));
		EXPECT_EQ(2, FImageFile(Path).GetWidth()) << Extension;
	}
	EXPECT_TRUE(IsImagePath("A.EXR"));
	EXPECT_FALSE(IsImagePath("a.gif"));
}

/** Rows are read in bands; a picture of more than one gives what it was written with. */
TEST_F(ImageFormat, PicturesOfSeveralBandsAreWhole)
{
	constexpr int Width = 16384;
	constexpr int Height = 1100; // a band has 1024 rows of this
	FImage Image{Width, Height, 1, {}};
	for (int Pixel = 0; Pixel < Width * Height; ++Pixel)
	{
		Image.Values.push_back((Pixel * 31 + Pixel / Width * 7) % 2048); // halves hold these
	}
	const std::string Path = (Folder / "a.exr").string();
	WriteExr(Path, Image, {"R"});
	const std::vector<float> Plane = FImageFile(Path).Read({0})[0];
	EXPECT_TRUE(std::equal(Image.Values.begin(), Image.Values.end(), Plane.begin(), Plane.end(),
		[](double A, float B) { return static_cast<float>(A) == B; }));
}

TEST_F(ImageFormat, BytesInMemoryAreReadAsAFileIs)
{
	const std::string Path = (Folder / "a.exr").string();
	WriteExr(Path, {2, 1, 3, {0.0, 0.25, 1.5, -2.0, 65504.0, 1e-7}}, {"R", "G", "B"});
	std::ifstream Stream(Path, std::ios::binary);
	const std::string Bytes(std::istreambuf_iterator<char>(Stream), {});
	const std::vector<std::vector<float>> FromFile = FImageFile(Path).Read({0, 1, 2});
	{
		const FImageBytes Memory("memory.exr", Bytes);
		EXPECT_EQ(FromFile, FImageFile("memory.exr").Read({0, 1, 2}));
		EXPECT_EQ(2, FImageFile(Path).GetWidth());
	}
	EXPECT_TRUE(Begins(ErrorOf("memory.exr"), "DD5001 "));
}

TEST_F(ImageFormat, ColourIsDecodedAsTheFileStates)
{
	struct FCase
	{
		const char* Name;
		OIIO::TypeDesc Type;
		const char* ColorSpace;
		double Expected; // of a stored half
	};
	const double Film = (std::pow(10.0, (511.5 - 685.0) / 300.0) - std::pow(10.0, -590.0 / 300.0)) /
						(1.0 - std::pow(10.0, -590.0 / 300.0)); // Kodak's curve: 95 is black and 685 is white
	for (const FCase& Case : std::vector<FCase>{
			 {"byte.tif", OIIO::TypeDesc::UINT8, "", 0.214},
			 {"float.tif", OIIO::TypeDesc::FLOAT, "", 0.5},
			 {"linear.dpx", OIIO::TypeDesc::UINT16, "Linear", 0.5},
			 {"film.dpx", OIIO::TypeDesc::UINT16, "KodakLog", Film},
		 })
	{
		const std::string Path = (Folder / Case.Name).string();
		OIIO::ImageSpec Spec(2, 1, 3, Case.Type);
		Spec.attribute("oiio:ColorSpace", Case.ColorSpace);
		const std::vector<float> Pixels(6, 0.5f);
		const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
		ASSERT_TRUE(Output && Output->open(Path, Spec)) << Case.Name;
		ASSERT_TRUE(Output->write_image(OIIO::TypeDesc::FLOAT, Pixels.data()) && Output->close()) << Case.Name;
		EXPECT_NEAR(Case.Expected, FImageFile(Path).Read({0}).at(0).at(0), 0.002) << Case.Name;
	}
	OIIO::ImageSpec Tiled(16, 16, 3, OIIO::TypeDesc::FLOAT);
	Tiled.tile_width = Tiled.tile_height = 16;
	const std::string TiledPath = (Folder / "tiled.tif").string();
	const std::unique_ptr<OIIO::ImageOutput> Tiles = OIIO::ImageOutput::create(TiledPath);
	ASSERT_TRUE(Tiles->open(TiledPath, Tiled) &&
				Tiles->write_image(OIIO::TypeDesc::FLOAT, std::vector<float>(16 * 16 * 3).data()) && Tiles->close());
	EXPECT_EQ(
		"DD5002 the image file cannot be read: its pixels are stored in tiles, and only rows are read; oiiotool makes "
		"rows of them with --scanline",
		ErrorOf(TiledPath));
	OIIO::ImageSpec Video(2, 1, 3, OIIO::TypeDesc::UINT16);
	Video.attribute("oiio:ColorSpace", "Rec709");
	const std::string Path = (Folder / "video.dpx").string();
	const std::unique_ptr<OIIO::ImageOutput> Output = OIIO::ImageOutput::create(Path);
	ASSERT_TRUE(Output->open(Path, Video) && Output->write_image(OIIO::TypeDesc::FLOAT, std::vector<float>(6).data()) &&
				Output->close());
	EXPECT_EQ(
		"DD5002 the image file cannot be read: its colour is encoded as Rec709; linear, sRGB and KodakLog are read",
		ErrorOf(Path));
}
