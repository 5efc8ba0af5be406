// What each hazard is as a run of a pass: the library's pictures (HazardPictures.h), sizes and parameters.
#include "Cases.h"

#include "Hazards/HazardPictures.h"

#include <cmath>
#include <functional>

namespace Stability
{

namespace
{

constexpr int Width = 64;
constexpr int Height = 48;
const FIntPoint HotPixel(31, 24);
const FTexel Flat = {0.75, 0.5, 0.25, 1};

FImage Noise()
{
	return FImage::Noise(Width, Height);
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

FImage Convert(const Drydock::FImage& Image)
{
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y) {
			return FTexel{Image.Get(X, Y, 0), Image.Get(X, Y, 1), Image.Get(X, Y, 2), Image.Get(X, Y, 3)};
		});
}

/** The library's pictures of a hazard. */
std::vector<FTrial> WithPictures(EHazard Hazard, FIntPoint At = BadPixel)
{
	std::vector<FTrial> Trials;
	for (const Drydock::FHazardPicture& Picture : Drydock::MakeHazardPictures(Hazard, Width, Height, At.X, At.Y))
	{
		const EPixelFormat Format = Picture.bFloat32 ? PF_A32B32G32R32F : PF_FloatRGBA;
		Trials.push_back(
			{MakeCase(Convert(Picture.Picture), Format), MakeCase(Convert(Picture.Clean), Format), BadPixel});
	}
	return Trials;
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

std::vector<FTrial> WithPowers(EHazard Hazard, std::initializer_list<double> Powers)
{
	std::vector<FTrial> Trials;
	for (const double Power : Powers)
	{
		Trials.push_back(WithPictures(Hazard)[0]);
		Trials.back().Case.Power = Power;
	}
	return Trials;
}

/** With a threshold. */
std::vector<FTrial> WithThreshold(std::vector<FTrial> Trials, double Threshold)
{
	for (FTrial& Trial : Trials)
	{
		Trial.Case.Threshold = Trial.Clean.Threshold = Threshold;
	}
	return Trials;
}

std::vector<FTrial> MakeFormOne(EHazard Hazard)
{
	switch (Hazard)
	{
	case EHazard::NaN:
	case EHazard::PlusInf:
	case EHazard::MinusInf:
	case EHazard::LargestHalf:
	case EHazard::BeyondHalf:
	case EHazard::Huge:
	case EHazard::Denormals:
	case EHazard::NegativeZero:
	case EHazard::NegativeColors:
	case EHazard::Black:
		return WithPictures(Hazard);
	case EHazard::HotPixel:
		return WithPictures(Hazard, HotPixel);
	case EHazard::MovingHotPixel:
		return WithThreshold(WithPictures(Hazard, HotPixel), 1.0);
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
		return WithPowers(Hazard, {0.0, 2.5});
	case EHazard::PowOfNegative:
		return WithPowers(Hazard, {0.5, 2.5});
	case EHazard::LuminanceZero:
		return WithThreshold(WithPictures(Hazard), 0.0);
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
