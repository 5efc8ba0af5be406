// Writes a picture of a report: a PNG to look at, figures over its values, and in a full report the values.
#pragma once

#include "Picture/Picture.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

class FJsonWriter;

/** Figures of a picture's values. */
struct FPictureFigures
{
	std::vector<double> Min; // by channel, of the finite values; NaN where there are none
	std::vector<double> Max;
	uint64_t NumNaN = 0; // values
	uint64_t NumInfinite = 0;
	uint64_t NumNegative = 0; // -infinity among them

	/** Whether WritePreviewPng shows the values unchanged. */
	DRYDOCK_API bool IsInDisplayRange() const;
};

DRYDOCK_API FPictureFigures MeasurePicture(const FPicture& Picture);

/** zlib's stream. */
std::string Deflate(const std::string& Bytes);

/** Values as zlib's stream of planes: of each channel in turn the rows from the top; of a plane first all most
 * significant bytes, then the next ones. Halves where the picture fits them (FPicture::FitsHalf), else floats. */
struct FPackedValues
{
	std::string Type; // "half", "float"
	std::string Bytes;
};
DRYDOCK_API FPackedValues PackValues(const FPicture& Picture);

/** The way from the PNG's codes to values. */
enum class EReportEncoding
{
	Display,    // the final picture: codes are its values, if it has 8 bits
	Srgb,       // linear values, encoded
	Compressed, // linear values by x / (1 + x), encoded
};

/** One of a report's pictures. */
struct FReportPicture
{
	std::string Id = {};    // unique in the report
	std::string Role = {};  // "final", "scene", "dump", "thumbnail", "previous"
	std::string Label = {}; // as the page lists it
	int Pass = -1;          // index, of a dump or thumbnail
	std::string Resource = {};
	int Mip = -1;
	std::array<int, 2> Extent = {0, 0}; // of the whole texture
	std::array<int, 2> Corner = {0, 0}; // of the picture in it
	std::array<int, 2> Size = {0, 0};   // of the picture in texels of the texture; a thumbnail's PNG is smaller
	std::vector<std::string> Channels = {};
	EReportEncoding Encoding = EReportEncoding::Display;
	std::string Png = {};             // bytes
	const FPicture* Values = nullptr; // measured; null: a PNG is all there is
	bool bPack = false;               // Values go into the report
};

void WriteReportPicture(FJsonWriter& Writer, const FReportPicture& Picture);
/** The member "pictures" of a page: all of them in order. */
void WriteReportPictures(FJsonWriter& Writer, const std::vector<FReportPicture>& Pictures);

} // namespace Drydock
