// Integers, conversions, and the same bits for uniform scalars and every lane width.
#include <gtest/gtest.h>

#include "LanesDispatch.h"
#include "LanesMathKernels.h"

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

uint32_t Bits1(const char* Name, uint32_t A, uint32_t B = 0)
{
	uint32_t Out;
	GetMathKernelsUniform().Bits.Find(Name)(&A, &B, &Out, 1);
	return Out;
}

uint32_t BitsOf(float X)
{
	return std::bit_cast<uint32_t>(X);
}

struct FBitsCase
{
	const char* Name;
	uint32_t A;
	uint32_t B;
	uint32_t Expected;
};

TEST(LanesInteger, WhatCppLeavesUndefinedIsDefined)
{
	const uint32_t Minimum = 0x80000000u;
	const FBitsCase Cases[] = {
		{"Divide", 7, 0, 0xFFFFFFFFu},
		{"Remainder", 7, 0, 0xFFFFFFFFu},
		{"DivideSigned", 7, 0, 0xFFFFFFFFu},
		{"DivideSigned", Minimum, 0xFFFFFFFFu, Minimum},
		{"RemainderSigned", Minimum, 0xFFFFFFFFu, 0},
		{"Divide", 0xFFFFFFFEu, 2, 0x7FFFFFFFu},
		{"DivideSigned", uint32_t(-7), 2, uint32_t(-3)},
		{"RemainderSigned", uint32_t(-7), 2, uint32_t(-1)},
		{"ModuloSigned", uint32_t(-7), 2, 1},
		{"ModuloSigned", 7, uint32_t(-2), uint32_t(-1)},
		{"ShiftLeft", 1, 33, 2},
		{"ShiftRight", Minimum, 32 + 31, 1},
		{"ShiftRightSigned", Minimum, 31, 0xFFFFFFFFu},
		{"Multiply", 0x10001, 0x10001, 0x20001},
		{"Add", 0xFFFFFFFFu, 2, 1},
		{"Negate", Minimum, 0, Minimum},
		{"Less", 1, Minimum, 1},
		{"LessSigned", 1, Minimum, 0},
		{"MinUnsigned", 1, Minimum, 1},
		{"MaxSigned", 1, Minimum, 1},
		{"AbsSigned", uint32_t(-5), 0, 5},
		{"SignSigned", uint32_t(-5), 0, 0xFFFFFFFFu},
		{"SignSigned", 5, 0, 1},
		{"BitCount", 0xF00F0001u, 0, 9},
		{"BitReverse", 1, 0, Minimum},
		{"FindLsb", 0, 0, 0xFFFFFFFFu},
		{"FindLsb", 0x50, 0, 4},
		{"FindMsb", 0, 0, 0xFFFFFFFFu},
		{"FindMsb", 0x50, 0, 6},
		{"FindMsbSigned", 0xFFFFFFFFu, 0, 0xFFFFFFFFu},
		{"FindMsbSigned", 0xFFFFFFF7u, 0, 3},
		{"ExtractField", 0xABCD, 8, 0x5E},
		{"ExtractField", 0xABCD, 0, 0},
		{"ExtractFieldSigned", 0xF0, 4, 0xFFFFFFFFu},
		{"InsertField", 0, 0xFFFF, 0xFF80},
		{"InsertField", 0xFFFFFFFFu, 0, 0xFFFF007Fu},
	};
	for (const FBitsCase& Case : Cases)
	{
		EXPECT_EQ(Case.Expected, Bits1(Case.Name, Case.A, Case.B)) << Case.Name << " of " << Case.A << ", " << Case.B;
	}
}

