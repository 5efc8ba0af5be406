// Operators: arithmetic, comparisons, logic, choices, assignments.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

bool IsComparison(std::string_view Operator)
{
	return Operator == "<" || Operator == ">" || Operator == "<=" || Operator == ">=" || Operator == "==" ||
		   Operator == "!=";
}

bool IsBitwise(std::string_view Operator)
{
	return Operator == "&" || Operator == "|" || Operator == "^" || Operator == "<<" || Operator == ">>";
}

/** Null: the operator is none of a division, or has this scalar. */
const char* RefuseDivision(std::string_view Operator, EScalar Scalar)
{
	if (Operator == "%" && Scalar == EScalar::Double)
	{
		return "X3684: modulo cannot be used with doubles, cast to float first";
	}
	return (Operator == "%" || Operator == "/") && Scalar == EScalar::MinInt
			   ? "X3706: signed integer division is not supported on minimum-precision types; cast to int"
			   : nullptr;
}

std::string Quote(std::string_view Text)
{
	return "'" + std::string(Text) + "'";
}

} // namespace

/** An enumeration as its integer. */
FValue* FAnalyser::ToPlain(FValue* Value)
{
	return Value->Type->IsEnum() && !Value->Type->bScoped ? Convert(Value, Types->Scalar(Value->Type->Scalar)) : Value;
}

FValue* FAnalyser::CallOperator(
	std::string_view Operator, FValue* Object, std::vector<FValue*> Others, const FPlace& Place)
{
	const std::string Name = "operator" + std::string(Operator);
	FNameScope* Where = nullptr;
	FSymbol* const Symbol = FindIn(*GetInfo(Object->Type)->Scope, Name, &Where);
	if (!Symbol || Symbol->Kind != ESymbol::Functions)
	{
		return Fail(Place, "X3022: " + Quote(Operator) + " takes scalars, vectors and matrices, and '" +
							   GetName(Object->Type) + "' has no " + Name);
	}
	FArguments Arguments;
	Arguments.Values = std::move(Others);
	Arguments.Trees.resize(Arguments.Values.size());
	FExpression Tree;
	Tree.Place = Place;
	return CallMethod(Tree, Object, *Symbol, Arguments);
}

FValue* FAnalyser::AnalyseUnary(const FExpression& Tree)
{
	FValue* Value = Analyse(*Tree.Operands[0]);
	if (IsError(Value))
	{
		return Value;
	}
	if (Value->Type->IsStruct())
	{
		return CallOperator(Tree.Text, Value, {}, Tree.Place);
	}
	Value = ToPlain(Value);
	const FType* Type = Value->Type;
	if (!Type->IsNumeric() || Type->bScoped)
	{
		return Fail(Tree.Place,
			"X3022: " + Quote(Tree.Text) + " takes scalars, vectors and matrices, not '" + GetName(Type) + "'");
	}
	if (Tree.Text == "!")
	{
		Type = Types->WithScalar(Type, EScalar::Bool);
	}
	else if (Type->Scalar == EScalar::Bool)
	{
		Type = Types->WithScalar(Type, EScalar::Int);
	}
	if (Tree.Text == "~" && IsReal(Type->Scalar))
	{
		return Fail(Tree.Place, "X3082: int or unsigned int type required for '~', not '" + GetName(Type) + "'");
	}
	const bool bConstant = Value->Kind == EValue::Constant;
	Value =
		Convert(bConstant ? Value : Settle(Value), bConstant || !IsLiteral(Type->Scalar) ? Type : Settle(Value)->Type);
	if (Tree.Text == "+" || IsError(Value))
	{
		FValue* const Copy = IsError(Value) || Value->Kind == EValue::Constant
								 ? Value
								 : Make(EValue::Convert, Value->Type, Tree.Place, {Value});
		return Copy;
	}
	FValue* const Result = Make(EValue::Unary, Value->Type, Tree.Place, {Value});
	Result->Operator = KeepOperator(Tree.Text);
	return Simplify(Result);
}

