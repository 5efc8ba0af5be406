// Values: makes nodes of the program, converts and folds them, and judges what can be written to.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

FValue* FAnalyser::Make(EValue Kind, const FType* Type, const FPlace& Place, std::vector<FValue*> Operands)
{
	FValue* const Value = Program->Make<FValue>();
	Value->Kind = Kind;
	Value->Type = Type;
	Value->Place = Place;
	Value->Operands = std::move(Operands);
	return Value;
}

FValue* FAnalyser::MakeConstant(const FType* Type, FConstant Constant, const FPlace& Place)
{
	FValue* const Value = Make(EValue::Constant, Type, Place);
	Value->Constant = std::move(Constant);
	return Value;
}

FValue* FAnalyser::MakeVariable(FVariable& Variable, const FPlace& Place)
{
	FValue* const Value = Make(EValue::Variable, Variable.Type, Place);
	Value->Variable = &Variable;
	Value->bPlace = Variable.Storage != EStorage::Resource && Variable.Type->Kind != EType::Error;
	Value->bConst = (Variable.Modifiers & ModifierConst) != 0 || Variable.Storage == EStorage::Member;
	return Value;
}

/** A local that the text does not have, declared in front of the statement. */
FVariable* FAnalyser::MakeTemporary(const FType* Type, const FPlace& Place)
{
	FVariable* const Variable = Program->Make<FVariable>();
	Variable->Name = "temporary";
	Variable->Type = Type;
	Variable->Place = Place;
	Variable->bWritten = true;
	if (Here.Code)
	{
		FCode* const Code = MakeCode(EStep::Variable, Place);
		Code->Variable = Variable;
		Here.Code->push_back(Code);
	}
	else
	{
		Variable->Storage = EStorage::Static; // of an initializer at file scope
		Statics.push_back({Here.Order, Variable});
	}
	return Variable;
}

/** A value that can be named several times; Before: what must be run before. */
FValue* FAnalyser::MakeOnce(FValue* Value, std::vector<FValue*>& Before)
{
	if (IsKnown(*Value) || Value->Kind == EValue::Variable || Value->Type->IsObject())
	{
		return Value;
	}
	FVariable* const Temporary = MakeTemporary(Value->Type, Value->Place);
	Before.push_back(Make(EValue::Assign, Value->Type, Value->Place, {MakeVariable(*Temporary, Value->Place), Value}));
	return MakeVariable(*Temporary, Value->Place);
}

FValue* FAnalyser::MakeCommas(std::vector<FValue*> Values)
{
	FValue* Result = Values[0];
	for (size_t i = 1; i < Values.size(); ++i)
	{
		Result = Make(EValue::Comma, Values[i]->Type, Values[i]->Place, {Result, Values[i]});
	}
	return Result;
}

/** Value, with steps before and behind it. */
FValue* FAnalyser::MakeSequence(std::vector<FValue*> Before, FValue* Value, const std::vector<FValue*>& After)
{
	if (Before.empty() && After.empty())
	{
		return Value;
	}
	const bool bKept = !After.empty() && Value->Type->Kind != EType::Void;
	FVariable* const Result = bKept ? MakeTemporary(Value->Type, Value->Place) : nullptr;
	Before.push_back(
		bKept ? Make(EValue::Assign, Value->Type, Value->Place, {MakeVariable(*Result, Value->Place), Value}) : Value);
	Before.insert(Before.end(), After.begin(), After.end());
	if (bKept)
	{
		Before.push_back(MakeVariable(*Result, Value->Place));
	}
	return MakeCommas(std::move(Before));
}

/** Makes literals int or float: nothing else decides. */
FValue* FAnalyser::Settle(FValue* Value)
{
	if (!Value->Type->IsNumeric() || !IsLiteral(Value->Type->Scalar))
	{
		return Value;
	}
	EScalar Scalar = Value->Type->Scalar == EScalar::LiteralInt ? EScalar::Int : EScalar::Float;
	if (Value->Kind == EValue::Constant && Scalar == EScalar::Int)
	{
		const bool bFits = std::ranges::all_of(Value->Constant,
			[](uint64_t Bits) { return int64_t(Bits) >= INT32_MIN && int64_t(Bits) <= int64_t(UINT32_MAX); });
		const bool bPositive =
			std::ranges::any_of(Value->Constant, [](uint64_t Bits) { return int64_t(Bits) > INT32_MAX; });
		Scalar = !bFits ? EScalar::Long : bPositive ? EScalar::Uint : EScalar::Int;
	}
	return Convert(Value, Types->WithScalar(Value->Type, Scalar));
}

