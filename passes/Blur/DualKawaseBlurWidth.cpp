// Level sizes, widths and matching settings of the dual Kawase blur, from closed forms.
#include "Blur/DualKawaseBlurWidth.h"

#include "Math/ToInteger.h"

#include <cmath>

namespace Drydock
{

namespace
{

/** Variance of picking the left or right texel by the bilinear weight. */
double GetFilterVariance(double Position)
{
	const double Fraction = Position - std::floor(Position);
	return Fraction * (1.0 - Fraction);
}

/** The same for a tap of the up pass, whose sample points lie a quarter texel left or right of a texel's centre. */
double GetUpFilterVariance(double Distance)
{
	return (GetFilterVariance(Distance + 0.25) + GetFilterVariance(Distance - 0.25)) / 2.0;
}

/** (1 + 4 + ... + 4^(N-1)): how often the variance of the first level's two passes counts. */
double GetLevelSum(int32 PassNum)
{
	return (std::exp2(2.0 * PassNum) - 1.0) / 3.0;
}

/** Smallest offset whose unrounded variance reaches the wanted one. */
double BisectOffset(double Variance, int32 PassNum)
{
	double Low = 0.0;
	double High = GDualKawaseMaxOffset;
	while (High - Low > 1.0 / (4.0 * GSubtexelSteps))
	{
		const double Middle = (Low + High) / 2.0;
		(GetDualKawaseVariance(PassNum, Middle) < Variance ? Low : High) = Middle;
	}
	return Low;
}

/** Middles of the intervals of offsets that round to the same taps. Offset changes a tap at odd multiples of 1/512,
 * half the offset one at odd multiples of 1/256: per 1/128 three intervals, in units of 1/512 around 0, 1.5 and 2.5. */
double FindNearestStep(double StandardDeviation, int32 PassNum, double Offset)
{
	constexpr double Middles[] = {0.0, 1.5 / 512.0, 2.5 / 512.0};
	double Nearest = Offset;
	double NearestError = HUGE_VAL;
	const double First = std::floor(Offset * 128.0) / 128.0;
	for (int32 Step = -1; Step <= 2; ++Step)
	{
		for (const double Middle : Middles)
		{
			const double Candidate = First + Step / 128.0 + Middle;
			const double Error = std::abs(GetDualKawaseStandardDeviation(PassNum, Candidate) - StandardDeviation);
			if (Candidate >= 0.0 && Candidate <= GDualKawaseMaxOffset && Error < NearestError)
			{
				Nearest = Candidate;
				NearestError = Error;
			}
		}
	}
	return Nearest;
}

} // namespace

TArray<FIntPoint> GetDualKawaseLevelSizes(FIntPoint Size, int32 PassNum)
{
	TArray<FIntPoint> Sizes;
	Sizes.Add(Size);
	for (int32 Level = 1; Level <= PassNum; ++Level)
	{
		const FIntPoint Next = FIntPoint::DivideAndRoundUp(Sizes.Last(), 2);
		if (Next.GetMin() < 2)
		{
			break;
		}
		Sizes.Add(Next);
	}
	return Sizes;
}

TArray<FIntPoint> GetDualKawasePrintedSizes(FIntPoint Size, int32 PassNum)
{
	TArray<FIntPoint> Sizes;
	while (Sizes.Num() < PassNum && Size.GetMin() >= 2)
	{
		Sizes.Add(Size);
		Size = FIntPoint(Size.X / 2, Size.Y / 2);
	}
	for (int32 Pass = Sizes.Num(); Pass > 0; --Pass)
	{
		Size = Size * 2;
		Sizes.Add(Size);
	}
	return Sizes;
}

FIntPoint GetDualKawasePrintedLoss(FIntPoint Size, int32 PassNum)
{
	const TArray<FIntPoint> Sizes = GetDualKawasePrintedSizes(Size, PassNum);
	return Sizes.Num() > 0 ? Size - Sizes.Last() : FIntPoint(0, 0);
}

FDualKawaseTaps GetDualKawaseTaps(double Offset)
{
	const double Distance = std::nearbyint(std::abs(Offset) * GSubtexelSteps) / GSubtexelSteps;
	return {Distance, Distance, std::nearbyint(std::abs(Offset) / 2.0 * GSubtexelSteps) / GSubtexelSteps};
}

double GetDualKawaseVariance(int32 PassNum, double Offset)
{
	const FDualKawaseTaps Taps = GetDualKawaseTaps(Offset);
	const double Down =
		(Taps.DownDiagonal * Taps.DownDiagonal + GetFilterVariance(0.5) + GetFilterVariance(0.5 + Taps.DownDiagonal)) /
		2.0;
	const double Up = (Taps.UpAxis * Taps.UpAxis + GetUpFilterVariance(Taps.UpAxis) + GetUpFilterVariance(0.0)) / 6.0 +
					  (Taps.UpDiagonal * Taps.UpDiagonal + GetUpFilterVariance(Taps.UpDiagonal)) * 2.0 / 3.0;
	return GetLevelSum(PassNum) * (Down + 4.0 * Up);
}

double GetDualKawaseStandardDeviation(int32 PassNum, double Offset)
{
	return std::sqrt(GetDualKawaseVariance(PassNum, Offset));
}

int32 GetDualKawaseReach(int32 PassNum, double Offset)
{
	// A bilinear tap touches texel centres less than one texel from it. The texels of level k are 2^k pixels.
	const FDualKawaseTaps Taps = GetDualKawaseTaps(Offset);
	const double FirstLevel = (Taps.DownDiagonal + 1.0) + 2.0 * (Taps.UpAxis + 1.0);
	return ToInteger<int32>(std::ceil(FirstLevel * (std::exp2(PassNum) - 1.0)));
}

FDualKawaseSetting FitDualKawase(double Radius)
{
	// Below 1, and for a radius that is not a number, the logarithm is of no use.
	const double Levels = Radius > 1.0 ? std::round(4.0 / 3.0 * std::log(Radius)) : 1.0;
	const int32 PassNum = ToCount(Levels, 1, 64);
	return {PassNum, std::pow(0.4538, PassNum) * Radius};
}

FDualKawaseMatch MatchDualKawaseWidth(double StandardDeviation, int32 MaxPasses)
{
	if (MaxPasses < 1)
	{
		return {{0, 0.0}, 0.0, false};
	}
	const double Variance = StandardDeviation * StandardDeviation;
	int32 PassNum = FMath::Clamp(FitDualKawase(StandardDeviation).PassNum, 1, MaxPasses);
	while (PassNum > 1 && GetDualKawaseVariance(PassNum, 0.0) > Variance)
	{
		--PassNum;
	}
	while (PassNum < MaxPasses && GetDualKawaseVariance(PassNum, GDualKawaseBlockyOffset) < Variance)
	{
		++PassNum;
	}

	FDualKawaseMatch Match;
	Match.Setting = {PassNum, FindNearestStep(StandardDeviation, PassNum, BisectOffset(Variance, PassNum))};
	Match.StandardDeviation = GetDualKawaseStandardDeviation(PassNum, Match.Setting.Offset);
	Match.bReached = std::abs(Match.StandardDeviation / StandardDeviation - 1.0) <= 0.0025;
	return Match;
}

TArray<double> ComputeMatchedGaussian(double StandardDeviation, double ReachInDeviations)
{
	const double Wanted = FMath::Max(StandardDeviation, 0.5);
	const int32 Reach = ToCount(std::ceil(ReachInDeviations * Wanted), 1, GMatchedGaussianMaxReach);
	const auto GetWeights = [Reach](double Sigma)
	{
		TArray<double> Weights;
		double Sum = 0.0;
		for (int32 X = 0; X <= Reach; ++X)
		{
			Weights.Add(std::exp(-0.5 * (X / Sigma) * (X / Sigma)));
			Sum += Weights.Last() * (X == 0 ? 1.0 : 2.0);
		}
		for (double& Weight : Weights)
		{
			Weight /= Sum;
		}
		return Weights;
	};
	const auto GetVariance = [](const TArray<double>& Weights)
	{
		double Variance = 0.0;
		for (int32 X = 1; X < Weights.Num(); ++X)
		{
			Variance += 2.0 * X * X * Weights[X];
		}
		return Variance;
	};

	double Low = Wanted / 2.0;
	double High = Wanted * 2.0;
	for (int32 Step = 0; Step < 60; ++Step)
	{
		const double Middle = (Low + High) / 2.0;
		(GetVariance(GetWeights(Middle)) < Wanted * Wanted ? Low : High) = Middle;
	}
	return GetWeights(Low);
}

} // namespace Drydock
