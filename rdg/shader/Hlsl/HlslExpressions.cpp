// Expressions: literals, names, casts, and which file analyses the rest.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

/** "A::B" as it is written. */
std::string JoinName(const FName& Name)
{
	std::string Result = Name.bGlobal ? "::" : "";
	for (const FNamePart& Part : Name.Parts)
	{
		Result += (&Part == &Name.Parts[0] ? "" : "::") + std::string(Part.Text);
	}
	return Result;
}

} // namespace

FValue* FAnalyser::Analyse(const FExpression& Tree)
{
	const FLevel Level(Depth);
	if (Depth > MaxValueDepth)
	{
		return Fail(Tree.Place, "an expression is nested more than " + std::to_string(MaxValueDepth) +
									" levels, with the constants that it names; split it");
	}
	return AnalyseKind(Tree);
}

FValue* FAnalyser::AnalyseKind(const FExpression& Tree)
{
	switch (Tree.Kind)
	{
	case EExpression::Number:
		return AnalyseNumber(Tree);
	case EExpression::Boolean:
		return MakeConstant(Types->Scalar(EScalar::Bool), {Tree.Text == "true" ? 1u : 0u}, Tree.Place);
	case EExpression::String:
	{
		FValue* const Value = Make(EValue::String, Types->String(), Tree.Place);
		Value->Text = std::string(Tree.Text);
		return Value;
	}
	case EExpression::Name:
		return AnalyseName(Tree);
	case EExpression::This:
		return AnalyseThis(Tree.Place);
	case EExpression::Unary:
		return Tree.Text == "++" || Tree.Text == "--" ? AnalyseStep(Tree, false) : AnalyseUnary(Tree);
	case EExpression::Postfix:
		return AnalyseStep(Tree, true);
	case EExpression::Binary:
		return AnalyseBinary(Tree);
	case EExpression::Assign:
		return AnalyseAssign(Tree);
	case EExpression::Conditional:
		return AnalyseConditional(Tree);
	case EExpression::Comma:
	{
		FValue* const Left = Settle(Analyse(*Tree.Operands[0]));
		FValue* const Right = Analyse(*Tree.Operands[1]);
		if (IsError(Left) || IsError(Right))
		{
			return MakeError(Tree.Place);
		}
		FValue* const Result = Make(EValue::Comma, Right->Type, Tree.Place, {Left, Right});
		Result->bPlace = Right->bPlace;
		Result->bConst = Right->bConst;
		return Simplify(Result);
	}
	case EExpression::Call:
		return AnalyseCall(Tree);
	case EExpression::Member:
		return AnalyseMember(Tree);
	case EExpression::Index:
		return AnalyseIndex(Tree);
	case EExpression::Cast:
		return AnalyseCast(Tree);
	case EExpression::Construct:
	{
		const FType* const Type = FindType(*Tree.Type, 0);
		FArguments Arguments = AnalyseArguments(Tree, 0);
		return MakeConstructor(Type, Arguments, Tree.Place);
	}
	case EExpression::List:
		return Fail(Tree.Place,
			"X3000: a list in braces can stand only where a variable gets its first value, or as an "
			"argument; write float4(...)");
	case EExpression::SizeOf:
		return AnalyseSizeOf(Tree);
	}
	return MakeError(Tree.Place);
}

FValue* FAnalyser::AnalyseNumber(const FExpression& Tree)
{
	std::string Why;
	std::optional<FNumber> Number = ReadNumber(Tree.Text, Why, Types->HasRealHalf());
	if (Number && Number->Scalar == EScalar::LiteralFloat && Options.bFloatLiterals)
	{
		Number = ReadNumber(std::string(Tree.Text) + "f", Why);
	}
	return Number ? MakeConstant(Types->Scalar(Number->Scalar), {Number->Bits}, Tree.Place) : Fail(Tree.Place, Why);
}

FValue* FAnalyser::AnalyseName(const FExpression& Tree)
{
	FNameScope* Where = nullptr;
	FSymbol* const Symbol = FindQualified(Tree.Name, &Where);
	return Symbol ? MakeNamed(*Symbol, Where, Tree) : FailName(Tree.Name, Tree.Place);
}

