// Decodes a picture for its device and encodes it for an sRGB display.
#include "Picture/DisplayPreview.h"

#include <algorithm>
#include <array>
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

double EncodeSrgb(double Linear)
{
	return Linear <= 0.0031308 ? 12.92 * Linear : 1.055 * std::pow(Linear, 1.0 / 2.4) - 0.055;
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
		std::transform(Color.begin(), Color.end(), Color.begin(), DecodeRec709);
		return Color;
	case EDisplayOutputFormat::HDR_ACES_1000nit_ST2084:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ST2084:
		std::transform(Color.begin(), Color.end(), Color.begin(), DecodeST2084);
		return Rec2020ToRec709(Color);
	case EDisplayOutputFormat::HDR_ACES_1000nit_ScRGB:
	case EDisplayOutputFormat::HDR_ACES_2000nit_ScRGB:
		return {Color[0] * 0.8, Color[1] * 0.8, Color[2] * 0.8};
	default:
		return Color;
	}
}

} // namespace

FImage MakeDisplayPreview(const FImage& Picture, EDisplayOutputFormat OutputDevice)
{
	if (OutputDevice == EDisplayOutputFormat::SDR_sRGB ||
		OutputDevice == EDisplayOutputFormat::SDR_ExplicitGammaMapping)
	{
		return Picture;
	}
	FImage Preview = Picture;
	for (size_t Index = 0; Index + 2 < Preview.Values.size(); Index += 3)
	{
		double* const Pixel = &Preview.Values[Index];
		const FColor Linear = ToLinear({Pixel[0], Pixel[1], Pixel[2]}, OutputDevice);
		std::transform(
			Linear.begin(), Linear.end(), Pixel, [](double Value) { return EncodeSrgb(std::clamp(Value, 0.0, 1.0)); });
	}
	return Preview;
}

} // namespace Drydock
