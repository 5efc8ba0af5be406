// Calls of the text's own functions and methods: which overload is meant, its arguments, its body.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

bool IsStaticMethod(const FOverload& Overload)
{
	return (Overload.Declaration->Modifiers & ModifierStatic) != 0;
}

} // namespace

FArguments FAnalyser::AnalyseArguments(const FExpression& Tree, size_t First)
{
	FArguments Arguments;
	for (size_t i = First; i < Tree.Operands.size(); ++i)
	{
		const FExpression* const Each = Tree.Operands[i];
		Arguments.Values.push_back(Each->Kind == EExpression::List ? nullptr : Analyse(*Each));
		Arguments.Trees.push_back(Each);
		Arguments.bBad = Arguments.bBad || (Arguments.Values.back() && IsError(Arguments.Values.back()));
	}
	return Arguments;
}

FValue* FAnalyser::AnalyseCall(const FExpression& Tree)
{
	const FExpression& Callee = *Tree.Operands[0];
	if (Callee.Kind == EExpression::Name)
	{
		return CallName(Tree);
	}
	if (Callee.Kind == EExpression::Member)
	{
		return CallMember(Tree);
	}
	FValue* const Object = Analyse(Callee);
	FArguments Arguments = AnalyseArguments(Tree, 1);
	if (IsError(Object) || Arguments.bBad)
	{
		return MakeError(Tree.Place);
	}
	return Object->Type->IsStruct() ? CallOperator("()", Object, Arguments.Values, Tree.Place)
									: Fail(Tree.Place, "X3005: what stands before ( is a value of '" +
														   GetName(Object->Type) + "' and no function");
}

FValue* FAnalyser::CallName(const FExpression& Tree)
{
	const FName& Name = Tree.Operands[0]->Name;
	const FPlace& Place = Tree.Operands[0]->Place;
	FNameScope* Where = nullptr;
	FSymbol* const Symbol = FindQualified(Name, &Where);
	FArguments Arguments = AnalyseArguments(Tree, 1);
	if (Symbol)
	{
		return CallSymbol(Tree, *Symbol, Where, Arguments);
	}
	const std::string Last(Name.Last());
	if (Name.Parts.size() == 1)
	{
		if (IsIntrinsic(Last))
		{
			return Arguments.bBad ? MakeError(Place) : CallIntrinsic(Name.Last(), Arguments, Place);
		}
		FTypeName Type;
		Type.Place = Place;
		Type.Name = Name;
		if (const FType* const Found = FindBuiltInType(Type, EOrder::Row))
		{
			return MakeConstructor(Found, Arguments, Place);
		}
		std::vector<std::string> Known = ListNames(true, false);
		const std::vector<std::string> Intrinsics = ListIntrinsics();
		Known.insert(Known.end(), Intrinsics.begin(), Intrinsics.end());
		const bool bLater = File->Symbols.count(Name.Last()) != 0;
		const std::string Nearest = bLater ? std::string() : SuggestName(Last, Known);
		return bLater ? FailName(Name, Place)
					  : Fail(Place, "X3004: undeclared identifier '" + Last + "': there is no such function" + Nearest);
	}
	return FailName(Name, Place);
}

