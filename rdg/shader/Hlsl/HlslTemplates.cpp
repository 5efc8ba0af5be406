// Templates: what their arguments are, written or deduced, and an instance for each set of them.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

std::string MakeTemplateKey(const std::vector<FTemplateValue>& Values)
{
	std::string Key;
	for (const FTemplateValue& Value : Values)
	{
		Key += std::to_string(reinterpret_cast<uintptr_t>(Value.Type)) + (Value.Value ? "=" : ";");
		for (const uint64_t Bits : Value.Value ? Value.Value->Constant : FConstant())
		{
			Key += std::to_string(Bits) + ";";
		}
	}
	return Key;
}

} // namespace

/** TypeScope: where the type of a value is looked up, which an argument before may be. */
std::optional<FTemplateValue> FAnalyser::ReadArgument(
	const FTemplateArgument& Argument, const FTemplateParameter& Parameter, FNameScope* TypeScope)
{
	if (!Parameter.ValueType)
	{
		FTypeName Named;
		if (!Argument.Type && (!Argument.Value || Argument.Value->Kind != EExpression::Name))
		{
			Error(Argument.Value ? Argument.Value->Place : Parameter.Place,
				"X3000: the template's argument '" + std::string(Parameter.Name) + "' must be a type");
			return std::nullopt;
		}
		if (!Argument.Type)
		{
			Named.Place = Argument.Value->Place;
			Named.Name = Argument.Value->Name;
		}
		const FType* const Type = FindType(Argument.Type ? *Argument.Type : Named, 0);
		return Type->Kind == EType::Error ? std::nullopt : std::optional(FTemplateValue{Type, nullptr});
	}
	const FType* Type = nullptr;
	{
		FPosition Position = Here;
		Position.Scope = TypeScope ? TypeScope : Here.Scope;
		const FPositionGuard Guard(*this, Position);
		Type = FindType(*Parameter.ValueType, 0);
	}
	if (!Argument.Value || Type->Kind == EType::Error)
	{
		if (!Argument.Value)
		{
			Error(Argument.Type ? Argument.Type->Place : Parameter.Place,
				"X3000: the template's argument '" + std::string(Parameter.Name) + "' must be a value");
		}
		return std::nullopt;
	}
	FValue* const Value = Convert(Analyse(*Argument.Value), Type);
	if (IsError(Value))
	{
		return std::nullopt;
	}
	const std::optional<FConstant> Constant = Fold(*Types, *Value);
	if (!Constant || !Type->IsScalar())
	{
		Error(Argument.Value->Place,
			"X3058: the template's argument '" + std::string(Parameter.Name) + "' must be a constant expression");
		return std::nullopt;
	}
	return FTemplateValue{Type, MakeConstant(Type, *Constant, Argument.Value->Place)};
}

void FAnalyser::BindParameter(FNameScope& Scope, const FTemplateParameter& Parameter, const FTemplateValue& Value)
{
	if (Parameter.Name.empty())
	{
		return;
	}
	const ESymbol Kind = Value.Value ? ESymbol::Enumerator : ESymbol::Type;
	if (FSymbol* const Symbol = Add(Scope, Parameter.Name, Kind, Parameter.Place))
	{
		Symbol->Type = Value.Type;
		Symbol->Value = Value.Value;
	}
}

bool FAnalyser::CountInstance(const FPlace& Place)
{
	if (++NumInstances > MaxInstances)
	{
		Error(Place, "there are more than " + std::to_string(MaxInstances) + " instances of templates");
		return false;
	}
	return true;
}

bool FAnalyser::FillDefaults(FDeduction& Into, FNameScope& Scope, std::vector<FTemplateValue>& Values)
{
	const std::vector<FTemplateParameter>& Parameters = Into.Template->Template;
	for (size_t i = 0; i < Parameters.size(); ++i)
	{
		if (i < Into.NumGiven)
		{
			Values.push_back(*Into.Values[i]); // bound already
			continue;
		}
		if (!Into.Values[i] && (Parameters[i].Default.Type || Parameters[i].Default.Value))
		{
			FPosition Position = Here;
			Position.Scope = &Scope;
			const FPositionGuard Guard(*this, Position);
			Into.Values[i] = ReadArgument(Parameters[i].Default, Parameters[i], &Scope);
		}
		if (!Into.Values[i])
		{
			Into.Why = "the template argument '" + std::string(Parameters[i].Name) +
					   "' cannot be found from this call: write it between < and >";
			return false;
		}
		BindParameter(Scope, Parameters[i], *Into.Values[i]);
		Values.push_back(*Into.Values[i]);
	}
	return true;
}

