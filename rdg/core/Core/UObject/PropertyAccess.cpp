// Reads and writes values of properties: what a type takes is checked first, then all of it is written.
#include "UObject/Assets.h"
#include "UObject/Reflection.h"

#include "Diagnostics.h"

#include <cmath>
#include <strings.h>

namespace Drydock
{

namespace
{

using EKind = FPropertyValue::EKind;

bool Refuse(
	FPropertyProblem& OutProblem, const std::string& Path, const FPropertyType& Type, const FPropertyValue& Value)
{
	const std::string Found = Value.Kind == EKind::Text ? "\"" + Value.Text + "\"" : Value.Describe();
	OutProblem = {FPropertyProblem::EKind::WrongValue, Path,
		"expected " + DescribeExpected(Type) + ", found " + (Value.IsNumber() ? "another number" : Found)};
	if (Value.IsNumber() && Type.Kind != EPropertyKind::Whole && Type.Kind != EPropertyKind::Enum)
	{
		OutProblem.Message = "expected " + DescribeExpected(Type) + ", found a number";
	}
	return false;
}

/** The object that is given, or that a text names. */
FGivenAsset FindObject(const FPropertyValue& Value)
{
	return Value.Kind == EKind::Text ? FindGivenAsset(Value.Text) : FGivenAsset{Value.Object, ""};
}

std::vector<std::string> GetEnumNames(const FPropertyType& Type)
{
	std::vector<std::string> Names;
	if (const FReflectedEnum* const Enum = FReflection::Get().FindEnum(*Type.Type))
	{
		for (const auto& [Name, Number] : Enum->Values)
		{
			Names.emplace_back(Name);
		}
	}
	return Names;
}

/** `Multiply`, `EMode::Multiply` or a number. */
bool FindEnumNumber(const FPropertyType& Type, const FPropertyValue& Value, int64& OutNumber)
{
	const FReflectedEnum* const Enum = FReflection::Get().FindEnum(*Type.Type);
	if (Value.Kind == EKind::Whole)
	{
		OutNumber = Value.Whole;
		return Value.Whole >= Type.Least && Value.Whole <= Type.Most;
	}
	if (Value.Kind != EKind::Text || Enum == nullptr)
	{
		return false;
	}
	const size_t Colons = Value.Text.rfind("::");
	const std::string Name = Colons == std::string::npos ? Value.Text : Value.Text.substr(Colons + 2);
	for (const auto& [Each, Number] : Enum->Values)
	{
		if (strcasecmp(Each, Name.c_str()) == 0)
		{
			OutNumber = Number;
			return true;
		}
	}
	return false;
}

bool CheckReal(const FPropertyType& Type, const FPropertyValue& Value)
{
	return Value.IsNumber() && std::isfinite(Value.Real) &&
		   (!Type.bFloat || std::isfinite(static_cast<float>(Value.Real)));
}

bool CheckComponent(const FPropertyType& Type, const FPropertyValue& Value)
{
	return Type.bWholeComponents ? Value.Kind == EKind::Whole && Value.Whole >= Type.Least && Value.Whole <= Type.Most
								 : CheckReal(Type, Value);
}

/** Index of a component's name, ignoring case; -1: there is none. */
int32 FindComponent(const FPropertyType& Type, const std::string& Name)
{
	for (size_t Index = 0; Index < Type.Names.size(); ++Index)
	{
		if (strcasecmp(Type.Names[Index].c_str(), Name.c_str()) == 0)
		{
			return static_cast<int32>(Index);
		}
	}
	return -1;
}

bool CheckVector(
	const FPropertyType& Type, const FPropertyValue& Value, const std::string& Path, FPropertyProblem& OutProblem)
{
	const size_t Num = Value.Items.size();
	const size_t NumWanted = Type.Names.size();
	const bool bList =
		Value.Kind == EKind::List && (Num == NumWanted || (Type.bLastMayBeMissing && Num + 1 == NumWanted));
	if (!bList && Value.Kind != EKind::Fields)
	{
		return Refuse(OutProblem, Path, Type, Value);
	}
	for (const auto& [Name, Component] : Value.Items)
	{
		if ((!bList && FindComponent(Type, Name) < 0) || !CheckComponent(Type, Component))
		{
			return Refuse(OutProblem, Path, Type, Value);
		}
	}
	return true;
}

bool Check(
	const FPropertyType& Type, const FPropertyValue& Value, const std::string& Path, FPropertyProblem& OutProblem);

bool CheckStruct(
	const FPropertyType& Type, const FPropertyValue& Value, const std::string& Path, FPropertyProblem& OutProblem)
{
	const FReflectedStruct* const Struct = FReflection::Get().FindStruct(*Type.Type);
	if (Struct == nullptr)
	{
		OutProblem = {FPropertyProblem::EKind::NotGiven, Path,
			"values of this type cannot be given: it is not a number, text, enum, colour, vector, USTRUCT of the "
			"plugin or array of these"};
		return false;
	}
	if (Value.Kind != EKind::Fields)
	{
		return Refuse(OutProblem, Path, Type, Value);
	}
	for (const auto& [Name, Member] : Value.Items)
	{
		const FFoundProperty Found = FReflection::Get().FindProperty(*Struct, Name, true);
		if (Found.Property == nullptr)
		{
			OutProblem = {FPropertyProblem::EKind::UnknownProperty, Path + "/" + Name,
				std::string(Struct->Name) + " has no UPROPERTY " + Name +
					SuggestName(Name, FReflection::Get().GetPropertyNames(*Struct))};
			return false;
		}
		if (!Check(*Found.Property->Type, Member, Path + "/" + Name, OutProblem))
		{
			return false;
		}
	}
	return true;
}

bool Check(
	const FPropertyType& Type, const FPropertyValue& Value, const std::string& Path, FPropertyProblem& OutProblem)
{
	bool bTaken = false;
	int64 Number = 0;
	switch (Type.Kind)
	{
	case EPropertyKind::Bool:
		bTaken = Value.Kind == EKind::Bool;
		break;
	case EPropertyKind::Whole:
		bTaken = Value.Kind == EKind::Whole && Value.Whole >= Type.Least && Value.Whole <= Type.Most;
		break;
	case EPropertyKind::Real:
		bTaken = CheckReal(Type, Value);
		break;
	case EPropertyKind::Text:
		bTaken = Value.Kind == EKind::Text;
		break;
	case EPropertyKind::Enum:
		bTaken = FindEnumNumber(Type, Value, Number);
		if (!bTaken && Value.Kind == EKind::Text)
		{
			Refuse(OutProblem, Path, Type, Value);
			OutProblem.Message += SuggestName(Value.Text, GetEnumNames(Type));
			return false;
		}
		break;
	case EPropertyKind::Vector:
		return CheckVector(Type, Value, Path, OutProblem);
	case EPropertyKind::Array:
		if (Value.Kind != EKind::List)
		{
			break;
		}
		for (size_t Index = 0; Index < Value.Items.size(); ++Index)
		{
			if (!Check(*Type.Element, Value.Items[Index].second, Path + "/" + std::to_string(Index), OutProblem))
			{
				return false;
			}
		}
		return true;
	case EPropertyKind::Struct:
		return CheckStruct(Type, Value, Path, OutProblem);
	case EPropertyKind::Object:
		if (Type.SetObject == nullptr)
		{
			OutProblem = {FPropertyProblem::EKind::NotGiven, Path,
				"of objects and assets only textures can be given; set it in the plugin's code"};
			return false;
		}
		if (const FGivenAsset Given = FindObject(Value); Given.Problem.empty())
		{
			bTaken = (Given.Asset != nullptr || Value.Kind == EKind::Object) && (*Type.SetObject)(nullptr, Given.Asset);
		}
		else
		{
			OutProblem = {FPropertyProblem::EKind::WrongValue, Path, Given.Problem};
			return false;
		}
		break;
	case EPropertyKind::Other:
		OutProblem = {FPropertyProblem::EKind::NotGiven, Path, "values of this type cannot be given"};
		return false;
	}
	return bTaken || Refuse(OutProblem, Path, Type, Value);
}

/** Value: checked. */
void Write(const FPropertyType& Type, void* Address, const FPropertyValue& Value)
{
	int64 Number = 0;
	switch (Type.Kind)
	{
	case EPropertyKind::Bool:
		(*Type.SetWhole)(Address, Value.bBool ? 1 : 0);
		break;
	case EPropertyKind::Whole:
		(*Type.SetWhole)(Address, Value.Whole);
		break;
	case EPropertyKind::Real:
		(*Type.SetReal)(Address, 0, Value.Real);
		break;
	case EPropertyKind::Text:
		(*Type.SetText)(Address, Value.Text);
		break;
	case EPropertyKind::Enum:
		FindEnumNumber(Type, Value, Number);
		(*Type.SetWhole)(Address, Number);
		break;
	case EPropertyKind::Vector:
		for (size_t Index = 0; Index < Value.Items.size(); ++Index)
		{
			const auto& [Name, Component] = Value.Items[Index];
			(*Type.SetReal)(Address, Value.Kind == EKind::List ? static_cast<int32>(Index) : FindComponent(Type, Name),
				Component.Real);
		}
		if (Value.Kind == EKind::List && Value.Items.size() < Type.Names.size())
		{
			(*Type.SetReal)(Address, static_cast<int32>(Value.Items.size()), Type.bWholeComponents ? 255.0 : 1.0);
		}
		break;
	case EPropertyKind::Array:
		(*Type.Reset)(Address, static_cast<int32>(Value.Items.size()));
		for (size_t Index = 0; Index < Value.Items.size(); ++Index)
		{
			Write(*Type.Element, (*Type.GetElement)(Address, static_cast<int32>(Index)), Value.Items[Index].second);
		}
		break;
	case EPropertyKind::Struct:
		for (const auto& [Name, Member] : Value.Items)
		{
			const FReflectedStruct* const Struct = FReflection::Get().FindStruct(*Type.Type);
			const FFoundProperty Found = FReflection::Get().FindProperty(*Struct, Name, true);
			Write(*Found.Property->Type, Found.GetAddress(Address), Member);
		}
		break;
	case EPropertyKind::Object:
		(*Type.SetObject)(Address, FindObject(Value).Asset);
		break;
	case EPropertyKind::Other:
		break;
	}
}

std::string DescribeRange(const FPropertyType& Type)
{
	return "a whole number from " + std::to_string(Type.Least) + " to " + std::to_string(Type.Most);
}

} // namespace

std::string DescribeExpected(const FPropertyType& Type)
{
	std::string Text;
	switch (Type.Kind)
	{
	case EPropertyKind::Bool:
		return "true or false";
	case EPropertyKind::Whole:
		return DescribeRange(Type);
	case EPropertyKind::Real:
		return Type.bFloat ? "a number that a float holds" : "a number";
	case EPropertyKind::Text:
		return "a text";
	case EPropertyKind::Enum:
		for (const std::string& Name : GetEnumNames(Type))
		{
			Text += (Text.empty() ? "one of " : ", ") + Name;
		}
		return Text.empty() ? "the number of an enum" : Text;
	case EPropertyKind::Vector:
		for (const std::string& Name : Type.Names)
		{
			Text += (Text.empty() ? "[" : ", ") + Name;
		}
		return Text + "] or the components by name, each " + (Type.bWholeComponents ? DescribeRange(Type) : "a number");
	case EPropertyKind::Array:
		return "a list, each of it " + DescribeExpected(*Type.Element);
	case EPropertyKind::Struct:
		return "the struct's fields by name";
	case EPropertyKind::Object:
		return Type.SetObject != nullptr ? "the name of a picture file, or of an entry of \"assets\", of that class"
										 : "nothing";
	case EPropertyKind::Other:
		break;
	}
	return "nothing";
}

FPropertyValue ReadProperty(const FPropertyType& Type, const void* Address)
{
	FPropertyValue Value;
	switch (Type.Kind)
	{
	case EPropertyKind::Bool:
		return FPropertyValue::MakeBool((*Type.GetWhole)(Address) != 0);
	case EPropertyKind::Whole:
	case EPropertyKind::Enum:
		return FPropertyValue::MakeWhole((*Type.GetWhole)(Address));
	case EPropertyKind::Real:
		return {.Kind = EKind::Real, .Real = (*Type.GetReal)(Address, 0)};
	case EPropertyKind::Text:
		return FPropertyValue::MakeText((*Type.GetText)(Address));
	case EPropertyKind::Vector:
		Value = FPropertyValue::MakeList();
		for (size_t Index = 0; Index < Type.Names.size(); ++Index)
		{
			const double Component = (*Type.GetReal)(Address, static_cast<int32>(Index));
			Value.Items.emplace_back("", Type.bWholeComponents
											 ? FPropertyValue::MakeNumber(Component)
											 : FPropertyValue{.Kind = EKind::Real, .Real = Component});
		}
		return Value;
	case EPropertyKind::Array:
		Value = FPropertyValue::MakeList();
		for (int32 Index = 0; Index < (*Type.GetNum)(Address); ++Index)
		{
			Value.Items.emplace_back(
				"", ReadProperty(*Type.Element, (*Type.GetElement)(const_cast<void*>(Address), Index)));
		}
		return Value;
	case EPropertyKind::Struct:
		Value = FPropertyValue::MakeFields();
		if (const FReflectedStruct* const Struct = FReflection::Get().FindStruct(*Type.Type))
		{
			for (const std::string& Name : FReflection::Get().GetPropertyNames(*Struct))
			{
				const FFoundProperty Found = FReflection::Get().FindProperty(*Struct, Name, false);
				const FPropertyValue Member =
					ReadProperty(*Found.Property->Type, Found.GetAddress(const_cast<void*>(Address)));
				if (Member.Kind != EKind::None)
				{
					Value.Items.emplace_back(Name, Member);
				}
			}
		}
		return Value;
	case EPropertyKind::Object:
		return Type.GetObject != nullptr ? FPropertyValue::MakeObject((*Type.GetObject)(Address)) : Value;
	case EPropertyKind::Other:
		break;
	}
	return Value;
}

bool WriteProperty(const FPropertyType& Type, void* Address, const FPropertyValue& Value, FPropertyProblem& OutProblem)
{
	if (!Check(Type, Value, "", OutProblem))
	{
		return false;
	}
	Write(Type, Address, Value);
	return true;
}

} // namespace Drydock
