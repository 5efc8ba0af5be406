// The blurs in float lanes that no shader runs, against plain loops in double, on pictures drawn at random, of all
// sizes, lane widths and threads.
#include <gtest/gtest.h>

#include "HAL/ConsoleVariableTools.h"
#include "LanesDispatch.h"
#include "Study/BlurAlgorithms.h"
#include "Study/BlurNative.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <limits>
#include <random>

using namespace Drydock;

namespace
{

using FBlurFunction = void (*)(FFloatImage&, double);

/** 0..1, of full precision. */
FFloatImage MakeRandom(int Width, int Height, uint32_t Seed)
{
	std::mt19937 Engine(Seed);
	std::uniform_real_distribution<float> Value(0.0f, 1.0f);
	FFloatImage Image{Width, Height, std::vector<float>(static_cast<size_t>(Width * Height) * 4)};
	std::generate(Image.Values.begin(), Image.Values.end(), [&] { return Value(Engine); });
	return Image;
}

FFloatImage MakeConstant(int Width, int Height, float Value)
{
	return {Width, Height, std::vector<float>(static_cast<size_t>(Width * Height) * 4, Value)};
}

FFloatImage Apply(FBlurFunction Blur, FFloatImage Image, double Sigma)
{
	Blur(Image, Sigma);
	return Image;
}

float GetTexel(const FFloatImage& Image, int X, int Y, int Channel)
{
	return Image.Values[static_cast<size_t>((Y * Image.Width + X) * 4 + Channel)];
}

/** One line at a time through Filter, rows and then columns. */
template<typename F>
std::vector<double> FilterBoth(const FFloatImage& Image, F Filter)
{
	std::vector<double> Values(Image.Values.begin(), Image.Values.end());
	const auto Run = [&](int Begin, int Step, int Length)
	{
		std::vector<double> Line;
		for (int Index = 0; Index < Length; ++Index)
		{
			Line.push_back(Values[static_cast<size_t>(Begin + Index * Step)]);
		}
		Line = Filter(Line);
		for (int Index = 0; Index < Length; ++Index)
		{
			Values[static_cast<size_t>(Begin + Index * Step)] = Line[static_cast<size_t>(Index)];
		}
	};
	for (int Row = 0; Row < Image.Height * 4; ++Row)
	{
		Run(Row / 4 * Image.Width * 4 + Row % 4, 4, Image.Width);
	}
	for (int Column = 0; Column < Image.Width * 4; ++Column)
	{
		Run(Column, Image.Width * 4, Image.Height);
	}
	return Values;
}

/** The variance of one box is sigma^2 / 3; r and the end weight a are found by trying. */
std::vector<double> AverageThrice(std::vector<double> Line, double Sigma)
{
	const double Wanted = Sigma * Sigma / 3.0;
	const auto GetVariance = [](int Radius, double Part)
	{
		double Square = 0.0;
		for (int Distance = 1; Distance <= Radius; ++Distance)
		{
			Square += 2.0 * Distance * Distance;
		}
		return (Square + 2.0 * Part * (Radius + 1.0) * (Radius + 1.0)) / (2.0 * Radius + 1.0 + 2.0 * Part);
	};
	int Radius = 0;
	while (GetVariance(Radius, 1.0) <= Wanted)
	{
		++Radius;
	}
	double Low = 0.0;
	double High = 1.0;
	for (int Step = 0; Step < 60; ++Step)
	{
		const double Middle = (Low + High) / 2.0;
		(GetVariance(Radius, Middle) < Wanted ? Low : High) = Middle;
	}
	const int Length = static_cast<int>(Line.size());
	for (int Time = 0; Time < 3; ++Time)
	{
		std::vector<double> Averaged;
		for (int Index = 0; Index < Length; ++Index)
		{
			double Sum = 0.0;
			for (int Distance = -Radius - 1; Distance <= Radius + 1; ++Distance)
			{
				Sum += Line[static_cast<size_t>(std::clamp(Index + Distance, 0, Length - 1))] *
					   (std::abs(Distance) <= Radius ? 1.0 : Low);
			}
			Averaged.push_back(Sum / (2.0 * Radius + 1.0 + 2.0 * Low));
		}
		Line = Averaged;
	}
	return Line;
}

/** y = g x + b1 y1 + b2 y2 + b3 y3 forth and back, over a line whose ends go on for 30 deviations; q by trying. */
std::vector<double> RecurseLong(const std::vector<double>& Line, double Sigma)
{
	using FComplex = std::complex<double>;
	const FComplex M[3] = {{1.16680, 0.0}, {1.10783, 1.40586}, {1.10783, -1.40586}};
	double Low = 0.0;
	double High = 10.0 * Sigma + 1.0;
	for (int Step = 0; Step < 100; ++Step)
	{
		const double Q = (Low + High) / 2.0;
		FComplex Variance = 0.0; // of p / (1 - p)^2 for each pole, and both ways
		for (const FComplex& Root : M)
		{
			const FComplex P = Q / (Root + Q);
			Variance += 2.0 * P / ((1.0 - P) * (1.0 - P));
		}
		(Variance.real() < Sigma * Sigma ? Low : High) = Q;
	}
	FComplex P[3];
	std::transform(std::begin(M), std::end(M), P, [Low](FComplex Root) { return Low / (Root + Low); });
	const double B1 = (P[0] + P[1] + P[2]).real();
	const double B2 = -(P[0] * P[1] + P[0] * P[2] + P[1] * P[2]).real();
	const double B3 = (P[0] * P[1] * P[2]).real();
	const double Gain = ((1.0 - P[0]) * (1.0 - P[1]) * (1.0 - P[2])).real();
	const int Beyond = static_cast<int>(30.0 * Sigma) + 30;
	const int Length = static_cast<int>(Line.size());
	std::vector<double> Long;
	for (int Index = -Beyond; Index < Length + Beyond; ++Index)
	{
		Long.push_back(Line[static_cast<size_t>(std::clamp(Index, 0, Length - 1))]);
	}
	for (int Way = 0; Way < 2; ++Way)
	{
		double Y[3] = {Long[0], Long[0], Long[0]};
		for (double& Value : Long)
		{
			const double Next = Gain * Value + B1 * Y[0] + B2 * Y[1] + B3 * Y[2];
			Y[2] = Y[1];
			Y[1] = Y[0];
			Y[0] = Value = Next;
		}
		std::reverse(Long.begin(), Long.end());
	}
	return {Long.begin() + Beyond, Long.begin() + Beyond + Length};
}

double GetLargestDifference(const FFloatImage& Image, const std::vector<double>& Expected)
{
	double Largest = 0.0;
	for (size_t Index = 0; Index < Expected.size(); ++Index)
	{
		const double Difference = std::abs(static_cast<double>(Image.Values[Index]) - Expected[Index]);
		Largest = Difference <= Largest ? Largest : Difference; // NaN is kept
	}
	return Largest;
}

/** Where a texel is not finite. */
std::vector<std::pair<int, int>> FindNotFinite(const FFloatImage& Image)
{
	std::vector<std::pair<int, int>> Places;
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			if (!std::isfinite(GetTexel(Image, X, Y, 1)))
			{
				Places.emplace_back(X, Y);
			}
		}
	}
	return Places;
}