TEST(LanesInteger, QuotientsAreExactAtEveryWidth)
{
	std::mt19937_64 Random(1);
	const auto Draw = [&Random]
	{
		const uint32_t Number = uint32_t(Random() >> Random() % 32);
		return Random() % 2 ? Number : uint32_t(0) - Number;
	};
	std::vector<uint32_t> A(1 << 16);
	std::vector<uint32_t> B(A.size());
	for (size_t i = 0; i < A.size(); ++i)
	{
		B[i] = Draw();
		A[i] = i % 2 ? Draw() : Draw() * B[i] - uint32_t(i / 2 % 3); // at a multiple, and just below
	}
	std::vector<const FMathKernels*> Sets = {&GetMathKernelsSse()};
	if (AreLanesSupported(false, 8))
	{
		Sets.push_back(&GetMathKernelsAvx2());
	}
	if (AreLanesSupported(false, 16))
	{
		Sets.push_back(&GetMathKernelsAvx512());
	}
	std::vector<uint32_t> Out(A.size());
	for (const FMathKernels* const Set : Sets)
	{
		const auto Check = [&](const char* Name, auto Expected)
		{
			Set->Bits.Find(Name)(A.data(), B.data(), Out.data(), int(A.size()));
			for (size_t i = 0; i < A.size(); ++i)
			{
				ASSERT_EQ(uint32_t(Expected(A[i], B[i])), Out[i]) << Name << " of " << A[i] << ", " << B[i];
			}
		};
		Check("Divide", [](uint32_t X, uint32_t Y) { return Y ? X / Y : ~0u; });
		Check("Remainder", [](uint32_t X, uint32_t Y) { return Y ? X % Y : ~0u; });
		Check("DivideBy7", [](uint32_t X, uint32_t) { return X / 7; });
		Check("DivideBy64", [](uint32_t X, uint32_t) { return X / 64; });
		Check("RemainderBy64", [](uint32_t X, uint32_t) { return X % 64; });
		Check("DivideBy0", [](uint32_t, uint32_t) { return ~0u; });
		Check("DivideSigned", [](int32_t X, int32_t Y) { return Y ? int64_t(X) / Y : -1; });
		Check("RemainderSigned", [](int32_t X, int32_t Y) { return Y ? int64_t(X) % Y : -1; });
		Check("DivideByMinus8", [](int32_t X, int32_t) { return X / -8; });
		Check("RemainderBy8Signed", [](int32_t X, int32_t) { return X % 8; });
	}
}

TEST(LanesConversion, FloatToIntegerSaturatesAndNanIsZero)
{
	const FBitsCase Cases[] = {
		{"FloatToInt", BitsOf(3e9f), 0, 0x7FFFFFFFu},
		{"FloatToInt", BitsOf(-3e9f), 0, 0x80000000u},
		{"FloatToInt", BitsOf(GNan), 0, 0},
		{"FloatToInt", BitsOf(-2.9f), 0, uint32_t(-2)},
		{"FloatToInt", BitsOf(-2147483648.0f), 0, 0x80000000u},
		{"FloatToInt", BitsOf(GInf), 0, 0x7FFFFFFFu},
		{"FloatToUint", BitsOf(-1.0f), 0, 0},
		{"FloatToUint", BitsOf(5e9f), 0, 0xFFFFFFFFu},
		{"FloatToUint", BitsOf(3e9f), 0, 3000000000u},
		{"FloatToUint", BitsOf(GNan), 0, 0},
		{"FloatToUint", BitsOf(2.9f), 0, 2},
		{"DoubleToInt", BitsOf(3e9f), 0, 0x7FFFFFFFu},
		{"DoubleToUint", BitsOf(3e9f), 0, 3000000000u},
		{"IntToFloat", 16777217u, 0, BitsOf(16777216.0f)},
		{"IntToFloat", uint32_t(-1), 0, BitsOf(-1.0f)},
		{"UintToFloat", 0xFFFFFFFFu, 0, BitsOf(4294967296.0f)},
		{"UintToFloat", 0x80000081u, 0, BitsOf(float(0x80000081u))},
		{"UintToDouble", 3000000000u, 0, BitsOf(3e9f)},
	};
	for (const FBitsCase& Case : Cases)
	{
		EXPECT_EQ(Case.Expected, Bits1(Case.Name, Case.A, Case.B)) << Case.Name << " of " << Case.A;
	}
}

TEST(LanesConversion, LdexpReachesEveryExponent)
{
	EXPECT_EQ(BitsOf(0x1p127f), Bits1("Ldexp", BitsOf(0x1p-126f), 253));
	EXPECT_EQ(BitsOf(GInf), Bits1("Ldexp", BitsOf(1.0f), 128));
	EXPECT_EQ(BitsOf(12.0f), Bits1("Ldexp", BitsOf(3.0f), 2));
	EXPECT_EQ(0u, Bits1("Ldexp", BitsOf(1.0f), uint32_t(-400)));
}

