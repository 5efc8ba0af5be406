// Arithmetic of constants: worked values, of conversions and operators and of parts of composites; how numbers are
// read.
#include "ConstantsFixture.h"

#include <cmath>
#include <optional>

namespace Drydock::Hlsl::Tests
{
namespace
{

TEST_F(HlslConstants, WhatTheReferenceListHadWrong)
{
	EXPECT_EQ(CallFloat("fmod", {-7.5f, 2}), -1.5f);
	EXPECT_EQ(CallFloat("fmod", {-1, 3}), -1.0f);
	EXPECT_EQ(FoldFloat(Binary("%", Floats({-7.5f}), Floats({2}))), -1.5f);
	EXPECT_EQ(FoldFloat(Binary("%", Floats({6.5f}), Floats({6}))), 0.5f);
	EXPECT_EQ(FoldFloat(Binary("%", Floats({7.5f}), Floats({2}))), 1.5f);
	EXPECT_NEAR(FoldFloat(Binary("%", Floats({7}), Floats({6.2831853f}))), 0.7168147f, 1e-6f);
	EXPECT_EQ(MustFold(Binary(">", Floats({1, 5}), Floats({2, 3}))), (FConstant{0, 1}));
	EXPECT_EQ(MustFold(Binary("<", Floats({1, 5}), Floats({2, 3}))), (FConstant{1, 0}));
	const auto AnyAll = [this](std::string_view Name, FValue* Value)
	{
		return MustFold(Call(Name, Types.Scalar(EScalar::Bool), {Value})).at(0);
	};
	EXPECT_EQ(AnyAll("any", Binary(">", Floats({1, 5}), Floats({2, 3}))), 1u);
	EXPECT_EQ(AnyAll("all", Binary("<", Floats({1, 5}), Floats({2, 3}))), 0u);
	EXPECT_EQ(AnyAll("any", Binary(">", Floats({4, 1}), Floats({5, 0.5f}))), 1u);
	EXPECT_EQ(AnyAll("all", Binary(">", Floats({1, 2, 3}), Floats({-4.5f, 0.5f, 6}))), 0u);
	FValue* const Condition = Binary(">", Floats({1, 2, 3}), Floats({2, 2, 2}));
	EXPECT_EQ(FoldFloats(Make(
				  EValue::Select, Types.Vector(EScalar::Float, 3), {Condition, Floats({1, 2, 3}), Floats({4, 5, 6})})),
		(std::vector<float>{4, 5, 3}));
	EXPECT_EQ(FoldFloats(Call("lit", Types.Vector(EScalar::Float, 4), {Floats({1.2f}), Floats({2}), Floats({3})})),
		(std::vector<float>{1, 1.2f, 8, 1}));
	FValue* const Tiny = Constant(EScalar::Double, {BitsOfDouble(5e-324)});
	EXPECT_EQ(MustFold(Binary("*", Tiny, Constant(EScalar::Double, {BitsOfDouble(3)}))).at(0), BitsOfDouble(1.5e-323));
	FValue* const Single = Matrix(1, 1, {3});
	EXPECT_EQ(FoldFloat(Call("determinant", Types.Scalar(EScalar::Float), {Single})), 3);
	const FType* const Uint1 = Types.Scalar(EScalar::Uint);
	EXPECT_EQ(MustFold(Call("abs", Uint1, {Uint(0xFFFFFFFF)})).at(0), 0xFFFFFFFFu);
	EXPECT_EQ(MustFold(Call("sign", Types.Scalar(EScalar::Int), {Uint(0xFFFFFFFF)})).at(0), 1u);
	EXPECT_EQ(MustFold(Call("dot", Types.Scalar(EScalar::Int),
						   {Constant(EScalar::Int, {100, 4}), Constant(EScalar::Int, {25, 3})}))
				  .at(0),
		2512u);
}

TEST_F(HlslConstants, DenormalsOfFloatAreZero)
{
	const float Tiny = std::bit_cast<float>(0x00000001u);
	EXPECT_EQ(MustFold(Binary("+", Floats({Tiny}), Floats({0}))).at(0), 0u);
	EXPECT_EQ(MustFold(Binary("*", Floats({1e-30f}), Floats({1e-10f}))).at(0), 0u);
	EXPECT_EQ(MustFold(Binary("==", Floats({Tiny}), Floats({0}))).at(0), 1u);
	EXPECT_EQ(CallFloat("sqrt", {Tiny}), 0.0f);
	EXPECT_EQ(MustFold(Floats({Tiny})).at(0), 1u) << "a constant keeps its bits";
	EXPECT_EQ(ConvertConstant(Types, EScalar::LiteralFloat, EScalar::Float, BitsOfDouble(1e-45)), 1u);
	EXPECT_EQ(ConvertConstant(Types, EScalar::Double, EScalar::Float, BitsOfDouble(1e-45)), 0u);
	EXPECT_EQ(ConvertConstant(Types, EScalar::Float, EScalar::Double, 1), 0u);
	EXPECT_EQ(ConvertConstant(Types, EScalar::Float, EScalar::Bool, 1), 0u);
}

TEST_F(HlslConstants, ConversionsAsTheInterpreterHasThem)
{
	const auto Convert = [this](EScalar From, EScalar To, uint64_t Word)
	{
		return ConvertConstant(Types, From, To, Word);
	};
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Int, BitsOfFloat(-1.9f)), 0xFFFFFFFFu);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Int, BitsOfFloat(3e9f)), 0x7FFFFFFFu);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Int, BitsOfFloat(-3e9f)), 0x80000000u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Int, BitsOfFloat(GConstantsNan)), 0u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Uint, BitsOfFloat(-1)), 0u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Uint, BitsOfFloat(3e9f)), 3000000000u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Uint, BitsOfFloat(1e20f)), 0xFFFFFFFFu);
	EXPECT_EQ(Convert(EScalar::Int, EScalar::Float, 0xFFFFFFFFu), BitsOfFloat(-1));
	EXPECT_EQ(Convert(EScalar::Uint, EScalar::Float, 0xFFFFFFFFu), BitsOfFloat(4294967296.0f));
	EXPECT_EQ(Convert(EScalar::Int, EScalar::Long, 0xFFFFFFFFu), UINT64_MAX);
	EXPECT_EQ(Convert(EScalar::Uint, EScalar::Long, 0xFFFFFFFFu), 0xFFFFFFFFu);
	EXPECT_EQ(Convert(EScalar::LiteralInt, EScalar::Int, 0x1FFFFFFFFu), 0xFFFFFFFFu);
	EXPECT_EQ(Convert(EScalar::LiteralInt, EScalar::Float, uint64_t(-3)), BitsOfFloat(-3));
	EXPECT_EQ(Convert(EScalar::LiteralInt, EScalar::Double, 0x1FFFFFFFFu), BitsOfDouble(8589934591.0));
	EXPECT_EQ(Convert(EScalar::Bool, EScalar::Float, 1), BitsOfFloat(1));
	EXPECT_EQ(Convert(EScalar::Bool, EScalar::Long, 1), 1u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Bool, BitsOfFloat(GConstantsNan)), 1u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Bool, BitsOfFloat(-0.0f)), 0u);
	EXPECT_EQ(Convert(EScalar::LiteralFloat, EScalar::Float, BitsOfDouble(0.1)), BitsOfFloat(0.1f));
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Half, BitsOfFloat(1.0f / 3)), 0x3555u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Half, BitsOfFloat(65520)), 0x7C00u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Half, BitsOfFloat(0x1p-24f)), 1u);
	EXPECT_EQ(Convert(EScalar::Half, EScalar::Float, 1), BitsOfFloat(0x1p-24f));
	EXPECT_EQ(Convert(EScalar::Int, EScalar::Short, 0x18000u), 0x8000u);
	EXPECT_EQ(Convert(EScalar::Short, EScalar::Int, 0x8000u), 0xFFFF8000u);
	EXPECT_EQ(Convert(EScalar::Ushort, EScalar::Int, 0x8000u), 0x8000u);
	EXPECT_EQ(Convert(EScalar::Float, EScalar::Short, BitsOfFloat(70000)), 70000u & 0xFFFF) << "by way of int";
	EXPECT_EQ(Convert(EScalar::Double, EScalar::Ulong, BitsOfDouble(1e19)), 10000000000000000000u);
	EXPECT_EQ(Convert(EScalar::Double, EScalar::Long, BitsOfDouble(1e19)), uint64_t(INT64_MAX));
}

