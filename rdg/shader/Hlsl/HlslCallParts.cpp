// The parts of a call: arguments, those that the declaration gives, the function for the type of the object.
#include "HlslAnalysisImpl.h"

namespace Drydock::Hlsl
{

bool FAnalyser::IsDerived(const FType* Type, const FType* Base)
{
	return Type->IsStruct() && Base->IsStruct() && Type != Base && FindConversion(*Types, Type, Base).bPossible;
}

/** The members of a base, one by one. */
void FAnalyser::CopyMembers(FValue* To, FValue* From, const FType* Base, std::vector<FValue*>& Steps)
{
	for (size_t i = 0; i < Base->Struct->Members.size(); ++i)
	{
		FSymbol Field;
		Field.Index = uint32_t(i);
		FValue* const Target = MakeField(To, Field, To->Place);
		Steps.push_back(Make(EValue::Assign, Target->Type, To->Place, {Target, MakeField(From, Field, To->Place)}));
	}
}

/** A struct where its base is written to. */
FValue* FAnalyser::MakeBaseArgument(
	const FParameterType& Parameter, FValue* Value, std::vector<FValue*>& Before, std::vector<FValue*>& After)
{
	FVariable* const Temporary = MakeTemporary(Parameter.Type, Value->Place);
	FValue* const Copy = MakeVariable(*Temporary, Value->Place);
	if (Parameter.bIn)
	{
		Before.push_back(Make(EValue::Assign, Parameter.Type, Value->Place, {Copy, Convert(Value, Parameter.Type)}));
	}
	CopyMembers(Value, Copy, Parameter.Type, After);
	return Copy;
}

FValue* FAnalyser::MakeArgument(
	FOverload& Overload, size_t Index, FValue* Value, std::vector<FValue*>& Before, std::vector<FValue*>& After)
{
	const FParameterType& Parameter = Overload.Parameters[Index];
	if (!Parameter.bOut)
	{
		return Convert(Value, Parameter.Type);
	}
	const std::string What = "argument " + std::to_string(Index + 1) + (Parameter.bIn ? " (inout)" : " (out)");
	const bool bBase = Value->Kind == EValue::Cast && IsDerived(Value->Operands[0]->Type, Value->Type);
	Value = bBase ? Value->Operands[0] : Uncast(Value);
	if (!RequirePlace(Value, What))
	{
		return MakeError(Value->Place);
	}
	if (IsDerived(Value->Type, Parameter.Type))
	{
		return MakeBaseArgument(Parameter, Value, Before, After);
	}
	const bool bIn = !Parameter.bIn || FindConversion(*Types, Value->Type, Parameter.Type).bPossible;
	const FConversion Back = FindConversion(*Types, Parameter.Type, Value->Type);
	if (!bIn || !Back.bPossible)
	{
		return Fail(Value->Place, "X3017: " + What + " cannot be converted from '" +
									  GetName(bIn ? Parameter.Type : Value->Type) + "' to '" +
									  GetName(bIn ? Value->Type : Parameter.Type) + "'");
	}
	if (Back.bTruncates)
	{
		Warn(Value->Place, "X3206: implicit truncation of '" + GetName(Parameter.Type) + "' to '" +
							   GetName(Value->Type) + "' by " + What);
	}
	return Value;
}

FValue* FAnalyser::MakeCall(FOverload& Overload, FValue* Object, const FArguments& Arguments, const FPlace& Place)
{
	const FDeclaration& Declaration = *Overload.Declaration;
	if (!Declaration.Body)
	{
		return Fail(Place, "X3004: '" + std::string(Declaration.Name.Last()) + "' is declared in line " +
							   std::to_string(Declaration.Place.Line) + ", but nothing defines it: it has no body");
	}
	std::vector<FValue*> Before;
	std::vector<FValue*> After;
	FValue* const Call = Make(EValue::Call, Overload.Result, Place);
	if (Object)
	{
		if (!Object->bPlace || Object->bConst)
		{
			FVariable* const Copy = MakeTemporary(Object->Type, Place);
			Before.push_back(Make(EValue::Assign, Object->Type, Place, {MakeVariable(*Copy, Place), Object}));
			Object = MakeVariable(*Copy, Place);
		}
		else if (!Declaration.bConstMethod)
		{
			MarkWritten(Object);
		}
		Call->Operands.push_back(Object);
	}
	const FType* const This = Object ? Object->Type : nullptr;
	for (size_t i = 0; i < Overload.Parameters.size(); ++i)
	{
		FValue* Value = nullptr;
		if (i < Arguments.Values.size() && Arguments.Values[i])
		{
			Value = MakeArgument(Overload, i, Arguments.Values[i], Before, After);
		}
		else if (i < Arguments.Values.size())
		{
			Value = Initialise(Overload.Parameters[i].Type, *Arguments.Trees[i]);
		}
		else
		{
			FPosition Position = Here;
			Position.Scope = Overload.Scope;
			Position.Order = std::max(Overload.BodyOrder, Overload.Struct ? Overload.Struct->Order : 0u);
			const FPositionGuard Guard(*this, Position);
			Value = Overload.Defaults[i] ? Initialise(Overload.Parameters[i].Type, *Overload.Defaults[i]->Value)
										 : MakeError(Place);
		}
		if (IsError(Value))
		{
			return MakeError(Place);
		}
		Call->Operands.push_back(Value);
	}
	Call->Function = Require(Overload, This);
	Calls[Here.Function].emplace_back(Call->Function, Place);
	return MakeSequence(std::move(Before), Call, After);
}

/** The function of an overload; a method's for the type of its object, which may be derived. */
FFunction* FAnalyser::Require(FOverload& Overload, const FType* This)
{
	FFunction*& Function = Overload.Made[This];
	if (Function)
	{
		return Function;
	}
	const FDeclaration& Declaration = *Overload.Declaration;
	Function = Program->Make<FFunction>();
	const FNameScope* Named = Overload.Scope;
	while (Named->Kind == EScopeKind::Template && Named->Parent)
	{
		Named = Named->Parent;
	}
	const std::string Own = Declaration.Operator.empty() ? std::string(Declaration.Name.Last())
														 : "operator" + std::string(Declaration.Operator);
	Function->Name = Named->Prefix + Own + Overload.Arguments;
	Function->Place = Declaration.Place;
	Function->Result = Overload.Result;
	Function->bPrecise = (Declaration.Modifiers & ModifierPrecise) != 0;
	if (This)
	{
		FVariable* const Object = Program->Make<FVariable>();
		Object->Name = "this";
		Object->Type = This;
		Object->Storage = EStorage::This;
		Object->Place = Declaration.Place;
		Object->Modifiers = ModifierIn | (Declaration.bConstMethod ? ModifierConst : ModifierOut);
		Function->bMethod = true;
		Function->Parameters.push_back(Object);
	}
	AddParameters(*Function, Overload, false);
	Work.emplace_back(Function, &Overload);
	return Function;
}

} // namespace Drydock::Hlsl