bool FAnalyser::IsTypeArgument(const FTemplateArgument& Argument)
{
	if (Argument.Type || !Argument.Value || Argument.Value->Kind != EExpression::Name)
	{
		return Argument.Type != nullptr;
	}
	const FSymbol* const Symbol = FindQualified(Argument.Value->Name);
	return Symbol && (Symbol->Kind == ESymbol::Struct || Symbol->Kind == ESymbol::Enum ||
						 Symbol->Kind == ESymbol::Alias || Symbol->Kind == ESymbol::Type);
}

/** The arguments of a struct's or an alias' template, bound in Scope. */
bool FAnalyser::FindArguments(
	FSymbol& Symbol, const FNamePart& Part, FNameScope& Scope, std::vector<FTemplateValue>& Values)
{
	FDeduction Into;
	Into.Template = Symbol.Declaration;
	Into.NumGiven = Part.Arguments.size();
	if (!Into.Template) // only specializations are there
	{
		for (const FTemplateArgument& Argument : Part.Arguments)
		{
			FTypeName Int;
			Int.Name.Parts.emplace_back().Text = "int";
			FTemplateParameter Any;
			Any.Place = Part.Place;
			Any.ValueType = IsTypeArgument(Argument) ? nullptr : &Int;
			const std::optional<FTemplateValue> Value = ReadArgument(Argument, Any);
			if (!Value)
			{
				return false;
			}
			Values.push_back(*Value);
		}
		return true;
	}
	Into.Values.resize(Symbol.Declaration->Template.size());
	if (Part.Arguments.size() > Into.Values.size())
	{
		Error(Part.Place, "X3000: '" + std::string(Symbol.Name) + "' takes " + std::to_string(Into.Values.size()) +
							  " template arguments, not " + std::to_string(Part.Arguments.size()));
		return false;
	}
	for (size_t i = 0; i < Part.Arguments.size(); ++i)
	{
		Into.Values[i] = ReadArgument(Part.Arguments[i], Into.Template->Template[i], &Scope);
		if (!Into.Values[i])
		{
			return false; // and was reported
		}
		BindParameter(Scope, Into.Template->Template[i], *Into.Values[i]);
	}
	if (!FillDefaults(Into, Scope, Values))
	{
		Error(Part.Place, "X3000: the template '" + std::string(Symbol.Name) + "': " + Into.Why);
		return false;
	}
	return true;
}

FStructInfo* FAnalyser::InstantiateStruct(FSymbol& Symbol, const FNamePart& Part)
{
	FNameScope* Scope = MakeScope(EScopeKind::Template, Symbol.Scope);
	std::vector<FTemplateValue> Values;
	if (!FindArguments(Symbol, Part, *Scope, Values))
	{
		return nullptr;
	}
	const std::string Key = MakeTemplateKey(Values);
	if (const auto Known = Symbol.Instances.find(Key); Known != Symbol.Instances.end())
	{
		return Known->second;
	}
	if (!CountInstance(Part.Place))
	{
		return nullptr;
	}
	const FDeclaration* const Special = FindSpecialStruct(Symbol, Values, Scope);
	if (!Special && !Symbol.Struct)
	{
		Error(Part.Place, "X3000: the template '" + std::string(Symbol.Name) + "' is declared, and not defined for " +
							  NameTemplateArguments(Values));
		return nullptr;
	}
	const FStruct& Struct = Special ? *Special->Struct : *Symbol.Struct;
	const uint32_t Order = std::max(Symbol.Order, Here.Order);
	FStructInfo* const Info =
		MakeStruct(Struct, *Scope, std::string(Symbol.Name) + NameTemplateArguments(Values), Order);
	Info->Template = &Symbol;
	Info->Arguments = std::move(Values);
	Symbol.Instances[Key] = Info;
	if (!Special)
	{
		AddOutside(Symbol, *Info);
	}
	return Info;
}