FValue* FAnalyser::AnalyseStep(const FExpression& Tree, bool bPostfix)
{
	FValue* const Value = Analyse(*Tree.Operands[0]);
	if (IsError(Value))
	{
		return Value;
	}
	if (Value->Type->IsStruct())
	{
		return CallOperator(Tree.Text, Value, {}, Tree.Place);
	}
	if (Value->Type->IsNumeric() && Value->Type->Scalar == EScalar::Bool)
	{
		return Fail(Tree.Place, "X3020: " + Quote(Tree.Text) + ": operator cannot be used with a bool lvalue");
	}
	if (!Value->Type->IsNumeric() || Value->Type->IsEnum())
	{
		return Fail(Tree.Place, "X3020: " + Quote(Tree.Text) + " takes numbers, not '" + GetName(Value->Type) + "'");
	}
	if (!RequirePlace(Value, Quote(Tree.Text)))
	{
		return MakeError(Tree.Place);
	}
	FValue* const Result = Make(EValue::Step, Value->Type, Tree.Place, {Value});
	Result->bPlace = !bPostfix;
	Result->Operator = KeepOperator(Tree.Text);
	Result->bPostfix = bPostfix;
	return Result;
}

FValue* FAnalyser::AnalyseBinary(const FExpression& Tree)
{
	FValue* const Left = Analyse(*Tree.Operands[0]);
	FValue* const Right = Analyse(*Tree.Operands[1]);
	if (IsError(Left) || IsError(Right))
	{
		return MakeError(Tree.Place);
	}
	if (Left->Type->IsStruct())
	{
		return CallOperator(Tree.Text, Left, {Right}, Tree.Place);
	}
	return Tree.Text == "&&" || Tree.Text == "||" ? MakeLogical(Tree, Left, Right)
												  : MakeBinary(Tree.Text, Left, Right, Tree.Place);
}

FValue* FAnalyser::MakeLogical(const FExpression& Tree, FValue* Left, FValue* Right)
{
	const bool bAnd = Tree.Text == "&&";
	if (Options.bFxcRules && Left->Type->IsNumeric() && Right->Type->IsNumeric())
	{
		FArguments Arguments;
		Arguments.Values = {Left, Right};
		return CallIntrinsic(bAnd ? "and" : "or", Arguments, Tree.Place);
	}
	const std::string Advice = std::string("write ") + (bAnd ? "and" : "or") +
							   "(A, B) for components, or all(...) or any(...) around each side";
	FValue* const First = MakeCondition(Left, Quote(Tree.Text), Advice);
	FValue* const Second = IsError(First) ? First : MakeCondition(Right, Quote(Tree.Text), Advice);
	if (IsError(Second))
	{
		return MakeError(Tree.Place);
	}
	return Simplify(Make(bAnd ? EValue::And : EValue::Or, Types->Scalar(EScalar::Bool), Tree.Place, {First, Second}));
}