FValue* FAnalyser::MakeNamed(FSymbol& Symbol, FNameScope* Where, const FExpression& Tree)
{
	const std::string Name(Symbol.Name);
	switch (Symbol.Kind)
	{
	case ESymbol::Variable:
	{
		FVariable* const Variable = FindGlobal(Symbol);
		if (!Variable)
		{
			return MakeError(Tree.Place);
		}
		const bool bLocal = Variable->Storage == EStorage::Local || Variable->Storage == EStorage::Parameter;
		if (bLocal && (Here.bStatic || Symbol.Scope->Function != Here.Function))
		{
			return Fail(Tree.Place, "X3011: '" + Name +
										"' is a local variable, which cannot be read here: static variables get their "
										"first value before the entry is run");
		}
		return MakeVariable(*Variable, Tree.Place);
	}
	case ESymbol::Field:
	{
		const FStructInfo* Info = Here.This ? GetInfo(Here.This->Type) : nullptr;
		while (Info && Info->Scope != Where)
		{
			Info = Info->Base;
		}
		return Info ? MakeField(AnalyseThis(Tree.Place), Symbol, Tree.Place)
					: Fail(Tree.Place,
						  "X3004: '" + Name + "' is a member of a struct; name the variable whose member it is");
	}
	case ESymbol::Enumerator:
	{
		if (Symbol.Value)
		{
			FValue* const Value = Make(EValue::Constant, Symbol.Value->Type, Tree.Place);
			Value->Constant = Symbol.Value->Constant;
			return Value;
		}
		const FType* const Type = CompleteEnum(*Symbol.Owner);
		const auto Found = Symbol.Owner->Inner->Symbols.find(Symbol.Name);
		const bool bKnown = Found != Symbol.Owner->Inner->Symbols.end() && Found->second.Value;
		return bKnown ? MakeConstant(Type, Found->second.Value->Constant, Tree.Place)
					  : Fail(Tree.Place, "X3004: '" + Name + "' is not known yet");
	}
	case ESymbol::Functions:
		return Fail(Tree.Place, "X3005: '" + Name + "' is a function; call it with ()");
	case ESymbol::Namespace:
		return Fail(Tree.Place, "X3004: '" + Name + "' is a namespace and no value");
	default:
		return Fail(Tree.Place, "X3004: '" + Name + "' is a type and no value");
	}
}

FValue* FAnalyser::FailName(const FName& Name, const FPlace& Place)
{
	const std::string Last(Name.Last());
	if (Name.Parts.size() > 1)
	{
		FName Owner = Name;
		Owner.Parts.pop_back();
		FSymbol* const Symbol = FindQualified(Owner);
		FNameScope* const Scope = Symbol ? FindScopeOf(*Symbol, Owner.Parts.back()) : nullptr;
		std::vector<std::string> Known;
		for (const auto& [Each, Ignored] : Scope ? Scope->Symbols : std::unordered_map<std::string_view, FSymbol>())
		{
			Known.emplace_back(Each);
		}
		std::ranges::sort(Known);
		return Fail(Place, Scope ? "X3018: '" + JoinName(Owner) + "' has no '" + Last + "'" + SuggestName(Last, Known)
								 : "X3004: undeclared identifier '" + JoinName(Symbol ? Name : Owner) + "'");
	}
	for (const FNameScope* Scope = Here.Scope; Scope; Scope = Scope->Parent)
	{
		if (const auto Later = Scope->Symbols.find(Last); Later != Scope->Symbols.end())
		{
			return Fail(Place, "X3004: undeclared identifier '" + Last + "': line " +
								   std::to_string(Later->second.Place.Line) + ", behind this one, declares it");
		}
	}
	if (Last == "ResourceDescriptorHeap" || Last == "SamplerDescriptorHeap")
	{
		return Fail(Place, "'" + Last +
							   "' does not run on the CPU tier: a pass binds its resources by name; declare one as a "
							   "parameter of the shader");
	}
	std::vector<std::string> Known = ListNames(false, false);
	std::string Suggestion = SuggestName(Last, Known);
	for (const auto& [Buffer, Members] : Options.UniformBuffers)
	{
		if (Buffer == Last)
		{
			Suggestion = ", which is a uniform buffer; write " + Buffer + ".Member";
		}
	}
	return Fail(Place, "X3004: undeclared identifier '" + Last + "'" + Suggestion);
}

FValue* FAnalyser::AnalyseThis(const FPlace& Place)
{
	if (!Here.This)
	{
		return Fail(Place, "X3004: 'this' is known only in methods that are not static");
	}
	return MakeVariable(*Here.This, Place);
}

FValue* FAnalyser::AnalyseCast(const FExpression& Tree)
{
	const FType* const Type = FindType(*Tree.Type, 0);
	FValue* const Value = Analyse(*Tree.Operands[0]);
	if (Type->Kind == EType::Void && !IsError(Value))
	{
		return Make(EValue::Comma, Type, Tree.Place, {Settle(Value), Make(EValue::Zero, Type, Tree.Place)});
	}
	FValue* const Result = Convert(Value, Type, true);
	if (Result != Value || !Value->bPlace)
	{
		return Result;
	}
	FValue* const Copy = Make(EValue::Convert, Type, Tree.Place, {Value}); // a value and no place
	return Type->IsNumeric() ? Copy : Value;
}

FValue* FAnalyser::AnalyseSizeOf(const FExpression& Tree)
{
	const FType* Type = nullptr;
	if (Tree.Type)
	{
		Type = FindType(*Tree.Type, 0);
	}
	else
	{
		FValue* const Value = Settle(Analyse(*Tree.Operands[0]));
		Type = Value->Type;
	}
	if (Type->Kind == EType::Error)
	{
		return MakeError(Tree.Place);
	}
	if (HasObject(Type) || Type->Kind == EType::Void || Type->Kind == EType::String)
	{
		return Fail(Tree.Place, "X3000: '" + GetName(Type) + "' has no size");
	}
	return MakeConstant(Types->Scalar(EScalar::Uint), {GetLayout(*Types, Type, ELayout::Structured).Size}, Tree.Place);
}

} // namespace Drydock::Hlsl
