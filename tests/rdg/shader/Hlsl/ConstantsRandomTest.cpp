// Random expressions of constants against C++'s own arithmetic.
#include "ConstantsFixture.h"

#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace Drydock::Hlsl::Tests
{
namespace
{

/** A random expression with what C++ makes of it. */
class FRandomExpression
{
public:
	FRandomExpression(FTypes& InTypes, FProgram& InProgram, uint32_t Seed)
		: Types(InTypes)
		, Program(InProgram)
		, Random(Seed)
	{
	}

	struct FMade
	{
		FValue* Value = nullptr;
		std::optional<uint32_t> Word; // none: an integer was divided by zero
	};

	FMade Make(EScalar Scalar, int Depth)
	{
		if (Depth == 0)
		{
			return MakeLeaf(Scalar);
		}
		switch (Random() % 8)
		{
		case 0:
			return MakeConvert(Scalar, Depth);
		case 1:
			return MakeChoice(Scalar, Depth);
		default:
			return Scalar == EScalar::Bool ? MakeComparison(Depth) : MakeArithmetic(Scalar, Depth);
		}
	}

	EScalar Pick() { return std::vector{EScalar::Float, EScalar::Int, EScalar::Uint, EScalar::Bool}[Random() % 4]; }

private:
	static float F(uint32_t Word) { return std::bit_cast<float>(Word); }

	FValue* MakeValue(EValue Kind, EScalar Scalar, const std::vector<FValue*>& Operands, std::string_view Operator = "")
	{
		FValue* const Value = Program.Make<FValue>();
		Value->Kind = Kind;
		Value->Type = Types.Scalar(Scalar);
		Value->Operands = Operands;
		Value->Operator = Operator;
		return Value;
	}

	FMade MakeLeaf(EScalar Scalar)
	{
		static constexpr uint32_t Words[] = {0, 1, 2, 7, 31, 33, 0xFFFFFFFF, 0x80000000, 0x7FFFFFFF};
		static constexpr float Reals[] = {0, -0.0f, 1, -1, 0.5f, -7.5f, 2, 3e9f, -3e9f, 1e-38f, 1e-30f, 1e38f};
		const uint32_t Word = Scalar == EScalar::Bool    ? Random() % 2
							  : Scalar == EScalar::Float ? uint32_t(BitsOfFloat(Reals[Random() % std::size(Reals)]))
														 : Words[Random() % std::size(Words)];
		FValue* const Value = MakeValue(EValue::Constant, Scalar, {});
		Value->Constant = {Word};
		return {Value, Word};
	}

	FMade MakeConvert(EScalar To, int Depth)
	{
		const EScalar From = Pick();
		const FMade Inner = Make(From, Depth - 1);
		FValue* const Value = MakeValue(EValue::Convert, To, {Inner.Value});
		if (!Inner.Word || From == To)
		{
			return {Value, Inner.Word};
		}
		const uint32_t Word = *Inner.Word;
		if (To == EScalar::Bool)
		{
			return {Value, From == EScalar::Float ? F(Word) != 0 : Word != 0};
		}
		if (To == EScalar::Float)
		{
			return {Value, uint32_t(BitsOfFloat(From == EScalar::Int ? float(int32_t(Word)) : float(Word)))};
		}
		if (From != EScalar::Float)
		{
			return {Value, Word};
		}
		const double Number = double(F(Word));
		const double Least = To == EScalar::Int ? -2147483648.0 : 0;
		const double Most = To == EScalar::Int ? 2147483647.0 : 4294967295.0;
		const double Cut = Number != Number ? 0 : std::trunc(std::min(std::max(Number, Least), Most));
		return {Value, uint32_t(int64_t(Cut))};
	}

	FMade MakeChoice(EScalar Scalar, int Depth)
	{
		const FMade Condition = Make(EScalar::Bool, Depth - 1);
		const FMade Yes = Make(Scalar, Depth - 1);
		const FMade No = Make(Scalar, Depth - 1);
		FValue* const Value = MakeValue(EValue::Choose, Scalar, {Condition.Value, Yes.Value, No.Value});
		return {Value, !Condition.Word ? std::nullopt : *Condition.Word ? Yes.Word : No.Word};
	}

	FMade MakeComparison(int Depth)
	{
		static constexpr std::string_view Operators[] = {"<", ">", "<=", ">=", "==", "!="};
		const size_t Which = Random() % 6;
		const EScalar Scalar = std::vector{EScalar::Float, EScalar::Int, EScalar::Uint}[Random() % 3];
		const FMade A = Make(Scalar, Depth - 1);
		const FMade B = Make(Scalar, Depth - 1);
		FValue* const Value = MakeValue(EValue::Binary, EScalar::Bool, {A.Value, B.Value}, Operators[Which]);
		if (!A.Word || !B.Word)
		{
			return {Value, std::nullopt};
		}
		const auto Compare = [Which](auto X, auto Y) -> uint32_t
		{
			return Which == 0   ? X < Y
				   : Which == 1 ? X > Y
				   : Which == 2 ? X <= Y
				   : Which == 3 ? X >= Y
				   : Which == 4 ? X == Y
								: X != Y;
		};
		return {Value, Scalar == EScalar::Float ? Compare(F(*A.Word), F(*B.Word))
					   : Scalar == EScalar::Int ? Compare(int32_t(*A.Word), int32_t(*B.Word))
												: Compare(*A.Word, *B.Word)};
	}

	FMade MakeArithmetic(EScalar Scalar, int Depth)
	{
		static constexpr std::string_view Operators[] = {"+", "-", "*", "/", "%", "&", "|", "^", "<<", ">>"};
		const bool bReal = Scalar == EScalar::Float;
		const std::string_view Operator = Operators[Random() % (bReal ? 5 : 10)];
		const FMade Left = Make(Scalar, Depth - 1);
		const FMade Right = Make(Scalar, Depth - 1);
		FValue* const Value = MakeValue(EValue::Binary, Scalar, {Left.Value, Right.Value}, Operator);
		if (!Left.Word || !Right.Word)
		{
			return {Value, std::nullopt};
		}
		const uint32_t A = *Left.Word;
		const uint32_t B = *Right.Word;
		if (bReal)
		{
			const float X = F(A);
			const float Y = F(B);
			const float Result = Operator == "+"   ? X + Y
								 : Operator == "-" ? X - Y
								 : Operator == "*" ? X * Y
								 : Operator == "/" ? X / Y
												   : X - Y * std::trunc(X / Y);
			return {Value, uint32_t(BitsOfFloat(Result))};
		}
		if (Operator == "/" || Operator == "%")
		{
			const bool bSigned = Scalar == EScalar::Int;
			const int64_t X = bSigned ? int64_t(int32_t(A)) : int64_t(A);
			const int64_t Y = bSigned ? int64_t(int32_t(B)) : int64_t(B);
			return {Value, Y == 0 ? std::nullopt : std::optional(uint32_t(Operator == "/" ? X / Y : X % Y))};
		}
		return {Value, Operator == "+"          ? A + B
					   : Operator == "-"        ? A - B
					   : Operator == "*"        ? A * B
					   : Operator == "&"        ? A & B
					   : Operator == "|"        ? A | B
					   : Operator == "^"        ? A ^ B
					   : Operator == "<<"       ? A << (B % 32)
					   : Scalar == EScalar::Int ? uint32_t(int32_t(A) >> (B % 32))
												: A >> (B % 32)};
	}

	FTypes& Types;
	FProgram& Program;
	std::mt19937 Random;
};

TEST_F(HlslConstants, RandomExpressionsAsInCpp)
{
	int NumFolded = 0;
	for (uint32_t Seed = 0; Seed < 4000; ++Seed)
	{
		FProgram Fresh;
		FRandomExpression Expression(Types, Fresh, Seed);
		const EScalar Scalar = Expression.Pick();
		FRandomExpression::FMade Made;
		{
			const FScopedDenormals Denormals(EDenormals::Flush);
			Made = Expression.Make(Scalar, 1 + int(Seed % 5));
		}
		std::string Error;
		const std::optional<FConstant> Folded = Fold(Types, *Made.Value, &Error);
		ASSERT_EQ(Folded.has_value(), Made.Word.has_value()) << Seed << ": " << Error;
		if (!Folded)
		{
			EXPECT_NE(Error.find("by zero"), std::string::npos);
			continue;
		}
		++NumFolded;
		const float Left = std::bit_cast<float>(uint32_t(Folded->at(0)));
		const float Right = std::bit_cast<float>(*Made.Word);
		const bool bBothNan = Scalar == EScalar::Float && std::isnan(Left) && std::isnan(Right);
		ASSERT_TRUE(bBothNan || Folded->at(0) == *Made.Word)
			<< "seed " << Seed << ": " << std::hex << Folded->at(0) << " for " << *Made.Word;
	}
	EXPECT_GT(NumFolded, 3000);
}

} // namespace
} // namespace Drydock::Hlsl::Tests