TEST_F(HlslConstants, IntegersWrapAndDivisionByZeroIsNone)
{
	EXPECT_EQ(MustFold(Binary("+", Int(INT32_MAX), Int(1))).at(0), 0x80000000u);
	EXPECT_EQ(MustFold(Binary("/", Int(INT32_MIN), Int(-1))).at(0), 0x80000000u);
	EXPECT_EQ(MustFold(Binary("%", Int(INT32_MIN), Int(-1))).at(0), 0u);
	EXPECT_EQ(MustFold(Binary("%", Int(-7), Int(3))).at(0), uint32_t(-1));
	EXPECT_EQ(MustFold(Binary("/", Uint(0xFFFFFFFF), Uint(2))).at(0), 0x7FFFFFFFu);
	EXPECT_EQ(MustFold(Binary("<<", Int(1), Int(33))).at(0), 2u);
	EXPECT_EQ(MustFold(Binary(">>", Int(-8), Int(1))).at(0), uint32_t(-4));
	EXPECT_EQ(MustFold(Binary(">>", Uint(0x80000000), Uint(31))).at(0), 1u);
	EXPECT_EQ(MustFold(Binary("<<", Constant(EScalar::LiteralInt, {1}), Constant(EScalar::LiteralInt, {40}))).at(0),
		uint64_t(1) << 40);
	EXPECT_EQ(MustFold(Binary("<<", Constant(EScalar::Short, {1}), Constant(EScalar::Short, {17}))).at(0), 2u);
	EXPECT_EQ(
		MustFold(Binary("*", Constant(EScalar::Ushort, {0xFFFF}), Constant(EScalar::Ushort, {0xFFFF}))).at(0), 1u);
	EXPECT_EQ(FoldFloat(Binary("/", Floats({1}), Floats({0}))), GConstantsInf);
	for (const std::string_view Operator : {"/", "%"})
	{
		for (const EScalar Scalar : {EScalar::Int, EScalar::Uint, EScalar::Long, EScalar::LiteralInt, EScalar::Short})
		{
			std::string Error;
			const FValue* const Value = Binary(Operator, Constant(Scalar, {1}), Constant(Scalar, {0}));
			EXPECT_FALSE(Fold(Types, *Value, &Error));
			EXPECT_NE(Error.find("by zero"), std::string::npos);
			EXPECT_FALSE(Fold(Types, *Value));
		}
	}
}

