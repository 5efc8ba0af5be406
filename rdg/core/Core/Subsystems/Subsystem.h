// Subsystems: objects that live as long as the engine, or as the world, and that nobody makes by hand. Those of plugins
// are made after the modules have started (FModuleManager::StartupPendingModules), the engine's before
// FCoreDelegates::OnPostEngineInit and the world's after it, in the order of their registration. Which classes there
// are is in the code that drydock_add_plugin generates. Source: engine Subsystems/Subsystem.h, SubsystemCollection.h.
#pragma once

#include "Containers/Array.h"
#include "Templates/Function.h"
#include "UObject/Object.h"

#include <typeinfo>

class USubsystem;

namespace Drydock
{

/** The object whose lifetime a subsystem shares. */
enum class ESubsystemKind : uint8
{
	Engine,
	GameInstance,
	World,
	LocalPlayer,
};

} // namespace Drydock

/** The argument of Initialize. */
class DRYDOCK_API FSubsystemCollectionBase
{
public:
	explicit FSubsystemCollectionBase(Drydock::ESubsystemKind InKind)
		: Kind(InKind)
	{
	}

	/** Starts another subsystem of this collection now, so that it is ready. Null if there is none of that class. */
	template<typename T>
	T* InitializeDependency()
	{
		return static_cast<T*>(Start(typeid(T)));
	}

private:
	USubsystem* Start(const std::type_info& Type);

	Drydock::ESubsystemKind Kind;
};

class DRYDOCK_API USubsystem : public UObject
{
public:
	DRYDOCK_CLASS(USubsystem, UObject)
	using UObject::UObject;

	/** Outer: the engine (null here) or the world. */
	virtual bool ShouldCreateSubsystem(UObject* Outer) const;
	virtual void Initialize(FSubsystemCollectionBase& Collection);
	virtual void Deinitialize();

	/** Ours: all of its collection have been initialised. */
	virtual void OnCollectionStarted() {}
};

namespace Drydock
{

/** The description of a subsystem's class. */
struct FSubsystemClass
{
	const TCHAR* Name = nullptr;
	ESubsystemKind Kind = ESubsystemKind::Engine;
	const std::type_info* Type = nullptr;
	USubsystem* (*Make)() = nullptr;
};

/** The registered classes and the one object of each that has started. */
class DRYDOCK_API FSubsystems
{
public:
	static FSubsystems& Get();

	void Register(const FSubsystemClass& Class);
	/** Ends its object. */
	void Unregister(const std::type_info& Type);
	/** Sets the outer object that ShouldCreateSubsystem is asked with and GetOuter returns. */
	void SetOuter(ESubsystemKind Kind, UObject* Outer);
	/** Starts those of a kind that have not started. */
	void StartPending(ESubsystemKind Kind);
	USubsystem* Start(const std::type_info& Type);
	/** Calls Function for each object of a kind, until it answers true; those of the running plugin come first. */
	void ForEach(ESubsystemKind Kind, TFunctionRef<bool(USubsystem&)> Function) const;

	/** The first object of a kind that is a T; null if there is none. */
	template<typename T>
	T* Find(ESubsystemKind Kind) const
	{
		T* Result = nullptr;
		ForEach(Kind,
			[&Result](USubsystem& Subsystem)
			{
				Result = Cast<T>(&Subsystem);
				return Result != nullptr;
			});
		return Result;
	}

private:
	FSubsystems() = default;
};

/** Registers a class of a plugin for as long as the plugin is loaded; does nothing for classes that are not made by
 * themselves. Generated code has one for each UCLASS. */
template<typename T>
class TClassRegistration : private FNoncopyable
{
public:
	explicit TClassRegistration(const TCHAR* Name)
	{
		if constexpr (bIsMade)
		{
			FSubsystems::Get().Register({Name, T::SubsystemKind, &typeid(T),
				[]() -> USubsystem*
				{
					return new T();
				}});
		}
	}
	~TClassRegistration()
	{
		if constexpr (bIsMade)
		{
			FSubsystems::Get().Unregister(typeid(T));
		}
	}

private:
	static constexpr bool bIsMade = std::is_base_of_v<USubsystem, T> && !std::is_abstract_v<T>;
};

} // namespace Drydock
