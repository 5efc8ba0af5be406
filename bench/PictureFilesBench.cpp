// What pictures cost in files: the compressions of OpenEXR and the filters of PNG, on scene colour and on the final
// picture of a frame. One thread; the cells take turns; medians. Prints a table in Markdown, from which ExrWriter.cpp
// and PngWriter.cpp have their choice.
//
//     bench_picture_files [ROUNDS]
#include "Picture/Picture.h"
#include "Run/Run.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <png.h>
#include <unistd.h>
#include <zlib.h>

using namespace Drydock;

namespace
{

/** One measurement: a file's bytes. */
struct FCell
{
	std::string Name;
	std::function<size_t()> Write;
	std::vector<double> Milliseconds = {};
	size_t Bytes = 0;
};

double GetCpuMs()
{
	return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class FCountingStream final : public Imf::OStream
{
public:
	FCountingStream()
		: OStream("memory")
	{
	}
	void write(const char[], int Count) override
	{
		At += static_cast<uint64_t>(Count);
		Size = std::max(Size, At);
	}
	uint64_t tellp() override { return At; }
	void seekp(uint64_t Position) override { At = Position; }

	uint64_t At = 0;
	uint64_t Size = 0;
};

/** Planes of half floats. */
std::vector<std::vector<uint16_t>> MakeHalves(const FPicture& Picture)
{
	std::vector<std::vector<uint16_t>> Planes(static_cast<size_t>(Picture.NumChannels));
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * Planes.size());
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (size_t Index = 0; Index < Row.size(); ++Index)
		{
			Planes[Index % Planes.size()].push_back(imath_float_to_half(Row[Index]));
		}
	}
	return Planes;
}

size_t WriteExrInMemory(
	const FPicture& Picture, const std::vector<std::vector<uint16_t>>& Planes, Imf::Compression Compression, int Level)
{
	Imf::Header Header(Picture.Width, Picture.Height);
	Header.compression() = Compression;
	Header.zipCompressionLevel() = Level;
	Imf::FrameBuffer Buffer;
	const char* const Names[] = {"R", "G", "B", "A"};
	for (size_t Channel = 0; Channel < Planes.size(); ++Channel)
	{
		Header.channels().insert(Names[Channel], Imf::Channel(Imf::HALF));
		Buffer.insert(Names[Channel], Imf::Slice::Make(Imf::HALF, Planes[Channel].data(), Header.dataWindow()));
	}
	FCountingStream Stream;
	{
		Imf::OutputFile File(Stream, Header, 0);
		File.setFrameBuffer(Buffer);
		File.writePixels(Picture.Height);
	}
	return Stream.Size;
}

size_t WritePngInMemory(const FPicture& Picture, const std::vector<uint8_t>& Bytes, int Level, int Filter, int Strategy)
{
	size_t Size = 0;
	png_structp Png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
	png_infop Info = png_create_info_struct(Png);
	png_set_write_fn(
		Png, &Size, [](png_structp To, png_bytep, size_t Count) { *static_cast<size_t*>(png_get_io_ptr(To)) += Count; },
		nullptr);
	png_set_compression_level(Png, Level);
	png_set_filter(Png, PNG_FILTER_TYPE_BASE, Filter);
	png_set_compression_strategy(Png, Strategy);
	png_set_IHDR(Png, Info, static_cast<png_uint_32>(Picture.Width), static_cast<png_uint_32>(Picture.Height), 8,
		PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	png_write_info(Png, Info);
	for (size_t Y = 0; Y < static_cast<size_t>(Picture.Height); ++Y)
	{
		png_write_row(Png, &Bytes[Y * static_cast<size_t>(Picture.Width) * 3]);
	}
	png_write_end(Png, Info);
	png_destroy_write_struct(&Png, &Info);
	return Size;
}

std::vector<uint8_t> MakeBytes(const FPicture& Picture)
{
	std::vector<uint8_t> Bytes;
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.NumChannels));
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (size_t Index = 0; Index < Row.size(); ++Index)
		{
			Bytes.push_back(static_cast<uint8_t>(std::lround(Row[Index] * 255.0f)));
		}
	}
	return Bytes;
}

} // namespace

