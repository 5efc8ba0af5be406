// Finds the classes that ini files and "objects" mean, and gives them their values.
#include "Objects/ObjectValues.h"

#include "CodeScope.h"
#include "Config/ConfigReader.h"
#include "GameFramework/Actor.h"
#include "Objects/ConfigAssets.h"
#include "Objects/ObjectErrors.h"
#include "RangeTools.h"
#include "UObject/Reflection.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** The class of "/Script/Module.Class"; other names as they are. */
std::string GetClassName(const std::string& Name)
{
	return Name.starts_with("/Script/") ? Name.substr(Name.rfind('.') + 1) : Name;
}

FPropertyValue MakeValue(const FJsonValue& Json)
{
	FPropertyValue Value;
	switch (Json.Type)
	{
	case EJsonType::Bool:
		return FPropertyValue::MakeBool(Json.Bool);
	case EJsonType::Number:
		return FPropertyValue::MakeNumber(Json.Number);
	case EJsonType::String:
		return FPropertyValue::MakeText(Json.String);
	case EJsonType::Array:
		Value = FPropertyValue::MakeList();
		for (const FJsonValue& Element : Json.Elements)
		{
			Value.Items.emplace_back("", MakeValue(Element));
		}
		return Value;
	case EJsonType::Object:
		Value = FPropertyValue::MakeFields();
		for (const FJsonMember& Member : Json.Members)
		{
			Value.Items.emplace_back(Member.Key, MakeValue(Member.Value));
		}
		return Value;
	case EJsonType::Null:
	case EJsonType::Invalid:
		break;
	}
	return Value;
}

bool ContainsInvalid(const FJsonValue& Value)
{
	return Value.Type == EJsonType::Invalid || std::ranges::any_of(Value.Elements, ContainsInvalid) ||
		   std::ranges::any_of(Value.Members, [](const FJsonMember& Member) { return ContainsInvalid(Member.Value); });
}

/** The value that a path ("/Colors/2") leads to from Value on. */
const FJsonValue& FindAt(const FJsonValue& Value, const std::string& Path)
{
	const size_t End = std::min(Path.find('/', 1), Path.size());
	const std::string Step = Path.empty() ? "" : Path.substr(1, End - 1);
	if (Value.Type == EJsonType::Object && Value.Find(Step) != nullptr)
	{
		return FindAt(*Value.Find(Step), Path.substr(End));
	}
	if (Value.Type == EJsonType::Array && !Step.empty())
	{
		return FindAt(Value.Elements.at(std::stoul(Step)), Path.substr(End));
	}
	return Value;
}

const std::string CallKey = "call"; // of an object's entry

/** An item of "call": "Start", or {"SetTint": [1, "Soft"]}. */
struct FCalled
{
	std::string Function; // empty: it is neither
	std::vector<FPropertyValue> Arguments = {};
	const FJsonValue* Place = nullptr; // of the arguments, or of the item
};

FCalled ReadCall(const FJsonValue& Item)
{
	if (Item.Type == EJsonType::String)
	{
		return {Item.String, {}, &Item};
	}
	if (Item.Type != EJsonType::Object || Item.Members.size() != 1 || Item.Members[0].Value.Type != EJsonType::Array)
	{
		return {"", {}, &Item};
	}
	const FJsonMember& Member = Item.Members[0];
	return {Member.Key, ToVector<FPropertyValue>(Member.Value.Elements, MakeValue), &Member.Value};
}

/** Reports what cannot be called. */
void CheckCalls(const FReflectedStruct& Class, const FJsonValue& Calls, FConfigMessages& Messages)
{
	if (Calls.Type != EJsonType::Array)
	{
		Messages.Error(ErrorPropertyValue, Calls, "expected a list of calls: [\"Start\", {\"SetTint\": [1, 0.5]}]");
	}
	for (const FJsonValue& Item : Calls.Elements)
	{
		const FCalled Called = ReadCall(Item);
		FPropertyProblem Problem;
		if (Called.Function.empty())
		{
			Messages.Error(ErrorPropertyValue, Item,
				"expected a function's name, or an object with one name and the list of its arguments: {\"SetTint\": "
				"[1, 0.5]}");
		}
		else if (!ContainsInvalid(Item) &&
				 !FReflection::Get().Call(Class, Called.Function, Called.Arguments, nullptr, Problem))
		{
			const bool bUnknown = Problem.Kind == FPropertyProblem::EKind::UnknownProperty;
			const bool bNotGiven = Problem.Kind == FPropertyProblem::EKind::NotGiven;
			Messages.Error(bUnknown    ? ErrorUnknownProperty
						   : bNotGiven ? ErrorPropertyNotGiven
									   : ErrorPropertyValue,
				FindAt(*Called.Place, Problem.Path), Problem.Message);
		}
	}
}