FValue* FAnalyser::CallSymbol(const FExpression& Tree, FSymbol& Symbol, FNameScope* Where, FArguments& Arguments)
{
	const FName& Name = Tree.Operands[0]->Name;
	const FPlace& Place = Tree.Operands[0]->Place;
	if (Symbol.Kind == ESymbol::Struct || Symbol.Kind == ESymbol::Alias || Symbol.Kind == ESymbol::Type ||
		Symbol.Kind == ESymbol::Enum)
	{
		return MakeConstructor(FindSymbolType(Symbol, Name.Parts.back()), Arguments, Place);
	}
	if (Symbol.Kind != ESymbol::Functions)
	{
		FValue* const Object = MakeNamed(Symbol, Where, *Tree.Operands[0]);
		if (IsError(Object) || Arguments.bBad)
		{
			return MakeError(Place);
		}
		return Object->Type->IsStruct()
				   ? CallOperator("()", Object, Arguments.Values, Place)
				   : Fail(Place, "X3005: '" + std::string(Symbol.Name) + "' is a variable and no function");
	}
	if (Arguments.bBad)
	{
		return MakeError(Place);
	}
	std::string Why;
	FOverload* const Overload = ChooseOpened(Symbol, Name.Parts.back(), Arguments, Why);
	const bool bIntrinsic =
		Name.Parts.size() == 1 && !Symbol.Scope->Struct && IsIntrinsic(Name.Last()) && !Name.Parts[0].bArguments;
	if (bIntrinsic)
	{
		std::vector<const FType*> Given;
		for (const FValue* Each : Arguments.Values)
		{
			Given.push_back(Each ? Each->Type : Types->Error());
		}
		const auto IsExact = [&](size_t i)
		{
			return IsSame(Overload->Parameters[i].Type, Given[i]);
		};
		bool bExact = Overload != nullptr;
		for (size_t i = 0; i < Given.size() && bExact; ++i)
		{
			bExact = IsExact(i);
		}
		const FIntrinsicCall Call = bExact ? FIntrinsicCall() : FindIntrinsicCall(*Types, Name.Last(), Given);
		const bool bFits = !bExact && Call.Error.empty();
		if (bFits && (!Overload || std::ranges::equal(Call.Parameters, Given, IsSame)))
		{
			return CallIntrinsic(Name.Last(), Arguments, Place);
		}
	}
	if (!Overload)
	{
		return Why.empty() ? MakeError(Place) : Fail(Place, Why);
	}
	if (!Overload->Struct || IsStaticMethod(*Overload))
	{
		return MakeCall(*Overload, nullptr, Arguments, Place);
	}
	const FStructInfo* Info = Here.This ? GetInfo(Here.This->Type) : nullptr;
	while (Info && Info != Overload->Struct)
	{
		Info = Info->Base;
	}
	return Info ? MakeCall(*Overload, AnalyseThis(Place), Arguments, Place)
				: Fail(Place, "X3004: '" + std::string(Symbol.Name) + "' is a method; call it of a variable of '" +
								  Overload->Struct->Name + "'");
}

FValue* FAnalyser::CallMember(const FExpression& Tree)
{
	const FExpression& Member = *Tree.Operands[0];
	FValue* Object = FindUniform(Member); // View.Texture(...) is not a call
	if (Object)
	{
		AnalyseArguments(Tree, 1);
		return IsError(Object) ? Object
							   : Fail(Member.Place,
									 "X3005: '" + std::string(Member.Name.Last()) + "' is a variable and no function");
	}
	Object = Analyse(*Member.Operands[0]);
	if (Object->Type->IsObject() && Object->Type->Object != EObject::ConstantBuffer)
	{
		return CallResource(Tree, Object);
	}
	Object = OpenConstantBuffer(Object);
	FArguments Arguments = AnalyseArguments(Tree, 1);
	if (IsError(Object) || Arguments.bBad)
	{
		return MakeError(Tree.Place);
	}
	const std::string Last(Member.Name.Last());
	if (!Object->Type->IsStruct())
	{
		return Fail(Member.Place, "X3018: '" + GetName(Object->Type) + "' has no method '" + Last + "'");
	}
	FNameScope* Where = GetInfo(Object->Type)->Scope;
	if (Member.Name.Parts.size() > 1)
	{
		FName Base = Member.Name;
		Base.Parts.pop_back();
		FSymbol* const Owner = FindQualified(Base);
		FNameScope* const Scope = Owner ? FindScopeOf(*Owner, Base.Parts.back()) : nullptr;
		Where = Scope ? Scope : Where;
	}
	FSymbol* const Symbol = FindIn(*Where, Member.Name.Last(), &Where);
	if (!Symbol)
	{
		std::vector<std::string> Known;
		for (const auto& [Name, Each] : GetInfo(Object->Type)->Scope->Symbols)
		{
			Known.emplace_back(Name);
		}
		std::ranges::sort(Known);
		return Fail(Member.Place,
			"X3018: '" + GetName(Object->Type) + "' has no method '" + Last + "'" + SuggestName(Last, Known));
	}
	if (Symbol->Kind != ESymbol::Functions)
	{
		FValue* const Field = MakeMember(Object, Member.Name, Member.Place);
		return IsError(Field)            ? Field
			   : Field->Type->IsStruct() ? CallOperator("()", Field, Arguments.Values, Tree.Place)
										 : Fail(Member.Place, "X3005: '" + Last + "' is a member and no method");
	}
	return CallMethod(Member, Object, *Symbol, Arguments);
}

FValue* FAnalyser::CallMethod(const FExpression& Tree, FValue* Object, FSymbol& Symbol, FArguments& Arguments)
{
	static const FNamePart None;
	std::string Why;
	FOverload* const Overload =
		ChooseOpened(Symbol, Tree.Name.Parts.empty() ? None : Tree.Name.Parts.back(), Arguments, Why);
	if (!Overload)
	{
		return Why.empty() ? MakeError(Tree.Place) : Fail(Tree.Place, Why);
	}
	return MakeCall(*Overload, IsStaticMethod(*Overload) ? nullptr : Object, Arguments, Tree.Place);
}

} // namespace Drydock::Hlsl
