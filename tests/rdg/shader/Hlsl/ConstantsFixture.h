// Values of HLSL made by hand, and what they fold to.
#pragma once

#include <gtest/gtest.h>

#include "HlslConstants.h"

#include <bit>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace Drydock::Hlsl::Tests
{

inline constexpr float GConstantsInf = std::numeric_limits<float>::infinity();
inline constexpr float GConstantsNan = std::numeric_limits<float>::quiet_NaN();

inline uint64_t BitsOfFloat(float Value)
{
	return std::bit_cast<uint32_t>(Value);
}

inline uint64_t BitsOfDouble(double Value)
{
	return std::bit_cast<uint64_t>(Value);
}

/** Makes values by hand and folds them. */
class HlslConstants : public ::testing::Test
{
protected:
	FTypes Types{true};
	FProgram Program;

	FValue* Make(EValue Kind, const FType* Type, const std::vector<FValue*>& Operands = {})
	{
		FValue* const Value = Program.Make<FValue>();
		Value->Kind = Kind;
		Value->Type = Type;
		Value->Operands = Operands;
		return Value;
	}

	FValue* Constant(EScalar Scalar, const FConstant& Words)
	{
		const uint32_t Count = uint32_t(Words.size());
		FValue* const Value = Make(EValue::Constant, Count == 1 ? Types.Scalar(Scalar) : Types.Vector(Scalar, Count));
		Value->Constant = Words;
		return Value;
	}

	FValue* Floats(const std::vector<float>& Values)
	{
		FConstant Words;
		for (const float Value : Values)
		{
			Words.push_back(BitsOfFloat(Value));
		}
		return Constant(EScalar::Float, Words);
	}

	FValue* Matrix(uint32_t Rows, uint32_t Columns, const std::vector<float>& Values)
	{
		FValue* const Value = Floats({0});
		Value->Type = Types.Matrix(EScalar::Float, Rows, Columns);
		Value->Constant.clear();
		for (const float Element : Values)
		{
			Value->Constant.push_back(BitsOfFloat(Element));
		}
		return Value;
	}

	FValue* Int(int32_t Value) { return Constant(EScalar::Int, {uint32_t(Value)}); }
	FValue* Uint(uint32_t Value) { return Constant(EScalar::Uint, {Value}); }

	FValue* Binary(std::string_view Operator, FValue* A, FValue* B)
	{
		const bool bCompares = Operator == "<" || Operator == ">" || Operator == "<=" || Operator == ">=" ||
							   Operator == "==" || Operator == "!=";
		FValue* const Value =
			Make(EValue::Binary, bCompares ? Types.WithScalar(A->Type, EScalar::Bool) : A->Type, {A, B});
		Value->Operator = Operator;
		return Value;
	}

	FValue* Call(std::string_view Name, const FType* Type, const std::vector<FValue*>& Operands)
	{
		FValue* const Value = Make(EValue::Intrinsic, Type, Operands);
		Value->Name = Name;
		return Value;
	}

	FConstant MustFold(const FValue* Value)
	{
		std::string Error;
		const std::optional<FConstant> Result = Fold(Types, *Value, &Error);
		EXPECT_TRUE(Result) << Error;
		return Result.value_or(FConstant(16, 0xDEADBEEF));
	}

	float FoldFloat(const FValue* Value, size_t i = 0) { return std::bit_cast<float>(uint32_t(MustFold(Value).at(i))); }

	std::vector<float> FoldFloats(const FValue* Value)
	{
		std::vector<float> Result;
		for (const uint64_t Word : MustFold(Value))
		{
			Result.push_back(std::bit_cast<float>(uint32_t(Word)));
		}
		return Result;
	}

	/** A function of floats of one shape. */
	float CallFloat(std::string_view Name, const std::vector<float>& Arguments)
	{
		std::vector<FValue*> Operands;
		for (const float Argument : Arguments)
		{
			Operands.push_back(Floats({Argument}));
		}
		return FoldFloat(Call(Name, Types.Scalar(EScalar::Float), Operands));
	}
};

} // namespace Drydock::Hlsl::Tests
