// Makes the subsystems of all registered classes, and ends them, in the engine's order.
#include "Subsystems/Subsystem.h"

#include "CodeScope.h"
#include "Logging/LogMacros.h"

#include <map>

namespace Drydock
{

namespace
{

struct FEntry
{
	FSubsystemClass Class;
	FCodeOwner Owner;
	std::unique_ptr<USubsystem> Object; // null until started
	bool bAsked = false;                // whether it is to be made
	bool bNotified = false;             // its collection has started
};

struct FState
{
	std::vector<std::unique_ptr<FEntry>> Entries;
	std::map<ESubsystemKind, UObject*> Outers;
};

/** Never destroyed: libraries unregister at the very end of the program. */
FState& GetState()
{
	static auto* const State = new FState;
	return *State;
}

/** File name of the plugin whose code runs; empty for drydock's own. */
std::string GetRunningPlugin()
{
	const FCodeOwner* const Running = GetRunningCode();
	return Running != nullptr ? Running->Plugin : std::string();
}

/** Plugins may have classes of equal names, whose types count as equal: that of the running plugin comes first. */
FEntry* FindEntry(const std::type_info& Type)
{
	const std::string Running = GetRunningPlugin();
	FEntry* First = nullptr;
	for (const std::unique_ptr<FEntry>& Entry : GetState().Entries)
	{
		if (*Entry->Class.Type == Type && Entry->Owner.Plugin == Running)
		{
			return Entry.get();
		}
		First = First == nullptr && *Entry->Class.Type == Type ? Entry.get() : First;
	}
	return First;
}

/** That of the library that Type lies in. */
FEntry* FindOwnEntry(const std::type_info& Type)
{
	for (const std::unique_ptr<FEntry>& Entry : GetState().Entries)
	{
		if (Entry->Class.Type == &Type)
		{
			return Entry.get();
		}
	}
	return nullptr;
}

void StartEntry(FEntry& Entry)
{
	if (Entry.bAsked)
	{
		return;
	}
	Entry.bAsked = true;
	const FCodeOwner Owner = {Entry.Owner.Plugin, "Initialize of " + Entry.Owner.Callback};
	const FCodeScope Scope(Owner);
	UObject* const Outer = GetState().Outers[Entry.Class.Kind];
	std::unique_ptr<USubsystem> Object(Entry.Class.Make());
	Object->SetFName(Entry.Class.Name);
	Object->SetOuter(Outer);
	FinishNewObject(*Object, *Entry.Class.Type);
	if (Object->ShouldCreateSubsystem(Outer))
	{
		Entry.Object = std::move(Object);
		FSubsystemCollectionBase Collection(Entry.Class.Kind);
		Entry.Object->Initialize(Collection);
	}
}

} // namespace

FSubsystems& FSubsystems::Get()
{
	static FSubsystems Subsystems;
	return Subsystems;
}

void FSubsystems::Register(const FSubsystemClass& Class)
{
	const FEntry* const Present = FindEntry(*Class.Type);
	if (Present != nullptr && Present->Owner.Plugin == GetRunningPlugin())
	{
		UE_LOG(LogCore, Warning, "Subsystem %s is registered twice; the first one stays", Class.Name);
		return;
	}
	GetState().Entries.push_back(
		std::make_unique<FEntry>(FEntry{Class, MakeCodeOwner(std::string("subsystem ") + Class.Name), nullptr}));
}

void FSubsystems::Unregister(const std::type_info& Type)
{
	FEntry* const Entry = FindOwnEntry(Type);
	if (Entry == nullptr)
	{
		return;
	}
	if (Entry->Object != nullptr)
	{
		const FCodeOwner Owner = {Entry->Owner.Plugin, "Deinitialize of " + Entry->Owner.Callback};
		const FCodeScope Scope(Owner);
		Entry->Object->Deinitialize();
	}
	std::erase_if(GetState().Entries, [Entry](const std::unique_ptr<FEntry>& Other) { return Other.get() == Entry; });
}

void FSubsystems::SetOuter(ESubsystemKind Kind, UObject* Outer)
{
	GetState().Outers[Kind] = Outer;
}

void FSubsystems::StartPending(ESubsystemKind Kind)
{
	// By index: a subsystem may load a module, which brings others.
	std::vector<USubsystem*> Started;
	for (size_t Index = 0; Index < GetState().Entries.size(); ++Index)
	{
		FEntry& Entry = *GetState().Entries[Index];
		if (Entry.Class.Kind == Kind && !Entry.bNotified)
		{
			StartEntry(Entry);
			Entry.bNotified = true;
			Started.push_back(Entry.Object.get());
		}
	}
	for (USubsystem* const Subsystem : Started)
	{
		if (Subsystem != nullptr)
		{
			Subsystem->OnCollectionStarted();
		}
	}
}

USubsystem* FSubsystems::Start(const std::type_info& Type)
{
	FEntry* const Entry = FindEntry(Type);
	if (Entry == nullptr)
	{
		return nullptr;
	}
	StartEntry(*Entry);
	return Entry->Object.get();
}

void FSubsystems::ForEach(ESubsystemKind Kind, TFunctionRef<bool(USubsystem&)> Function) const
{
	const std::string Running = GetRunningPlugin();
	for (const bool bOwn : {true, false})
	{
		for (const std::unique_ptr<FEntry>& Entry : GetState().Entries)
		{
			if (Entry->Class.Kind == Kind && Entry->Object != nullptr && (Entry->Owner.Plugin == Running) == bOwn &&
				Function(*Entry->Object))
			{
				return;
			}
		}
	}
}

} // namespace Drydock

USubsystem* FSubsystemCollectionBase::Start(const std::type_info& Type)
{
	return Drydock::FSubsystems::Get().Start(Type);
}

bool USubsystem::ShouldCreateSubsystem(UObject*) const
{
	return true;
}

void USubsystem::Initialize(FSubsystemCollectionBase&) {}

void USubsystem::Deinitialize() {}