/** The actor or component of that class in the world, else its subsystem or its default object. */
UObject* FindCalledObject(const FReflectedStruct& Class)
{
	const auto IsOne = [&Class](const UObject& Object)
	{
		return typeid(Object) == *Class.Type;
	};
	for (const std::shared_ptr<AActor>& Actor : GWorld->GetActors())
	{
		if (IsOne(*Actor))
		{
			return Actor.get();
		}
		for (UActorComponent* const Component : Actor->GetOwnedComponents())
		{
			if (IsOne(*Component))
			{
				return Component;
			}
		}
	}
	return FReflection::Get().FindObject(Class);
}

} // namespace

FObjectValues::FObjectValues(const FConfig& InConfig, std::vector<FDiagnostic>& InDiagnostics)
	: Config(InConfig)
	, Diagnostics(InDiagnostics)
{
	GWorld->RemovePlacedActors();
	FReflection::Get().TakeBack();
	BeginAssets(Config, Diagnostics);
}

void FObjectValues::GiveTo(const std::string& Library)
{
	for (const FReflectedStruct* const Class : FReflection::Get().FindClasses(Library))
	{
		ClassNames.emplace_back(Class->Name);
	}
	for (const std::string& Path : FindIniFiles(Library))
	{
		GiveIniFile(Library, Path, Variables, Diagnostics);
	}
	GiveObjects(Library);
	FReflection::Get().FinishDefaults(Library);
}

void FObjectValues::GiveObjects(const std::string& Library)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const FJsonMember& Object : Config.Objects.Members)
	{
		for (const FReflectedStruct* const Class : FReflection::Get().FindClasses(Library))
		{
			if (!IsNameOf(GetClassName(Object.Key), *Class))
			{
				continue;
			}
			Taken.insert(Object.Key);
			for (const FJsonMember& Member : Object.Value.Members)
			{
				FPropertyProblem Problem;
				if (Member.Key == CallKey)
				{
					CheckCalls(*Class, Member.Value, Messages);
					continue;
				}
				if (ContainsInvalid(Member.Value) ||
					FReflection::Get().Give(*Class, Member.Key, MakeValue(Member.Value), Problem))
				{
					continue;
				}
				const FJsonValue& At = FindAt(Member.Value, Problem.Path);
				if (Problem.Kind == FPropertyProblem::EKind::UnknownProperty)
				{
					Messages.ErrorAtKey(ErrorUnknownProperty, At, Problem.Message);
				}
				else
				{
					const bool bNotGiven = Problem.Kind == FPropertyProblem::EKind::NotGiven;
					Messages.Error(bNotGiven ? ErrorPropertyNotGiven : ErrorPropertyValue, At, Problem.Message);
				}
			}
			break;
		}
	}
}

void FObjectValues::PlaceActors(const std::string& Library) const
{
	std::vector<std::pair<const FReflectedStruct*, const FJsonValue*>> Named;
	for (const FReflectedStruct* const Class : FReflection::Get().FindClasses(Library))
	{
		for (const FJsonMember& Object : Config.Objects.Members)
		{
			if (IsNameOf(GetClassName(Object.Key), *Class))
			{
				Named.emplace_back(Class, &Object.Value);
			}
		}
	}
	// An actor may bring a component that is named, too.
	std::stable_partition(Named.begin(), Named.end(),
		[](const auto& Each) { return Each.first->GetDefault && Cast<AActor>(Each.first->GetDefault()); });
	for (const auto& [Class, Value] : Named)
	{
		if (Class->Place)
		{
			CallCode(FCodeOwner{Library, "BeginPlay of " + std::string(Class->Name)}, Class->Place);
		}
	}
	for (const auto& [Class, Value] : Named)
	{
		const FJsonValue* const Calls = Value->Find(CallKey);
		for (const FJsonValue& Call : Calls != nullptr ? Calls->Elements : std::vector<FJsonValue>())
		{
			const FCalled Called = ReadCall(Call);
			FPropertyProblem Told; // by CheckCalls
			if (UObject* const Object = FindCalledObject(*Class))
			{
				FReflection::Get().Call(*Class, Called.Function, Called.Arguments, Object, Told);
			}
			else
			{
				FConfigMessages(Config.File, Diagnostics)
					.Error(ErrorPropertyNotGiven, Call,
						Called.Function + " is not called: there is no object of " + Class->Name +
							", and drydock makes none, because its default constructor is not public");
			}
		}
	}
}

void FObjectValues::ReportUnknownClasses(bool bAllLoaded)
{
	FConfigMessages Messages(Config.File, Diagnostics);
	for (const FJsonMember& Object : Config.Objects.Members)
	{
		if (Taken.count(Object.Key) != 0)
		{
			continue;
		}
		const std::string Lacking = ClassNames.empty() ? "; no loaded plugin has a UCLASS with a generated header" : "";
		Messages.ErrorAtKey(ErrorUnknownClass, Object.Value,
			"no plugin has a class " + Object.Key + Messages.Suggest(GetClassName(Object.Key), ClassNames) +
				(bAllLoaded ? Lacking : " (or a plugin has it that was not loaded)"));
	}
}

} // namespace Drydock
