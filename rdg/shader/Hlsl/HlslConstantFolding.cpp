// Folds values: what depends on constants alone, to their scalars.
#include "HlslConstants.h"

#include "HlslConstantCalls.h"
#include "HlslConstantMath.h"
#include "SpirvOps.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

/** An array beyond it stays a value of run time. */
constexpr uint32_t FoldMostScalars = 1u << 16;

class FFolder
{
public:
	explicit FFolder(std::string* InError)
		: Error(InError)
	{
	}

	std::optional<FConstant> Fold(const FValue& Value)
	{
		if (CountScalars(Value.Type) > FoldMostScalars)
		{
			return std::nullopt;
		}
		std::optional<FConstant> Result = FoldValue(Value);
		return Result && Result->size() == CountScalars(Value.Type) ? Result : std::nullopt;
	}

private:
	using FResult = std::optional<FConstant>;

	FResult FoldValue(const FValue& Value)
	{
		switch (Value.Kind)
		{
		case EValue::Constant:
			return Value.Constant;
		case EValue::Variable:
			return Value.Variable ? Value.Variable->Constant : std::nullopt;
		case EValue::Zero:
			return FConstant(CountScalars(Value.Type), 0);
		case EValue::And:
		case EValue::Or:
		{
			const FResult Left = FoldOperand(Value, 0);
			const bool bDecided = Left && (Left->at(0) != 0) == (Value.Kind == EValue::Or);
			return !Left || bDecided ? Left : FoldOperand(Value, 1);
		}
		case EValue::Choose:
		{
			const FResult Condition = FoldOperand(Value, 0);
			return Condition ? FoldOperand(Value, Condition->at(0) ? 1 : 2) : std::nullopt;
		}
		default:
			break;
		}
		std::vector<FConstant> Operands;
		for (size_t i = 0; i < Value.Operands.size(); ++i)
		{
			FResult Operand = IsFolded(Value.Kind) ? FoldOperand(Value, i) : std::nullopt;
			if (!Operand || Operand->empty())
			{
				return std::nullopt;
			}
			Operands.push_back(std::move(*Operand));
		}
		return Operands.empty() ? std::nullopt : FoldWith(Value, Operands);
	}

	static bool IsFolded(EValue Kind)
	{
		switch (Kind)
		{
		case EValue::Member:
		case EValue::Index:
		case EValue::Swizzle:
		case EValue::Elements:
		case EValue::Unary:
		case EValue::Binary:
		case EValue::Select:
		case EValue::Convert:
		case EValue::Compose:
		case EValue::Comma:
		case EValue::Cast:
		case EValue::Intrinsic:
			return true;
		default:
			return false;
		}
	}

	FResult FoldOperand(const FValue& Value, size_t i)
	{
		return i < Value.Operands.size() ? Fold(*Value.Operands[i]) : std::nullopt;
	}

	FResult FoldWith(const FValue& Value, std::vector<FConstant>& Operands)
	{
		const FType* const From = Value.Operands[0]->Type;
		switch (Value.Kind)
		{
		case EValue::Member:
			return FoldMember(Value, Operands[0]);
		case EValue::Index:
			return FoldIndex(From, Value.Operands[1]->Type, Operands);
		case EValue::Swizzle:
		case EValue::Elements:
			return FoldParts(Value, Operands[0]);
		case EValue::Unary:
			return FoldUnary(Value, Operands[0]);
		case EValue::Binary:
			return FoldBinary(Value, Operands);
		case EValue::Select:
			return FoldSelect(Value, Operands);
		case EValue::Convert:
			return FoldConvert(From, Value.Type, Operands[0]);
		case EValue::Cast:
			return FoldCast(From, Value.Type, Operands[0]);
		case EValue::Compose:
		{
			FConstant Result;
			for (const FConstant& Operand : Operands)
			{
				Result.insert(Result.end(), Operand.begin(), Operand.end());
			}
			return Result;
		}
		case EValue::Comma:
			return Operands.back();
		default:
			return FoldIntrinsic(Value, Operands);
		}
	}

	static FResult Slice(const FConstant& Whole, uint64_t First, uint64_t Count)
	{
		return First + Count <= Whole.size()
				   ? FResult(FConstant(Whole.begin() + int64_t(First), Whole.begin() + int64_t(First + Count)))
				   : std::nullopt;
	}

	static FResult FoldMember(const FValue& Value, const FConstant& Whole)
	{
		const FType* const Struct = Value.Operands[0]->Type;
		if (!Struct->IsStruct() || Value.Index >= Struct->Struct->Members.size())
		{
			return std::nullopt;
		}
		uint64_t First = 0;
		for (uint32_t i = 0; i < Value.Index; ++i)
		{
			First += CountScalars(Struct->Struct->Members[i].Type);
		}
		return Slice(Whole, First, CountScalars(Value.Type));
	}