TEST(LanesConversion, HalvesMatchTheCompilersOwnType)
{
	for (uint32_t Half = 0; Half < 0x10000; ++Half)
	{
		const float Expected = float(std::bit_cast<_Float16>(uint16_t(Half)));
		const float Actual = std::bit_cast<float>(Bits1("UnpackLow", Half));
		ASSERT_TRUE(std::isnan(Expected) ? std::isnan(Actual) : BitsOf(Expected) == BitsOf(Actual)) << Half;
		ASSERT_EQ(BitsOf(Actual), Bits1("UnpackHigh", Half << 16));
	}
	std::mt19937 Engine(3);
	for (int i = 0; i < 300000; ++i)
	{
		const float X = std::bit_cast<float>(uint32_t(0x33000000u + Engine() % 0x15000000u) | (uint32_t(i & 1) << 31));
		const uint32_t Expected = std::bit_cast<uint16_t>(_Float16(X));
		ASSERT_EQ(Expected, Bits1("PackHalf", BitsOf(X), 0) & 0xFFFF) << X;
	}
}

// ---- The same bits everywhere.

template<typename T>
void ExpectSame(const std::vector<T>& Expected, const std::vector<T>& Actual, const std::string& What)
{
	for (size_t i = 0; i < Expected.size(); ++i)
	{
		bool bNan = false;
		if constexpr (std::is_floating_point_v<T>)
		{
			bNan = std::isnan(Expected[i]) && std::isnan(Actual[i]);
		}
		ASSERT_TRUE(bNan || std::memcmp(&Expected[i], &Actual[i], sizeof(T)) == 0) << What << " at " << i;
	}
}

template<typename T, typename M>
void CompareTables(
	const M& Reference, const M& Other, const std::vector<T>& A, const std::vector<T>& B, const std::string& What)
{
	for (const auto& [Name, Function] : Reference)
	{
		std::vector<T> Expected(A.size());
		std::vector<T> Actual(A.size());
		Function(A.data(), B.data(), Expected.data(), int(A.size()));
		Other.Find(Name)(A.data(), B.data(), Actual.data(), int(A.size()));
		ExpectSame(Expected, Actual, What + " " + Name);
	}
}

void CompareKernels(const FMathKernels& Other, const std::string& What)
{
	std::mt19937 Engine(11);
	constexpr int Count = 1 << 15;
	std::vector<uint32_t> BitsA(Count);
	std::vector<uint32_t> BitsB(Count);
	std::vector<float> FloatA(Count);
	std::vector<float> FloatB(Count);
	std::vector<double> DoubleA(Count);
	std::vector<double> DoubleB(Count);
	std::uniform_real_distribution<double> Value(-20, 20);
	for (size_t i = 0; i < Count; ++i)
	{
		BitsA[i] = Engine();
		BitsB[i] = i % 3 == 0 ? Engine() % 40 : Engine();
		// Half are any bits at all, NaN and denormals among them.
		FloatA[i] = i % 2 == 0 ? float(Value(Engine)) : std::bit_cast<float>(uint32_t(Engine()));
		FloatB[i] = i % 2 == 0 ? float(Value(Engine)) : std::bit_cast<float>(uint32_t(Engine()));
		DoubleA[i] = Value(Engine);
		DoubleB[i] = Value(Engine);
	}
	CompareTables<float>(GetMathKernelsUniform().Float, Other.Float, FloatA, FloatB, What + " float");
	CompareTables<double>(GetMathKernelsUniform().Double, Other.Double, DoubleA, DoubleB, What + " double");
	CompareTables<uint32_t>(GetMathKernelsUniform().Bits, Other.Bits, BitsA, BitsB, What + " bits");
}

TEST(LanesBits, Sse)
{
	CompareKernels(GetMathKernelsSse(), "sse");
}

TEST(LanesBits, Avx2)
{
	if (!AreLanesSupported(false, 8))
	{
		GTEST_SKIP() << "this CPU has no AVX2";
	}
	CompareKernels(GetMathKernelsAvx2(), "avx2");
}

TEST(LanesBits, Avx512)
{
	if (!AreLanesSupported(false, 16))
	{
		GTEST_SKIP() << "this CPU has no AVX-512";
	}
	CompareKernels(GetMathKernelsAvx512(), "avx512");
}

} // namespace
} // namespace Drydock::Tests