TEST_F(HlslConstants, OnlyWhatIsTakenIsComputed)
{
	const FType* const Bool = Types.Scalar(EScalar::Bool);
	FValue* const True = Constant(EScalar::Bool, {1});
	FValue* const False = Constant(EScalar::Bool, {0});
	FValue* const Bad = Binary("==", Binary("/", Int(1), Int(0)), Int(0));
	FValue* const Unknown = Make(EValue::Variable, Bool);
	Unknown->Variable = Program.Make<FVariable>();
	std::string Error;
	EXPECT_EQ(Fold(Types, *Make(EValue::And, Bool, {False, Bad}), &Error), FConstant{0});
	EXPECT_EQ(Fold(Types, *Make(EValue::Or, Bool, {True, Bad}), &Error), FConstant{1});
	EXPECT_EQ(Fold(Types, *Make(EValue::Choose, Bool, {True, False, Bad}), &Error), FConstant{0});
	EXPECT_EQ(Error, "");
	EXPECT_EQ(Fold(Types, *Make(EValue::And, Bool, {True, False})), FConstant{0});
	EXPECT_EQ(Fold(Types, *Make(EValue::And, Bool, {False, Unknown})), FConstant{0});
	EXPECT_EQ(Fold(Types, *Make(EValue::And, Bool, {True, Unknown})), std::nullopt);
	EXPECT_EQ(Fold(Types, *Make(EValue::Or, Bool, {Unknown, True})), std::nullopt);
	EXPECT_EQ(Fold(Types, *Make(EValue::Call, Bool, {True})), std::nullopt);
	EXPECT_EQ(Fold(Types, *Call("WaveActiveSum", Types.Scalar(EScalar::Int), {Int(1)})), std::nullopt);
	EXPECT_EQ(Fold(Types, *Call("ddx", Types.Scalar(EScalar::Float), {Floats({1})})), std::nullopt);
}