/** Members that are defined outside of their template, whose parameters may have other names there. */
void FAnalyser::AddOutside(FSymbol& Symbol, FStructInfo& Info)
{
	for (const FDeclaration* Outside : Symbol.Outside)
	{
		const std::string_view Name =
			Outside->Operator.empty() ? Outside->Name.Last() : Keep("operator" + std::string(Outside->Operator));
		const auto Found = Info.Scope->Symbols.find(Name);
		const bool bFunction = Outside->Kind == EDeclaration::Function;
		if (Found == Info.Scope->Symbols.end() || (Found->second.Kind == ESymbol::Functions) != bFunction)
		{
			continue;
		}
		if (!bFunction)
		{
			Found->second.Definition = Outside;
			continue;
		}
		FOverload& Overload = Overloads.emplace_back();
		Overload.Declaration = Outside;
		Overload.Struct = &Info;
		Overload.Scope = MakeScope(EScopeKind::Template, Info.Scope);
		Overload.BodyOrder = NumDeclarations;
		Overload.bOutside = true;
		for (size_t i = 0; i < Outside->Template.size() && i < Info.Arguments.size(); ++i)
		{
			BindParameter(*Overload.Scope, Outside->Template[i], Info.Arguments[i]);
		}
		Found->second.Overloads.push_back(&Overload);
	}
}

const FDeclaration* FAnalyser::FindSpecialStruct(
	FSymbol& Symbol, const std::vector<FTemplateValue>& Values, FNameScope*& Scope)
{
	const FDeclaration* Best = nullptr;
	for (const FDeclaration* Special : Symbol.Special)
	{
		const std::vector<FTemplateArgument>& Patterns = Special->Name.Parts.back().Arguments;
		FDeduction Into;
		Into.Template = Special;
		Into.Values.resize(Special->Template.size());
		bool bFits = Patterns.size() <= Values.size();
		for (size_t i = 0; i < Patterns.size() && bFits; ++i)
		{
			bFits = DeduceArgument(Patterns[i], Values[i], Into);
		}
		FNameScope* const Own = MakeScope(EScopeKind::Template, Symbol.Scope);
		std::vector<FTemplateValue> Bound;
		if (bFits && FillDefaults(Into, *Own, Bound) && (!Best || Special->Template.size() < Best->Template.size()))
		{
			Best = Special;
			Scope = Own;
		}
	}
	return Best;
}

const FType* FAnalyser::InstantiateAlias(FSymbol& Symbol, const FNamePart& Part)
{
	FNameScope* const Scope = MakeScope(EScopeKind::Template, Symbol.Scope);
	std::vector<FTemplateValue> Values;
	if (!FindArguments(Symbol, Part, *Scope, Values) || !CountInstance(Part.Place))
	{
		return Types->Error();
	}
	FPosition Position = Here;
	Position.Scope = Scope;
	Position.Order = std::max(Symbol.Order, Here.Order);
	const FPositionGuard Guard(*this, Position);
	const FDeclaration& Declaration = *Symbol.Declaration;
	return AddDimensions(FindType(*Declaration.Type, Declaration.Modifiers), Declaration.Dimensions, Part.Place);
}

