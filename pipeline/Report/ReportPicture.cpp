// Measures pictures, packs their values and writes them as JSON.
#include "Report/ReportPicture.h"

#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <half.h>
#include <cmath>
#include <cstring>
#include <limits>
#include <zlib.h>

namespace Drydock
{

namespace
{

const char* GetReportEncodingName(EReportEncoding Encoding)
{
	return Encoding == EReportEncoding::Srgb         ? "srgb"
		   : Encoding == EReportEncoding::Compressed ? "compressed"
													 : "display";
}

template<typename T>
std::string SplitPlanes(const FPicture& Picture, T (*Convert)(float))
{
	const size_t NumPixels = static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.Height);
	const size_t NumChannels = static_cast<size_t>(Picture.NumChannels);
	std::string Bytes(NumPixels * NumChannels * sizeof(T), '\0');
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * NumChannels);
	size_t Pixel = 0;
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (size_t X = 0; X < Row.size(); X += NumChannels, ++Pixel)
		{
			for (size_t Channel = 0; Channel < NumChannels; ++Channel)
			{
				const T Bits = Convert(Row[X + Channel]);
				for (size_t Byte = 0; Byte < sizeof(T); ++Byte)
				{
					const size_t Plane = Channel * sizeof(T) + Byte;
					Bytes[Plane * NumPixels + Pixel] = static_cast<char>(Bits >> (8 * (sizeof(T) - 1 - Byte)));
				}
			}
		}
	}
	return Bytes;
}

void WriteFigures(FJsonWriter& Writer, const FPictureFigures& Figures)
{
	Writer.Key("figures").Object({{"min", Figures.Min}, {"max", Figures.Max}, {"nan", Figures.NumNaN},
		{"infinite", Figures.NumInfinite}, {"negative", Figures.NumNegative}});
}

} // namespace

bool FPictureFigures::IsInDisplayRange() const
{
	const auto IsFrom0 = [](double Value)
	{
		return Value >= 0.0;
	};
	const auto IsTo1 = [](double Value)
	{
		return Value <= 1.0;
	};
	return NumNaN + NumInfinite == 0 && std::ranges::all_of(Min, IsFrom0) && std::ranges::all_of(Max, IsTo1);
}

FPictureFigures MeasurePicture(const FPicture& Picture)
{
	const size_t NumChannels = static_cast<size_t>(Picture.NumChannels);
	constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();
	FPictureFigures Figures{std::vector<double>(NumChannels, Nothing), std::vector<double>(NumChannels, Nothing)};
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * NumChannels);
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		for (size_t Index = 0; Index < Row.size(); ++Index)
		{
			const float Value = Row[Index];
			Figures.NumNaN += std::isnan(Value);
			Figures.NumInfinite += std::isinf(Value);
			Figures.NumNegative += Value < 0.0f;
			if (std::isfinite(Value))
			{
				double& Min = Figures.Min[Index % NumChannels];
				double& Max = Figures.Max[Index % NumChannels];
				Min = Value < Min || std::isnan(Min) ? Value : Min;
				Max = Value > Max || std::isnan(Max) ? Value : Max;
			}
		}
	}
	return Figures;
}

std::string Deflate(const std::string& Bytes)
{
	uLongf Size = compressBound(static_cast<uLong>(Bytes.size()));
	std::string Packed(Size, '\0');
	if (compress2(reinterpret_cast<Bytef*>(Packed.data()), &Size, reinterpret_cast<const Bytef*>(Bytes.data()),
			static_cast<uLong>(Bytes.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
	{
		throw std::bad_alloc(); // the one way in which it fails with a buffer of this size
	}
	Packed.resize(Size);
	return Packed;
}

FPackedValues PackValues(const FPicture& Picture)
{
	if (Picture.FitsHalf())
	{
		return {
			"half", Deflate(SplitPlanes<uint16_t>(Picture, [](float Value) { return imath_float_to_half(Value); }))};
	}
	return {"float", Deflate(SplitPlanes<uint32_t>(Picture,
						 [](float Value)
						 {
							 uint32_t Bits;
							 std::memcpy(&Bits, &Value, sizeof(Bits));
							 return Bits;
						 }))};
}

void WriteReportPicture(FJsonWriter& Writer, const FReportPicture& Picture)
{
	Writer.BeginObject();
	Writer.Members({{"id", Picture.Id}, {"role", Picture.Role}, {"label", Picture.Label}, {"pass", Picture.Pass},
		{"resource", Picture.Resource}, {"mip", Picture.Mip}, {"extent", Picture.Extent}, {"corner", Picture.Corner},
		{"size", Picture.Size}, {"channels", Picture.Channels}, {"encoding", GetReportEncodingName(Picture.Encoding)}});
	if (Picture.Values != nullptr)
	{
		WriteFigures(Writer, MeasurePicture(*Picture.Values));
	}
	Writer.Member("png", EncodeBase64(Picture.Png));
	if (Picture.Values != nullptr && Picture.bPack)
	{
		const FPackedValues Packed = PackValues(*Picture.Values);
		Writer.Key("values").Object({{"type", Packed.Type}, {"zlib", EncodeBase64(Packed.Bytes)}});
	}
	Writer.EndObject();
}

void WriteReportPictures(FJsonWriter& Writer, const std::vector<FReportPicture>& Pictures)
{
	Writer.Array("pictures", Pictures, [&](const FReportPicture& Picture) { WriteReportPicture(Writer, Picture); });
}

} // namespace Drydock
