// Keeps the registered modules and starts them.
#include "Modules/ModuleManager.h"

#include "CodeScope.h"
#include "Logging/LogMacros.h"
#include "Misc/CoreDelegates.h"
#include "Subsystems/Subsystem.h"

FModuleManager& FModuleManager::Get()
{
	static FModuleManager Manager;
	return Manager;
}

void FModuleManager::RegisterModule(FName Name, FModuleFactory Factory)
{
	if (FindEntry(Name) != nullptr)
	{
		UE_LOG(LogCore, Warning, "Two modules are named %s: both start, and LoadModule gives the first one",
			*Name.ToString());
	}
	Entries.Add(MakeUnique<FEntry>(
		FEntry{Name, Factory, Drydock::MakeCodeOwner("module " + std::string(*Name.ToString())), nullptr}));
}

void FModuleManager::UnregisterModule(FName Name, FModuleFactory Factory)
{
	const TUniquePtr<FEntry>* const Found = Entries.FindByPredicate(
		[&](const TUniquePtr<FEntry>& Entry) { return Entry->Name == Name && Entry->Factory == Factory; });
	if (FEntry* const Entry = Found != nullptr ? Found->Get() : nullptr)
	{
		if (Entry->Module.IsValid())
		{
			const Drydock::FCodeOwner Owner = {Entry->Owner.Plugin, "ShutdownModule of " + Entry->Owner.Callback};
			const Drydock::FCodeScope Scope(Owner);
			Entry->Module->ShutdownModule();
		}
		Entries.RemoveAll([Entry](const TUniquePtr<FEntry>& Other) { return Other.Get() == Entry; });
	}
}

void FModuleManager::StartupPendingModules()
{
	// By index: a module may load another while it starts.
	for (int32 Index = 0; Index < Entries.Num(); ++Index)
	{
		Startup(*Entries[Index]);
	}
	using enum Drydock::ESubsystemKind;
	Drydock::FSubsystems& Subsystems = Drydock::FSubsystems::Get();
	Subsystems.StartPending(Engine);
	// Subscribers hear it once, however often modules come; the list is emptied first, as a callee may subscribe.
	const FSimpleMulticastDelegate Waiting = FCoreDelegates::OnPostEngineInit;
	FCoreDelegates::OnPostEngineInit.Clear();
	Waiting.Broadcast();
	Subsystems.StartPending(GameInstance);
	Subsystems.StartPending(World);
	Subsystems.StartPending(LocalPlayer);
}

IModuleInterface* FModuleManager::LoadModule(FName Name)
{
	FEntry* Entry = FindEntry(Name);
	if (Entry == nullptr)
	{
		return nullptr;
	}
	Startup(*Entry);
	return Entry->Module.Get();
}

IModuleInterface& FModuleManager::LoadModuleChecked(FName Name)
{
	IModuleInterface* Module = LoadModule(Name);
	checkf(Module != nullptr, "Module %s is not registered", *Name.ToString());
	return *Module;
}

IModuleInterface* FModuleManager::GetModule(FName Name)
{
	FEntry* Entry = FindEntry(Name);
	return Entry != nullptr ? Entry->Module.Get() : nullptr;
}

void FModuleManager::Startup(FEntry& Entry)
{
	if (!Entry.Module.IsValid())
	{
		const Drydock::FCodeOwner Owner = {Entry.Owner.Plugin, "StartupModule of " + Entry.Owner.Callback};
		Drydock::CallCode(Owner,
			[&]
			{
				Entry.Module = TUniquePtr<IModuleInterface>(Entry.Factory());
				Entry.Module->StartupModule();
			});
	}
}

FModuleManager::FEntry* FModuleManager::FindEntry(FName Name)
{
	const TUniquePtr<FEntry>* Found =
		Entries.FindByPredicate([Name](const TUniquePtr<FEntry>& Entry) { return Entry->Name == Name; });
	return Found != nullptr ? Found->Get() : nullptr;
}
