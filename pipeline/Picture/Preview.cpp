// Decodes pictures for their device, or compresses their range, and encodes them for an sRGB display, row by row.
#include "Picture/Preview.h"

#include "Math/ToInteger.h"
#include "Picture/PngWriter.h"
#include "Picture/Srgb.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** Nits over 100. */
double DecodeST2084(double Code)
{
	const double N = std::pow(std::clamp(Code, 0.0, 1.0), 1.0 / 78.84375);
	return 100.0 * std::pow(std::max(N - 0.8359375, 0.0) / (18.8515625 - 18.6875 * N), 1.0 / 0.1593017578125);
}

double DecodeRec709(double Code)
{
	return Code < 0.081 ? Code / 4.5 : std::pow((Code + 0.099) / 1.099, 1.0 / 0.45);
}

using FColor = std::array<double, 3>;

FColor Rec2020ToRec709(const FColor& C)
{
	return {1.6604910021 * C[0] - 0.5876411388 * C[1] - 0.0728498633 * C[2],
		-0.1245504745 * C[0] + 1.1328998971 * C[1] - 0.0083494226 * C[2],
		-0.0181507634 * C[0] - 0.1005788980 * C[1] + 1.1187296614 * C[2]};
}

FColor ToLinear(FColor Color, EDisplayOutputFormat OutputDevice)
{
	switch (OutputDevice)
	{
	case EDisplayOutputFormat::SDR_Rec709:
		std::ranges::transform(Color, Color.begin(), DecodeRec709);
		return Color;
	case EDisplayOutputFormat::HDR_ACES_1000nit_ST2084:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ST2084:
		std::ranges::transform(Color, Color.begin(), DecodeST2084);
		return Rec2020ToRec709(Color);
	case EDisplayOutputFormat::HDR_ACES_1000nit_ScRGB:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ScRGB:
		return {Color[0] * 0.8, Color[1] * 0.8, Color[2] * 0.8};
	default:
		return Color;
	}
}

bool IsSrgb(EDisplayOutputFormat OutputDevice)
{
	return OutputDevice == EDisplayOutputFormat::SDR_sRGB ||
		   OutputDevice == EDisplayOutputFormat::SDR_ExplicitGammaMapping;
}

/** The same as of a double: 255 times a float, and half of 1 more, are exact in a double where they are not far
 * below 1.
 */
uint8_t ToByte(float Value)
{
	return static_cast<uint8_t>((Value > 0.0f ? std::min(static_cast<double>(Value), 1.0) : 0.0) * 255.0 + 0.5);
}

uint8_t ToByte(double Value)
{
	return ToInteger<uint8_t>(std::round((Value > 0.0 ? std::min(Value, 1.0) : 0.0) * 255.0));
}

void ReadRow(const FPicture& Picture, int Y, double* Row)
{
	Picture.ReadRow(Y, Row);
}

void ReadRow(const FImage& Image, int Y, double* Row)
{
	const std::ptrdiff_t RowSize = std::ptrdiff_t(Image.Width) * Image.NumChannels;
	std::copy_n(Image.Values.begin() + Y * RowSize, RowSize, Row);
}

bool IsInDisplayRange(double Value)
{
	return Value >= 0.0 && Value <= 1.0;
}

double CompressRange(double Value)
{
	const double Clipped = std::max(Value, 0.0);
	return std::isinf(Clipped) ? 1.0 : Clipped / (1.0 + Clipped);
}

template<typename TPicture>
void WritePreview(const std::string& Path, const TPicture& Picture)
{
	const size_t NumChannels = static_cast<size_t>(Picture.NumChannels);
	std::vector<double> Row(static_cast<size_t>(Picture.Width) * NumChannels);
	bool bDisplayRange = true;
	for (int Y = 0; Y < Picture.Height && bDisplayRange; ++Y)
	{
		ReadRow(Picture, Y, Row.data());
		bDisplayRange = std::ranges::all_of(Row, IsInDisplayRange);
	}
	const size_t NumShown = NumChannels == 1 ? 1 : 3; // PNG has no colour of two channels
	WritePngRows(Path, Picture.Width, Picture.Height, static_cast<int>(NumShown), EPngEffort::Quick,
		[&](int Y, uint8_t* Bytes)
		{
			ReadRow(Picture, Y, Row.data());
			for (size_t Pixel = 0; Pixel < Row.size(); Pixel += NumChannels)
			{
				for (size_t Channel = 0; Channel < NumShown; ++Channel)
				{
					const double Value = Channel < NumChannels ? Row[Pixel + Channel] : 0.0;
					*Bytes++ = ToByte(EncodeSrgb(bDisplayRange ? Value : CompressRange(Value)));
				}
			}
		});
}

} // namespace

std::array<double, 3> MakeDisplayColor(const std::array<double, 3>& Color, EDisplayOutputFormat OutputDevice)
{
	if (IsSrgb(OutputDevice))
	{
		return Color;
	}
	FColor Shown = ToLinear(Color, OutputDevice);
	std::ranges::transform(Shown, Shown.begin(), [](double Value) { return EncodeSrgb(std::clamp(Value, 0.0, 1.0)); });
	return Shown;
}

void MakeDisplayRow(
	const float* Row, int Width, int NumChannels, EDisplayOutputFormat OutputDevice, uint8_t* Bytes, int Step)
{
	if (IsSrgb(OutputDevice))
	{
		if (NumChannels == Step)
		{
			std::transform(Row, Row + static_cast<size_t>(Width) * static_cast<size_t>(Step), Bytes,
				[](float Value) { return ToByte(Value); });
			return;
		}
		for (int X = 0; X < Width; ++X, Row += NumChannels, Bytes += Step)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				Bytes[Channel] = ToByte(Row[Channel]);
			}
		}
		return;
	}
	for (int X = 0; X < Width; ++X, Row += NumChannels, Bytes += Step)
	{
		std::ranges::transform(MakeDisplayColor({double(Row[0]), double(Row[1]), double(Row[2])}, OutputDevice), Bytes,
			[](double Value) { return ToByte(Value); });
	}
}

void WriteDisplayPng(const std::string& Path, const FPicture& Picture, EDisplayOutputFormat OutputDevice)
{
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.NumChannels));
	WritePngRows(Path, Picture.Width, Picture.Height, 3, EPngEffort::Quick,
		[&](int Y, uint8_t* Bytes)
		{
			Picture.ReadRow(Y, Row.data());
			MakeDisplayRow(Row.data(), Picture.Width, Picture.NumChannels, OutputDevice, Bytes, 3);
		});
}

void WritePreviewPng(const std::string& Path, const FPicture& Picture)
{
	WritePreview(Path, Picture);
}

void WritePreviewPng(const std::string& Path, const FImage& Image)
{
	WritePreview(Path, Image);
}

} // namespace Drydock
