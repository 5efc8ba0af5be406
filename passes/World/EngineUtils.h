// Iteration over the actors of the world. Source: engine file EngineUtils.h.
#pragma once

#include "GameFramework/Actor.h"

/** `for (TActorIterator<AMyActor> It(World); It; ++It)`. */
template<typename ActorType>
class TActorIterator
{
public:
	explicit TActorIterator(const UWorld* World)
	{
		for (const std::shared_ptr<AActor>& Actor : World->GetActors())
		{
			if (ActorType* const Found = Cast<ActorType>(Actor.get()))
			{
				Actors.Add(Found);
			}
		}
	}

	explicit operator bool() const { return Index < Actors.Num(); }
	TActorIterator& operator++()
	{
		++Index;
		return *this;
	}
	ActorType* operator*() const { return Actors[Index]; }
	ActorType* operator->() const { return Actors[Index]; }

private:
	TArray<ActorType*> Actors;
	int32 Index = 0;
};
