// The one world, its actors and its subsystems.
#include "Engine/World.h"

#include "CodeScope.h"
#include "GameFramework/Actor.h"
#include "GameFramework/WorldSettings.h"
#include "HAL/IConsoleManager.h"
#include "RendererScene.h"
#include "Subsystems/WorldSubsystem.h"
#include "TimerManager.h"
#include "UObject/Reflection.h"

#include <algorithm>

namespace
{

/** Never destroyed: static variables of any library may ask for it until the very end. */
UWorld* MakeWorld()
{
	UWorld* const World = new UWorld;
	Drydock::FSubsystems& Subsystems = Drydock::FSubsystems::Get();
	Subsystems.SetOuter(Drydock::ESubsystemKind::World, World);
	Subsystems.SetOuter(Drydock::ESubsystemKind::GameInstance, World->GetGameInstance());
	Drydock::GetConsoleWorld() = World;
	Drydock::GetWorldContext() = World;
	return World;
}

} // namespace

UWorld* GWorld = MakeWorld();

UWorld* UGameInstance::GetWorld() const
{
	return GWorld;
}

UWorld::UWorld()
	: Scene(new FScene(this))
	, GameInstance(new UGameInstance)
	, WorldSettings(new AWorldSettings)
	, TimerManager(new FTimerManager)
{
	SetFName(TEXT("World"));
}

UWorld::~UWorld()
{
	delete Scene;
	delete GameInstance;
	delete WorldSettings;
	delete TimerManager;
}

AWorldSettings* UWorld::GetWorldSettings(bool, bool) const
{
	return WorldSettings;
}

void UWorld::AddActor(const std::shared_ptr<AActor>& Actor)
{
	Actor->SetOuter(this);
	Actors.push_back(Actor);
	Actor->StartPlay();
}

void UWorld::RemoveActor(const AActor* Actor)
{
	std::erase(Placed, Actor);
	std::erase_if(Actors, [Actor](const std::shared_ptr<AActor>& Other) { return Other.get() == Actor; });
}

AActor* UWorld::PlaceEmptyActor()
{
	return Placed.emplace_back(SpawnActor<AActor>());
}

void UWorld::RemovePlacedActors()
{
	for (AActor* const Actor : std::exchange(Placed, {}))
	{
		Actor->Destroy();
	}
}

FSceneInterface::~FSceneInterface() = default;

bool UWorldSubsystem::ShouldCreateSubsystem(UObject* Outer) const
{
	const UWorld* const World = Cast<UWorld>(Outer);
	return World != nullptr && DoesSupportWorldType(World->WorldType);
}

UWorld* UWorldSubsystem::GetWorld() const
{
	return Cast<UWorld>(GetOuter());
}

bool UWorldSubsystem::DoesSupportWorldType(const EWorldType::Type) const
{
	return true;
}

void UWorldSubsystem::OnCollectionStarted()
{
	PostInitialize();
	OnWorldBeginPlay(*GetWorld());
	bStarted = true;
}

UWorld* UActorComponent::GetWorld() const
{
	return GWorld;
}

void UActorComponent::RegisterComponent()
{
	if (!bRegistered)
	{
		bRegistered = true;
		OnRegister();
		if (bAutoActivate && !IsActive())
		{
			Activate(true);
		}
		if (bWantsInitializeComponent)
		{
			InitializeComponent();
		}
		if (AActor* const Actor = GetOwner())
		{
			Actor->AddOwnedComponent(this);
		}
	}
}

UObject* UActorComponent::ToObject(AActor* Actor)
{
	return Actor;
}

void UActorComponent::Place(bool (*IsOne)(const UActorComponent*), UActorComponent* (*Make)(AActor*))
{
	for (const std::shared_ptr<AActor>& Actor : GWorld->GetActors())
	{
		if (std::ranges::any_of(Actor->GetOwnedComponents(), IsOne))
		{
			return;
		}
	}
	AActor* const Actor = GWorld->PlaceEmptyActor();
	UActorComponent* const Component = Make(Actor);
	if (USceneComponent* const Root = Cast<USceneComponent>(Component))
	{
		Actor->SetRootComponent(Root);
	}
	Component->RegisterComponent();
}

void UActorComponent::UnregisterComponent()
{
	if (bRegistered)
	{
		bRegistered = false;
		OnUnregister();
	}
}

UWorld* AActor::GetWorld() const
{
	return GWorld;
}

void AActor::Destroy()
{
	for (UActorComponent* const Component : GetOwnedComponents())
	{
		Component->EndPlay(EEndPlayReason::Destroyed);
		Component->UnregisterComponent();
	}
	EndPlay(EEndPlayReason::Destroyed);
	Destroyed();
	GWorld->RemoveActor(this);
}

void AActor::StartPlay()
{
	Owner = Drydock::MakeCodeOwner("Tick of actor " + std::string(*GetName()));
	PrimaryActorTick.SetTickFunctionEnable(PrimaryActorTick.bStartWithTickEnabled);
	PostInitializeComponents();
	for (UActorComponent* const Component : GetOwnedComponents())
	{
		Component->RegisterComponent();
	}
	bPlays = true;
	for (UActorComponent* const Component : GetOwnedComponents())
	{
		Component->StartPlay();
	}
	BeginPlay();
}

std::vector<UActorComponent*> AActor::GetOwnedComponents() const
{
	std::vector<UActorComponent*> Owned;
	for (const TWeakObjectPtr<UActorComponent>& Component : Components)
	{
		if (Component.IsValid())
		{
			Owned.push_back(Component.Get());
		}
	}
	return Owned;
}

void AActor::AddOwnedComponent(UActorComponent* Component)
{
	Components.AddUnique(Component);
	if (bPlays)
	{
		Component->StartPlay();
	}
}

void UActorComponent::StartPlay()
{
	if (!std::exchange(bPlays, true))
	{
		PrimaryComponentTick.SetTickFunctionEnable(PrimaryComponentTick.bStartWithTickEnabled);
		BeginPlay();
	}
}

FTimerManager& AActor::GetWorldTimerManager() const
{
	return GWorld->GetTimerManager();
}

FTimerManager& UGameInstance::GetTimerManager() const
{
	return GWorld->GetTimerManager();
}

float AActor::GetActorTimeDilation() const
{
	return CustomTimeDilation * GWorld->GetWorldSettings()->GetEffectiveTimeDilation();
}