FOverload* FAnalyser::InstantiateFunction(FSymbol& Symbol, FOverload& Overload, const FNamePart& Part,
	const std::vector<const FType*>& Arguments, std::string& Why)
{
	const FDeclaration& Declaration = *Overload.Declaration;
	FDeduction Into;
	Into.Template = &Declaration;
	Into.Values.resize(Declaration.Template.size());
	Into.NumGiven = Part.Arguments.size();
	FNameScope* const Scope = MakeScope(EScopeKind::Template, Overload.Scope);
	if (Part.Arguments.size() > Into.Values.size() || Arguments.size() > Declaration.Parameters.size())
	{
		Why = Part.Arguments.size() > Into.Values.size() ? "too many template arguments" : "too many arguments";
		return nullptr;
	}
	for (size_t i = 0; i < Part.Arguments.size(); ++i)
	{
		// A type's name may stand in brackets as an expression: what does not fit this template may fit another one.
		const bool bValue = Part.Arguments[i].Value != nullptr && !Part.Arguments[i].Type;
		const bool bName = bValue && Part.Arguments[i].Value->Kind == EExpression::Name;
		const bool bFits = Declaration.Template[i].ValueType ? Part.Arguments[i].Value != nullptr : !bValue || bName;
		Into.Values[i] = bFits ? ReadArgument(Part.Arguments[i], Declaration.Template[i], Scope) : std::nullopt;
		if (!Into.Values[i])
		{
			Why = "template argument " + std::to_string(i + 1) + " does not fit";
			return nullptr;
		}
		BindParameter(*Scope, Declaration.Template[i], *Into.Values[i]);
	}
	for (size_t i = 0; i < Arguments.size(); ++i)
	{
		const FDeclaration& Parameter = *Declaration.Parameters[i];
		const bool bKnown = Arguments[i]->Kind == EType::Error;
		if (!bKnown && !Deduce(*Parameter.Type, Parameter.Dimensions, Arguments[i], Into))
		{
			Why = Into.Why.empty()
					  ? "argument " + std::to_string(i + 1) + " (" + GetName(Arguments[i]) + ") does not fit"
					  : Into.Why;
			return nullptr;
		}
	}
	std::vector<FTemplateValue> Values;
	if (!FillDefaults(Into, *Scope, Values))
	{
		Why = Into.Why;
		return nullptr;
	}
	FOverload*& Instance = Overload.Instances[MakeTemplateKey(Values)];
	const int InstanceDepth = Here.Overload ? Here.Overload->Depth + 1 : 1;
	if (Instance || !CountInstance(Part.Place))
	{
		return Instance;
	}
	if (InstanceDepth > MaxTemplateDepth)
	{
		Error(Part.Place, "instances of '" + std::string(Symbol.Name) + "' call each other more than " +
							  std::to_string(MaxTemplateDepth) + " times deep");
		return nullptr;
	}
	Instance = &Overloads.emplace_back();
	const FDeclaration* const Special = FindSpecialFunction(Symbol, Overload, Values);
	Instance->Declaration = Special ? Special : &Declaration;
	Instance->Scope = Special ? Overload.Scope : Scope;
	Instance->Struct = Overload.Struct;
	Instance->Order = std::max(Overload.Order, Here.Order);
	Instance->BodyOrder = std::max(Overload.BodyOrder, Here.Order);
	Instance->Arguments = NameTemplateArguments(Values);
	Instance->Template = &Overload;
	Instance->Depth = InstanceDepth;
	return Instance;
}

/** `template<> float F<float>(float X)` for these arguments, written or deduced from its parameters. */
const FDeclaration* FAnalyser::FindSpecialFunction(
	FSymbol& Symbol, FOverload& Overload, const std::vector<FTemplateValue>& Values)
{
	for (const FOverload* Special : Symbol.Specializations)
	{
		const FDeclaration& Declaration = *Special->Declaration;
		const FNamePart& Part = Declaration.Name.Parts.back();
		const std::vector<FDeclaration*>& Parameters = Overload.Declaration->Parameters;
		FPosition Position;
		Position.Scope = Special->Scope;
		Position.Order = Special->Order;
		const FPositionGuard Guard(*this, Position);
		FDeduction Into;
		Into.Template = Overload.Declaration;
		Into.Values.resize(Values.size());
		Into.NumGiven = Part.Arguments.size();
		bool bFits = Part.Arguments.size() <= Values.size() && Parameters.size() == Declaration.Parameters.size();
		for (size_t i = 0; i < Part.Arguments.size() && bFits; ++i)
		{
			Into.Values[i] = ReadArgument(Part.Arguments[i], Overload.Declaration->Template[i]);
			bFits = Into.Values[i].has_value();
		}
		for (size_t i = 0; i < Parameters.size() && bFits; ++i)
		{
			bFits = Deduce(*Parameters[i]->Type, Parameters[i]->Dimensions,
				FindDeclaredType(*Declaration.Parameters[i], true), Into);
		}
		for (size_t i = 0; i < Values.size() && bFits; ++i)
		{
			bFits = Into.Values[i] && MakeTemplateKey({*Into.Values[i]}) == MakeTemplateKey({Values[i]});
		}
		if (bFits)
		{
			return &Declaration;
		}
	}
	return nullptr;
}

} // namespace Drydock::Hlsl