TEST_F(HlslConstants, PartsOfComposites)
{
	FStructType Struct;
	Struct.Name = "FPair";
	Struct.Members = {{"A", Types.Vector(EScalar::Float, 2), {}, "", 0},
		{"B", Types.Array(Types.Vector(EScalar::Int, 2), 3), {}, "", 0}};
	const FType* const Pair = Types.Struct(Struct);
	FValue* const Whole = Make(EValue::Variable, Pair);
	Whole->Variable = Program.Make<FVariable>();
	Whole->Variable->Constant = FConstant{BitsOfFloat(1), BitsOfFloat(2), 10, 11, 20, 21, 30, 31};
	FValue* const Array = Make(EValue::Member, Pair->Struct->Members[1].Type, {Whole});
	Array->Index = 1;
	const FType* const Int2 = Types.Vector(EScalar::Int, 2);
	EXPECT_EQ(MustFold(Make(EValue::Index, Int2, {Array, Uint(2)})), (FConstant{30, 31}));
	EXPECT_EQ(Fold(Types, *Make(EValue::Index, Int2, {Array, Int(3)})), std::nullopt);
	EXPECT_EQ(Fold(Types, *Make(EValue::Index, Int2, {Array, Int(-1)})), std::nullopt);
	FValue* const Swizzle =
		Make(EValue::Swizzle, Types.Vector(EScalar::Int, 3), {Make(EValue::Index, Int2, {Array, Int(1)})});
	Swizzle->Parts = {1, 0, 1};
	EXPECT_EQ(MustFold(Swizzle), (FConstant{21, 20, 21}));
	EXPECT_EQ(MustFold(Make(EValue::Index, Types.Scalar(EScalar::Int), {Swizzle, Int(1)})), FConstant{20});

	FValue* const M = Matrix(2, 3, {1, 2, 3, 4, 5, 6});
	EXPECT_EQ(
		FoldFloats(Make(EValue::Index, Types.Vector(EScalar::Float, 3), {M, Int(1)})), (std::vector<float>{4, 5, 6}));
	FValue* const Elements = Make(EValue::Elements, Types.Vector(EScalar::Float, 2), {M});
	Elements->Parts = {4 + 2, 1};
	EXPECT_EQ(FoldFloats(Elements), (std::vector<float>{6, 2}));
	EXPECT_EQ(
		FoldFloats(Make(EValue::Compose, Types.Vector(EScalar::Float, 4), {Floats({1, 2}), Floats({3}), Floats({4})})),
		(std::vector<float>{1, 2, 3, 4}));
	EXPECT_EQ(Fold(Types, *Make(EValue::Compose, Types.Vector(EScalar::Float, 4), {Floats({1, 2})})), std::nullopt);
	EXPECT_EQ(MustFold(Make(EValue::Zero, Pair)), FConstant(8, 0));
	EXPECT_EQ(MustFold(Make(EValue::Comma, Int2, {Floats({1}), Make(EValue::Index, Int2, {Array, Int(0)})})),
		(FConstant{10, 11}));
	EXPECT_EQ(Fold(Types, *Make(EValue::Zero, Types.Array(Pair, 1u << 30))), std::nullopt) << "memory is bounded";
}

