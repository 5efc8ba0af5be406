// Functions of HLSL on constants: worked values, and the C library's.
#include "ConstantsFixture.h"

#include "HlslIntrinsics.h"

#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <utility>

namespace Drydock::Hlsl::Tests
{
namespace
{

TEST_F(HlslConstants, FunctionsOfMatricesAndVectors)
{
	const FType* const Float = Types.Scalar(EScalar::Float);
	const auto Vector = [this](uint32_t Count)
	{
		return Types.Vector(EScalar::Float, Count);
	};
	FValue* const M = Matrix(2, 3, {1, 2, 3, 4, 5, 6});
	using FFloats = std::vector<float>;
	EXPECT_EQ(FoldFloats(Call("mul", Vector(2), {M, Floats({1, 10, 100})})), (FFloats{321, 654}));
	EXPECT_EQ(FoldFloats(Call("mul", Vector(3), {Floats({1, 10}), M})), (FFloats{41, 52, 63}));
	EXPECT_EQ(FoldFloats(Call("mul", Types.Matrix(EScalar::Float, 2, 2), {M, Matrix(3, 2, {1, 0, 0, 1, 1, 1})})),
		(FFloats{4, 5, 10, 11}));
	EXPECT_EQ(FoldFloats(Call("mul", M->Type, {Floats({2}), M})), (FFloats{2, 4, 6, 8, 10, 12}));
	EXPECT_EQ(FoldFloats(Call("mul", Float, {Floats({1, 2}), Floats({3, 4})})), FFloats{11});
	EXPECT_EQ(FoldFloats(Call("transpose", Types.Matrix(EScalar::Float, 3, 2), {M})), (FFloats{1, 4, 2, 5, 3, 6}));
	EXPECT_EQ(FoldFloat(Call("determinant", Float, {Matrix(2, 2, {1, 2, 3, 4})})), -2);
	EXPECT_EQ(FoldFloat(Call("determinant", Float, {Matrix(3, 3, {2, 0, 1, 1, 3, 2, 1, 1, 1})})), 0);
	EXPECT_EQ(
		FoldFloat(Call("determinant", Float, {Matrix(4, 4, {2, 0, 0, 1, 0, 3, 0, 0, 0, 0, 4, 0, 5, 0, 0, 6})})), 84);
	EXPECT_EQ(FoldFloat(Call("dot", Float, {Floats({1, 2, 3}), Floats({4, 5, 6})})), 32);
	EXPECT_EQ(FoldFloat(Call("length", Float, {Floats({3, 4})})), 5);
	EXPECT_EQ(FoldFloat(Call("length", Float, {Floats({-3})})), 3);
	EXPECT_EQ(FoldFloat(Call("distance", Float, {Floats({1, 1}), Floats({4, 5})})), 5);
	EXPECT_EQ(FoldFloats(Call("normalize", Vector(2), {Floats({0, -8})})), (FFloats{0, -1}));
	EXPECT_EQ(FoldFloats(Call("cross", Vector(3), {Floats({1, 0, 0}), Floats({0, 1, 0})})), (FFloats{0, 0, 1}));
	EXPECT_EQ(FoldFloats(Call("reflect", Vector(2), {Floats({1, -1}), Floats({0, 1})})), (FFloats{1, 1}));
	EXPECT_EQ(
		FoldFloats(Call("refract", Vector(2), {Floats({0, -1}), Floats({0, 1}), Floats({0.5f})})), (FFloats{0, -1}));
	EXPECT_EQ(
		FoldFloats(Call("refract", Vector(2), {Floats({0.8f, -0.6f}), Floats({0, 1}), Floats({2})})), (FFloats{0, 0}));
	EXPECT_EQ(FoldFloats(Call("faceforward", Vector(2), {Floats({1, 2}), Floats({0, 1}), Floats({0, 1})})),
		(FFloats{-1, -2}));
	EXPECT_EQ(FoldFloats(Call("dst", Vector(4), {Floats({1, 2, 3, 4}), Floats({5, 6, 7, 8})})), (FFloats{1, 12, 3, 8}));
}

TEST_F(HlslConstants, FunctionsOfBits)
{
	const FType* const U = Types.Scalar(EScalar::Uint);
	const auto OfUint = [this, U](std::string_view Name, uint32_t Value)
	{
		return MustFold(Call(Name, U, {Uint(Value)})).at(0);
	};
	EXPECT_EQ(OfUint("countbits", 0xF0F0), 8u);
	EXPECT_EQ(OfUint("reversebits", 1), 0x80000000u);
	EXPECT_EQ(OfUint("firstbithigh", 0x00010000), 16u);
	EXPECT_EQ(OfUint("firstbithigh", 0), 0xFFFFFFFFu);
	EXPECT_EQ(OfUint("firstbitlow", 0x00010100), 8u);
	EXPECT_EQ(OfUint("firstbitlow", 0), 0xFFFFFFFFu);
	EXPECT_EQ(MustFold(Call("firstbithigh", U, {Int(-2)})).at(0), 0u);
	EXPECT_EQ(MustFold(Call("firstbithigh", U, {Int(-1)})).at(0), 0xFFFFFFFFu);
	EXPECT_EQ(MustFold(Call("firstbitlow", U, {Constant(EScalar::Ulong, {0})})).at(0), 0xFFFFFFFFu);
	EXPECT_EQ(MustFold(Call("countbits", U, {Constant(EScalar::Ulong, {UINT64_MAX})})).at(0), 64u);
	EXPECT_EQ(MustFold(Call("asuint", U, {Floats({1})})).at(0), 0x3F800000u);
	EXPECT_EQ(FoldFloat(Call("asfloat", Types.Scalar(EScalar::Float), {Uint(0x40000000)})), 2);
	EXPECT_EQ(MustFold(Call("f32tof16", U, {Floats({1})})).at(0), 0x3C00u);
	EXPECT_EQ(FoldFloat(Call("f16tof32", Types.Scalar(EScalar::Float), {Uint(0xABCD3C00)})), 1);
	EXPECT_EQ(
		MustFold(Call("asdouble", Types.Scalar(EScalar::Double), {Uint(0), Uint(0x3FF00000)})).at(0), BitsOfDouble(1));
	EXPECT_EQ(MustFold(Call("mad", Types.Scalar(EScalar::Int), {Int(3), Int(-4), Int(5)})).at(0), uint32_t(-7));
	EXPECT_EQ(MustFold(Call("clamp", Types.Scalar(EScalar::Int), {Int(-9), Int(-4), Int(5)})).at(0), uint32_t(-4));
	EXPECT_EQ(MustFold(Call("min", U, {Uint(0xFFFFFFFF), Uint(1)})).at(0), 1u);
	EXPECT_EQ(MustFold(Call("max", Types.Scalar(EScalar::Int), {Int(-1), Int(1)})).at(0), 1u);
}

TEST_F(HlslConstants, FunctionsOfRealsAgainstTheLibrary)
{
	using FUnary = std::function<double(double)>;
	const std::vector<std::pair<std::string_view, FUnary>> Unary = {{"abs",
																		[](double X)
																		{
																			return std::fabs(X);
																		}},
		{"floor",
			[](double X)
			{
				return std::floor(X);
			}},
		{"ceil",
			[](double X)
			{
				return std::ceil(X);
			}},
		{"trunc",
			[](double X)
			{
				return std::trunc(X);
			}},
		{"round",
			[](double X)
			{
				return std::nearbyint(X);
			}},
		{"frac",
			[](double X)
			{
				return X - std::floor(X);
			}},
		{"sqrt",
			[](double X)
			{
				return std::sqrt(X);
			}},
		{"rsqrt",
			[](double X)
			{
				return 1 / std::sqrt(X);
			}},
		{"rcp",
			[](double X)
			{
				return 1 / X;
			}},
		{"exp",
			[](double X)
			{
				return std::exp(X);
			}},
		{"exp2",
			[](double X)
			{
				return std::exp2(X);
			}},
		{"log",
			[](double X)
			{
				return std::log(X);
			}},
		{"log2",
			[](double X)
			{
				return std::log2(X);
			}},
		{"log10",
			[](double X)
			{
				return std::log10(X);
			}},
		{"sin",
			[](double X)
			{
				return std::sin(X);
			}},
		{"cos",
			[](double X)
			{
				return std::cos(X);
			}},
		{"tan",
			[](double X)
			{
				return std::tan(X);
			}},
		{"asin",
			[](double X)
			{
				return std::asin(X);
			}},
		{"acos",
			[](double X)
			{
				return std::acos(X);
			}},
		{"atan",
			[](double X)
			{
				return std::atan(X);
			}},
		{"sinh",
			[](double X)
			{
				return std::sinh(X);
			}},
		{"cosh",
			[](double X)
			{
				return std::cosh(X);
			}},
		{"tanh",
			[](double X)
			{
				return std::tanh(X);
			}},
		{"degrees",
			[](double X)
			{
				return X * 180 / M_PI;
			}},
		{"radians",
			[](double X)
			{
				return X * M_PI / 180;
			}},
		{"saturate", [](double X)
			{
				return std::fmin(std::fmax(X, 0), 1);
			}}};
	std::mt19937 Random(38);
	std::uniform_real_distribution<float> Any(-6, 6);
	const FType* const Double = Types.Scalar(EScalar::Double);
	for (int i = 0; i < 100; ++i)
	{
		const float X = i == 0 ? 2.5f : i == 1 ? -0.5f : Any(Random);
		const float Y = Any(Random);
		const float Z = Any(Random);
		for (const auto& [Name, Function] : Unary)
		{
			const double Exact = Function(X);
			const float Made = CallFloat(Name, {X});
			EXPECT_EQ(std::isnan(Made), std::isnan(Exact)) << Name << "(" << X << ")";
			EXPECT_TRUE(std::isnan(Exact) || std::fabs(Made - Exact) <= 2e-6 * std::fmax(1, std::fabs(Exact)))
				<< Name << "(" << X << ") is " << Exact << ", not " << Made;
			const double Wide = std::bit_cast<double>(
				MustFold(Call(Name, Double, {Constant(EScalar::Double, {BitsOfDouble(X)})})).at(0));
			EXPECT_TRUE(std::isnan(Exact) || std::fabs(Wide - Exact) <= 1e-12 * std::fmax(1, std::fabs(Exact)))
				<< Name << "(" << X << ") is " << Exact << ", not " << Wide;
		}
		EXPECT_NEAR(CallFloat("pow", {std::fabs(X), Y}) / std::pow(std::fabs(X), Y), 1, 1e-5);
		EXPECT_NEAR(CallFloat("atan2", {X, Y}), std::atan2(X, Y), 1e-6);
		EXPECT_EQ(CallFloat("lerp", {X, Y, Z}), X + Z * (Y - X));
		EXPECT_EQ(CallFloat("mad", {X, Y, Z}), X * Y + Z);
		EXPECT_EQ(CallFloat("step", {X, Y}), Y >= X ? 1 : 0);
		EXPECT_EQ(CallFloat("min", {X, Y}), std::min(X, Y));
		EXPECT_EQ(CallFloat("max", {X, Y}), std::max(X, Y));
		EXPECT_EQ(CallFloat("clamp", {X, -1, 2}), std::min(std::max(X, -1.0f), 2.0f));
		EXPECT_NEAR(CallFloat("ldexp", {X, 3}), X * 8, 1e-5);
		const float T = std::min(std::max((X - 1) / 2, 0.0f), 1.0f);
		EXPECT_NEAR(CallFloat("smoothstep", {1, 3, X}), T * T * (3 - 2 * T), 1e-6);
		EXPECT_EQ(MustFold(Call("sign", Types.Scalar(EScalar::Int), {Floats({X})})).at(0), uint32_t((X > 0) - (X < 0)));
	}
	EXPECT_EQ(CallFloat("round", {2.5f}), 2);
	EXPECT_EQ(CallFloat("min", {GConstantsNan, 1}), 1);
	const FType* const Bool = Types.Scalar(EScalar::Bool);
	EXPECT_EQ(MustFold(Call("isnan", Bool, {Floats({GConstantsNan})})).at(0), 1u);
	EXPECT_EQ(MustFold(Call("isinf", Bool, {Floats({-GConstantsInf})})).at(0), 1u);
	EXPECT_EQ(MustFold(Call("isfinite", Bool, {Floats({-GConstantsInf})})).at(0), 0u);
	EXPECT_EQ(MustFold(Call("isfinite", Bool, {Floats({1})})).at(0), 1u);
	// Half is computed as float and rounded once.
	FValue* const Third = Constant(EScalar::Half, {0x3555});
	EXPECT_EQ(MustFold(Binary("*", Third, Constant(EScalar::Half, {0x4200}))).at(0), 0x3C00u);
}

TEST_F(HlslConstants, EachPureFunctionOfReferenceIsFoldedOrStays)
{
	// Whatever it is given, nothing breaks: results have the size of their type, or there is none.
	for (const std::string& Name : ListIntrinsics())
	{
		for (const FType* const Type : {Types.Scalar(EScalar::Float), Types.Vector(EScalar::Float, 3),
				 Types.Matrix(EScalar::Float, 2, 2), Types.Scalar(EScalar::Int), Types.Vector(EScalar::Uint, 4),
				 Types.Scalar(EScalar::Half), Types.Scalar(EScalar::Ulong)})
		{
			for (size_t Count = 1; Count <= 4; ++Count)
			{
				FValue* const Argument = Make(EValue::Zero, Type);
				FValue* const Value = Call(Name, Type, std::vector<FValue*>(Count, Argument));
				const std::optional<FConstant> Result = Fold(Types, *Value);
				EXPECT_TRUE(!Result || Result->size() == CountScalars(Type)) << Name;
				EXPECT_TRUE(!Result || IsPure(Name)) << Name;
			}
		}
	}
}

} // namespace
} // namespace Drydock::Hlsl::Tests