constexpr std::pair<int, int> GSizes[] = {
	{1, 1}, {2, 1}, {1, 3}, {3, 2}, {5, 7}, {8, 8}, {17, 4}, {33, 9}, {9, 33}, {64, 16}, {130, 3}};

} // namespace

TEST(BlurBoxes, IsThreePlainAveragesOfAnySize)
{
	for (const auto& [Width, Height] : GSizes)
	{
		const FFloatImage Image = MakeRandom(Width, Height, 11);
		for (const double Sigma : {0.3, 0.9, std::sqrt(2.0), 3.7, 16.0, 64.0, 300.0})
		{
			const std::vector<double> Expected =
				FilterBoth(Image, [Sigma](const std::vector<double>& Line) { return AverageThrice(Line, Sigma); });
			EXPECT_LE(GetLargestDifference(Apply(&BlurBoxes, Image, Sigma), Expected), 4e-6)
				<< Width << " x " << Height << ", " << Sigma;
		}
	}
}

TEST(BlurRecursive, IsThePlainRecursionOverAnEndlessLine)
{
	for (const auto& [Width, Height] : GSizes)
	{
		const FFloatImage Image = MakeRandom(Width, Height, 12);
		for (const double Sigma : {0.5, 0.8, 2.0, 5.0, 16.0, 64.0})
		{
			const std::vector<double> Expected =
				FilterBoth(Image, [Sigma](const std::vector<double>& Line) { return RecurseLong(Line, Sigma); });
			EXPECT_LE(GetLargestDifference(Apply(&BlurRecursive, Image, Sigma), Expected), 4e-6)
				<< Width << " x " << Height << ", " << Sigma;
		}
	}
}

/** Its columns are single texels, which stay. */
TEST(BlurRecursive, OfALongLineStaysWithinItsBound)
{
	const FFloatImage Image = MakeRandom(2000, 1, 13);
	for (const double Sigma : {64.0, 500.0})
	{
		const std::vector<double> Expected = FilterBoth(Image,
			[Sigma](const std::vector<double>& Line) { return Line.size() == 1 ? Line : RecurseLong(Line, Sigma); });
		EXPECT_LE(GetLargestDifference(Apply(&BlurRecursive, Image, Sigma), Expected), 4e-6) << Sigma;
	}
}

TEST(BlurRecursive, KeepsAConstantToTheBit)
{
	for (const double Sigma : {0.5, 8.0, 64.0, 500.0})
	{
		const FFloatImage Image = MakeConstant(61, 40, 0.1f);
		EXPECT_EQ(Image.Values, Apply(&BlurRecursive, Image, Sigma).Values) << Sigma;
	}
}

