// Values: operators, choices, what is assigned. HlslEmitterParts.cpp converts and composes them.
#include "HlslEmitterImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

using namespace Spirv;

namespace
{

constexpr int EmitFreeBudget = 12; // nodes of a side that is computed although it may not be needed

struct FEmitOperator
{
	std::string_view Sign;
	uint16_t Bool;
	uint16_t Signed;
	uint16_t Unsigned;
	uint16_t Real;
	bool bCompares;
};

constexpr FEmitOperator EmitOperators[] = {
	{"+", 0, OpIAdd, OpIAdd, OpFAdd, false},
	{"-", 0, OpISub, OpISub, OpFSub, false},
	{"*", OpLogicalAnd, OpIMul, OpIMul, OpFMul, false},
	{"/", 0, OpSDiv, OpUDiv, OpFDiv, false},
	{"%", 0, OpSRem, OpUMod, OpFRem, false},
	{"<<", 0, OpShiftLeftLogical, OpShiftLeftLogical, 0, false},
	{">>", 0, OpShiftRightArithmetic, OpShiftRightLogical, 0, false},
	{"&", OpLogicalAnd, OpBitwiseAnd, OpBitwiseAnd, 0, false},
	{"|", OpLogicalOr, OpBitwiseOr, OpBitwiseOr, 0, false},
	{"^", OpLogicalNotEqual, OpBitwiseXor, OpBitwiseXor, 0, false},
	{"&&", OpLogicalAnd, 0, 0, 0, false},
	{"||", OpLogicalOr, 0, 0, 0, false},
	{"==", OpLogicalEqual, OpIEqual, OpIEqual, OpFOrdEqual, true},
	{"!=", OpLogicalNotEqual, OpINotEqual, OpINotEqual, OpFUnordNotEqual, true},
	{"<", 0, OpSLessThan, OpULessThan, OpFOrdLessThan, true},
	{">", 0, OpSGreaterThan, OpUGreaterThan, OpFOrdGreaterThan, true},
	{"<=", 0, OpSLessThanEqual, OpULessThanEqual, OpFOrdLessThanEqual, true},
	{">=", 0, OpSGreaterThanEqual, OpUGreaterThanEqual, OpFOrdGreaterThanEqual, true},
};

const FEmitOperator* FindEmitOperator(std::string_view Sign)
{
	for (const FEmitOperator& Row : EmitOperators)
	{
		if (Row.Sign == Sign)
		{
			return &Row;
		}
	}
	return nullptr;
}

/** Whether an index that is known at run time only selects in an array or a matrix. */
bool NeedsEmitMemory(const FValue& Node)
{
	const bool bPart = Node.Kind == EValue::Member || Node.Kind == EValue::Index || Node.Kind == EValue::Swizzle ||
					   Node.Kind == EValue::Elements;
	const bool bIndex = Node.Kind == EValue::Index && Node.Operands[1]->Kind != EValue::Constant &&
						(!Node.Operands[0]->Type->IsNumeric() || Node.Operands[0]->Type->IsMatrix());
	return bPart && (bIndex || NeedsEmitMemory(*Node.Operands[0]));
}

/** A scalar that was splat. */
const FValue* FindSplat(const FValue& Node)
{
	const bool bSplat = Node.Kind == EValue::Convert && Node.Type->IsVector() && Node.Operands[0]->Type->IsScalar();
	return bSplat ? Node.Operands[0] : nullptr;
}

} // namespace

uint32_t FEmitter::Value(const FValue& Node)
{
	uint32_t Result = 0;
	Deeper(Node.Place, [&] { Result = ValueOf(Node); });
	return Result;
}

