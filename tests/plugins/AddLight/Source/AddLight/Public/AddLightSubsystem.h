#pragma once

#include "CoreMinimal.h"
#include "Subsystems/EngineSubsystem.h"
#include "AddLightSubsystem.generated.h"

class FAddLightExtension;

/** How the light is given; read by the extension. */
USTRUCT(BlueprintType)
struct ADDLIGHT_API FAddLightSettings
{
	GENERATED_BODY()

	UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Light", meta = (ClampMin = "0.0"))
	FLinearColor Color = FLinearColor(1.0f, 0.5f, 0.25f);
};

// The base of this plugin's subsystems: Super::Initialize must come here first.
UCLASS(Abstract)
class ADDLIGHT_API UAddLightSubsystemBase : public UEngineSubsystem
{
	GENERATED_BODY()

public:
	virtual void Initialize(FSubsystemCollectionBase& Collection) override;
	virtual void Tint(FAddLightSettings& Settings) = 0;

	UPROPERTY(Transient)
	FAddLightSettings Settings;
};

UCLASS()
class ADDLIGHT_API UAddLightSubsystem final : public UAddLightSubsystemBase
{
	GENERATED_BODY()

public:
	virtual void Initialize(FSubsystemCollectionBase& Collection) override;
	virtual void Deinitialize() override;
	virtual void Tint(FAddLightSettings& InSettings) override;

	UFUNCTION(BlueprintCallable, Category = "Light")
	FLinearColor GetColor() const { return Settings.Color; }

private:
	TSharedPtr<FAddLightExtension, ESPMode::ThreadSafe> Extension;
};
