// Local variables: their scope, their first value, and those that are static.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

void FAnalyser::AnalyseLocal(const FDeclaration& Declaration, std::vector<FCode*>& Code)
{
	switch (Declaration.Kind)
	{
	case EDeclaration::Variable:
		AnalyseLocalVariable(Declaration, Code);
		break;
	case EDeclaration::Assert:
		CheckAssert(Declaration);
		break;
	case EDeclaration::Function: // a prototype: what is defined later can be called from here on
		if (const auto Found = File->Symbols.find(Declaration.Name.Last()); Found != File->Symbols.end())
		{
			Found->second.Order = std::min(Found->second.Order, Here.Order);
			for (FOverload* Overload : Found->second.Overloads)
			{
				Overload->Order = std::min(Overload->Order, Here.Order);
			}
		}
		break;
	default:
		EnterOne(Declaration, *Here.Scope, nullptr);
		break;
	}
}

void FAnalyser::AnalyseLocalVariable(const FDeclaration& Declaration, std::vector<FCode*>& Code)
{
	EnterType(Declaration.Type, *Here.Scope);
	FVariable& Variable = *Program->Make<FVariable>();
	Variable.Name = std::string(Declaration.Name.Last());
	Variable.Place = Declaration.Place;
	Variable.Modifiers = Declaration.Modifiers | Declaration.Type->Modifiers;
	Variable.ResourceName = Variable.Name;
	Variable.Type = FindDeclaredType(Declaration);
	if (FSymbol* const Symbol = Add(*Here.Scope, Declaration.Name.Last(), ESymbol::Variable, Declaration.Place))
	{
		Symbol->Variable = &Variable;
		Symbol->Declaration = &Declaration;
	}
	if (!Declaration.Annotations.empty())
	{
		Error(
			Declaration.Annotations[0].Place, "X3043: '" + Variable.Name + "': local variables cannot have semantics");
	}
	InitialiseLocal(Declaration, Variable, Code);
	if (Variable.Type->IsArray() && Variable.Type->Count == 0)
	{
		Error(Variable.Place, "X3072: '" + Variable.Name + "': the size of an array must be given");
		Variable.Type = Types->Error();
	}
}

/** A static local gets its first value when it is first come to. */
FCode* FAnalyser::MakeFirstTime(FVariable& Variable, FCode& First)
{
	const FType* const Bool = Types->Scalar(EScalar::Bool);
	FVariable& Done = *Program->Make<FVariable>();
	Done.Name = Variable.Name + "_initialised";
	Done.Type = Bool;
	Done.Place = Variable.Place;
	Done.Storage = EStorage::Static;
	Done.Initializer = MakeConstant(Bool, {0}, Variable.Place);
	Done.bWritten = true;
	Statics.push_back({Here.Order, &Done});
	const auto AddAssign = [&](FVariable& To, FValue* Value)
	{
		FCode* const Step = MakeCode(EStep::Value, Variable.Place);
		Step->Value = Make(EValue::Assign, To.Type, Variable.Place, {MakeVariable(To, Variable.Place), Value});
		First.Body.push_back(Step);
	};
	AddAssign(Variable, Variable.Initializer);
	AddAssign(Done, MakeConstant(Bool, {1}, Variable.Place));
	Variable.Initializer = nullptr;
	Variable.bWritten = true;
	FCode* const If = MakeCode(EStep::If, Variable.Place);
	If->Value = Make(EValue::Unary, Bool, Variable.Place, {MakeVariable(Done, Variable.Place)});
	If->Value->Operator = "!";
	If->Body.push_back(&First);
	return If;
}

void FAnalyser::InitialiseLocal(const FDeclaration& Declaration, FVariable& Variable, std::vector<FCode*>& Code)
{
	const bool bStatic = (Variable.Modifiers & ModifierStatic) != 0;
	const bool bConst = (Variable.Modifiers & ModifierConst) != 0;
	FValue* Value = nullptr;
	if (Declaration.Value)
	{
		FPosition Position = Here;
		FCode* const First = bStatic ? MakeCode(EStep::Block, Declaration.Place) : nullptr;
		Position.Code = bStatic ? &First->Body : Here.Code;
		const FPositionGuard Guard(*this, Position);
		Value = Initialise(Variable.Type, *Declaration.Value);
		Variable.Type = Variable.Type->Kind == EType::Error ? Variable.Type : Value->Type;
		Variable.Initializer = Value;
		SetConstant(Variable);
		if (bStatic && !IsError(Value) && !IsKnown(*Value))
		{
			Code.push_back(MakeFirstTime(Variable, *First));
		}
	}
	else if (bConst && !bStatic && Variable.Type->Kind != EType::Error)
	{
		Error(Variable.Place, "X3012: '" + Variable.Name + "': missing initial value of a const variable");
	}
	if (bStatic)
	{
		Variable.Storage = EStorage::Static;
		Statics.push_back({Here.Order, &Variable});
		return;
	}
	FCode* const Step = MakeCode(EStep::Variable, Declaration.Place);
	Step->Variable = &Variable;
	Step->Value = Value;
	Code.push_back(Step);
	if (Value && Variable.Modifiers & ModifierPrecise && !IsError(Value))
	{
		MarkPrecise(Value);
	}
}

} // namespace Drydock::Hlsl