/** A constant in place of an operation on constants. */
FValue* FAnalyser::Simplify(FValue* Value)
{
	if (!Value->Type->IsNumeric() || Value->Kind == EValue::Constant || Value->Kind == EValue::Variable)
	{
		return Value;
	}
	switch (Value->Kind)
	{
	case EValue::Assign:
	case EValue::Modify:
	case EValue::Step:
	case EValue::Call:
	case EValue::Method:
	case EValue::Element:
		return Value;
	case EValue::Intrinsic:
		if (!IsPure(Value->Name))
		{
			return Value;
		}
		break;
	default:
		break;
	}
	if (!std::ranges::all_of(Value->Operands, [](const FValue* Each) { return IsKnown(*Each); }))
	{
		return Value;
	}
	std::string Why;
	std::optional<FConstant> Constant = Fold(*Types, *Value, &Why);
	if (!Why.empty())
	{
		return Fail(Value->Place, Why);
	}
	if (!Constant)
	{
		return Value;
	}
	FValue* const Result = MakeConstant(Value->Type, std::move(*Constant), Value->Place);
	Result->bPlace = Value->bPlace; // a member of a const variable is a place, though none that can be written to
	Result->bConst = true;
	return Result;
}

/** The alternatives of a literal ?: become what the whole becomes. */
FValue* FAnalyser::SpreadConversion(FValue* Value, const FType* To)
{
	const bool bChoice = Value->Kind == EValue::Choose || Value->Kind == EValue::Select || Value->Kind == EValue::Comma;
	if (!bChoice || !Value->Type->IsNumeric() || !IsLiteral(Value->Type->Scalar) || !To->IsNumeric())
	{
		return nullptr;
	}
	const FType* const Type = Types->WithScalar(Value->Type, To->Scalar);
	FValue* const Result = Make(Value->Kind, Type, Value->Place, Value->Operands);
	for (size_t i = 1; i < Result->Operands.size(); ++i)
	{
		Result->Operands[i] = Convert(Result->Operands[i], Type, true);
	}
	return Result;
}

FValue* FAnalyser::Convert(FValue* Value, const FType* To, bool bExplicit)
{
	if (IsError(Value) || To->Kind == EType::Error)
	{
		return MakeError(Value->Place);
	}
	if (Value->Type == To)
	{
		return Value;
	}
	const bool bOpens = Value->Type->IsObject() && !To->IsObject();
	Value = bOpens ? OpenConstantBuffer(Value) : Value;
	const FConversion Conversion = FindConversion(*Types, Value->Type, To, bExplicit);
	if (!Conversion.bPossible)
	{
		const bool bCast = !bExplicit && FindConversion(*Types, Value->Type, To, true).bPossible;
		return Fail(Value->Place, "X3017: cannot convert from '" + GetName(Value->Type) + "' to '" + GetName(To) + "'" +
									  (bCast ? "; if it is meant, write (" + GetName(To) + ")" : ""));
	}
	if (Conversion.bTruncates && !bExplicit)
	{
		Warn(Value->Place, "X3206: implicit truncation of '" + GetName(Value->Type) + "' to '" + GetName(To) + "'");
	}
	if (Value->bFractionLost && To->IsNumeric() && IsReal(To->Scalar))
	{
		Warn(Value->Place,
			"a division of whole numbers loses its fraction before it becomes '" + GetName(To) + "'; write 1.0 for 1");
	}
	if (FValue* const Spread = SpreadConversion(Value, To))
	{
		return Convert(Spread, To, bExplicit);
	}
	FValue* const Result = MakeConversion(*Program, *Types, Value, To, bExplicit);
	return Result ? Simplify(Result)
				  : Fail(Value->Place,
						"X3017: cannot convert from '" + GetName(Value->Type) + "' to '" + GetName(To) + "'");
}

/** A bool scalar. */
FValue* FAnalyser::MakeCondition(FValue* Value, const std::string& What, const std::string& Advice)
{
	if (IsError(Value))
	{
		return Value;
	}
	if (!Value->Type->IsNumeric() || Value->Type->NumComponents() != 1)
	{
		const bool bShape = Value->Type->IsNumeric();
		return Fail(Value->Place,
			"X3019: " + What + " takes a scalar, not '" + GetName(Value->Type) + "'" + (bShape ? "; " + Advice : ""));
	}
	return Convert(Value, Types->Scalar(EScalar::Bool), Value->Type->bScoped);
}

