// Makes the pictures of the hazards (Hazards.h has the words).
#include "Hazards/HazardPictures.h"

#include "CoreMinimal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace Drydock
{

namespace
{

using FTexel = std::array<double, 4>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr int NumChannels = 4;

FImage MakeImage(int Width, int Height, TFunctionRef<FTexel(int, int)> Color)
{
	FImage Image{Width, Height, NumChannels, {}};
	Image.Values.reserve(static_cast<size_t>(Width) * static_cast<size_t>(Height) * NumChannels);
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			const FTexel Texel = Color(X, Y);
			Image.Values.insert(Image.Values.end(), Texel.begin(), Texel.end());
		}
	}
	return Image;
}

FImage Fill(int Width, int Height, double Value)
{
	return MakeImage(Width, Height, [=](int, int) { return FTexel{Value, Value, Value, 1}; });
}

FImage Map(FImage Image, TFunctionRef<double(double)> Function)
{
	for (size_t Index = 0; Index < Image.Values.size(); ++Index)
	{
		double& Value = Image.Values[Index];
		Value = Index % NumChannels == NumChannels - 1 ? Value : Function(Value);
	}
	return Image;
}

FImage WithPixel(FImage Image, int X, int Y, double Value)
{
	const size_t First =
		(static_cast<size_t>(Y) * static_cast<size_t>(Image.Width) + static_cast<size_t>(X)) * NumChannels;
	std::fill_n(Image.Values.begin() + static_cast<std::ptrdiff_t>(First), 3, Value);
	return Image;
}

/** Luminance 0 to rounding for the weights (0.3, 0.59, 0.11), and colours that are nearly black. */
FTexel GetLuminanceZero(int X, int Y)
{
	constexpr FTexel Texels[] = {{0.59, -0.3, 0, 1}, {-0.11, 0, 0.3, 1}, {1e-9, 1e-9, 1e-9, 1}, {0, 0, 0, 1}};
	return Texels[(X + Y) % 4];
}

/** The whole picture is the hazard. */
FHazardPicture Whole(const FImage& Image, bool bFloat32 = false)
{
	return {Image, Image, bFloat32};
}

std::vector<FHazardPicture> MakeMovingLight(int Width, int Height, int X, int Y)
{
	constexpr int NumSteps = 10;
	constexpr double Light = 16.0;
	std::vector<FHazardPicture> Pictures;
	for (int Step = 0; Step <= NumSteps; ++Step)
	{
		const double Shift = Step / static_cast<double>(NumSteps);
		Pictures.push_back(
			Whole(WithPixel(WithPixel(Fill(Width, Height, 0), X, Y, Light * (1 - Shift)), X + 1, Y, Light * Shift)));
	}
	return Pictures;
}

} // namespace

FImage MakeHazardNoise(int Width, int Height)
{
	std::mt19937 Random(1);
	std::uniform_int_distribution<int> Step(0, 64);
	return MakeImage(Width, Height,
		[&](int, int) {
			return FTexel{Step(Random) / 64.0, Step(Random) / 64.0, Step(Random) / 64.0, 1};
		});
}

std::vector<FHazardPicture> MakeHazardPictures(EHazard Hazard, int Width, int Height, int X, int Y)
{
	const FImage Noise = MakeHazardNoise(Width, Height);
	const auto OnePixel = [&](double Value, bool bFloat32 = false)
	{
		return FHazardPicture{WithPixel(Noise, X, Y, Value), Noise, bFloat32};
	};
	const auto BothSigns = [&Noise]
	{
		return Map(Noise, [](double Value) { return Value - 0.5; });
	};
	switch (Hazard)
	{
	case EHazard::NaN:
		return {OnePixel(NaN)};
	case EHazard::PlusInf:
		return {OnePixel(Infinity)};
	case EHazard::MinusInf:
		return {OnePixel(-Infinity)};
	case EHazard::LargestHalf:
		return {Whole(Fill(Width, Height, 65504))};
	case EHazard::BeyondHalf:
		return {{WithPixel(Noise, X, Y, 65520), WithPixel(Noise, X, Y, Infinity)},
			{WithPixel(Noise, X, Y, 65519), WithPixel(Noise, X, Y, 65504)}};
	case EHazard::Huge:
		return {OnePixel(1e30, true)};
	case EHazard::Denormals:
		return {Whole(Map(Noise, [](double Value) { return Value * 1e-40; }), true),
			Whole(Map(Noise, [](double Value) { return Value * std::exp2(-18); }))};
	case EHazard::NegativeZero:
		return {Whole(Fill(Width, Height, -0.0))};
	case EHazard::NegativeColors:
	case EHazard::PowOfNegative:
		return {Whole(BothSigns())};
	case EHazard::HotPixel:
		return {{WithPixel(Fill(Width, Height, 0), X, Y, 60000), Fill(Width, Height, 0)}};
	case EHazard::MovingHotPixel:
		return MakeMovingLight(Width, Height, X, Y);
	case EHazard::Black:
	case EHazard::PowOfZero:
		return {Whole(Fill(Width, Height, 0))};
	case EHazard::Constant:
		return {Whole(MakeImage(Width, Height, [](int, int) { return FTexel{0.75, 0.5, 0.25, 1}; }))};
	case EHazard::LuminanceZero:
		return {Whole(MakeImage(Width, Height, GetLuminanceZero), true)};
	default:
		return {}; // a size, a parameter or a blend, of any picture
	}
}

} // namespace Drydock