uint32_t FEmitter::ValueOf(const FValue& Node)
{
	switch (Node.Kind)
	{
	case EValue::Constant:
		return ConstantOf(Node.Type, Node.Constant);
	case EValue::Variable:
		return CountScalars(Node.Type) == 0 ? 0
			   : IsPlace(Node)              ? Load(Place(Node))
											: ConstantOf(Node.Type, *Node.Variable->Constant);
	case EValue::Member:
	case EValue::Index:
	case EValue::Swizzle:
	case EValue::Elements:
	case EValue::Element:
		return CountScalars(Node.Type) == 0             ? 0
			   : IsPlace(Node) || NeedsEmitMemory(Node) ? Load(Place(Node))
														: PartOf(Node);
	case EValue::Bits:
		return BitsOf(Value(*Node.Operands[0]), Node.Bits);
	case EValue::Unary:
		return Negate(Node.Operator, Node.Type, Value(*Node.Operands[0]));
	case EValue::Binary:
		return Operate(Node);
	case EValue::And:
	case EValue::Or:
	case EValue::Choose:
		return ShortCircuit(Node);
	case EValue::Assign:
		return Assign(Node);
	case EValue::Modify:
		return Modify(Node);
	case EValue::Step:
		return StepOf(Node);
	case EValue::Zero:
		return CountScalars(Node.Type) == 0 ? 0 : Module.Null(TypeOf(Node.Type));
	case EValue::Call:
		return Call(Node);
	case EValue::Intrinsic:
		return Intrinsic(Node);
	case EValue::Method:
		return Method(Node);
	case EValue::Comma:
		Value(*Node.Operands[0]);
		return Value(*Node.Operands[1]);
	case EValue::Select:
	{
		const uint32_t Condition = Value(*Node.Operands[0]);
		const uint32_t A = Value(*Node.Operands[1]);
		const uint32_t B = Value(*Node.Operands[2]);
		const FType* const Of = Node.Operands[0]->Type;
		return Of->IsScalar()
				   ? Choose(Condition, Node.Type, A, B)
				   : ByRows(Node.Type, {{Condition, Of}, {A, Node.Type}, {B, Node.Type}},
						 [this](const FType* Row, const FWords& Ids) { return Op(OpSelect, TypeOf(Row), Ids); });
	}
	case EValue::Convert:
	case EValue::Cast:
	case EValue::Compose:
	{
		std::vector<FPart> Parts;
		for (const FValue* const Operand : Node.Operands)
		{
			Parts.push_back({Value(*Operand), Operand->Type});
		}
		if (Node.Kind == EValue::Cast && CountScalars(Parts[0].Type) == 1) // goes to all
		{
			Parts.resize(CountScalars(Node.Type), FPart(Parts[0]));
		}
		return Node.Kind == EValue::Convert ? Convert(Parts[0].Id, Parts[0].Type, Node.Type) : Build(Node.Type, Parts);
	}
	case EValue::String:
		break;
	}
	Fail(Node.Place, "a text is not a value here");
}

/** A part of a value that lies nowhere: a result, a constant. */
uint32_t FEmitter::PartOf(const FValue& Node)
{
	const FValue& Whole = *Node.Operands[0];
	const FType* const Of = Whole.Type;
	if (Node.Kind == EValue::Index)
	{
		const bool bVector = Of->IsNumeric() && !Of->IsMatrix();
		const uint32_t Id = Value(Whole);
		if (Node.Operands[1]->Kind != EValue::Constant)
		{
			const uint32_t At = Value(*Node.Operands[1]);
			return Of->Columns == 1 ? Id : Op(OpVectorExtractDynamic, TypeOf(Node.Type), {Id, At});
		}
		const uint32_t Number = uint32_t(Node.Operands[1]->Constant.at(0));
		const uint32_t Count = Of->IsArray() ? Of->Count : Of->IsMatrix() ? Of->Rows : Of->Columns;
		const bool bOnly = bVector && Count == 1;
		return bOnly ? Id : ExtractAt(Id, TypeOf(Node.Type), {std::min(Number, std::max(Count, 1u) - 1)});
	}
	const uint32_t Id = Value(Whole);
	if (Node.Kind == EValue::Member)
	{
		return ExtractAt(Id, TypeOf(Node.Type), {MemberIndex(*Of->Struct, Node.Index)});
	}
	if (Node.Kind == EValue::Swizzle)
	{
		return Shuffle(Id, Of->Scalar, Of->Columns, Node.Parts);
	}
	FWords Scalars;
	for (const uint8_t Part : Node.Parts)
	{
		Scalars.push_back(Extract(Id, Of, uint32_t(Part / 4) * Of->Columns + Part % 4));
	}
	return Scalars.size() == 1 ? Scalars[0] : Construct(TypeOf(Node.Type), Scalars);
}

uint32_t FEmitter::Negate(std::string_view Operator, const FType* Type, uint32_t A)
{
	const ENumber Kind = KindOf(Type->Scalar);
	const uint16_t Opcode = Operator == "!"         ? OpLogicalNot
							: Operator == "~"       ? OpNot
							: Kind == ENumber::Real ? OpFNegate
													: OpSNegate;
	return Operator == "+" ? A
						   : ByRows(Type, {{A, Type}},
								 [&](const FType* Row, const FWords& Ids) { return Op(Opcode, TypeOf(Row), Ids); });
}

