#pragma once

#include "CoreMinimal.h"
#include "Engine/DataAsset.h"
#include "Subsystems/WorldSubsystem.h"

#include "WorldTintSubsystem.generated.h"

class FWorldTintExtension;

UENUM(BlueprintType)
enum class EWorldTintMode : uint8
{
	Off UMETA(DisplayName = "Off"),
	Multiply UMETA(DisplayName = "Multiply"),
};

UCLASS(BlueprintType)
class WORLDTINT_API UWorldTintAsset : public UDataAsset
{
	GENERATED_UCLASS_BODY()

	UPROPERTY(EditAnywhere, Category = Tint)
	FLinearColor Tint;

	UPROPERTY(EditAnywhere, Category = Tint)
	EWorldTintMode Mode = EWorldTintMode::Off;
};

/** Holds the asset that the extension tints with. */
UCLASS()
class WORLDTINT_API UWorldTintSubsystem : public UWorldSubsystem
{
	GENERATED_BODY()

public:
	virtual void Initialize(FSubsystemCollectionBase& Collection) override;
	virtual void Deinitialize() override;
	virtual void OnWorldBeginPlay(UWorld& InWorld) override;

	UFUNCTION(BlueprintPure, Category = "Tint")
	const UWorldTintAsset* GetAsset() const { return Asset; }

protected:
	virtual bool DoesSupportWorldType(const EWorldType::Type WorldType) const override
	{
		return WorldType == EWorldType::Game || WorldType == EWorldType::PIE;
	}

private:
	UPROPERTY()
	TObjectPtr<UWorldTintAsset> Asset;

	TSharedPtr<FWorldTintExtension, ESPMode::ThreadSafe> Extension;
};