TEST(HlslNumbers, AreReadWithTheirTypes)
{
	struct FExample
	{
		const char* Text;
		EScalar Scalar;
		uint64_t Word;
	};
	const FExample Examples[] = {{"0", EScalar::LiteralInt, 0}, {"7", EScalar::LiteralInt, 7},
		{"07", EScalar::LiteralInt, 7}, {"010", EScalar::LiteralInt, 8}, {"0x10u", EScalar::Uint, 16},
		{"0XfF", EScalar::LiteralInt, 255}, {"4294967295", EScalar::LiteralInt, 4294967295u},
		{"10ll", EScalar::Long, 10}, {"2L", EScalar::Int, 2}, {"2UL", EScalar::Uint, 2}, {"2ull", EScalar::Ulong, 2},
		{"0x123456789ull", EScalar::Ulong, 0x123456789}, {"18446744073709551615ULL", EScalar::Ulong, UINT64_MAX},
		{"0xFFFFFFFFFFFFFFFF", EScalar::LiteralInt, UINT64_MAX}, {"1.5f", EScalar::Float, BitsOfFloat(1.5f)},
		{"1.F", EScalar::Float, BitsOfFloat(1)}, {".5", EScalar::LiteralFloat, BitsOfDouble(0.5)},
		{"1e3L", EScalar::Double, BitsOfDouble(1000)}, {"1e-3", EScalar::LiteralFloat, BitsOfDouble(1e-3)},
		{"9223372036854775808", EScalar::Ulong, 1ull << 63}, {"0b101", EScalar::LiteralInt, 5},
		{"1.#INF", EScalar::Float, BitsOfFloat(GConstantsInf)}, {"0.1", EScalar::LiteralFloat, BitsOfDouble(0.1)},
		{"0.1f", EScalar::Float, BitsOfFloat(0.1f)}, {"08.5", EScalar::LiteralFloat, BitsOfDouble(8.5)},
		{"1.1h", EScalar::MinFloat, BitsOfFloat(1.1f)}, {"16777217.0f", EScalar::Float, BitsOfFloat(16777216)},
		{"1e39f", EScalar::Float, BitsOfFloat(GConstantsInf)}, {"1e-60f", EScalar::Float, 0},
		{"1e400", EScalar::LiteralFloat, BitsOfDouble(INFINITY)}, {"1e-400", EScalar::LiteralFloat, 0},
		{"1e-45f", EScalar::Float, 1}, {"1E+2", EScalar::LiteralFloat, BitsOfDouble(100)}};
	for (const FExample& Example : Examples)
	{
		std::string Error;
		const std::optional<FNumber> Number = ReadNumber(Example.Text, Error);
		ASSERT_TRUE(Number) << Example.Text << ": " << Error;
		EXPECT_EQ(Number->Scalar, Example.Scalar) << Example.Text;
		EXPECT_EQ(Number->Bits, Example.Word) << Example.Text;
	}
	std::string Error;
	EXPECT_EQ(ReadNumber("1.5h", Error, true)->Scalar, EScalar::Half);
	EXPECT_EQ(ReadNumber("1.5h", Error, true)->Bits, 0x3E00u);
	for (const char* const Text : {"", "0x", "1.5x", "1.2.3", "12abc", "08", "1e", "1e+", "99999999999999999999",
			 "4294967296u", "0x1FFFFFFFFu", "1f", "1uu", "1.5u", "0xG", "--1", "1lll", "."})
	{
		Error.clear();
		EXPECT_FALSE(ReadNumber(Text, Error)) << Text;
		EXPECT_NE(Error, "") << Text;
	}
}

} // namespace
} // namespace Drydock::Hlsl::Tests
