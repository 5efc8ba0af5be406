#pragma once

#include "CoreMinimal.h"
#include "Engine/DeveloperSettings.h"
#include "Engine/Texture.h"
#include "Subsystems/EngineSubsystem.h"

#include "TunedSettings.generated.h"

UENUM()
enum class ETunedMode : uint8
{
	Off UMETA(DisplayName = "Off"),
	Multiply UMETA(DisplayName = "Multiply, as (most) do"),
	Add = 5,
};

USTRUCT(BlueprintType)
struct FTunedWeights
{
	GENERATED_BODY()

	UPROPERTY(EditAnywhere, Category = "Tuned", meta = (ClampMin = "0", ToolTip = "a factor; (really)"))
	float Scale = 1.0f;

	UPROPERTY(EditAnywhere, Category = "Tuned")
	FVector Lift = FVector(0.0, 0.0, 0.0);
};

UCLASS(Config = Game, defaultconfig, meta = (DisplayName = "Tuned"))
class TUNED_API UTunedSettings : public UDeveloperSettings
{
	GENERATED_BODY()

public:
	UTunedSettings()
		: bInvert(false)
	{
	}

	virtual void PostInitProperties() override
	{
		Super::PostInitProperties();
		SumOfOffsets = 0.0f;
		for (const float Offset : Offsets)
		{
			SumOfOffsets += Offset;
		}
	}

	UPROPERTY(Config, EditAnywhere, Category = "Tuned")
	FLinearColor Tint = FLinearColor::White;

	UPROPERTY(Config, EditAnywhere, Category = "Tuned")
	ETunedMode Mode = ETunedMode::Off;

	UPROPERTY(Config, EditAnywhere, Category = "Tuned")
	TArray<float> Offsets;

	UPROPERTY(Config, EditAnywhere, Category = "Tuned")
	FTunedWeights Weights;

	UPROPERTY(Config, EditAnywhere, Category = "Tuned")
	FString Label;

	UPROPERTY(EditAnywhere, Category = "Tuned", meta = (EditCondition = "Mode != ETunedMode::Off"))
	int32 Steps = 1;

	UPROPERTY(EditAnywhere, Category = "Tuned")
	uint8 bInvert : 1;

	UPROPERTY(EditAnywhere, Category = "Tuned")
	TObjectPtr<UTexture2D> Mask;

#if WITH_EDITORONLY_DATA
	UPROPERTY(EditAnywhere, Category = "Tuned")
	float OnlyInTheEditor = 0.0f;
#endif

	float GetSecret() const
	{
		return Secret;
	}
	float GetSumOfOffsets() const
	{
		return SumOfOffsets;
	}

private:
	UPROPERTY(Config)
	float Secret = 0.0f;

	float SumOfOffsets = 0.0f;
};

/** What a subsystem has when it is initialised. */
UCLASS()
class TUNED_API UTunedSubsystem : public UEngineSubsystem
{
	GENERATED_BODY()

public:
	virtual void Initialize(FSubsystemCollectionBase& Collection) override;

	UPROPERTY(EditAnywhere, Category = "Tuned")
	float Boost = 1.0f;

	float BoostAtStart = 0.0f;
};