/** Type: of both sides but for shifts, whose right side is of type Count. */
uint32_t FEmitter::Arithmetic(std::string_view Operator, const FType* Type, uint32_t A, uint32_t B, const FType* Count)
{
	const FEmitOperator* const Row = FindEmitOperator(Operator);
	const ENumber Kind = KindOf(Type->Scalar);
	const uint16_t Opcode = !Row                        ? uint16_t(0)
							: Kind == ENumber::Bool     ? Row->Bool
							: Kind == ENumber::Signed   ? Row->Signed
							: Kind == ENumber::Unsigned ? Row->Unsigned
														: Row->Real;
	if (Opcode == 0)
	{
		if (Kind == ENumber::Bool && Row && Row->Signed)
		{
			const FType* const Ints = Types.WithScalar(Type, EScalar::Int);
			return Arithmetic(Operator, Ints, Convert(A, Type, Ints), Convert(B, Type, Ints), Ints);
		}
		Fail(Current, "the operator " + std::string(Operator) + " has no meaning for " + GetName(Type));
	}
	const bool bShift = Operator == "<<" || Operator == ">>";
	const FType* const Result = Row->bCompares ? Types.WithScalar(Type, EScalar::Bool) : Type;
	return ByRows(Result, {{A, Type}, {B, Count}},
		[&](const FType* Part, const FWords& Ids)
		{
			FWords Operands = Ids;
			if (bShift) // a shift takes the low bits of its count
			{
				const uint32_t Width = Bits(Type->Scalar);
				const uint32_t CountType = VectorOf(Count->Scalar, Part->Columns);
				uint32_t Known = 0;
				const uint32_t Mask = ScalarConstant(Count->Scalar, Width - 1);
				Operands[1] =
					Module.FindNumber(Ids[1], Known) && Known < Width
						? Ids[1]
						: Op(OpBitwiseAnd, CountType, {Ids[1], Splat(Mask, ScalarType(Count->Scalar), Part->Columns)});
			}
			return Op(Opcode, TypeOf(Part), Operands);
		});
}

uint32_t FEmitter::Operate(const FValue& Node)
{
	const FValue* Left = Node.Operands[0];
	const FValue* Right = Node.Operands[1];
	const FType* const Type = Left->Type;
	const bool bScales = Node.Operator == "*" && Type->IsVector() && Type->Columns > 1 && IsReal(Type->Scalar);
	if (bScales && (FindSplat(*Left) || FindSplat(*Right)))
	{
		const bool bRight = FindSplat(*Right) != nullptr;
		const FValue& Factor = *FindSplat(bRight ? *Right : *Left);
		const auto Scale = [&]
		{
			return Convert(Value(Factor), Factor.Type, Types.Scalar(Type->Scalar));
		};
		const uint32_t First = bRight ? Value(*Left) : Scale();
		const uint32_t Second = bRight ? Scale() : Value(*Right);
		return Op(OpVectorTimesScalar, TypeOf(Type), {bRight ? First : Second, bRight ? Second : First});
	}
	const uint32_t A = Value(*Left);
	const uint32_t B = Value(*Right);
	return Arithmetic(Node.Operator, Type, A, B, Right->Type);
}

uint32_t FEmitter::Choose(uint32_t Condition, const FType* Type, uint32_t A, uint32_t B)
{
	return ByRows(Type, {{A, Type}, {B, Type}},
		[&](const FType* Row, const FWords& Ids) {
			return Op(OpSelect, TypeOf(Row), {Splat(Condition, Module.Bool(), Row->Columns), Ids[0], Ids[1]});
		});
}

/** Whether it costs little and nobody can tell whether it was computed. */
bool FEmitter::IsFree(const FValue& Node, int& Budget) const
{
	if (--Budget < 0)
	{
		return false;
	}
	switch (Node.Kind)
	{
	case EValue::Constant:
		return true;
	case EValue::Variable:
		return true;
	case EValue::Index:
		if (Node.Operands[1]->Kind != EValue::Constant)
		{
			return false;
		}
		break;
	case EValue::Binary:
		if ((Node.Operator == "/" || Node.Operator == "%") && !IsReal(Node.Type->Scalar))
		{
			return false;
		}
		break;
	case EValue::Member:
	case EValue::Swizzle:
	case EValue::Elements:
	case EValue::Unary:
	case EValue::And:
	case EValue::Or:
	case EValue::Choose:
	case EValue::Select:
	case EValue::Convert:
	case EValue::Compose:
	case EValue::Zero:
		break;
	case EValue::Intrinsic:
		if (Node.Name != "min" && Node.Name != "max" && Node.Name != "abs" && Node.Name != "saturate" &&
			Node.Name != "clamp" && Node.Name != "floor")
		{
			return false;
		}
		break;
	default:
		return false;
	}
	return std::ranges::all_of(Node.Operands, [&](const FValue* Operand) { return IsFree(*Operand, Budget); });
}