FValue* FAnalyser::MakeBinary(std::string_view Operator, FValue* Left, FValue* Right, const FPlace& Place)
{
	Left = ToPlain(OpenConstantBuffer(Left));
	Right = ToPlain(OpenConstantBuffer(Right));
	if (IsError(Left) || IsError(Right))
	{
		return MakeError(Place);
	}
	bool bTruncates = false;
	std::string Why;
	const FType* Type = MeetTypes(*Types, Left->Type, Right->Type, bTruncates, Why);
	if (!Type || (Type->bScoped && !IsComparison(Operator)))
	{
		return Fail(Place, (Type ? "X3020: " + Quote(Operator) + " takes no '" + GetName(Type) + "'; cast it" : Why));
	}
	const bool bEquality = Operator == "==" || Operator == "!=";
	if (bEquality && Left->Type->Scalar == EScalar::Bool && Right->Type->Scalar == EScalar::Bool)
	{
		Type = Types->WithScalar(Type, EScalar::Bool);
	}
	if (IsBitwise(Operator) && (IsReal(Left->Type->Scalar) || IsReal(Right->Type->Scalar)))
	{
		const FType* const Wrong = IsReal(Left->Type->Scalar) ? Left->Type : Right->Type;
		return Fail(Place,
			"X3082: int or unsigned int type required for " + Quote(Operator) + ", not '" + GetName(Wrong) + "'");
	}
	if (bTruncates)
	{
		Warn(Place, "X3206: implicit truncation of vector type: " + Quote(Operator) + " of '" + GetName(Left->Type) +
						"' and '" + GetName(Right->Type) + "' is of '" + GetName(Type) + "'");
	}
	if (const char* const Refused = RefuseDivision(Operator, Type->Scalar))
	{
		return Fail(Place, Refused);
	}
	if (Operator == "<<" || Operator == ">>")
	{
		EScalar Scalar = Left->Type->Scalar == EScalar::Bool ? EScalar::Int : Left->Type->Scalar;
		Scalar = Scalar == EScalar::LiteralInt ? Type->Scalar : Scalar; // `1 << U` is a uint
		Type = Types->WithScalar(Type, Scalar);
	}
	if (IsLiteral(Type->Scalar) && !(Left->Kind == EValue::Constant && Right->Kind == EValue::Constant))
	{
		Type = Types->WithScalar(Type, Type->Scalar == EScalar::LiteralInt ? EScalar::Int : EScalar::Float);
	}
	if (Type->bScoped)
	{
		Type = Types->Scalar(Type->Scalar);
	}
	Left = Convert(Left, Type, true);
	Right = Convert(Right, Type, true);
	if (IsError(Left) || IsError(Right))
	{
		return MakeError(Place);
	}
	const bool bDivides = (Operator == "/" || Operator == "%") && !IsReal(Type->Scalar) && IsKnown(*Right);
	const FConstant Divisor = bDivides ? Fold(*Types, *Right).value_or(FConstant()) : FConstant();
	if (std::ranges::find(Divisor, 0u) != Divisor.end())
	{
		return Fail(Place, "X4010: division of an integer by zero");
	}
	FValue* const Result = Make(
		EValue::Binary, IsComparison(Operator) ? Types->WithScalar(Type, EScalar::Bool) : Type, Place, {Left, Right});
	Result->Operator = KeepOperator(Operator);
	const FConstant Dividend = bDivides && IsKnown(*Left) ? Fold(*Types, *Left).value_or(FConstant()) : FConstant();
	FValue* const Simple = Simplify(Result);
	if (Operator == "/" && Dividend.size() == 1 && Divisor[0] != ~uint64_t(0) &&
		int64_t(Dividend[0]) % int64_t(Divisor[0]) != 0)
	{
		Simple->bFractionLost = true;
	}
	return Simple;
}

FValue* FAnalyser::AnalyseConditional(const FExpression& Tree)
{
	FValue* const Chosen = Analyse(*Tree.Operands[0]);
	FValue* Left = Analyse(*Tree.Operands[1]);
	FValue* Right = Analyse(*Tree.Operands[2]);
	if (Options.bFxcRules && Chosen->Type->IsNumeric() && Left->Type->IsNumeric() && Right->Type->IsNumeric())
	{
		FArguments Arguments;
		Arguments.Values = {Chosen, Left, Right};
		return CallIntrinsic("select", Arguments, Tree.Place);
	}
	FValue* const Condition =
		MakeCondition(Chosen, "the condition of '?:'", "write select(C, A, B) to choose by components");
	if (IsError(Condition) || IsError(Left) || IsError(Right))
	{
		return MakeError(Tree.Place);
	}
	const FType* Type = Left->Type;
	if (!IsSame(Left->Type, Right->Type))
	{
		Left = ToPlain(OpenConstantBuffer(Left));
		Right = ToPlain(OpenConstantBuffer(Right));
		bool bTruncates = false;
		std::string Why;
		Type = MeetTypes(*Types, Left->Type, Right->Type, bTruncates, Why);
		if (!Type)
		{
			return Fail(Tree.Place, "X3020: type mismatch: the sides of '?:' are '" + GetName(Left->Type) + "' and '" +
										GetName(Right->Type) + "'");
		}
		if (bTruncates)
		{
			Warn(Tree.Place, "X3206: implicit truncation of vector type: the sides of '?:' are '" +
								 GetName(Left->Type) + "' and '" + GetName(Right->Type) + "'");
		}
	}
	else if (Type->Kind == EType::Void)
	{
		return Fail(Tree.Place, "X3020: the sides of '?:' have no value; write if");
	}
	Left = Convert(Left, Type, true);
	Right = Convert(Right, Type, true);
	return IsError(Left) || IsError(Right) ? MakeError(Tree.Place)
										   : Simplify(Make(EValue::Choose, Type, Tree.Place, {Condition, Left, Right}));
}

