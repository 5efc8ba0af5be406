// A frame's time for the world: actors and their components by groups, timers, objects that tick by themselves.
#include "CodeScope.h"
#include "GameFramework/Actor.h"
#include "RangeTools.h"
#include "Subsystems/WorldSubsystem.h"
#include "Tickable.h"
#include "TimerManager.h"

namespace
{

/** Never destroyed: static variables of any library end later. */
std::vector<FTickableGameObject*>& GetTickables()
{
	static auto* const Tickables = new std::vector<FTickableGameObject*>;
	return *Tickables;
}

} // namespace

FTickableGameObject::FTickableGameObject()
	: Owner(Drydock::MakeCodeOwner("Tick of an FTickableGameObject"))
{
	GetTickables().push_back(this);
}

FTickableGameObject::~FTickableGameObject()
{
	std::erase(GetTickables(), this);
}

void FTickableGameObject::TickAll(float DeltaSeconds)
{
	const std::vector<FTickableGameObject*> Now = GetTickables();
	for (FTickableGameObject* const Object : Now)
	{
		if (!Drydock::Contains(GetTickables(), Object))
		{
			continue; // an earlier one has ended it
		}
		Drydock::CallCode(Object->Owner,
			[&]
			{
				const ETickableTickType Type = Object->GetTickableTickType();
				const UObject* const Default = dynamic_cast<const UObject*>(Object);
				const bool bTicks = Type != ETickableTickType::Never && !(Default != nullptr && Default->IsTemplate());
				if (bTicks && (Type == ETickableTickType::Always || Object->IsTickable()))
				{
					Object->Tick(DeltaSeconds);
				}
			});
	}
}

FTimerManager::FTimer& FTimerManager::Add(const FTimerDelegate& Delegate, double Delay)
{
	return Timers.emplace_back(
		FTimer{++LastId, Delegate, 0.0, false, false, Now + Delay, Drydock::MakeCodeOwner("a timer")});
}

FTimerManager::FTimer* FTimerManager::Find(FTimerHandle Handle) const
{
	return Handle.IsValid() ? Drydock::FindItem(Timers, Handle.Handle, &FTimer::Id) : nullptr;
}

void FTimerManager::SetTimer(
	FTimerHandle& InOutHandle, const FTimerDelegate& Delegate, float Rate, bool bLoop, float FirstDelay)
{
	ClearTimer(InOutHandle);
	if (Rate > 0.0f)
	{
		FTimer& Timer = Add(Delegate, static_cast<double>(FirstDelay >= 0.0f ? FirstDelay : Rate));
		Timer.Rate = static_cast<double>(Rate);
		Timer.bLoop = bLoop;
		InOutHandle.Handle = Timer.Id;
	}
}

FTimerHandle FTimerManager::SetTimerForNextTick(const FTimerDelegate& Delegate)
{
	FTimerHandle Handle;
	Handle.Handle = Add(Delegate, 0.0).Id;
	return Handle;
}

void FTimerManager::ClearTimer(FTimerHandle& InOutHandle)
{
	std::erase_if(Timers, [&](const FTimer& Timer) { return Timer.Id == InOutHandle.Handle; });
	InOutHandle.Invalidate();
}

void FTimerManager::ClearAllTimersForObject(const void* Object)
{
	std::erase_if(Timers, [&](const FTimer& Timer) { return Timer.Delegate.IsBoundToObject(Object); });
}

void FTimerManager::PauseTimer(FTimerHandle Handle)
{
	if (IsTimerActive(Handle))
	{
		Find(Handle)->bPaused = true;
		Find(Handle)->Due -= Now;
	}
}

void FTimerManager::UnPauseTimer(FTimerHandle Handle)
{
	if (IsTimerPaused(Handle))
	{
		Find(Handle)->bPaused = false;
		Find(Handle)->Due += Now;
	}
}

float FTimerManager::GetTimerRate(FTimerHandle Handle) const
{
	return TimerExists(Handle) ? static_cast<float>(Find(Handle)->Rate) : -1.0f;
}

