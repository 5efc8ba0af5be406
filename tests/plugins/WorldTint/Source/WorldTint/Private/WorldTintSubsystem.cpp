#include "WorldTintSubsystem.h"

#include "WorldTintExtension.h"

UWorldTintAsset::UWorldTintAsset(const FObjectInitializer& ObjectInitializer)
	: Super(ObjectInitializer)
	, Tint(FLinearColor(0.5f, 2.0f, 0.0f))
{
}

void UWorldTintSubsystem::Initialize(FSubsystemCollectionBase& Collection)
{
	Super::Initialize(Collection);
	Extension = FSceneViewExtensions::NewExtension<FWorldTintExtension>(GetWorld());
}

void UWorldTintSubsystem::OnWorldBeginPlay(UWorld& InWorld)
{
	Super::OnWorldBeginPlay(InWorld);
	Asset = NewObject<UWorldTintAsset>(this);
	Asset->Mode = EWorldTintMode::Multiply;
}

void UWorldTintSubsystem::Deinitialize()
{
	Extension.Reset();
	delete Asset.Get();
	Asset = nullptr;
	Super::Deinitialize();
}
