// Sums the bloom's energy inside and outside of what is toon.
#include "Effects/ToonBleed.h"

#include "Math/ToInteger.h"

#include <cmath>

namespace Drydock
{

namespace
{

constexpr long ShadingModelCloth = 8;

bool IsToon(double Alpha)
{
	return (ToInteger<long>(std::round(Alpha * 255.0)) & 0xF) == ShadingModelCloth;
}

double GetLuminance(const FImage& Bloom, int X, int Y)
{
	const double Luminance = 0.3 * Bloom.Get(X, Y, 0) + 0.59 * Bloom.Get(X, Y, 1) + 0.11 * Bloom.Get(X, Y, 2);
	return std::isfinite(Luminance) ? Luminance : 0.0;
}

} // namespace

FToonBleed MeasureToonBleed(const FImage& Bloom, const FImage& Alpha, double PreExposure)
{
	FToonBleed Bleed;
	for (int Y = 0; Y < Alpha.Height; ++Y)
	{
		// Whole numbers: (Y + 0.5) * height of the bloom / height of the picture, rounded down.
		const int BloomY = static_cast<int>((2 * int64_t(Y) + 1) * Bloom.Height / (2 * int64_t(Alpha.Height)));
		for (int X = 0; X < Alpha.Width; ++X)
		{
			const int BloomX = static_cast<int>((2 * int64_t(X) + 1) * Bloom.Width / (2 * int64_t(Alpha.Width)));
			const double Energy = GetLuminance(Bloom, BloomX, BloomY) / PreExposure;
			(IsToon(Alpha.Get(X, Y, 0)) ? Bleed.Inside : Bleed.Outside) += Energy;
		}
	}
	return Bleed;
}

} // namespace Drydock
