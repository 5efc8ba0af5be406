// Modules: IMPLEMENT_MODULE registers one while its library is loaded; it starts before the first frame, when all
// static variables of the library are there. Source: engine Modules/ModuleManager.h.
#pragma once

#include "Containers/Array.h"
#include "Delegates/Delegate.h"
#include "Modules/ModuleInterface.h"
#include "RunningCode.h"
#include "Templates/Function.h"
#include "Templates/UniquePtr.h"
#include "UObject/NameTypes.h"

class DRYDOCK_API FModuleManager
{
public:
	using FModuleFactory = IModuleInterface* (*)();

	static FModuleManager& Get();

	/** Starts all modules that were registered and have not started, in the order of registration; then the engine's
	 *  subsystems; then broadcasts FCoreDelegates::OnPostEngineInit to those who wait for it; then starts the
	 *  subsystems of game, world and player. Called by what renders frames; ours. */
	void StartupPendingModules();

	/** Starts it if need be; null if no library registered that name. */
	IModuleInterface* LoadModule(FName Name);
	IModuleInterface& LoadModuleChecked(FName Name);
	/** Null unless it has started. */
	IModuleInterface* GetModule(FName Name);
	bool IsModuleLoaded(FName Name) { return GetModule(Name) != nullptr; }
	template<typename ModuleType>
	static ModuleType& LoadModuleChecked(FName Name)
	{
		return static_cast<ModuleType&>(Get().LoadModuleChecked(Name));
	}
	template<typename ModuleType>
	static ModuleType& GetModuleChecked(FName Name)
	{
		return LoadModuleChecked<ModuleType>(Name);
	}
	template<typename ModuleType>
	static ModuleType* GetModulePtr(FName Name)
	{
		return static_cast<ModuleType*>(Get().GetModule(Name));
	}

	/** Ours: what IMPLEMENT_MODULE calls. Modules of one name all start; the first one has the name. */
	void RegisterModule(FName Name, FModuleFactory Factory);
	/** Shuts the module down if it has started, and forgets it. */
	void UnregisterModule(FName Name, FModuleFactory Factory);

private:
	struct FEntry
	{
		FName Name;
		FModuleFactory Factory;
		Drydock::FCodeOwner Owner;
		TUniquePtr<IModuleInterface> Module; // null until started
	};

	FModuleManager() = default;
	void Startup(FEntry& Entry);
	FEntry* FindEntry(FName Name);

	TArray<TUniquePtr<FEntry>> Entries;
};

namespace Drydock
{

/** Registers a module for as long as its library is loaded. */
class FModuleRegistration
{
public:
	FModuleRegistration(const TCHAR* InName, FModuleManager::FModuleFactory InFactory)
		: Name(InName)
		, Factory(InFactory)
	{
		FModuleManager::Get().RegisterModule(Name, Factory);
	}
	~FModuleRegistration() { FModuleManager::Get().UnregisterModule(Name, Factory); }

private:
	FName Name;
	FModuleManager::FModuleFactory Factory;
};

} // namespace Drydock

#define IMPLEMENT_MODULE(ModuleClass, ModuleName) \
	static ::Drydock::FModuleRegistration GModuleRegistration_##ModuleName( \
		#ModuleName, []() -> IModuleInterface* { return new ModuleClass(); });
#define IMPLEMENT_GAME_MODULE(ModuleClass, ModuleName) IMPLEMENT_MODULE(ModuleClass, ModuleName)
#define IMPLEMENT_PRIMARY_GAME_MODULE(ModuleClass, ModuleName, GameName) IMPLEMENT_MODULE(ModuleClass, ModuleName)
