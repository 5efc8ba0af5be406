// Keeps what is registered of classes, structs and enums, and the values that were given to classes.
#include "UObject/Reflection.h"

#include "CodeScope.h"
#include "RangeTools.h"
#include "RunningCode.h"
#include "Subsystems/Subsystem.h"

#include <algorithm>
#include <strings.h>

namespace Drydock
{

namespace
{

struct FStructEntry
{
	const FReflectedStruct* Struct;
	std::string Plugin; // file name of the shared object; empty: of the program
};

/** A value that a class was given, and what its default object had. */
struct FGiven
{
	const FReflectedStruct* Class;
	std::string Plugin;
	std::string Property;
	FPropertyValue Value;
	FPropertyValue Before;
};

struct FReflectionState
{
	std::vector<FStructEntry> Structs;
	std::vector<const FReflectedEnum*> Enums;
	std::vector<FGiven> Given;
};

/** Never destroyed: libraries unregister at the very end of the program. */
FReflectionState& GetReflectionState()
{
	static auto* const State = new FReflectionState;
	return *State;
}

/** That of Type's own library before one of the same name: plugins may have classes of equal names. */
template<typename TEntries, typename TGetType>
auto FindByType(const TEntries& Entries, const std::type_info& Type, const TGetType& GetType)
{
	const auto Own = std::ranges::find_if(Entries, [&](const auto& Entry) { return GetType(Entry) == &Type; });
	return Own != Entries.end()
			   ? Own
			   : std::ranges::find_if(Entries, [&](const auto& Entry) { return *GetType(Entry) == Type; });
}

std::string FindPluginOf(const FReflectedStruct& Struct)
{
	for (const FStructEntry& Entry : GetReflectionState().Structs)
	{
		if (Entry.Struct == &Struct)
		{
			return Entry.Plugin;
		}
	}
	return "";
}

FCodeOwner MakeOwner(const std::string& Plugin, const FReflectedStruct& Class, const char* What)
{
	return {Plugin, std::string(What) + " of class " + Class.Name};
}

/** The default object and the subsystem of a class, as far as there are any; both live. */
std::vector<UObject*> FindLiveObjects(const FReflectedStruct& Class, const std::string& Plugin)
{
	std::vector<UObject*> Objects;
	if (Class.GetDefault != nullptr)
	{
		Objects.push_back(
			CallCode(MakeOwner(Plugin, Class, "the default object"), [&] { return (*Class.GetDefault)(); }));
	}
	using enum ESubsystemKind;
	for (const ESubsystemKind Kind : {Engine, GameInstance, World, LocalPlayer})
	{
		FSubsystems::Get().ForEach(Kind,
			[&](USubsystem& Subsystem)
			{
				const std::type_info& Type = typeid(Subsystem);
				if (&Type == Class.Type)
				{
					Objects.push_back(&Subsystem);
				}
				return false;
			});
	}
	return Objects;
}

void WriteTo(UObject& Object, const FReflectedStruct& Class, const std::string& Name, const FPropertyValue& Value)
{
	const FFoundProperty Found = FReflection::Get().FindProperty(Class, Name, false);
	FPropertyProblem Unused; // it was taken once
	WriteProperty(*Found.Property->Type, Found.GetAddress((*Class.FromObject)(&Object)), Value, Unused);
}

} // namespace

void* FFoundProperty::GetAddress(void* Container) const
{
	for (void* (*const Step)(void*) : Steps)
	{
		Container = (*Step)(Container);
	}
	return (*Property->GetAddress)(Container);
}

UObject*& GetWorldContext()
{
	static UObject* Context = nullptr;
	return Context;
}

FReflection& FReflection::Get()
{
	static FReflection Reflection;
	return Reflection;
}

void FReflection::Register(const FReflectedStruct& Struct)
{
	const FCodeOwner* const Running = GetRunningCode();
	GetReflectionState().Structs.push_back({&Struct, Running != nullptr ? Running->Plugin : std::string()});
}

void FReflection::Register(const FReflectedEnum& Enum)
{
	GetReflectionState().Enums.push_back(&Enum);
}

void FReflection::Unregister(const FReflectedStruct& Struct)
{
	std::erase_if(GetReflectionState().Structs, [&](const FStructEntry& Entry) { return Entry.Struct == &Struct; });
	std::erase_if(GetReflectionState().Given, [&](const FGiven& Given) { return Given.Class == &Struct; });
}

void FReflection::Unregister(const FReflectedEnum& Enum)
{
	std::erase(GetReflectionState().Enums, &Enum);
}

std::vector<const FReflectedStruct*> FReflection::FindClasses(const std::string& Plugin) const
{
	std::vector<const FReflectedStruct*> Classes;
	for (const FStructEntry& Entry : GetReflectionState().Structs)
	{
		if (Entry.Plugin == Plugin && Entry.Struct->FromObject != nullptr)
		{
			Classes.push_back(Entry.Struct);
		}
	}
	return Classes;
}

const FReflectedStruct* FReflection::FindStruct(const std::type_info& Type) const
{
	const std::vector<FStructEntry>& Structs = GetReflectionState().Structs;
	const auto Found = FindByType(Structs, Type, [](const FStructEntry& Entry) { return Entry.Struct->Type; });
	return Found != Structs.end() ? Found->Struct : nullptr;
}

const FReflectedEnum* FReflection::FindEnum(const std::type_info& Type) const
{
	const std::vector<const FReflectedEnum*>& Enums = GetReflectionState().Enums;
	const auto Found = FindByType(Enums, Type, [](const FReflectedEnum* Enum) { return Enum->Type; });
	return Found != Enums.end() ? *Found : nullptr;
}

FFoundProperty FReflection::FindProperty(
	const FReflectedStruct& Struct, const std::string& Name, bool bIgnoreCase) const
{
	FFoundProperty Found;
	for (const FReflectedStruct* Class = &Struct; Class != nullptr;)
	{
		for (const FReflectedProperty& Property : Class->Properties)
		{
			if (bIgnoreCase ? strcasecmp(Property.Name, Name.c_str()) == 0 : Name == Property.Name)
			{
				Found.Property = &Property;
				return Found;
			}
		}
		if (Class->Super == nullptr)
		{
			break;
		}
		Found.Steps.push_back(Class->ToSuper);
		Class = FindStruct(*Class->Super);
	}
	return Found;
}

std::vector<std::string> FReflection::GetPropertyNames(const FReflectedStruct& Struct) const
{
	std::vector<std::string> Names;
	for (const FReflectedStruct* Class = &Struct; Class != nullptr;
		 Class = Class->Super != nullptr ? FindStruct(*Class->Super) : nullptr)
	{
		for (const FReflectedProperty& Property : Class->Properties)
		{
			Names.emplace_back(Property.Name);
		}
	}
	return Names;
}

bool FReflection::Give(
	const FReflectedStruct& Class, const std::string& Name, const FPropertyValue& Value, FPropertyProblem& OutProblem)
{
	const FFoundProperty Found = FindProperty(Class, Name, false);
	if (Found.Property == nullptr)
	{
		OutProblem = {FPropertyProblem::EKind::UnknownProperty, "",
			std::string(Class.Name) + " has no UPROPERTY " + Name + SuggestName(Name, GetPropertyNames(Class))};
		return false;
	}
	if (Class.GetDefault == nullptr)
	{
		OutProblem = {FPropertyProblem::EKind::NotGiven, "",
			std::string(Class.Name) + " has no default object: it is abstract, or nobody can make one"};
		return false;
	}
	const std::string Plugin = FindPluginOf(Class);
	const std::vector<UObject*> Objects = FindLiveObjects(Class, Plugin);
	const FPropertyValue Before =
		ReadProperty(*Found.Property->Type, Found.GetAddress((*Class.FromObject)(Objects[0])));
	if (!WriteProperty(*Found.Property->Type, Found.GetAddress((*Class.FromObject)(Objects[0])), Value, OutProblem))
	{
		if (OutProblem.Path.empty())
		{
			OutProblem.Message =
				std::string(Class.Name) + "::" + Name + " (" + Found.Property->TypeName + "): " + OutProblem.Message;
		}
		return false;
	}
	for (size_t Index = 1; Index < Objects.size(); ++Index)
	{
		WriteTo(*Objects[Index], Class, Name, Value);
	}
	GetReflectionState().Given.push_back({&Class, Plugin, Name, Value, Before});
	return true;
}

bool FReflection::Call(const FReflectedStruct& Class, const std::string& Name,
	const std::vector<FPropertyValue>& Arguments, UObject* Object, FPropertyProblem& OutProblem) const
{
	std::vector<std::string> Names;
	void* Container = Object != nullptr ? (*Class.FromObject)(Object) : nullptr;
	for (const FReflectedStruct* Each = &Class; Each != nullptr;
		 Each = Each->Super != nullptr ? FindStruct(*Each->Super) : nullptr)
	{
		if (const FReflectedFunction* const Function = FindItem(Each->Functions, Name, &FReflectedFunction::Name))
		{
			if (Arguments.size() == Function->NumParameters)
			{
				return CallCode(MakeOwner(FindPluginOf(Class), Class, Function->Name),
					[&] { return (*Function->Call)(Container, Arguments, OutProblem); });
			}
			OutProblem = {FPropertyProblem::EKind::WrongValue, "",
				std::string(Class.Name) + "::" + Name + " has " + std::to_string(Function->NumParameters) +
					" parameters, and " + std::to_string(Arguments.size()) + " arguments are given"};
			return false;
		}
		std::ranges::transform(
			Each->Functions, std::back_inserter(Names), [](const FReflectedFunction& Other) { return Other.Name; });
		Container = Container != nullptr && Each->ToSuper != nullptr ? (*Each->ToSuper)(Container) : nullptr;
	}
	OutProblem = {FPropertyProblem::EKind::UnknownProperty, "",
		std::string(Class.Name) + " has no UFUNCTION(BlueprintCallable) " + Name + SuggestName(Name, Names)};
	return false;
}

UObject* FReflection::FindObject(const FReflectedStruct& Class) const
{
	const std::vector<UObject*> Objects = FindLiveObjects(Class, FindPluginOf(Class));
	return Objects.empty() ? nullptr : Objects.back();
}

void FReflection::FinishDefaults(const std::string& Plugin)
{
	std::vector<const FReflectedStruct*> Classes;
	for (const FGiven& Given : GetReflectionState().Given)
	{
		if (Given.Plugin == Plugin && std::ranges::find(Classes, Given.Class) == Classes.end())
		{
			Classes.push_back(Given.Class);
		}
	}
	for (const FReflectedStruct* const Class : Classes)
	{
		CallCode(
			MakeOwner(Plugin, *Class, "PostInitProperties"), [&] { (*Class->GetDefault)()->PostInitProperties(); });
	}
}

void FReflection::TakeBack()
{
	std::vector<FGiven>& AllGiven = GetReflectionState().Given;
	// From the end: of a property that was given twice the first "before" is the constructor's.
	while (!AllGiven.empty())
	{
		const FGiven Given = std::move(AllGiven.back());
		AllGiven.pop_back();
		for (UObject* const Object : FindLiveObjects(*Given.Class, Given.Plugin))
		{
			WriteTo(*Object, *Given.Class, Given.Property, Given.Before);
		}
	}
}

void FReflection::FinishObject(UObject& Object, const std::type_info& Type)
{
	if (!GetReflectionState().Given.empty())
	{
		if (const FReflectedStruct* const Class = FindStruct(Type))
		{
			for (const FGiven& Given : GetReflectionState().Given)
			{
				if (Given.Class == Class)
				{
					WriteTo(Object, *Class, Given.Property, Given.Value);
				}
			}
		}
	}
	Object.PostInitProperties();
}

} // namespace Drydock

void Drydock::FinishNewObject(UObject& Object, const std::type_info& Type)
{
	FReflection::Get().FinishObject(Object, Type);
}