TEST(BlurBoxes, KeepsAConstant)
{
	for (const double Sigma : {0.5, 8.0, 64.0, 1000.0})
	{
		const FFloatImage Image = MakeConstant(61, 40, 0.1f);
		const std::vector<double> Expected(Image.Values.begin(), Image.Values.end());
		EXPECT_LE(GetLargestDifference(Apply(&BlurBoxes, Image, Sigma), Expected), 1e-7) << Sigma;
	}
}

TEST(BlurBoxes, OfOneThirdOfAVarianceIsThatWide)
{
	// sigma^2 = 3 * 2/3: three averages of three texels: [1 3 6 7 6 3 1] / 27.
	FFloatImage Impulse = MakeConstant(21, 1, 0.0f);
	std::fill_n(Impulse.Values.begin() + 40, 4, 27.0f);
	BlurBoxes(Impulse, std::sqrt(2.0));
	const double Expected[] = {7, 6, 3, 1, 0};
	for (int Distance = 0; Distance < 5; ++Distance)
	{
		EXPECT_NEAR(Expected[Distance], GetTexel(Impulse, 10 + Distance, 0, 0), 5e-6);
		EXPECT_NEAR(Expected[Distance], GetTexel(Impulse, 10 - Distance, 0, 0), 5e-6);
	}
}

/** Sides that leave lanes without a line. */
TEST(BlurNative, BitsAreTheSameOnEveryLaneWidthAndNumberOfThreads)
{
	const FFloatImage Image = MakeRandom(43, 29, 14);
	for (const FBlurFunction Blur : {&BlurBoxes, &BlurRecursive})
	{
		const FFloatImage Expected = Apply(Blur, Image, 4.2);
		for (const int Lanes : {4, 8, 16})
		{
			for (const int Threads : {1, 2, 5})
			{
				if (AreLanesSupported(false, Lanes))
				{
					const FScopedConsoleVariable Width(TEXT("r.Drydock.LaneWidth"), static_cast<float>(Lanes));
					const FScopedConsoleVariable Workers(TEXT("r.Drydock.Threads"), static_cast<float>(Threads));
					const FFloatImage Blurred = Apply(Blur, Image, 4.2);
					EXPECT_EQ(0, std::memcmp(Expected.Values.data(), Blurred.Values.data(),
									 Blurred.Values.size() * sizeof(float)))
						<< Lanes << " lanes, " << Threads << " threads";
				}
			}
		}
	}
}

TEST(BlurBoxes, ValueThatIsNotFiniteStaysInItsWindows)
{
	// Three boxes of a third of 2.25 = 0.75 reach one texel and a part of the second: six texels to each side.
	for (const float Value : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
			 -std::numeric_limits<float>::infinity()})
	{
		FFloatImage Image = MakeConstant(40, 30, 1.0f);
		Image.Values[(12 * 40 + 20) * 4 + 1] = Value;
		BlurBoxes(Image, 1.5);
		std::vector<std::pair<int, int>> Expected;
		for (int Y = 6; Y <= 18; ++Y)
		{
			for (int X = 14; X <= 26; ++X)
			{
				Expected.emplace_back(X, Y);
			}
		}
		EXPECT_EQ(Expected, FindNotFinite(Image)) << Value;
	}
}

TEST(BlurRecursive, ValueThatIsNotFiniteSpoilsItsRowAndColumn)
{
	FFloatImage Image = MakeConstant(9, 6, 1.0f);
	Image.Values[(2 * 9 + 4) * 4 + 1] = std::numeric_limits<float>::infinity();
	BlurRecursive(Image, 1.5);
	// Its row is spoilt first, so every column is.
	EXPECT_EQ(54u, FindNotFinite(Image).size());
	EXPECT_TRUE(std::isfinite(GetTexel(Image, 4, 2, 0)));
}

TEST(BlurNative, NothingIsDoneForNoWidthAndNoTexels)
{
	const FFloatImage Image = MakeRandom(5, 3, 15);
	for (const double Sigma : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
	{
		EXPECT_EQ(Image.Values, Apply(&BlurBoxes, Image, Sigma).Values);
		EXPECT_EQ(Image.Values, Apply(&BlurRecursive, Image, Sigma).Values);
	}
	EXPECT_TRUE(Apply(&BlurBoxes, {}, 2.0).Values.empty());
	EXPECT_TRUE(Apply(&BlurRecursive, {}, 2.0).Values.empty());
}

/** As the shaders do: four texels of four floats a pixel, along two axes there and back. */
TEST(BlurNative, MovesFloats)
{
	const FImage Image = ToImage(MakeRandom(16, 16, 16));
	EXPECT_DOUBLE_EQ(64.0, FBlur("Boxes", 2.0).Run(Image).BytesPerPixel);
	EXPECT_DOUBLE_EQ(64.0, FBlur("Recursive", 2.0).Run(Image).BytesPerPixel);
	EXPECT_DOUBLE_EQ(128.0, FBlur("Exact", 2.0).Run(Image).BytesPerPixel);
}
