#pragma once

#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "Kismet/BlueprintAsyncActionBase.h"
#include "Kismet/BlueprintFunctionLibrary.h"
#include "Subsystems/WorldSubsystem.h"
#include "TimerManager.h"

#include "TickingActor.generated.h"

/** Counts the seconds that it is ticked with, twice each half second's worth. */
UCLASS()
class TICKING_API UTickingComponent : public UActorComponent
{
	GENERATED_BODY()

public:
	UTickingComponent()
	{
		PrimaryComponentTick.bCanEverTick = true;
		PrimaryComponentTick.TickInterval = 0.5f;
	}
	virtual void TickComponent(
		float DeltaTime, ELevelTick TickType, FActorComponentTickFunction* ThisTickFunction) override
	{
		Super::TickComponent(DeltaTime, TickType, ThisTickFunction);
		Seconds += DeltaTime;
	}

	float Seconds = 0.0f;
};

UCLASS()
class TICKING_API UTickingSubsystem : public UTickableWorldSubsystem
{
	GENERATED_BODY()

public:
	virtual void Tick(float DeltaTime) override
	{
		Super::Tick(DeltaTime);
		Seconds += DeltaTime;
	}
	virtual TStatId GetStatId() const override
	{
		RETURN_QUICK_DECLARE_CYCLE_STAT(UTickingSubsystem, STATGROUP_Tickables);
	}

	UFUNCTION(BlueprintCallable, Category = "Ticking")
	void Start(float InFirst);

	float Seconds = 0.0f;
	float First = 0.0f;
};

UENUM(BlueprintType)
enum class ETickingMode : uint8
{
	Still,
	Glowing,
};

UCLASS()
class TICKING_API ATickingActor : public AActor
{
	GENERATED_BODY()

public:
	ATickingActor()
	{
		PrimaryActorTick.bCanEverTick = true;
		Component = CreateDefaultSubobject<UTickingComponent>(TEXT("Component"));
	}
	virtual void BeginPlay() override;
	virtual void Tick(float DeltaSeconds) override
	{
		Super::Tick(DeltaSeconds);
		Seconds += DeltaSeconds;
	}

	/** What a Blueprint of the level would do. */
	UFUNCTION(BlueprintCallable, Category = "Ticking", meta = (DisplayName = "Glow (now)"))
	void SetGlow(ETickingMode InMode, FLinearColor InColor, const FString& InName);

	UFUNCTION(BlueprintCallable)
	static void AddGlow(UObject* WorldContextObject, float Amount)
	{
		check(WorldContextObject->GetWorld() == GWorld);
		Added += Amount;
	}

	UFUNCTION(BlueprintImplementableEvent)
	void OnGlow();

	/** Nothing defines it. */
	UFUNCTION(BlueprintCallable)
	void Undefined();

	UPROPERTY(EditAnywhere, Category = "Ticking")
	float Rate = 0.25f;

	UPROPERTY()
	TObjectPtr<UTickingComponent> Component;

	float Seconds = 0.0f;
	int32 NumTimerCalls = 0;
	int32 NumNextTicks = 0;
	ETickingMode Mode = ETickingMode::Still;
	FLinearColor Color = FLinearColor::Black;
	FString Name;
	static float Added;

private:
	UFUNCTION(BlueprintCallable)
	void SetFactor(int32 InFactor) { Factor = InFactor; }
	void OnTimer();

	int32 Factor = 1;
	FTimerHandle Timer;

	friend class FTickingExtension;
};

/** Nobody makes one but a level. It is active from the start. */
UCLASS(meta = (BlueprintSpawnableComponent))
class TICKING_API ULevelComponent : public USceneComponent
{
	GENERATED_BODY()

public:
	ULevelComponent() { bAutoActivate = true; }
	virtual void InitializeComponent() override
	{
		Initialized = 64.0f;
	} // which bWantsInitializeComponent does not ask for
	virtual void BeginPlay() override
	{
		Super::BeginPlay();
		AtPlay = Amount;
	}

	UFUNCTION(BlueprintCallable)
	void Double() { AtPlay *= 2.0f; }

	/** Of those in the world, and a half for each UTickingComponent that no ATickingActor has. */
	static float GetSum();

	UPROPERTY(EditAnywhere, Category = "Ticking")
	float Amount = 0.0f;

	float AtPlay = 0.0f;
	float Initialized = 0.0f;
};

/** Adds to the actor's picture once a Blueprint has activated it. */
UCLASS()
class TICKING_API UTickingAction : public UBlueprintAsyncActionBase
{
	GENERATED_BODY()

public:
	UFUNCTION(BlueprintCallable, meta = (BlueprintInternalUseOnly = "true", WorldContext = "WorldContextObject"))
	static UTickingAction* AddLater(UObject* WorldContextObject, float InAmount)
	{
		UTickingAction* const Action = NewObject<UTickingAction>();
		Action->Amount = InAmount;
		Action->RegisterWithGameInstance(WorldContextObject);
		return Action;
	}
	virtual void Activate() override
	{
		ATickingActor::Added += Amount;
		SetReadyToDestroy();
	}

	float Amount = 0.0f;
};

/** Nobody but the engine makes one. */
UCLASS()
class TICKING_API UTickingLibrary : public UBlueprintFunctionLibrary
{
	GENERATED_BODY()

	UTickingLibrary() = default;

public:
	UFUNCTION(BlueprintCallable)
	static void Say(float Word) { ATickingActor::Added += Word; }
};