/** &&, || and ?:. A side that may have an effect or costs much is a branch. */
uint32_t FEmitter::ShortCircuit(const FValue& Node)
{
	int Budget = EmitFreeBudget;
	const bool bNumbers = CountScalars(Node.Type) > 0;
	const uint32_t Condition = Value(*Node.Operands[0]);
	const FValue& First = *Node.Operands[1];
	if (Node.Kind != EValue::Choose)
	{
		const bool bAnd = Node.Kind == EValue::And;
		if (IsFree(First, Budget))
		{
			return Op(bAnd ? OpLogicalAnd : OpLogicalOr, Module.Bool(), {Condition, Value(First)});
		}
		const uint32_t Result = Temporary(Module.Bool());
		Do(OpStore, {Result, Condition});
		If(bAnd ? Condition : Op(OpLogicalNot, Module.Bool(), {Condition}),
			[&]
			{
				const uint32_t Right = Value(First);
				Do(OpStore, {Result, Right});
			});
		return Op(OpLoad, Module.Bool(), {Result});
	}
	const FValue& Second = *Node.Operands[2];
	if (Node.Type->IsNumeric() && IsFree(First, Budget) && IsFree(Second, Budget))
	{
		const uint32_t A = Value(First);
		return Choose(Condition, Node.Type, A, Value(Second));
	}
	const uint32_t Result = bNumbers ? Temporary(TypeOf(Node.Type)) : 0;
	const auto Side = [&](const FValue& Of)
	{
		const uint32_t Id = Value(Of);
		if (Result)
		{
			Do(OpStore, {Result, Id});
		}
	};
	If(
		Condition, [&] { Side(First); }, [&] { Side(Second); });
	return Result ? Op(OpLoad, TypeOf(Node.Type), {Result}) : 0;
}

uint32_t FEmitter::Assign(const FValue& Node)
{
	const FValue& Target = *Node.Operands[0];
	const FValue& From = *Node.Operands[1];
	FObjects Found;
	const uint32_t Id = Both(From, Found);
	if (HasObject(Target.Type))
	{
		StoreObjects(SlotsOf(Target, true), Found);
	}
	if (Id)
	{
		Store(Place(Target), Id);
	}
	return Id;
}

uint32_t FEmitter::Modify(const FValue& Node)
{
	const bool bShift = Node.Operator.starts_with("<<") || Node.Operator.starts_with(">>");
	const std::string_view Operator =
		Node.Operator.ends_with("=") ? Node.Operator.substr(0, Node.Operator.size() - 1) : Node.Operator;
	const FValue& Right = *Node.Operands[1];
	const FType* const Type = Node.Operands[0]->Type;
	const FType* const Of = bShift ? Type : Right.Type;
	const FValue* const Factor = FindSplat(Right);
	const bool bScales = Operator == "*" && Factor && Of->Columns > 1 && IsReal(Of->Scalar);
	const uint32_t B = bScales ? Convert(Value(*Factor), Factor->Type, Types.Scalar(Of->Scalar)) : Value(Right);
	const FTarget Target = Place(*Node.Operands[0]);
	const uint32_t A = Convert(Load(Target), Type, Of);
	const uint32_t Result =
		bScales ? Op(OpVectorTimesScalar, TypeOf(Of), {A, B}) : Arithmetic(Operator, Of, A, B, Right.Type);
	const uint32_t Id = Convert(Result, Of, Type);
	Store(Target, Id);
	return Id;
}

uint32_t FEmitter::StepOf(const FValue& Node)
{
	const FTarget Target = Place(*Node.Operands[0]);
	const FType* const Type = Node.Type;
	const uint32_t Before = Load(Target);
	const bool bReal = IsReal(Type->Scalar);
	const uint32_t One = bReal ? RealConstant(Type->Scalar, 1) : ScalarConstant(Type->Scalar, 1);
	const uint32_t After = ByRows(Type, {{Before, Type}},
		[&](const FType* Row, const FWords& Ids)
		{
			const uint32_t Ones = Splat(One, ScalarType(Row->Scalar), Row->Columns);
			return Arithmetic(Node.Operator.substr(0, 1), Row, Ids[0], Ones, Row);
		});
	Store(Target, After);
	return Node.bPostfix ? Before : After;
}

} // namespace Drydock::Hlsl
