// What each hazard is as a picture or as parameters (Hazards.h says it in words).
#include "Cases.h"

#include <cmath>
#include <functional>

namespace Stability
{

namespace
{

using PassTest::Infinity;
using PassTest::NaN;

constexpr int Width = 64;
constexpr int Height = 48;
const FTexel Flat = {0.75, 0.5, 0.25, 1};

FImage Noise()
{
	return FImage::Noise(Width, Height);
}

FImage Map(FImage Image, const std::function<double(double)>& Function)
{
	for (FTexel& Texel : Image.Texels)
	{
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			Texel[Channel] = Function(Texel[Channel]);
		}
	}
	return Image;
}

FImage BothSigns()
{
	return Map(Noise(), [](double Value) { return Value - 0.5; });
}

/** A soft spot of standard deviation 3 near the middle, none of whose light is at the edges. */
FImage Spot(int SpotWidth, int SpotHeight)
{
	return FImage::Make(SpotWidth, SpotHeight,
		[=](int X, int Y)
		{
			const double DX = X - (SpotWidth / 2 + 0.3), DY = Y - (SpotHeight / 2 - 0.4);
			const double Value = std::exp(-(DX * DX + DY * DY) / 18);
			return FTexel{Value, Value, Value, 1};
		});
}

/** Luminance 0 to rounding for the weights (0.3, 0.59, 0.11), and colours that are nearly black. */
FImage LuminanceZero()
{
	return FImage::Make(Width, Height,
		[](int X, int Y) -> FTexel
		{
			switch ((X + Y) % 4)
			{
			case 0:
				return {0.59, -0.3, 0, 1};
			case 1:
				return {-0.11, 0, 0.3, 1};
			case 2:
				return {1e-9, 1e-9, 1e-9, 1};
			default:
				return {0, 0, 0, 1};
			}
		});
}

FCase MakeCase(FImage Image, EPixelFormat Format = PF_FloatRGBA)
{
	FCase Case;
	Case.Image = std::move(Image);
	Case.Format = Format;
	return Case;
}

FTrial MakeTrial(const FCase& Case)
{
	return {Case, Case, BadPixel};
}

FTrial WithBadPixel(double Value, EPixelFormat Format = PF_FloatRGBA)
{
	FTrial Trial = MakeTrial(MakeCase(Noise(), Format));
	Trial.Case.Image.At(BadPixel.X, BadPixel.Y) = {Value, Value, Value, 1};
	return Trial;
}

/** Noise, and parameters that Change sets. */
FTrial WithParameters(const std::function<void(FCase&)>& Change, EPixelFormat Format = PF_FloatRGBA)
{
	FTrial Trial = MakeTrial(MakeCase(Noise(), Format));
	Change(Trial.Case);
	return Trial;
}

FTrial Flatly(int FlatWidth, int FlatHeight)
{
	return MakeTrial(MakeCase(FImage(FlatWidth, FlatHeight, Flat)));
}

std::vector<FTrial> WithPowers(const FImage& Image, std::initializer_list<double> Powers)
{
	std::vector<FTrial> Trials;
	for (const double Power : Powers)
	{
		Trials.push_back(MakeTrial(MakeCase(Image)));
		Trials.back().Case.Power = Power;
	}
	return Trials;
}

FTrial Moving(double Shift)
{
	FImage Image(Width, Height, {0, 0, 0, 1});
	const double Left = 16 * (1 - Shift), Right = 16 * Shift;
	Image.At(31, 24) = {Left, Left, Left, 1};
	Image.At(32, 24) = {Right, Right, Right, 1};
	return WithParameters(
		[&](FCase& Case)
		{
			Case.Image = Image;
			Case.Threshold = 1.0;
		});
}

std::vector<FTrial> MakeFormOne(EHazard Hazard)
{
	switch (Hazard)
	{
	case EHazard::NaN:
		return {WithBadPixel(NaN)};
	case EHazard::PlusInf:
		return {WithBadPixel(Infinity)};
	case EHazard::MinusInf:
		return {WithBadPixel(-Infinity)};
	case EHazard::LargestHalf:
		return {MakeTrial(MakeCase(FImage(Width, Height, {65504, 65504, 65504, 1})))};
	case EHazard::BeyondHalf:
	{
		FTrial Rounded = WithBadPixel(65520);
		Rounded.Clean = WithBadPixel(Infinity).Case;
		FTrial Kept = WithBadPixel(65519);
		Kept.Clean = WithBadPixel(65504).Case;
		return {Rounded, Kept};
	}
	case EHazard::Huge:
		return {WithBadPixel(1e30, PF_A32B32G32R32F)};
	case EHazard::Denormals:
		return {MakeTrial(MakeCase(Map(Noise(), [](double Value) { return Value * 1e-40; }), PF_A32B32G32R32F)),
			MakeTrial(MakeCase(Map(Noise(), [](double Value) { return Value * std::exp2(-18); })))};
	case EHazard::NegativeZero:
		return {MakeTrial(MakeCase(FImage(Width, Height, {-0.0, -0.0, -0.0, 1})))};
	case EHazard::NegativeColors:
		return {MakeTrial(MakeCase(BothSigns()))};
	case EHazard::HotPixel:
	{
		FTrial Trial = MakeTrial(MakeCase(FImage(Width, Height, {0, 0, 0, 1})));
		Trial.Case.Image.At(31, 24) = {60000, 60000, 60000, 1};
		return {Trial};
	}
	case EHazard::MovingHotPixel:
	{
		std::vector<FTrial> Trials;
		for (int Step = 0; Step <= 10; ++Step)
		{
			Trials.push_back(Moving(Step / 10.0));
		}
		return Trials;
	}
	case EHazard::Black:
		return {MakeTrial(MakeCase(FImage(Width, Height, {0, 0, 0, 1})))};
	case EHazard::Constant:
		return {Flatly(Width, Height)};
	case EHazard::OneByOne:
		return {Flatly(1, 1)};
	case EHazard::OneByN:
		return {Flatly(1, 37)};
	case EHazard::NByOne:
		return {Flatly(37, 1)};
	case EHazard::Odd:
		return {MakeTrial(MakeCase(Spot(55, 45)))};
	case EHazard::Prime:
		return {MakeTrial(MakeCase(Spot(53, 47)))};
	case EHazard::RectOffset:
		return {WithParameters(
			[](FCase& Case)
			{
				Case.Offset = FIntPoint(128, 64);
				Case.Padding = FIntPoint(64, 16);
			})};
	case EHazard::PaddedExtent:
		return {WithParameters([](FCase& Case) { Case.Padding = FIntPoint(64, 80); })};
	case EHazard::TooManyLevels:
	{
		FTrial Trial = Flatly(5, 3);
		Trial.Case.Levels = 8;
		return {Trial};
	}
	case EHazard::SigmaZero:
		return {WithParameters([](FCase& Case) { Case.Sigma = 0.0; })};
	case EHazard::SigmaHuge:
		return {WithParameters([](FCase& Case) { Case.Sigma = 1e4; })};
	case EHazard::ThresholdZero:
	case EHazard::ThresholdNegative:
		return {WithParameters(
			[Hazard](FCase& Case)
			{
				Case.Image.At(BadPixel.X, BadPixel.Y) = {0, 0, 0, 1};
				Case.Threshold = Hazard == EHazard::ThresholdZero ? 0.0 : -1.0;
			})};
	case EHazard::ThresholdHuge:
		return {WithParameters([](FCase& Case) { Case.Threshold = 1e30; })};
	case EHazard::IntensityZero:
		return {WithParameters([](FCase& Case) { Case.Intensity = 0.0; })};
	case EHazard::IntensityNegative:
		return {WithParameters([](FCase& Case) { Case.Intensity = -1.0; })};
	case EHazard::IntensityHuge:
		return {WithParameters([](FCase& Case) { Case.Intensity = 1e6; }, PF_A32B32G32R32F)};
	case EHazard::PowOfZero:
		return WithPowers(FImage(Width, Height, {0, 0, 0, 1}), {0.0, 2.5});
	case EHazard::PowOfNegative:
		return WithPowers(BothSigns(), {0.5, 2.5});
	case EHazard::LuminanceZero:
		return {WithParameters(
			[](FCase& Case)
			{
				Case.Image = LuminanceZero();
				Case.Threshold = 0.0;
			},
			PF_A32B32G32R32F)};
	case EHazard::HalfAccumulation:
		return {MakeTrial(MakeCase(Noise()))};
	case EHazard::TenThousand:
		return {WithParameters(
			[](FCase& Case)
			{
				Case.Image = FImage::Noise(10000, 17);
				Case.Frames = 10000;
			},
			PF_A32B32G32R32F)};
	case EHazard::WeightOutside:
	case EHazard::EqualPriorities:
	case EHazard::MAX:
		break;
	}
	return {};
}

} // namespace

std::vector<FTrial> MakeTrials(EHazard Hazard, int Variant)
{
	std::vector<FTrial> Trials = MakeFormOne(Hazard);
	for (FTrial& Trial : Trials)
	{
		Trial.Case.Variant = Trial.Clean.Variant = Variant;
	}
	return Trials;
}

} // namespace Stability