FValue* FAnalyser::AnalyseAssign(const FExpression& Tree)
{
	FValue* Left = Analyse(*Tree.Operands[0]);
	FValue* Right = Analyse(*Tree.Operands[1]);
	if (IsError(Left) || IsError(Right))
	{
		return MakeError(Tree.Place);
	}
	if (Left->Kind == EValue::Cast && IsDerived(Left->Operands[0]->Type, Left->Type) && Tree.Text == "=" &&
		RequirePlace(Left->Operands[0], "'='"))
	{
		std::vector<FValue*> Steps;
		Right = Convert(Right, Left->Type);
		FValue* const From = IsError(Right) ? Right : MakeOnce(Right, Steps);
		CopyMembers(Left->Operands[0], From, Left->Type, Steps);
		return IsError(Right) || Steps.empty() ? MakeError(Tree.Place) : MakeCommas(std::move(Steps));
	}
	if (FValue* const Place = Uncast(Left); Place != Left && Tree.Text == "=")
	{
		Right = Convert(Right, Left->Type);
		Left = Place;
	}
	if (Tree.Text != "=")
	{
		return AnalyseModify(Tree, Left, Right);
	}
	if (!RequirePlace(Left, "'='"))
	{
		return MakeError(Tree.Place);
	}
	Right = Convert(Right, Left->Type);
	if (IsError(Right))
	{
		return MakeError(Tree.Place);
	}
	FValue* const Result = Make(EValue::Assign, Left->Type, Tree.Place, {Left, Right});
	Result->bPlace = true;
	if (Left->Kind == EValue::Variable && Left->Variable->Modifiers & ModifierPrecise)
	{
		MarkPrecise(Result);
	}
	return Result;
}

FValue* FAnalyser::AnalyseModify(const FExpression& Tree, FValue* Left, FValue* Right)
{
	const std::string_view Operator = KeepOperator(Tree.Text.substr(0, Tree.Text.size() - 1));
	if (Left->Type->IsStruct())
	{
		return CallOperator(Tree.Text, Left, {Right}, Tree.Place);
	}
	Right = ToPlain(OpenConstantBuffer(Right));
	if (IsError(Right) || !RequirePlace(Left, Quote(Tree.Text)))
	{
		return MakeError(Tree.Place);
	}
	bool bTruncates = false;
	std::string Why;
	const FType* const Met =
		Left->Type->IsEnum() ? nullptr : MeetTypes(*Types, Left->Type, Right->Type, bTruncates, Why);
	if (!Met)
	{
		return Fail(
			Tree.Place, Why.empty() ? "X3020: " + Quote(Tree.Text) + " takes no '" + GetName(Left->Type) + "'" : Why);
	}
	if (IsBitwise(Operator) && (IsReal(Left->Type->Scalar) || IsReal(Right->Type->Scalar)))
	{
		return Fail(Tree.Place, "X3082: int or unsigned int type required for " + Quote(Tree.Text));
	}
	if (const char* const Refused = RefuseDivision(Operator, Met->Scalar))
	{
		return Fail(Tree.Place, Refused);
	}
	if (Left->Type->Scalar == EScalar::Bool && Operator != "&" && Operator != "|" && Operator != "^")
	{
		return Fail(Tree.Place, "X3020: " + Quote(Tree.Text) + ": operator cannot be used with a bool lvalue");
	}
	const bool bShift = Operator == "<<" || Operator == ">>";
	EScalar Scalar = bShift ? Left->Type->Scalar : Met->Scalar;
	Scalar = Scalar == EScalar::Bool ? EScalar::Int : Scalar;
	const FType* const Type = Types->WithScalar(Left->Type, Scalar);
	const FConversion Shape = FindConversion(*Types, Right->Type, Type);
	if (!Shape.bPossible)
	{
		return Fail(Tree.Place, "X3020: type mismatch: " + Quote(Tree.Text) + " of '" + GetName(Left->Type) +
									"' and '" + GetName(Right->Type) + "'");
	}
	Right = Convert(Right, Type);
	if (IsError(Right))
	{
		return MakeError(Tree.Place);
	}
	FValue* const Result = Make(EValue::Modify, Left->Type, Tree.Place, {Left, Right});
	Result->bPlace = true;
	Result->Operator = Operator;
	if (Left->Kind == EValue::Variable && Left->Variable->Modifiers & ModifierPrecise)
	{
		MarkPrecise(Result);
	}
	return Result;
}

} // namespace Drydock::Hlsl
