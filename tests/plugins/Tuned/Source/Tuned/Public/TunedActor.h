#pragma once

#include "CoreMinimal.h"
#include "Engine/TextureRenderTarget2D.h"
#include "GameFramework/Actor.h"
#include "Kismet/KismetRenderingLibrary.h"

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

	/** Fills a target with the width of a picture and more. */
	UFUNCTION(BlueprintCallable, Category = "Tuned")
	void Paint(UTextureRenderTarget2D* Into, const UTexture2D* From)
	{
		const float Width = From->GetSurfaceWidth();
		UKismetRenderingLibrary::ClearRenderTarget2D(this, Into, FLinearColor(Width, 0.25f, 0.5f, 1.0f));
		UKismetRenderingLibrary::ClearRenderTarget2D(this, Target, FLinearColor(0.0f, Width, 0.0f, 1.0f));
	}

	/** Fills the project's target. */
	UFUNCTION(BlueprintCallable, Category = "Tuned")
	void PaintAsset()
	{
		UTextureRenderTarget2D* Asset = LoadObject<UTextureRenderTarget2D>(
			nullptr, TEXT("/Script/Engine.TextureRenderTarget2D'/Tuned/RT_Asset.RT_Asset'"));
		UKismetRenderingLibrary::ClearRenderTarget2D(this, Asset, FLinearColor(4.0f, 3.0f, 2.0f, 1.0f));
		check(LoadObject<UTexture2D>(nullptr, TEXT("/Tuned/RT_Asset.RT_Asset")) == nullptr);
	}

	UPROPERTY(EditAnywhere, Category = "Tuned")
	TObjectPtr<UTextureRenderTarget2D> Target;

	float LiftAtPlay = 0.0f;
	int32 NumTicks = 0;
};
