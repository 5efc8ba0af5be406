// Elementary functions and arithmetic: units in the last place against the C library in long double, and Direct3D's
// special cases.
#include <gtest/gtest.h>

#include "LanesMathKernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace Drydock::Tests
{
namespace
{

constexpr float GInf = std::numeric_limits<float>::infinity();
constexpr float GNan = std::numeric_limits<float>::quiet_NaN();

float Float1(const char* Name, float A, float B = 0)
{
	float Out;
	GetMathKernelsUniform().Float.Find(Name)(&A, &B, &Out, 1);
	return Out;
}

uint32_t BitsOf(float X)
{
	return std::bit_cast<uint32_t>(X);
}

/** Distance in units of the last place of the exact result; results below the smallest normal float must be 0. */
double UlpError(float Actual, long double Exact)
{
	if (std::isnan(Exact))
	{
		return std::isnan(Actual) ? 0 : 1e9;
	}
	if (std::abs(Exact) < 0x1p-126L)
	{
		return std::abs(Actual) <= 0x1p-126f ? 0 : 1e9;
	}
	if (std::abs(Exact) >= 0x1.ffffffp127L)
	{
		return std::isinf(Actual) && (Actual > 0) == (Exact > 0) ? 0 : 1e9;
	}
	int Exponent;
	std::frexp(Exact, &Exponent);
	return double(std::abs(Actual - Exact) / std::ldexp(1.0L, Exponent - 24));
}

/** Largest error of a function over a sweep. */
template<typename F>
double WorstUlp(const char* Name, F Exact, const std::vector<float>& A, const std::vector<float>& B = {})
{
	std::vector<float> Second = B.empty() ? std::vector<float>(A.size()) : B;
	std::vector<float> Out(A.size());
	GetMathKernelsUniform().Float.Find(Name)(A.data(), Second.data(), Out.data(), int(A.size()));
	double Worst = 0;
	for (size_t i = 0; i < A.size(); ++i)
	{
		Worst = std::max(
			Worst, UlpError(Out[i], Exact(static_cast<long double>(A[i]), static_cast<long double>(Second[i]))));
	}
	return Worst;
}

std::vector<float> Sweep(float Low, float High, int Count = 400000)
{
	std::mt19937 Engine(1);
	std::uniform_real_distribution<float> Value(Low, High);
	std::vector<float> Values = {Low, High};
	while (int(Values.size()) < Count)
	{
		Values.push_back(Value(Engine));
	}
	return Values;
}

/** Positive normal numbers of every magnitude, evenly by bits. */
std::vector<float> SweepBits(float Low, float High, int Count = 400000)
{
	std::vector<float> Values;
	const uint64_t First = BitsOf(Low);
	const uint64_t Last = BitsOf(High);
	for (int i = 0; i <= Count; ++i)
	{
		Values.push_back(std::bit_cast<float>(uint32_t(First + (Last - First) * uint64_t(i) / uint64_t(Count))));
	}
	return Values;
}

using FWide = long double;

TEST(LanesElementary, ExponentialsStayWithinTwoUlp)
{
	EXPECT_LE(WorstUlp(
				  "Exp2", [](FWide x, FWide) { return std::exp2(x); }, Sweep(-150, 130)),
		2.0);
	EXPECT_LE(WorstUlp(
				  "Exp2", [](FWide x, FWide) { return std::exp2(x); }, Sweep(-1, 1)),
		2.0);
	EXPECT_LE(WorstUlp(
				  "Exp", [](FWide x, FWide) { return std::exp(x); }, Sweep(-100, 90)),
		2.0);
	EXPECT_LE(WorstUlp(
				  "Exp", [](FWide x, FWide) { return std::exp(x); }, Sweep(-1, 1)),
		2.0);
}

TEST(LanesElementary, LogarithmsStayWithinTwoUlp)
{
	for (const auto& Values : {SweepBits(0x1p-126f, 0x1.fffffep127f), SweepBits(0.5f, 2.0f)})
	{
		EXPECT_LE(WorstUlp(
					  "Log2", [](FWide x, FWide) { return std::log2(x); }, Values),
			2.0);
		EXPECT_LE(WorstUlp(
					  "Log", [](FWide x, FWide) { return std::log(x); }, Values),
			2.0);
	}
}

TEST(LanesElementary, PowStaysWithinOneUlp)
{
	std::vector<float> Bases = SweepBits(0x1p-126f, 0x1.fffffep127f);
	const int Count = int(Bases.size());
	std::shuffle(Bases.begin(), Bases.end(), std::mt19937(4));
	const auto Exact = [](FWide x, FWide y)
	{
		return std::pow(x, y);
	};
	EXPECT_LE(WorstUlp("Pow", Exact, Bases, Sweep(-3, 3, Count)), 1.0);
	EXPECT_LE(WorstUlp("Pow", Exact, Sweep(0.01f, 2, Count), Sweep(-100, 100, Count)), 1.0);
	for (float Gamma : {0.4545f, 1 / 2.4f, 2.2f, 2.4f, 0.5f, 1.0f, 2.0f, 7.3f, -1.7f})
	{
		EXPECT_LE(WorstUlp("Pow", Exact, Sweep(0, 4, 40000), std::vector<float>(40000, Gamma)), 1.0) << Gamma;
	}
}

TEST(LanesElementary, PowStaysWithinOneUlpWhereTheLogarithmCountsMost)
{
	// Results of every exponent from bases around 1, whose logarithm has no whole part to hide behind.
	std::vector<float> Bases;
	std::vector<float> Exponents;
	std::mt19937 Engine(8);
	std::uniform_real_distribution<double> Result(-126, 127.9);
	std::uniform_real_distribution<double> Octave(-1, 1);
	for (int i = 0; i < 400000; ++i)
	{
		const float Base = i % 2 ? float(std::exp2(Octave(Engine))) : 1 + float(int(Engine() % 4001) - 2000) * 0x1p-23f;
		Bases.push_back(Base);
		Exponents.push_back(Base == 1 ? 3 : float(Result(Engine) / std::log2(double(Base))));
	}
	EXPECT_LE(WorstUlp(
				  "Pow", [](FWide x, FWide y) { return std::pow(x, y); }, Bases, Exponents),
		1.0);
}

TEST(LanesElementary, FusedRoundsOnce)
{
	std::vector<float> A;
	std::vector<float> B;
	std::mt19937 Engine(12);
	for (int i = 0; i < 300000; ++i)
	{
		// Beside 1, the sum of the product and 2^24 + 2 lies beside a tie, up to 2^-46 away: less than a double shows.
		const bool bNearOne = i % 3 == 0;
		A.push_back(
			bNearOne ? 1 + float(int(Engine() % 41) - 20) * 0x1p-23f : std::bit_cast<float>(uint32_t(Engine())));
		B.push_back(bNearOne ? 2 - A.back() : std::bit_cast<float>(uint32_t(Engine())));
	}
	struct FCase
	{
		const char* Name;
		float (*Summand)(float, float);
	};
	const FCase Cases[] = {
		{"Fused",
			[](float x, float)
			{
				return x;
			}},
		{"FusedRest",
			[](float x, float y)
			{
				return -(x * y);
			}},
		{"FusedTie",
			[](float, float)
			{
				return 16777218.0f;
			}},
	};
	int Hard = 0;
	for (const FCase& Case : Cases)
	{
		std::vector<float> Out(A.size());
		GetMathKernelsUniform().Float.Find(Case.Name)(A.data(), B.data(), Out.data(), int(A.size()));
		for (size_t i = 0; i < A.size(); ++i)
		{
			const float Z = Case.Summand(A[i], B[i]);
			const float Expected = std::fma(A[i], B[i], Z);
			ASSERT_TRUE(std::isnan(Expected) ? std::isnan(Out[i]) : BitsOf(Expected) == BitsOf(Out[i]))
				<< Case.Name << "(" << A[i] << ", " << B[i] << ") = " << Out[i] << ", expected " << Expected;
			Hard += Expected != float(double(A[i]) * double(B[i]) + double(Z)) && !std::isnan(Expected);
		}
	}
	EXPECT_GT(Hard, 1000) << "sums that double rounds wrongly";
}

TEST(LanesElementary, SineAndCosineStayWithinTwoUlpUpTo8192)
{
	for (float Range : {1.0f, 10.0f, 8192.0f})
	{
		EXPECT_LE(WorstUlp(
					  "Sin", [](FWide x, FWide) { return std::sin(x); }, Sweep(-Range, Range)),
			2.0);
		EXPECT_LE(WorstUlp(
					  "Cos", [](FWide x, FWide) { return std::cos(x); }, Sweep(-Range, Range)),
			2.0);
		EXPECT_LE(WorstUlp(
					  "Tan", [](FWide x, FWide) { return std::tan(x); }, Sweep(-Range, Range)),
			4.0);
	}
}

TEST(LanesElementary, SineIsAccurateBesideMultiplesOfPi)
{
	std::vector<float> Values;
	for (int k = 1; k < 2600; ++k)
	{
		Values.push_back(float(k * 3.14159265358979323846));
	}
	EXPECT_LE(WorstUlp(
				  "Sin", [](FWide x, FWide) { return std::sin(x); }, Values),
		2.0);
}

TEST(LanesElementary, InverseFunctionsStayWithinThreeUlp)
{
	EXPECT_LE(WorstUlp(
				  "Asin", [](FWide x, FWide) { return std::asin(x); }, Sweep(-1, 1)),
		3.0);
	EXPECT_LE(WorstUlp(
				  "Acos", [](FWide x, FWide) { return std::acos(x); }, Sweep(-1, 1)),
		3.0);
	EXPECT_LE(WorstUlp(
				  "Atan", [](FWide x, FWide) { return std::atan(x); }, Sweep(-20, 20)),
		3.0);
	EXPECT_LE(WorstUlp(
				  "Atan", [](FWide x, FWide) { return std::atan(x); }, SweepBits(1e-30f, 1e30f)),
		3.0);
	EXPECT_LE(WorstUlp(
				  "Atan2", [](FWide y, FWide x) { return std::atan2(y, x); }, Sweep(-5, 5),
				  []
				  {
					  auto v = Sweep(-7, 7);
					  std::shuffle(v.begin(), v.end(), std::mt19937(9));
					  return v;
				  }()),
		3.0);
}

TEST(LanesElementary, HyperbolicsStayWithinFourUlp)
{
	for (float Range : {1.0f, 95.0f})
	{
		EXPECT_LE(WorstUlp(
					  "Sinh", [](FWide x, FWide) { return std::sinh(x); }, Sweep(-Range, Range)),
			4.0);
		EXPECT_LE(WorstUlp(
					  "Cosh", [](FWide x, FWide) { return std::cosh(x); }, Sweep(-Range, Range)),
			4.0);
		EXPECT_LE(WorstUlp(
					  "Tanh", [](FWide x, FWide) { return std::tanh(x); }, Sweep(-Range, Range)),
			4.0);
	}
}

TEST(LanesElementary, ExponentialsDoNotDependOnTheDenormalMode)
{
	std::vector<float> A;
	std::vector<float> B;
	std::mt19937 Engine(21);
	std::uniform_real_distribution<float> Value(-140, 140);
	for (int i = 0; i < 200000; ++i)
	{
		A.push_back(i % 2 ? std::bit_cast<float>(uint32_t(Engine())) : Value(Engine));
		B.push_back(Value(Engine));
	}
	for (const char* Name : {"Exp2", "Exp", "Log2", "Log", "Pow"})
	{
		std::vector<float> Kept(A.size());
		std::vector<float> Flushed(A.size());
		const auto Function = GetMathKernelsUniform().Float.Find(Name);
		Function(A.data(), B.data(), Kept.data(), int(A.size()));
		const uint32_t Mode = __builtin_ia32_stmxcsr();
		__builtin_ia32_ldmxcsr(Mode | 0x8040); // flush to zero, denormals are zero
		Function(A.data(), B.data(), Flushed.data(), int(A.size()));
		__builtin_ia32_ldmxcsr(Mode);
		for (size_t i = 0; i < A.size(); ++i)
		{
			ASSERT_TRUE(BitsOf(Kept[i]) == BitsOf(Flushed[i]) || (std::isnan(Kept[i]) && std::isnan(Flushed[i])))
				<< Name << "(" << A[i] << ", " << B[i] << ")";
		}
	}
}

struct FSpecial
{
	const char* Name;
	float A;
	float B;
	float Expected;
};

TEST(LanesElementary, SpecialCases)
{
	const FSpecial Cases[] = {
		{"Exp2", 0, 0, 1},
		{"Exp2", GInf, 0, GInf},
		{"Exp2", -GInf, 0, 0},
		{"Exp2", GNan, 0, GNan},
		{"Exp2", 128, 0, GInf},
		{"Exp2", -126, 0, 0x1p-126f},
		{"Exp2", -126.5f, 0, 0},
		{"Exp2", 5, 0, 32},
		{"Exp2", -3, 0, 0.125f},
		{"Exp", GInf, 0, GInf},
		{"Exp", -GInf, 0, 0},
		{"Exp", GNan, 0, GNan},
		{"Log2", 1, 0, 0},
		{"Log2", 8, 0, 3},
		{"Log2", 0, 0, -GInf},
		{"Log2", -0.0f, 0, -GInf},
		{"Log2", -1, 0, GNan},
		{"Log2", GInf, 0, GInf},
		{"Log2", 1e-42f, 0, -GInf},
		{"Log", 0, 0, -GInf},
		{"Log", -GInf, 0, GNan},
		{"Log", GNan, 0, GNan},
		{"Log", 1, 0, 0},
		{"Pow", 2, 10, 1024},
		{"Pow", 0, 2, 0},
		{"Pow", 0, 0, 1},
		{"Pow", 0, -1, GInf},
		{"Pow", -2, 2, GNan},
		{"Pow", 7, 0, 1},
		{"Pow", GInf, 2, GInf},
		{"Pow", GInf, -2, 0},
		{"Pow", GInf, 0, 1},
		{"Pow", GNan, 0, GNan},
		{"Pow", 2, GNan, GNan},
		{"Pow", 2, GInf, GInf},
		{"Pow", 0.5f, GInf, 0},
		{"Pow", 1, GInf, GNan},
		{"Pow", 10, 39, GInf},
		{"Pow", 10, -38, 0},
		{"Pow", -0.0f, 3, 0},
		{"Pow", -0.0f, -1, GInf},
		{"Pow", 1e-42f, 2, 0},
		{"Pow", -1e-42f, 2, 0},
		{"Pow", 1e-42f, -2, GInf},
		{"Pow", 3, 1e-42f, 1},
		{"Pow", -3, 0, GNan},
		{"Pow", -GInf, 2, GNan},
		{"Pow", 1, -GInf, GNan},
		{"Pow", 1, 3e38f, 1},
		{"Pow", 0, GInf, 0},
		{"Pow", 0, GNan, GNan},
		{"Pow", GInf, GInf, GInf},
		{"Pow", GInf, -GInf, 0},
		{"Pow", 3, 3e38f, GInf},
		{"Pow", 3, -3e38f, 0},
		{"Pow", 0.3f, 3e38f, 0},
		{"Pow", 2, 127, 0x1p127f},
		{"Pow", 2, 128, GInf},
		{"Pow", 2, -126, 0x1p-126f},
		{"Pow", 2, -127, 0},
		{"Pow", 0x1.fffffep127f, 1, 0x1.fffffep127f},
		{"Pow", 0x1.fffffep127f, -1, 0},
		{"Pow", 0x1p-126f, 1, 0x1p-126f},
		{"Pow", 0x1.fffffep127f, 2, GInf},
		{"Pow", 9, 0.5f, 3},
		{"Sin", 0, 0, 0},
		{"Sin", GInf, 0, GNan},
		{"Cos", 0, 0, 1},
		{"Cos", GNan, 0, GNan},
		{"Tan", 0, 0, 0},
		{"Asin", 1.5f, 0, GNan},
		{"Acos", 1, 0, 0},
		{"Acos", -1.5f, 0, GNan},
		{"Atan", GInf, 0, 1.57079637f},
		{"Atan2", 0, 1, 0},
		{"Atan2", 0, -1, 3.14159274f},
		{"Atan2", -0.0f, -1, 3.14159274f}, // no negative number
		{"Atan2", -1e-30f, -1, -3.14159274f},
		{"Atan2", -0.0f, 1, -0.0f},
		{"Atan2", 0, 0, 0},
		{"Atan2", 1, 0, 1.57079637f},
		{"Atan2", GInf, GInf, 0.785398185f},
		{"Atan2", GNan, 1, GNan},
		{"Atan2", 1, GNan, GNan},
		{"Tanh", GInf, 0, 1},
		{"Tanh", -GInf, 0, -1},
		{"Sinh", -GInf, 0, -GInf},
		{"Cosh", -GInf, 0, GInf},
		{"Min", GNan, 1, 1},
		{"Min", 1, GNan, 1},
		{"Min", 2, 1, 1},
		{"Max", GNan, 1, 1},
		{"Max", 1, GNan, 1},
		{"Min", GNan, GNan, GNan},
		{"Saturate", GNan, 0, 0},
		{"Saturate", 2, 0, 1},
		{"Saturate", -1, 0, 0},
		{"RoundEven", 2.5f, 0, 2},
		{"RoundEven", 3.5f, 0, 4},
		{"RoundEven", -0.5f, 0, -0.0f},
		{"Floor", -0.5f, 0, -1},
		{"Ceil", -0.5f, 0, -0.0f},
		{"Trunc", -1.7f, 0, -1},
		{"Frac", -0.25f, 0, 0.75f},
		{"Sign", -3, 0, -1},
		{"Sign", GNan, 0, 0},
		{"Step", 1, 1, 1},
		{"Step", 1, 0.5f, 0},
		{"FMod", -1, 3, 2},
		{"FRem", -1, 3, -1},
		{"Clamp", GNan, 1, 1},
		{"SmoothStep", 1, 0, 0.5f},
		{"Mix", 4, 8, 5},
		{"Abs", -0.0f, 0, 0},
		{"Sqrt", -1, 0, GNan},
		{"InverseSqrt", 4, 0, 0.5f},
		{"InverseSqrt", 0, 0, GInf},
	};
	for (const FSpecial& Case : Cases)
	{
		const float Actual = Float1(Case.Name, Case.A, Case.B);
		EXPECT_TRUE(std::isnan(Case.Expected) ? std::isnan(Actual) : BitsOf(Actual) == BitsOf(Case.Expected))
			<< Case.Name << "(" << Case.A << ", " << Case.B << ") = " << Actual << ", expected " << Case.Expected;
	}
}

TEST(LanesElementary, FmaRoundsTwice)
{
	const float X = 1 + 0x1p-12f;
	const float Y = -1 + 0x3p-14f;
	const volatile float Product = X * Y;
	EXPECT_EQ(Product + X, Float1("Fma", X, Y));
	EXPECT_NE(std::fma(X, Y, X), Float1("Fma", X, Y));
}

} // namespace
} // namespace Drydock::Tests
