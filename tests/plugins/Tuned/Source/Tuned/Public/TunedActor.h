#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"

#include "TunedActor.generated.h"

/** What a level of it would have: adds to all colours when it begins to play, and to blue whenever it ticks. */
UCLASS()
class TUNED_API ATunedActor : public AActor
{
	GENERATED_BODY()

public:
	ATunedActor() { PrimaryActorTick.bCanEverTick = true; }

	virtual void BeginPlay() override
	{
		Super::BeginPlay();
		LiftAtPlay = Lift;
	}
	virtual void Tick(float DeltaSeconds) override
	{
		Super::Tick(DeltaSeconds);
		++NumTicks;
	}

	UPROPERTY(EditAnywhere, Category = "Tuned")
	float Lift = 0.0f;

	float LiftAtPlay = 0.0f;
	int32 NumTicks = 0;
};
