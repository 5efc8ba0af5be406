// The kernel of the Gaussian blur as plain functions: no graph, no shader. Evaluated in double, so that weights a float
// would lose still place their taps. Source: engine file PostProcessWeightedSampleSum.cpp (formulas only).
#include "Blur/PostProcessWeightedSampleSum.h"

#include "HAL/IConsoleManager.h"
#include "Math/ToInteger.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<float> CVarFilterSizeScale(TEXT("r.Filter.SizeScale"), 1.0f,
	TEXT("Scales how far the taps of a Gaussian blur reach, not its width: below 1 cuts the kernel off. Default 1, 0.1 "
		 "to 10."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarFilterLoopMode(TEXT("r.Filter.LoopMode"), 0,
	TEXT("0: at most 32 taps to a blur pass (default); 1, 2: at most 128, so that wide blurs keep their width."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarFastBlurThreshold(TEXT("r.FastBlurThreshold"), 7.0f,
	TEXT("Radius in texels from which the horizontal blur pass works at half width. Default 7; 0 always, large never."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

constexpr float MinimumRadius = 1e-5f;
constexpr double FalloffExponent = -16.7;

/** Weight of the texel at integer distance X from the centre, not normalised. */
double WeighTexel(int32 X, double Radius, double CrossCenterWeight)
{
	const double Distance = std::abs(static_cast<double>(X));
	const double Gaussian = std::exp(FalloffExponent * (Distance / Radius) * (Distance / Radius));
	const double Triangle = std::fmax(0.0, 1.0 - Distance);
	if (CrossCenterWeight > 1.0)
	{
		return std::pow(Triangle, CrossCenterWeight);
	}
	return CrossCenterWeight > 0.0 ? Gaussian + (Triangle - Gaussian) * CrossCenterWeight : Gaussian;
}

} // namespace

namespace Drydock
{

int32 GetFilterSampleCountMax()
{
	return CVarFilterLoopMode.GetValueOnRenderThread() != 0 ? 128 : 32;
}

float GetClampedKernelRadius(int32 SampleCountMax, float KernelRadius)
{
	return FMath::Clamp(KernelRadius, MinimumRadius, static_cast<float>(SampleCountMax - 1));
}

int32 GetIntegerKernelRadius(int32 SampleCountMax, float KernelRadius)
{
	const float SizeScale = FMath::Clamp(CVarFilterSizeScale.GetValueOnRenderThread(), 0.1f, 10.0f);
	return ToIndex(std::ceil(GetClampedKernelRadius(SampleCountMax, KernelRadius * SizeScale)), SampleCountMax);
}

TArray<FGaussianTap> ComputeGaussianKernel(int32 SampleCountMax, float KernelRadius, float CrossCenterWeight)
{
	TArray<FGaussianTap> Taps;
	if (std::isnan(KernelRadius))
	{
		return Taps;
	}

	const double Radius = GetClampedKernelRadius(SampleCountMax, KernelRadius);
	const int32 Reach = GetIntegerKernelRadius(SampleCountMax, KernelRadius);

	double WeightSum = 0.0;
	for (int32 Texel = -Reach; Texel <= Reach; Texel += 2)
	{
		const double First = WeighTexel(Texel, Radius, CrossCenterWeight);
		const double Second = Texel == Reach ? 0.0 : WeighTexel(Texel + 1, Radius, CrossCenterWeight);

		FGaussianTap Tap;
		Tap.Weight = First + Second;
		Tap.Offset = Texel + (Tap.Weight > 0.0 ? Second / Tap.Weight : 0.0);
		Taps.Add(Tap);
		WeightSum += Tap.Weight;
	}

	// The centre texel weighs 1, so the sum is never zero.
	for (FGaussianTap& Tap : Taps)
	{
		Tap.Weight /= WeightSum;
	}
	return Taps;
}

float GetBlurRadius(uint32 ViewSize, float KernelSizePercent)
{
	return static_cast<float>(ViewSize) * KernelSizePercent * 0.01f * 0.5f;
}

bool IsFastBlurEnabled(float BlurRadius)
{
	return BlurRadius >= CVarFastBlurThreshold.GetValueOnRenderThread();
}

} // namespace Drydock
