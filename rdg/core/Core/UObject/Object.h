// UObject, as much as code outside the engine needs to compile and to be watched: objects are plain C++ objects that
// the caller owns. Source: engine UObject/Object.h, UObject/UObjectGlobals.h, Templates/Casts.h,
// UObject/WeakObjectPtr.h, UObject/ObjectPtr.h, UObject/StrongObjectPtr.h, UObject/Class.h, Templates/SubclassOf.h.
#pragma once

#include "Misc/AssertionMacros.h"
#include "UObject/NameTypes.h"
#include "UObject/ObjectMacros.h"
#include "UObject/UObjectBase.h"

#include <typeinfo>
#include <vector>

class UClass;
class UObject;
class UWorld;

namespace Drydock
{

/** Ours: gives a new object of a class what its default object was given by a config or an ini file, and calls
 * PostInitProperties. Type: the class. */
DRYDOCK_API void FinishNewObject(UObject& Object, const std::type_info& Type);

/** Ours: the one UClass of a type; what it does is set anew, as plugins come and go. */
DRYDOCK_API UClass* FindOrAddClass(
	const std::type_info& Type, const TCHAR* Name, UClass* Super, UObject* (*Make)(), UObject* (*Default)());
/** Below, as UClass is. */
template<typename T>
UClass* FindClass(const TCHAR* Name, UClass* Super);

} // namespace Drydock