float FTimerManager::GetTimerRemaining(FTimerHandle Handle) const
{
	const FTimer* const Timer = Find(Handle);
	return Timer != nullptr ? static_cast<float>(Timer->Due - (Timer->bPaused ? 0.0 : Now)) : -1.0f;
}

float FTimerManager::GetTimerElapsed(FTimerHandle Handle) const
{
	return TimerExists(Handle) ? GetTimerRate(Handle) - GetTimerRemaining(Handle) : -1.0f;
}

void FTimerManager::Tick(float DeltaTime)
{
	const uint64 Last = LastId; // those that are set meanwhile wait
	Now += static_cast<double>(DeltaTime);
	for (;;)
	{
		FTimer* Next = nullptr;
		for (FTimer& Timer : Timers)
		{
			const bool bDue = Timer.Id <= Last && !Timer.bPaused && Timer.Due <= Now;
			Next = bDue && (Next == nullptr || Timer.Due < Next->Due) ? &Timer : Next;
		}
		if (Next == nullptr)
		{
			return;
		}
		const FTimer Called = *Next; // the call may set and clear timers
		if (Called.bLoop)
		{
			Next->Due += Called.Rate;
		}
		else
		{
			Timers.erase(Timers.begin() + (Next - Timers.data()));
		}
		if (!Called.Delegate.IsBound())
		{
			std::erase_if(Timers, [&](const FTimer& Timer) { return Timer.Id == Called.Id; });
			continue;
		}
		Drydock::CallCode(Called.Owner, [&] { Called.Delegate.ExecuteIfBound(); });
	}
}

bool FTickFunction::Advance(float DeltaSeconds, float& OutSeconds)
{
	Waited += DeltaSeconds;
	if (!bCanEverTick || !bTickEnabled || Waited < TickInterval)
	{
		Waited = bTickEnabled ? Waited : 0.0f;
		return false;
	}
	OutSeconds = std::exchange(Waited, 0.0f);
	return true;
}

void AActor::TickGroup(ETickingGroup Group, float DeltaSeconds)
{
	const float OwnSeconds = DeltaSeconds * CustomTimeDilation;
	float Seconds = 0.0f;
	const std::weak_ptr<const void> Life = GetLifeToken();
	if (PrimaryActorTick.TickGroup == Group && PrimaryActorTick.Advance(OwnSeconds, Seconds))
	{
		Drydock::CallCode(Owner, [&] { Tick(Seconds); });
	}
	const TArray<TWeakObjectPtr<UActorComponent>> Now =
		Life.expired() ? TArray<TWeakObjectPtr<UActorComponent>>() : Components;
	for (const TWeakObjectPtr<UActorComponent>& Component : Now)
	{
		if (Life.expired() || !Component.IsValid() || !Component->IsRegistered())
		{
			continue; // an earlier one has ended it
		}
		FActorComponentTickFunction& Function = Component->PrimaryComponentTick;
		if (Function.TickGroup == Group && Function.Advance(OwnSeconds, Seconds))
		{
			Drydock::CallCode(Owner, [&] { Component->TickComponent(Seconds, LEVELTICK_All, &Function); });
		}
	}
}

void UWorld::Tick(float InDeltaSeconds, double InTimeSeconds)
{
	DeltaSeconds = InDeltaSeconds;
	TimeSeconds = InTimeSeconds;
	const auto TickGroups = [this](int First, int End)
	{
		for (int Group = First; Group < End; ++Group)
		{
			const std::vector<std::shared_ptr<AActor>> Now = Actors; // one that ticks may spawn others, and end them
			for (const std::shared_ptr<AActor>& Actor : Now)
			{
				if (Drydock::Contains(Actors, Actor))
				{
					Actor->TickGroup(ETickingGroup(Group), DeltaSeconds);
				}
			}
		}
	};
	TickGroups(TG_PrePhysics, TG_PostUpdateWork);
	GetTimerManager().Tick(DeltaSeconds);
	FTickableGameObject::TickAll(DeltaSeconds);
	TickGroups(TG_PostUpdateWork, TG_MAX);
}
