// The one initializer that the constructors of objects are given, the classes of objects, and the messages about assets
// that code asks for.
#include "UObject/Object.h"

#include "Logging/LogMacros.h"

#include <atomic>
#include <map>
#include <mutex>
#include <set>
#include <string>

const FObjectInitializer& FObjectInitializer::Get()
{
	static const FObjectInitializer Initializer;
	return Initializer;
}

namespace
{

/** By the type's name: plugins see one class of the engine, and the name outlives its library. */
struct FClasses
{
	std::mutex Mutex;
	std::map<std::string, UClass*> ByType;
};

/** Never destroyed, as libraries come and go. */
FClasses& GetClasses()
{
	static auto* const Classes = new FClasses;
	return *Classes;
}

} // namespace

UClass* Drydock::FindOrAddClass(
	const std::type_info& Type, const TCHAR* Name, UClass* Super, UObject* (*Make)(), UObject* (*Default)())
{
	const std::lock_guard Lock(GetClasses().Mutex);
	UClass*& Class = GetClasses().ByType[Type.name()];
	Class = Class != nullptr ? Class : new UClass(Name + 1, Super);
	Class->Make = Make;
	Class->Default = Default;
	return Class;
}

uint32 UObject::MakeUniqueID()
{
	static std::atomic<uint32> Last{0};
	return ++Last;
}

UClass* UObject::StaticClass()
{
	return Drydock::FindClass<UObject>(TEXT("UObject"), nullptr);
}

UClass* UObject::GetClass() const
{
	{
		const std::lock_guard Lock(GetClasses().Mutex);
		const auto Found = GetClasses().ByType.find(typeid(*this).name());
		if (Found != GetClasses().ByType.end())
		{
			return Found->second;
		}
	}
	return UObject::StaticClass();
}

bool UObject::IsA(const UClass* Class) const
{
	return GetClass()->IsChildOf(Class);
}

UClass::UClass(FName InName, UClass* InSuper)
	: SuperClass(InSuper)
{
	SetFName(InName);
}

bool UClass::IsChildOf(const UClass* Other) const
{
	return this == Other || (SuperClass != nullptr && SuperClass->IsChildOf(Other));
}

void Drydock::SayNeutral(const TCHAR* Name, const TCHAR* What)
{
	static std::mutex Mutex;
	static std::set<std::string> Named;
	const std::lock_guard Lock(Mutex);
	if (Named.insert(Name).second)
	{
		UE_LOG(LogCore, Warning, "%s: %s", Name, What);
	}
}

void Drydock::WarnOfMissingAsset(const TCHAR* Path)
{
	SayNeutral(*FString::Printf("Failed to find object '%s'", Path != nullptr ? Path : ""),
		"the answer is null; \"assets\" of the config gives a picture or a render target for a path");
}