/** Ours: what the header tool writes into a class of the engine. */
#define DRYDOCK_CLASS(Class, Base) \
	using Super = Class; \
	static UClass* StaticClass() \
	{ \
		return ::Drydock::FindClass<Class>(TEXT(#Class), Base::StaticClass()); \
	}

/** A property and how it was changed, in the engine's editor. */
class FProperty
{
public:
	FName GetFName() const { return NAME_None; }
	FString GetName() const { return FString(); }
};
struct FPropertyChangedEvent
{
	FProperty* Property = nullptr;
	FProperty* MemberProperty = nullptr;

	FName GetPropertyName() const { return Property != nullptr ? Property->GetFName() : NAME_None; }
	FName GetMemberPropertyName() const { return MemberProperty != nullptr ? MemberProperty->GetFName() : NAME_None; }
};

/** The argument of constructors of older style: `UMyObject(const FObjectInitializer& ObjectInitializer)`. */
class DRYDOCK_API FObjectInitializer
{
public:
	static const FObjectInitializer& Get();

	/** A part of Owner, destroyed with it. */
	template<typename T>
	T* CreateDefaultSubobject(UObject* Owner, FName Name) const;
};

class DRYDOCK_API UObject : public UObjectBase
{
public:
	// The header tool writes Super into every class. Inherited, it names the direct base of a class derived from this
	// one; generated headers (drydock_add_plugin) write it as the header tool does.
	using Super = UObject;
	static UClass* StaticClass();
	/** The object's own class, once its StaticClass was called or a generated header named it; else UObject's. */
	UClass* GetClass() const;
	bool IsA(const UClass* Class) const;
	template<typename T>
	bool IsA() const
	{
		return dynamic_cast<const T*>(this) != nullptr;
	}

	UObject() = default;
	explicit UObject(const FObjectInitializer&) {}

	virtual UWorld* GetWorld() const { return nullptr; }
	/** Called once the object has its values: those of its constructor, then those given by ini files and config. */
	virtual void PostInitProperties() {}
	virtual void PostLoad() {}
	virtual void BeginDestroy() {}
	/** Never called: nothing is saved or loaded. */
	virtual void Serialize(class FArchive&) {}
	/** Never called: nothing is edited. */
	virtual void PostEditChangeProperty(FPropertyChangedEvent&) {}
	/** Two objects that live at one time have two numbers. */
	uint32 GetUniqueID() const { return UniqueID; }
	/** Null for an object that was made without one. */
	UObject* GetOuter() const { return Outer; }
	/** Ours: called by NewObject. */
	void SetOuter(UObject* InOuter) { Outer = InOuter; }
	/** A part of this object, destroyed with it. */
	template<typename T>
	T* CreateDefaultSubobject(FName SubobjectName)
	{
		const std::shared_ptr<T> Part = std::make_shared<T>();
		T* const Result = Part.get();
		Result->SetFName(SubobjectName);
		Result->SetOuter(this);
		Parts.push_back(Part);
		Drydock::FinishNewObject(*Result, typeid(T));
		return Result;
	}
	/** Nothing is collected here, rooted or not. */
	void AddToRoot() { bRooted = true; }
	void RemoveFromRoot() { bRooted = false; }
	bool IsRooted() const { return bRooted; }
	FString GetName() const { return Name.ToString(); }
	FName GetFName() const { return Name; }
	/** It is its class's default object. */
	bool IsTemplate() const { return bTemplate; }
	/** Ours: called by GetDefault. */
	void SetTemplate() { bTemplate = true; }
	/** Ours: the engine names objects when it makes them. */
	void SetFName(FName InName) { Name = InName; }

private:
	static uint32 MakeUniqueID();

	FName Name;
	uint32 UniqueID = MakeUniqueID();
	UObject* Outer = nullptr;
	bool bTemplate = false;
	bool bRooted = false;
	std::vector<std::shared_ptr<UObjectBase>> Parts;
};

template<typename T>
T* FObjectInitializer::CreateDefaultSubobject(UObject* Owner, FName Name) const
{
	return Owner->CreateDefaultSubobject<T>(Name);
}

/** "None" for null. */
inline FString GetNameSafe(const UObject* Object)
{
	return Object ? Object->GetName() : FString(TEXT("None"));
}

inline bool IsValid(const UObjectBase* Object)
{
	return Object != nullptr;
}

/** Null if Object is null or of another type. */
template<typename To, typename From>
To* Cast(From* Object)
{
	return dynamic_cast<To*>(Object);
}

template<typename To, typename From>
To* CastChecked(From* Object)
{
	To* Result = Cast<To>(Object);
	check(Result != nullptr);
	return Result;
}

/** A new object, which the caller owns: nothing collects it. */
template<typename T>
T* NewObject(UObject* Outer = nullptr, FName Name = NAME_None)
{
	T* Object = new T();
	Object->SetFName(Name);
	Object->SetOuter(Outer);
	Drydock::FinishNewObject(*Object, typeid(T));
	return Object;
}

namespace Drydock
{

/** The object that the run's config gives for that path or name ("assets"); null: none. */
DRYDOCK_API UObject* FindAsset(const TCHAR* Path);
/** Says, once for each path, that the config gives no asset of it and that class. */
DRYDOCK_API void WarnOfMissingAsset(const TCHAR* Path);
/** Says once for each name what a call of it does here, where that is not what the engine does. */
DRYDOCK_API void SayNeutral(const TCHAR* Name, const TCHAR* What);

} // namespace Drydock

/** The asset that the config gives for that path ("assets"). Null if there is none of that class, with a warning that
 * names the path. */
template<typename T>
T* LoadObject(UObject*, const TCHAR* Path, const TCHAR* = nullptr, uint32 = 0)
{
	T* Asset = nullptr;
	if constexpr (requires(UObject * Object) { dynamic_cast<T*>(Object); }) // T is complete
	{
		Asset = dynamic_cast<T*>(Drydock::FindAsset(Path));
	}
	if (Asset == nullptr)
	{
		Drydock::WarnOfMissingAsset(Path);
	}
	return Asset;
}
/** Null: objects are not found by their names. */
template<typename T>
T* FindObject(UObject*, const TCHAR*, bool = false)
{
	return nullptr;
}

/** The path of an asset. */
class FSoftObjectPath
{
public:
	FSoftObjectPath() = default;
	FSoftObjectPath(FString InPath)
		: Path(std::move(InPath))
	{
	}
	FSoftObjectPath(const TCHAR* InPath)
		: Path(InPath)
	{
	}

	const FString& ToString() const { return Path; }
	FString GetAssetPathString() const { return Path; }
	bool IsNull() const { return Path.IsEmpty(); }
	bool IsValid() const { return !IsNull(); }
	UObject* ResolveObject() const { return Drydock::FindAsset(*Path); }
	/** As LoadObject. */
	UObject* TryLoad() const { return LoadObject<UObject>(nullptr, *Path); }

private:
	FString Path;
};

/** Base of the U half of an interface; the I half is what classes implement. */
class DRYDOCK_API UInterface : public UObject
{
public:
	DRYDOCK_CLASS(UInterface, UObject)
	using UObject::UObject;
};

/** The object that holds a class's default values. */
template<typename T>
T* GetMutableDefault()
{
	static T Default;
	[[maybe_unused]] static const bool bMarked = (Default.SetTemplate(), true);
	return &Default;
}
template<typename T>
const T* GetDefault()
{
	return GetMutableDefault<T>();
}

/** A member pointer to an object: a plain pointer. */
template<typename T>
class TObjectPtr
{
public:
	TObjectPtr() = default;
	// A template, so that NULL, which is a number, means the pointer below.
	template<typename U>
	requires std::is_same_v<U, std::nullptr_t> TObjectPtr(U) {}
	TObjectPtr(T* InObject)
		: Object(InObject)
	{
	}
	template<typename U>
	requires std::is_convertible_v<U*, T*> TObjectPtr(const TObjectPtr<U>& Other)
		: Object(Other.Get())
	{
	}

	T* Get() const { return Object; }
	operator T*() const { return Object; }
	T* operator->() const { return Object; }
	T& operator*() const { return *Object; }

private:
	T* Object = nullptr;
};

/** Null once its object is destroyed. */
template<typename T = UObject>
class TWeakObjectPtr
{
public:
	TWeakObjectPtr() = default;
	TWeakObjectPtr(std::nullptr_t) {}
	TWeakObjectPtr(T* InObject)
		: Object(InObject)
		, LifeToken(InObject != nullptr ? InObject->GetLifeToken() : std::weak_ptr<const void>())
	{
	}

	bool IsValid() const { return !LifeToken.expired(); }
	T* Get() const { return IsValid() ? Object : nullptr; }
	T* operator->() const { return Get(); }
	T& operator*() const { return *Get(); }
	explicit operator bool() const { return IsValid(); }
	void Reset() { *this = TWeakObjectPtr(); }
	friend bool operator==(const TWeakObjectPtr& A, const TWeakObjectPtr& B) { return A.Get() == B.Get(); }

private:
	T* Object = nullptr;
	std::weak_ptr<const void> LifeToken;
};

/** In the engine it keeps the object from being collected; nothing is collected here. */
template<typename T>
class TStrongObjectPtr : public TObjectPtr<T>
{
public:
	using TObjectPtr<T>::TObjectPtr;

	bool IsValid() const { return this->Get() != nullptr; }
	void Reset(T* Object = nullptr) { *this = TStrongObjectPtr(Object); }
};

/** In the engine it names an asset that may not be loaded; here it is what was put into it. */
template<typename T = UObject>
class TSoftObjectPtr : public TObjectPtr<T>
{
public:
	using TObjectPtr<T>::TObjectPtr;
	TSoftObjectPtr() = default;
	/** The object of a path, or an object of another static type. */
	explicit TSoftObjectPtr(UObject* Object) requires(!std::is_same_v<T, UObject>)
		: TObjectPtr<T>(Cast<T>(Object))
	{
	}
	explicit TSoftObjectPtr(const FSoftObjectPath& InPath)
		: Path(InPath)
	{
	}

	const FSoftObjectPath& ToSoftObjectPath() const { return Path; }
	FString ToString() const { return Path.ToString(); }
	void Reset() { *this = TSoftObjectPtr(); }

	bool IsNull() const { return this->Get() == nullptr; }
	bool IsValid() const { return !IsNull(); }
	T* LoadSynchronous() const
	{
		return IsNull() && !Path.IsNull() ? LoadObject<T>(nullptr, *Path.ToString()) : this->Get();
	}

private:
	FSoftObjectPath Path;
};

/** A class of objects at run time, with its name, base and default object. Source: engine UObject/Class.h. */
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
