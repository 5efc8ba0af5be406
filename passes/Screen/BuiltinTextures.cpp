// The shapes of the built-in kernels.
#include "Screen/BuiltinTextures.h"
#include "RangeTools.h"

#include <algorithm>
#include <cmath>
#include <math.h> // j1, which is POSIX
#include <numbers>

namespace Drydock
{

namespace
{

constexpr int32 Middle = BuiltinKernelSize / 2;
constexpr double Radius = Middle + 0.5;

/** Falls from 1 in the middle to 0 at the picture's edge, so that the kernel ends softly. */
double FadeOut(double Distance)
{
	const double Remaining = std::max(0.0, 1.0 - Distance / Radius);
	return Remaining * (2.0 - Remaining);
}

/** The first dark ring lies at a thirty-second of the radius. */
double Airy(double X, double Y)
{
	constexpr double FirstZero = 3.8317059702075125; // of the Bessel function J1
	const double Distance = std::hypot(X, Y);
	const double Phase = FirstZero * Distance / (Radius / 32.0);
	const double Amplitude = 2.0 * ::j1(Phase) / Phase;
	return Amplitude * Amplitude * FadeOut(Distance);
}

/** Its edge is one texel wide. */
double Disc(double X, double Y)
{
	return std::clamp(Radius - std::hypot(X, Y), 0.0, 1.0);
}

double Star(double X, double Y)
{
	constexpr double SpikeWidth = 1.5, SpikeReach = 24.0, HaloReach = 12.0, Halo = 0.02; // texels
	const double Distance = std::hypot(X, Y);
	double Spikes = 0.0;
	for (int32 Line = 0; Line < 3; ++Line)
	{
		const double Angle = std::numbers::pi * (0.5 + Line / 3.0);
		const double FromLine = (X * std::sin(Angle) - Y * std::cos(Angle)) / SpikeWidth;
		Spikes += std::exp(-FromLine * FromLine);
	}
	const double Reach = Distance / SpikeReach, Spread = Distance / HaloReach;
	return (Spikes / (1.0 + Reach * Reach) + Halo / (1.0 + Spread * Spread)) * FadeOut(Distance);
}

struct FBuiltinKernel
{
	const char* Name;
	/** At texels from the middle, never (0, 0); the same for negative ones. */
	double (*Shape)(double X, double Y);
};

constexpr FBuiltinKernel Kernels[] = {{"Builtin/Airy", &Airy}, {"Builtin/Disc", &Disc}, {"Builtin/Star", &Star}};

} // namespace

const std::vector<std::string>& GetBuiltinTextureNames()
{
	static const std::vector<std::string> Names = []
	{
		return ToVector<std::string>(Kernels, &FBuiltinKernel::Name);
	}();
	return Names;
}

std::vector<float> MakeBuiltinKernel(const std::string& Name)
{
	const auto* const Kernel = std::ranges::find(Kernels, Name, &FBuiltinKernel::Name);
	if (Kernel == std::end(Kernels))
	{
		return {};
	}
	constexpr size_t Side = Middle + 1;
	std::vector<double> Quarter(Side * Side);
	double Sum = 0.0;
	for (size_t Index = 1; Index < Quarter.size(); ++Index)
	{
		const size_t X = Index % Side, Y = Index / Side;
		Quarter[Index] = Kernel->Shape(static_cast<double>(X), static_cast<double>(Y));
		Sum += Quarter[Index] * (X == 0 || Y == 0 ? 2.0 : 4.0);
	}
	std::vector<float> Result;
	for (int32 Y = -Middle; Y <= Middle; ++Y)
	{
		for (int32 X = -Middle; X <= Middle; ++X)
		{
			const size_t Index = static_cast<size_t>(std::abs(Y)) * Side + static_cast<size_t>(std::abs(X));
			Result.push_back(static_cast<float>(Quarter[Index] / Sum * BuiltinKernelScatter));
		}
	}
	Result[Result.size() / 2] = static_cast<float>(1.0 - BuiltinKernelScatter);
	return Result;
}

} // namespace Drydock