int main(int ArgumentCount, char** Arguments)
{
	const int Rounds = ArgumentCount > 1 ? std::max(1, std::atoi(Arguments[1])) : 5;
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_BENCH_SOURCE_DIR "/configs/toon_bloom.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/toon_character_1080p.exr"}})";
	const FRunResult Result = RunConfig(Options);
	const FPicture Final = Result.Final.Take(3);
	const std::vector<std::vector<uint16_t>> SceneHalves = MakeHalves(Result.SceneLinear);
	const std::vector<std::vector<uint16_t>> FinalHalves = MakeHalves(Final);
	const std::vector<uint8_t> Bytes = MakeBytes(Final);

	struct FExrKind
	{
		const char* Name;
		Imf::Compression Compression;
		int Level;
	};
	const FExrKind ExrKinds[] = {{"none", Imf::NO_COMPRESSION, 4}, {"RLE", Imf::RLE_COMPRESSION, 4},
		{"ZIP, level 1", Imf::ZIP_COMPRESSION, 1}, {"ZIP, level 2", Imf::ZIP_COMPRESSION, 2},
		{"ZIP, level 4 (OpenEXR's default)", Imf::ZIP_COMPRESSION, 4}, {"ZIP, level 6", Imf::ZIP_COMPRESSION, 6},
		{"PIZ (drydock)", Imf::PIZ_COMPRESSION, 4}};
	struct FPngKind
	{
		const char* Name;
		int Level;
		int Filter;
		int Strategy;
	};
	const FPngKind PngKinds[] = {{"any filter, level 6 (libpng's default)", 6, PNG_ALL_FILTERS, Z_FILTERED},
		{"any filter, level 3", 3, PNG_ALL_FILTERS, Z_FILTERED},
		{"any filter, level 1", 1, PNG_ALL_FILTERS, Z_FILTERED}, {"up, level 1", 1, PNG_FILTER_UP, Z_FILTERED},
		{"up, runs", 6, PNG_FILTER_UP, Z_RLE}, {"Paeth, runs (drydock)", 6, PNG_FILTER_PAETH, Z_RLE}};
	std::vector<FCell> Cells;
	for (const FExrKind& Kind : ExrKinds)
	{
		Cells.push_back({std::string("scene_linear.exr, ") + Kind.Name, [&]
			{
				return WriteExrInMemory(Result.SceneLinear, SceneHalves, Kind.Compression, Kind.Level);
			}});
		Cells.push_back({std::string("final.exr, ") + Kind.Name, [&]
			{
				return WriteExrInMemory(Final, FinalHalves, Kind.Compression, Kind.Level);
			}});
	}
	for (const FPngKind& Kind : PngKinds)
	{
		Cells.push_back({std::string("final.png, ") + Kind.Name, [&]
			{
				return WritePngInMemory(Final, Bytes, Kind.Level, Kind.Filter, Kind.Strategy);
			}});
	}
	for (int Round = 0; Round < Rounds; ++Round)
	{
		for (FCell& Cell : Cells)
		{
			const double Begin = GetCpuMs();
			Cell.Bytes = Cell.Write();
			Cell.Milliseconds.push_back(GetCpuMs() - Begin);
		}
	}
	std::printf("%d x %d, medians of %d\n\n| file | CPU ms | MB |\n|---|---|---|\n", Final.Width, Final.Height, Rounds);
	for (FCell& Cell : Cells)
	{
		std::sort(Cell.Milliseconds.begin(), Cell.Milliseconds.end());
		std::printf("| %s | %.0f | %.2f |\n", Cell.Name.c_str(), Cell.Milliseconds[Cell.Milliseconds.size() / 2],
			static_cast<double>(Cell.Bytes) / 1e6);
	}
}
