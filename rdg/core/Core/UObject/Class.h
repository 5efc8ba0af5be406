// UClass: a class of objects at run time, with its name, base and default object. Comes with UObject/Object.h. Source:
// engine UObject/Class.h, Templates/SubclassOf.h.
#pragma once

#include "UObject/Object.h"

class DRYDOCK_API UClass : public UObject
{
public:
	UClass(FName InName, UClass* InSuper);

	UClass* GetSuperClass() const { return SuperClass; }
	bool IsChildOf(const UClass* Other) const;
	template<typename T>
	bool IsChildOf() const
	{
		return IsChildOf(T::StaticClass());
	}
	/** Null for a class that cannot be made without arguments. */
	UObject* GetDefaultObject(bool = true) const { return Default != nullptr ? Default() : nullptr; }
	template<typename T>
	T* GetDefaultObject() const
	{
		return Cast<T>(GetDefaultObject());
	}

	/** Ours: how an object of the class is made, and its default object found. */
	UObject* (*Make)() = nullptr;
	UObject* (*Default)() = nullptr;

private:
	UClass* SuperClass;
};

namespace Drydock
{

template<typename T>
UClass* FindClass(const TCHAR* Name, UClass* Super)
{
	UObject* (*Make)() = nullptr;
	UObject* (*Default)() = nullptr;
	if constexpr (std::is_default_constructible_v<T>)
	{
		Make = []() -> UObject*
		{
			return new T();
		};
		Default = []() -> UObject*
		{
			return GetMutableDefault<T>();
		};
	}
	return FindOrAddClass(typeid(T), Name, Super, Make, Default);
}

} // namespace Drydock

/** A class that is a T's. */
template<typename T>
class TSubclassOf
{
public:
	TSubclassOf(UClass* InClass = nullptr)
		: Class(InClass)
	{
	}

	UClass* Get() const { return Class != nullptr && Class->IsChildOf(T::StaticClass()) ? Class : nullptr; }
	UClass* operator*() const { return Get(); }
	UClass* operator->() const { return Get(); }
	operator UClass*() const { return Get(); }
	T* GetDefaultObject() const { return Get() != nullptr ? Get()->template GetDefaultObject<T>() : nullptr; }

private:
	UClass* Class;
};

/** A new object of a class, which the caller owns; null if the class is null, cannot be made or is not a T's. */
template<typename T>
T* NewObject(UObject* Outer, const UClass* Class, FName Name = NAME_None)
{
	T* const Object = Class != nullptr && Class->Make != nullptr ? Cast<T>(Class->Make()) : nullptr;
	if (Object != nullptr)
	{
		Object->SetFName(Name);
		Object->SetOuter(Outer);
		Drydock::FinishNewObject(*Object, typeid(*Object));
	}
	return Object;
}
