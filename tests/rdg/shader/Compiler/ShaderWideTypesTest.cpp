// Numbers of 16 and 64 bits: kernels of all widths, in float and in double, and the interpreter against plain C++.
// A little past 500 lines: the cases share one harness and its words.
#include "ShaderHarness.h"
#include "TileExecutor.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace Drydock::Test
{

namespace
{

using ::testing::HasSubstr;

constexpr int32_t NumThreads = 256;

template<typename T>
std::vector<uint32_t> ToWords(const std::vector<T>& Values)
{
	std::vector<uint32_t> Words((Values.size() * sizeof(T) + 3) / 4);
	std::memcpy(Words.data(), Values.data(), Values.size() * sizeof(T));
	return Words;
}

template<typename T>
std::vector<T> FromWords(const std::vector<uint32_t>& Words)
{
	std::vector<T> Values(Words.size() * 4 / sizeof(T));
	std::memcpy(Values.data(), Words.data(), Values.size() * sizeof(T));
	return Values;
}

/** Every way to run the shader writes the same: kernels of each width, of floats and of doubles, and the interpreter
 * with and without the shader's functions. */
class FEverywhere
{
public:
	FEverywhere(std::string InText, bool bInDouble = true)
		: Text(std::move(InText))
		, bDouble(bInDouble)
	{
	}

	std::map<std::string, std::vector<uint32_t>> Inputs;
	size_t NumOutputWords = 0;

	std::vector<uint32_t> Run(bool bRealHalf = true)
	{
		const FScopedDenormals Scope(EDenormals::Flush); // as kernels of float run
		Inputs["Out"] = std::vector<uint32_t>(NumOutputWords, 0xCDCDCDCDu);
		FShaderHarness Model = Make(bRealHalf);
		Model.RunModel(NumThreads, 1);
		const std::vector<uint32_t> Expected = Model.Buffers["Out"];
		FShaderHarness Looked = Make(bRealHalf);
		Looked.RunInspected(NumThreads, 1);
		ExpectSame(Expected, Looked.Buffers["Out"], "with its functions");
		for (const int32_t Lanes : GetLaneCounts())
		{
			FShaderHarness Kernel = Make(bRealHalf);
			Kernel.Run(Lanes, NumThreads, 1);
			ExpectSame(Expected, Kernel.Buffers["Out"], std::to_string(Lanes) + " lanes");
		}
		for (int32_t Lanes = 2; bDouble && Lanes <= GetWidestLanes(true); Lanes *= 2)
		{
			FShaderHarness Kernel = Make(bRealHalf);
			Kernel.Run(Lanes, NumThreads, 1, 1, true);
			ExpectSame(Expected, Kernel.Buffers["Out"], std::to_string(Lanes) + " lanes of double");
		}
		return Expected;
	}

private:
	void ExpectSame(
		const std::vector<uint32_t>& Expected, const std::vector<uint32_t>& Actual, const std::string& How) const
	{
		const auto First = std::mismatch(Expected.begin(), Expected.end(), Actual.begin(), Actual.end()).first;
		const size_t At = size_t(First - Expected.begin());
		EXPECT_EQ(Expected.end(), First) << How << ": word " << At << " is " << std::hex
										 << Actual[std::min(At, Actual.size() - 1)] << ", not "
										 << (First == Expected.end() ? 0 : *First) << "\n"
										 << Text;
	}

	FShaderHarness Make(bool bRealHalf) const
	{
		FShaderHarness Harness(Text, "MainCS", EShaderStage::Compute);
		if (bRealHalf)
		{
			Harness.Request.Defines.emplace_back("__HLSL_ENABLE_16_BIT", "1");
		}
		Harness.Buffers = Inputs;
		return Harness;
	}

	const std::string Text;
	const bool bDouble;
};

/** `Out[Id * Count + i] = Expressions[i]`, of A and B of Type. */
std::string MakeShader(const std::string& Type, const std::string& Result, const std::vector<std::string>& Expressions)
{
	std::string Text = "StructuredBuffer<" + Type + "> InA;\nStructuredBuffer<" + Type + "> InB;\nRWStructuredBuffer<" +
					   Result + "> Out;\n[numthreads(8, 1, 1)]\nvoid MainCS(uint3 Id : SV_DispatchThreadID)\n{\n\t" +
					   Type + " A = InA[Id.x];\n\t" + Type + " B = InB[Id.x];\n";
	for (size_t i = 0; i < Expressions.size(); ++i)
	{
		Text += "\tOut[Id.x * " + std::to_string(Expressions.size()) + " + " + std::to_string(i) +
				"] = " + Expressions[i] + ";\n";
	}
	return Text + "}\n";
}

/** Random bits, and each pair of what is special. */
template<typename T>
void MakeInputs(const std::vector<T>& Special, std::vector<T>& A, std::vector<T>& B)
{
	std::mt19937_64 Random(7);
	for (int32_t i = 0; i < NumThreads; ++i)
	{
		const uint64_t Bits[2] = {Random(), Random()};
		T Values[2];
		std::memcpy(&Values[0], &Bits[0], sizeof(T));
		std::memcpy(&Values[1], &Bits[1], sizeof(T));
		const size_t Pair = size_t(i);
		const bool bSpecial = Pair < Special.size() * Special.size();
		A.push_back(bSpecial ? Special[Pair / Special.size()] : Values[0]);
		B.push_back(bSpecial ? Special[Pair % Special.size()] : Values[1]);
	}
}

template<typename T>
bool Same(T X, T Y)
{
	return std::memcmp(&X, &Y, sizeof(T)) == 0 || (X != X && Y != Y);
}

template<typename T, typename F>
void ExpectAll(const std::vector<uint32_t>& Words, size_t Count, F Compute)
{
	const std::vector<T> Values = FromWords<T>(Words);
	for (size_t i = 0; i < size_t(NumThreads); ++i)
	{
		const std::vector<T> Expected = Compute(i);
		for (size_t k = 0; k < Count; ++k)
		{
			EXPECT_TRUE(Same(Expected[k], Values[i * Count + k]))
				<< "expression " << k << " of thread " << i << ": " << double(Values[i * Count + k]) << ", not "
				<< double(Expected[k]);
		}
	}
}

template<typename T>
using FUnsigned = std::make_unsigned_t<T>;

/** C++'s own operators, where it has no undefined results; else Direct3D's rules. */
template<typename T>
std::vector<T> ComputeIntegers(T A, T B)
{
	using U = FUnsigned<T>;
	constexpr int Width = 8 * sizeof(T);
	const bool bWraps = std::is_signed_v<T> && B == T(-1);
	const int Count = int(U(B) & U(Width - 1));
	const U High = A < 0 ? U(~A) : U(A);
	T Turned = 0;
	for (int i = 0; i < Width; ++i)
	{
		Turned = T(Turned | T(T(U(A) >> i & 1) << (Width - 1 - i)));
	}
	return {T(U(A) + U(B)), T(U(A) - U(B)), T(uint64_t(U(A)) * U(B)),
		B == 0   ? T(-1)
		: bWraps ? T(U(0) - U(A))
				 : T(A / B),
		B == 0   ? T(-1)
		: bWraps ? T(0)
				 : T(A % B),
		T(uint64_t(U(A)) << Count), T(A >> Count), T(A & B), T(A | B), T(A ^ B), T(~A), T(U(0) - U(A)), T(A < B),
		T(A >= B), T(A == B), std::min(A, B), std::max(A, B), T(std::popcount(U(A))),
		A == 0 ? T(-1) : T(std::countr_zero(U(A))), High == 0 ? T(-1) : T(Width - 1 - std::countl_zero(High)), Turned};
}

const std::vector<std::string> IntegerExpressions = {"A + B", "A - B", "A * B", "A / B", "A % B", "A << B", "A >> B",
	"A & B", "A | B", "A ^ B", "~A", "-A", "T(A < B)", "T(A >= B)", "T(A == B)", "min(A, B)", "max(A, B)",
	"T(countbits(A))", "T(int(firstbitlow(A)))", "T(int(firstbithigh(A)))", "reversebits(A)"};

std::vector<std::string> WithType(std::vector<std::string> Expressions, const std::string& Type)
{
	for (std::string& Expression : Expressions)
	{
		for (size_t At = Expression.find("T("); At != std::string::npos; At = Expression.find("T(", At + Type.size()))
		{
			Expression.replace(At, 1, Type);
		}
	}
	return Expressions;
}

template<typename T>
void CheckIntegers(const std::string& Type)
{
	std::vector<T> A, B;
	MakeInputs<T>({0, 1, T(-1), 2, std::numeric_limits<T>::min(), std::numeric_limits<T>::max(), T(8 * sizeof(T)),
					  T(8 * sizeof(T) + 3), T(-7), 5},
		A, B);
	const size_t Count = IntegerExpressions.size();
	FEverywhere Everywhere(MakeShader(Type, Type, WithType(IntegerExpressions, Type)));
	Everywhere.Inputs = {{"InA", ToWords(A)}, {"InB", ToWords(B)}};
	Everywhere.NumOutputWords = (NumThreads * Count * sizeof(T) + 3) / 4;
	ExpectAll<T>(Everywhere.Run(), Count, [&](size_t i) { return ComputeIntegers(A[i], B[i]); });
}

} // namespace

TEST(ShaderWideTypes, IntegersOf64BitsAreThoseOfCpp)
{
	CheckIntegers<int64_t>("int64_t");
	CheckIntegers<uint64_t>("uint64_t");
}

TEST(ShaderWideTypes, IntegersOf16BitsAreThoseOfCpp)
{
	CheckIntegers<int16_t>("int16_t");
	CheckIntegers<uint16_t>("uint16_t");
}

TEST(ShaderWideTypes, DoublesAreThoseOfCppAndKeepDenormals)
{
	std::vector<double> A, B;
	const double Inf = std::numeric_limits<double>::infinity();
	MakeInputs<double>({0.0, -0.0, 1.0, -1.5, Inf, -Inf, std::nan(""), 5e-324, -1e-310, 1.7e308, 0.1, 1e-40}, A, B);
	const std::vector<std::string> Expressions = {"A + B", "A - B", "A * B", "A / B", "-A", "abs(A)", "double(A < B)",
		"double(A == B)", "double(A != B)", "double(float(A))", "sqrt(A)", "floor(A)", "fma(A, B, A)", "min(A, B)",
		"double(int(A))", "double(uint(B))", "double(int64_t(A))", "B < 0 ? A : 0.1L", "ceil(A)", "trunc(A)",
		"round(A)", "double(isinf(A))", "double(isnan(A))"};
	FEverywhere Everywhere(MakeShader("double", "double", Expressions), false);
	Everywhere.Inputs = {{"InA", ToWords(A)}, {"InB", ToWords(B)}};
	Everywhere.NumOutputWords = NumThreads * Expressions.size() * 2;
	const auto Saturate = [](double X, double Low, double High)
	{
		return X != X ? 0.0 : std::trunc(std::min(std::max(X, Low), High));
	};
	ExpectAll<double>(Everywhere.Run(), Expressions.size(),
		[&](size_t i) -> std::vector<double>
		{
			const double X = A[i];
			const double Y = B[i];
			const double Long =
				X >= 0x1p63 ? double(std::numeric_limits<int64_t>::max()) : Saturate(X, -0x1p63, 0x1p63);
			return {X + Y, X - Y, X * Y, X / Y, -X, std::fabs(X), double(X < Y), double(X == Y), double(X != Y),
				std::fabs(X) < 0x1p-126 ? std::copysign(0.0, X) : double(float(X)), std::sqrt(X), std::floor(X),
				X * Y + X,
				Y != Y  ? X
				: X < Y ? X
						: Y,
				Saturate(X, -2147483648.0, 2147483647.0) + 0.0, Saturate(Y, 0, 4294967295.0) + 0.0, Long + 0.0,
				Y < 0 ? X : 0.1, std::ceil(X), std::trunc(X), std::nearbyint(X), double(std::isinf(X)),
				double(std::isnan(X))};
		});
	FEverywhere Waves(MakeShader("double", "double", {"WaveActiveSum(A)"}), false); // waves of the group's 8 threads
	Waves.Inputs = {{"InA", ToWords(std::vector<double>(NumThreads, 5e-324))}, {"InB", ToWords(B)}};
	Waves.NumOutputWords = NumThreads * 2;
	EXPECT_EQ(ToWords(std::vector<double>(NumThreads, 4e-323)), Waves.Run());
}

TEST(ShaderWideTypes, HalvesAreRoundedToNearestEvenAfterEachOperation)
{
	std::vector<_Float16> A, B;
	const auto FromBits = [](uint16_t Bits)
	{
		return __builtin_bit_cast(_Float16, Bits);
	};
	MakeInputs<_Float16>({FromBits(0), FromBits(0x8000), FromBits(0x3C00), FromBits(0x3C01), FromBits(0x7BFF),
							 FromBits(0xFBFF), FromBits(0x7C00), FromBits(0xFC00), FromBits(0x7E00), FromBits(0x0001),
							 FromBits(0x83FF), FromBits(0x0400), FromBits(0x3555), FromBits(0x1400)},
		A, B);
	const std::vector<std::string> Expressions = {"A + B", "A - B", "A * B", "A / B", "-A", "abs(A)", "half(A < B)",
		"half(A == B)", "half(A != B)", "sqrt(A)", "floor(A)", "min(A, B)", "half(float(A) * 1.001f)", "half(int(A))",
		"half(int16_t(A))", "A * B + A", "half(double(A) * 1.001L)"};
	// An operation of floats inside is one of doubles in --precision double: that one is left to floats.
	FEverywhere Everywhere(MakeShader("half", "half", Expressions), false);
	Everywhere.Inputs = {{"InA", ToWords(A)}, {"InB", ToWords(B)}};
	Everywhere.NumOutputWords = NumThreads * Expressions.size() / 2;
	ExpectAll<_Float16>(Everywhere.Run(), Expressions.size(),
		[&](size_t i) -> std::vector<_Float16>
		{
			const _Float16 X = A[i];
			const _Float16 Y = B[i];
			const float Whole = X != X ? 0.0f : std::trunc(std::min(std::max(float(X), -2147483648.0f), 2147483520.0f));
			const int64_t Int = X != X ? 0 : X >= 1e5 ? 2147483647 : X <= -1e5 ? -2147483648LL : int64_t(float(X));
			const float Short = float(int16_t(Int)); // by way of int
			const volatile _Float16 Product = X * Y; // rounded before it is added
			return {_Float16(X + Y), _Float16(X - Y), Product, _Float16(X / Y), _Float16(-X),
				_Float16(std::fabs(float(X))), _Float16(X < Y), _Float16(X == Y), _Float16(X != Y),
				_Float16(std::sqrt(float(X))), _Float16(std::floor(float(X))),
				Y != Y  ? X
				: X < Y ? X
						: Y,
				_Float16(float(X) * 1.001f), _Float16(Whole + 0.0f), _Float16(Short + 0.0f), _Float16(Product + X),
				_Float16(double(X) * 1.001)};
		});
}

TEST(ShaderWideTypes, ArithmeticOfHalvesDoesNotKnowThePrecisionOfFloats)
{
	std::vector<_Float16> A, B;
	MakeInputs<_Float16>({_Float16(0.1f), _Float16(3.0f), _Float16(1e-5f), _Float16(60000.0f)}, A, B);
	const std::vector<std::string> Expressions = {"A + B", "A - B", "A * B", "A / B", "sqrt(abs(A))", "A * B + A"};
	FEverywhere Everywhere(MakeShader("float16_t", "float16_t", Expressions));
	Everywhere.Inputs = {{"InA", ToWords(A)}, {"InB", ToWords(B)}};
	Everywhere.NumOutputWords = NumThreads * Expressions.size() / 2;
	Everywhere.Run();
}

TEST(ShaderWideTypes, StructsLieInStructuredBuffersAsInCpp)
{
	struct FMixed
	{
		_Float16 Half[3];
		double Double;
		int16_t Short;
		float Float;
		uint64_t Long[2];
		uint16_t Last;
	};
	const std::string Text = R"(
struct FMixed
{
	float16_t3 Half;
	double Double;
	int16_t Short;
	float Float;
	vector<uint64_t, 2> Long;
	uint16_t Last;
};
StructuredBuffer<FMixed> In;
RWStructuredBuffer<FMixed> Out;
[numthreads(8, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	FMixed M = In[Id.x];
	M.Half = M.Half.zxy + float16_t(1);
	M.Double *= 2;
	M.Short -= M.Last;
	M.Float += float(M.Half.x);
	M.Long = M.Long.yx + 0x123456789ull;
	M.Last = uint16_t(M.Long.x);
	Out[Id.x] = M;
}
)";
	std::vector<FMixed> In(NumThreads);
	std::vector<FMixed> Expected(NumThreads);
	std::memset(static_cast<void*>(In.data()), 0, In.size() * sizeof(FMixed));
	for (int32_t i = 0; i < NumThreads; ++i)
	{
		FMixed& M = In[size_t(i)];
		M.Half[0] = _Float16(i);
		M.Half[1] = _Float16(0.1f);
		M.Half[2] = _Float16(i * 100);
		M.Double = i * 0.1;
		M.Short = int16_t(-i);
		M.Float = float(i) * 0.3f;
		M.Long[0] = uint64_t(i) << 40;
		M.Long[1] = ~uint64_t(i);
		M.Last = uint16_t(i * 500);
		FMixed& E = Expected[size_t(i)];
		E = M;
		const _Float16 One = _Float16(1);
		E.Half[0] = M.Half[2] + One;
		E.Half[1] = M.Half[0] + One;
		E.Half[2] = M.Half[1] + One;
		E.Double = M.Double * 2;
		E.Short = int16_t(M.Short - M.Last);
		E.Float = M.Float + float(E.Half[0]);
		E.Long[0] = M.Long[1] + 0x123456789ull;
		E.Long[1] = M.Long[0] + 0x123456789ull;
		E.Last = uint16_t(E.Long[0]);
	}
	FEverywhere Everywhere(Text, false);
	Everywhere.Inputs["In"] = ToWords(In);
	Everywhere.NumOutputWords = Everywhere.Inputs["In"].size();
	const std::vector<FMixed> Made = FromWords<FMixed>(Everywhere.Run());
	for (size_t i = 0; i < Made.size(); ++i)
	{
		EXPECT_EQ(0, std::memcmp(Made[i].Half, Expected[i].Half, sizeof(Made[i].Half))) << i;
		EXPECT_EQ(Expected[i].Double, Made[i].Double) << i;
		EXPECT_EQ(Expected[i].Short, Made[i].Short) << i;
		EXPECT_EQ(Expected[i].Float, Made[i].Float) << i;
		EXPECT_EQ(Expected[i].Long[0], Made[i].Long[0]) << i;
		EXPECT_EQ(Expected[i].Long[1], Made[i].Long[1]) << i;
		EXPECT_EQ(Expected[i].Last, Made[i].Last) << i;
	}
}

TEST(ShaderWideTypes, DoublesAreMadeOfTwoWordsAndCutIntoThem)
{
	const std::string Text = R"(
StructuredBuffer<double2> In;
RWStructuredBuffer<uint> Out;
[numthreads(8, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	uint Low, High;
	asuint(In[Id.x].x, Low, High);
	Out[Id.x * 4] = Low;
	Out[Id.x * 4 + 1] = High;
	const double Again = asdouble(High, Low) == 0 ? 1 : asdouble(Low, High);
	uint2 Lows, Highs;
	asuint(double2(Again, In[Id.x].y), Lows, Highs);
	Out[Id.x * 4 + 2] = Lows.x ^ Highs.y;
	Out[Id.x * 4 + 3] = Lows.y ^ Highs.x;
}
)";
	std::vector<double> In;
	for (int32_t i = 0; i < 2 * NumThreads; ++i)
	{
		In.push_back(std::sin(double(i)) * std::pow(10.0, i % 30));
	}
	FEverywhere Everywhere(Text, false);
	Everywhere.Inputs["In"] = ToWords(In);
	Everywhere.NumOutputWords = 4 * NumThreads;
	const std::vector<uint32_t> Out = Everywhere.Run();
	const std::vector<uint32_t>& Words = Everywhere.Inputs["In"];
	for (size_t i = 1; i < size_t(NumThreads); ++i)
	{
		const uint32_t* const W = &Words[4 * i];
		EXPECT_EQ(W[0], Out[4 * i]);
		EXPECT_EQ(W[1], Out[4 * i + 1]);
		EXPECT_EQ(W[0] ^ W[3], Out[4 * i + 2]);
		EXPECT_EQ(W[2] ^ W[1], Out[4 * i + 3]);
	}
}

TEST(ShaderWideTypes, GroupsAndWavesShareThem)
{
	const std::string Text = R"(
RWStructuredBuffer<int64_t> Out;
groupshared int64_t Longs[64];
groupshared float16_t Halves[64];
groupshared double Doubles[64];
[numthreads(64, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID, uint Index : SV_GroupIndex)
{
	Longs[Index] = int64_t(Id.x) << 33;
	Halves[Index] = float16_t(Index) / float16_t(3);
	Doubles[Index] = double(Id.x) / 3;
	GroupMemoryBarrierWithGroupSync();
	const uint Other = Index * 7 % 64;
	const int64_t Sum = WaveActiveSum(Longs[Other] + int64_t(Other));
	const int64_t Half = int64_t(asuint16(Halves[Other])) << 40;
	Out[Id.x] = Sum ^ Half ^ int64_t(Doubles[63 - Index] * 1e12L) ^ WavePrefixSum(int64_t(Id.x) << 40);
}
)";
	FEverywhere Everywhere(Text, false);
	Everywhere.NumOutputWords = 2 * NumThreads;
	const std::vector<int64_t> Out = FromWords<int64_t>(Everywhere.Run());
	for (int32_t i = 0; i < NumThreads; ++i)
	{
		const int32_t Group = i / 64;
		int64_t Sum = 0;
		int64_t Prefix = 0;
		for (int32_t Lane = i / 32 * 32; Lane < i / 32 * 32 + 32; ++Lane)
		{
			const int32_t Other = Lane % 64 * 7 % 64;
			Sum += (int64_t(Group * 64 + Other) << 33) + Other;
			Prefix += Lane < i ? int64_t(Lane) << 40 : 0;
		}
		const _Float16 Half = _Float16(i % 64 * 7 % 64) / _Float16(3);
		const double Double = double(Group * 64 + 63 - i % 64) / 3;
		EXPECT_EQ(
			Sum ^ int64_t(__builtin_bit_cast(uint16_t, Half)) << 40 ^ int64_t(Double * 1e12) ^ Prefix, Out[size_t(i)])
			<< i;
	}
}

TEST(ShaderWideTypes, HalfIsFloatWhereNobodyAsksForSixteenBits)
{
	const std::string Text = MakeShader("half", "min16float", {"A + B * half(0.1)"});
	FEverywhere Everywhere(Text, false);
	std::vector<float> A, B;
	for (int32_t i = 0; i < NumThreads; ++i)
	{
		A.push_back(float(i) * 1.7f);
		B.push_back(float(i) * 0.3f);
	}
	Everywhere.Inputs = {{"InA", ToWords(A)}, {"InB", ToWords(B)}};
	Everywhere.NumOutputWords = NumThreads;
	ExpectAll<float>(Everywhere.Run(false), 1, [&](size_t i) { return std::vector<float>{A[i] + B[i] * 0.1f}; });
}

TEST(ShaderWideTypes, WhatTheyCannotDoIsAMessage)
{
	const std::string Switch =
		"RWStructuredBuffer<int64_t> Out;\n[numthreads(8, 1, 1)]\nvoid MainCS(uint3 Id : "
		"SV_DispatchThreadID)\n{\n\tswitch (Out[Id.x]) { case 1: Out[Id.x] = 2; break; default: break; }\n}\n";
	FShaderHarness Harness(Switch, "MainCS", EShaderStage::Compute);
	Harness.Buffers["Out"].resize(16);
	EXPECT_THAT(ErrorOf([&] { Harness.Run(0, 8, 1); }),
		HasSubstr("/Test/Shader.usf:5:13: error: X3000: switch takes an int or a uint, not 'int64_t'; cast it"));
}

} // namespace Drydock::Test