namespace
{

const FValue* FindRoot(const FValue* Value)
{
	while (Value->Kind == EValue::Member || Value->Kind == EValue::Index || Value->Kind == EValue::Swizzle ||
		   Value->Kind == EValue::Elements || Value->Kind == EValue::Element || Value->Kind == EValue::Bits ||
		   Value->Kind == EValue::Assign || Value->Kind == EValue::Modify || Value->Kind == EValue::Step ||
		   Value->Kind == EValue::Comma)
	{
		Value = Value->Operands[Value->Kind == EValue::Comma ? 1 : 0];
	}
	return Value;
}

/** Why a value cannot be written to. */
std::string ExplainPlace(const FValue* Value)
{
	for (const FValue* At = Value;; At = At->Operands[0])
	{
		if (At->Kind == EValue::Swizzle || At->Kind == EValue::Elements)
		{
			std::vector<uint8_t> Parts = At->Parts;
			std::ranges::sort(Parts);
			if (std::ranges::adjacent_find(Parts) != Parts.end())
			{
				return "a component stands in the swizzle twice";
			}
		}
		if (At->Kind == EValue::Element && At->Operands[0]->Type->IsObject() &&
			!IsWritable(At->Operands[0]->Type->Object))
		{
			return "'" + GetName(At->Operands[0]->Type) + "' can only be read; declare it as RW" +
				   std::string(At->Operands[0]->Type->ObjectName);
		}
		const bool bInside = At->Kind == EValue::Member || At->Kind == EValue::Index || At->Kind == EValue::Swizzle ||
							 At->Kind == EValue::Elements || At->Kind == EValue::Element || At->Kind == EValue::Bits;
		if (!bInside)
		{
			break;
		}
	}
	const FValue* const Root = FindRoot(Value);
	if (Root->Kind == EValue::Variable && Root->Variable)
	{
		const FVariable& Variable = *Root->Variable;
		return "'" + Variable.Name + "' is " +
			   (Variable.Storage == EStorage::Member        ? "a member of a cbuffer, which shaders can only read"
				   : Variable.Storage == EStorage::Resource ? "a resource"
				   : Variable.Storage == EStorage::This     ? "'this' of a const method"
															: "const");
	}
	return Root->Kind == EValue::Constant ? "it is a constant" : "it is a value and no variable";
}

} // namespace

/** The place that a cast reads: what is written to `(int4)X` is converted back. */
FValue* FAnalyser::Uncast(FValue* Value)
{
	FValue* Place = Value;
	while ((Place->Kind == EValue::Convert || Place->Kind == EValue::Cast) && !Place->bPlace)
	{
		Place = Place->Operands[0];
	}
	const bool bWhole = Place->bPlace && FindConversion(*Types, Value->Type, Place->Type).bPossible;
	return bWhole ? Place : Value;
}

bool FAnalyser::RequirePlace(FValue* Value, const std::string& What)
{
	if (IsError(Value))
	{
		return false;
	}
	if (Value->bPlace && !Value->bConst)
	{
		MarkWritten(Value);
		return true;
	}
	Error(Value->Place, "X3025: " + What + " needs something that can be written to: " + ExplainPlace(Value));
	return false;
}

/** A parameter of the shader that is written becomes a copy for each thread, as in FXC's older mode. */
void FAnalyser::MarkWritten(FValue* Value)
{
	FVariable* const Variable = FindRoot(Value)->Variable;
	if (!Variable)
	{
		return;
	}
	Variable->bWritten = true;
	if (Variable->Storage != EStorage::Loose)
	{
		return;
	}
	Warn(Value->Place, "X3025: global variables are implicitly constant: '" + Variable->Name +
						   "' is a parameter of the shader, which DXC refuses to write; copy it into a local variable");
	FVariable& Parameter = *Program->Make<FVariable>();
	Parameter = *Variable;
	Parameter.ResourceName = Parameter.Name;
	Parameter.bWritten = false;
	uint32_t Order = 0;
	for (FMade& Made : Loose)
	{
		if (Made.Variable == Variable)
		{
			Made.Variable = &Parameter;
			Order = Made.Order;
		}
	}
	if (const auto Offset = Offsets.find(Variable); Offset != Offsets.end())
	{
		Offsets[&Parameter] = Offset->second;
	}
	Variable->Storage = EStorage::Static;
	Variable->Buffer = nullptr;
	Variable->Initializer = MakeVariable(Parameter, Variable->Place);
	Statics.push_back({Order, Variable});
}

/** Marks all values of a precise variable as precise. */
void FAnalyser::MarkPrecise(FValue* Value)
{
	std::vector<FValue*> Open = {Value};
	while (!Open.empty())
	{
		FValue* const Each = Open.back();
		Open.pop_back();
		if (!Each->bPrecise)
		{
			Each->bPrecise = true;
			Open.insert(Open.end(), Each->Operands.begin(), Each->Operands.end());
		}
	}
}

} // namespace Drydock::Hlsl