	/** An index outside stays for run time, which has its rule. */
	static FResult FoldIndex(const FType* Whole, const FType* IndexType, const std::vector<FConstant>& Operands)
	{
		if (Operands.size() != 2 || !IndexType->IsNumeric())
		{
			return std::nullopt;
		}
		const uint64_t Index = ConvertConstantBits(IndexType->Scalar, EScalar::Long, Operands[1][0]);
		const uint32_t Count = Whole->IsArray() ? Whole->Count : Whole->IsMatrix() ? Whole->Rows : Whole->Columns;
		const uint32_t Size = Whole->IsArray() ? CountScalars(Whole->Element) : Whole->IsMatrix() ? Whole->Columns : 1;
		return Index < Count ? Slice(Operands[0], Index * Size, Size) : std::nullopt;
	}

	static FResult FoldParts(const FValue& Value, const FConstant& Whole)
	{
		FConstant Result;
		for (const uint8_t Part : Value.Parts)
		{
			const FType* const From = Value.Operands[0]->Type;
			const size_t At = Value.Kind == EValue::Swizzle ? Part : size_t(Part / 4) * From->Columns + Part % 4;
			if (At >= Whole.size())
			{
				return std::nullopt;
			}
			Result.push_back(Whole[At]);
		}
		return Result;
	}

	static FResult FoldUnary(const FValue& Value, const FConstant& Operand)
	{
		const EScalar Scalar = Value.Type->Scalar;
		const uint16_t Negate = IsReal(Scalar) ? Spirv::OpFNegate : Spirv::OpSNegate;
		const uint16_t Op = Value.Operator == "-" ? Negate : FindConstantOperation(Value.Operator, Scalar);
		FConstant Result(Operand.size());
		for (size_t i = 0; i < Operand.size(); ++i)
		{
			const uint64_t Bits[3] = {Operand[i], 0, 0};
			if (Op == Spirv::OpNop || !EvaluateConstant(Op, Scalar, Scalar, Bits, Result[i]))
			{
				return std::nullopt;
			}
		}
		return Result;
	}

	FResult FoldBinary(const FValue& Value, const std::vector<FConstant>& Operands)
	{
		const EScalar Scalar = Value.Operands[0]->Type->Scalar;
		const uint16_t Op = FindConstantOperation(Value.Operator, Scalar);
		if (Op == Spirv::OpNop || Operands.size() != 2)
		{
			return std::nullopt;
		}
		FConstant Result(Operands[0].size());
		for (size_t i = 0; i < Result.size(); ++i)
		{
			const uint64_t Bits[3] = {Operands[0][i], Operands[1][Operands[1].size() == 1 ? 0 : i], 0};
			const bool bDivides = Value.Operator == "/" || Value.Operator == "%";
			if (bDivides && Bits[1] == 0 && !IsReal(Scalar))
			{
				if (Error)
				{
					*Error = "X4010: division of an integer by zero in a constant expression";
				}
				return std::nullopt;
			}
			if (!EvaluateConstant(Op, Scalar, Value.Type->Scalar, Bits, Result[i]))
			{
				return std::nullopt;
			}
		}
		return Result;
	}

	static FResult FoldSelect(const FValue& Value, const std::vector<FConstant>& Operands)
	{
		FConstant Result(CountScalars(Value.Type));
		for (size_t i = 0; i < Result.size() && Operands.size() == 3; ++i)
		{
			const FConstant& Side = Operands[Operands[0][Operands[0].size() == 1 ? 0 : i] ? 1 : 2];
			Result[i] = Side[Side.size() == 1 ? 0 : i];
		}
		return Operands.size() == 3 ? FResult(Result) : std::nullopt;
	}

	static FResult FoldConvert(const FType* From, const FType* To, const FConstant& Operand)
	{
		FConstant Result;
		const bool bMatrix = From->IsMatrix() && To->IsMatrix();
		for (uint32_t i = 0; i < To->NumComponents(); ++i)
		{
			const uint32_t At = Operand.size() == 1 ? 0
								: bMatrix           ? i / To->Columns * From->Columns + i % To->Columns
													: i;
			if (At >= Operand.size())
			{
				return std::nullopt;
			}
			Result.push_back(ConvertConstantBits(From->Scalar, To->Scalar, Operand[At]));
		}
		return Result;
	}

	/** The first scalars; a single one goes to all. */
	static FResult FoldCast(const FType* From, const FType* To, const FConstant& Operand)
	{
		FConstant Result(CountScalars(To));
		for (uint32_t i = 0; i < Result.size(); ++i)
		{
			const uint32_t At = Operand.size() == 1 ? 0 : i;
			if (At >= Operand.size())
			{
				return std::nullopt;
			}
			Result[i] = ConvertConstantBits(GetScalarAt(From, At), GetScalarAt(To, i), Operand[At]);
		}
		return Result;
	}

	static FResult FoldIntrinsic(const FValue& Value, const std::vector<FConstant>& Operands)
	{
		std::vector<FConstantArgument> Arguments;
		for (size_t i = 0; i < Operands.size(); ++i)
		{
			if (!Value.Operands[i]->Type->IsNumeric() || !Value.Type->IsNumeric())
			{
				return std::nullopt;
			}
			Arguments.push_back({Value.Operands[i]->Type, &Operands[i]});
		}
		return EvaluateConstantCall(Value.Name, Value.Type, Arguments);
	}

	std::string* const Error;
};

} // namespace

std::optional<FConstant> Fold(FTypes&, const FValue& Value, std::string* Error)
{
	return FFolder(Error).Fold(Value);
}

} // namespace Drydock::Hlsl
