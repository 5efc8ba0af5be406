// The world: there is one, of a game, and it is empty. It is what world subsystems belong to, what Family->Scene shows
// and what plugins ask for their subsystems. Source: engine file Engine/World.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/EngineBaseTypes.h"
#include "RHIFeatureLevel.h"
#include "Subsystems/Subsystem.h"

class AActor;
class APlayerController;
class AWorldSettings;
class FSceneInterface;
class FTimerManager;

class DRYDOCK_API UGameInstance : public UObject
{
public:
	DRYDOCK_CLASS(UGameInstance, UObject)
	using UObject::UObject;

	UWorld* GetWorld() const override;
	/** The world's (TimerManager.h). */
	FTimerManager& GetTimerManager() const;

	/** Null if no plugin brings it. */
	template<typename T>
	T* GetSubsystem() const
	{
		return Drydock::FSubsystems::Get().Find<T>(Drydock::ESubsystemKind::GameInstance);
	}
	template<typename T>
	static T* GetSubsystem(const UGameInstance* GameInstance)
	{
		return GameInstance ? GameInstance->GetSubsystem<T>() : nullptr;
	}
};

class UGameViewportClient;

/** How the engine names and places an actor; only its class and place matter here. */
struct FActorSpawnParameters
{
	FName Name;
	AActor* Owner = nullptr;
	uint32 ObjectFlags = 0;
};

class DRYDOCK_API UWorld : public UObject
{
public:
	UWorld();
	~UWorld() override;

	/** Never null; with the engine's defaults (GameFramework/WorldSettings.h). */
	AWorldSettings* GetWorldSettings(bool bCheckStreamingPersistent = false, bool bChecked = true) const;
	/** Null: there is no window. */
	UGameViewportClient* GetGameViewport() const { return nullptr; }

	UWorld* GetWorld() const override { return const_cast<UWorld*>(this); }

	EWorldType::Type WorldType = EWorldType::Game;
	/** Never null. */
	FSceneInterface* Scene;
	ERHIFeatureLevel::Type FeatureLevel = ERHIFeatureLevel::SM5;
	ERHIFeatureLevel::Type GetFeatureLevel() const { return FeatureLevel; }

	bool IsGameWorld() const { return WorldType == EWorldType::Game; }
	bool IsPreviewWorld() const { return false; }
	bool IsEditorWorld() const { return false; }
	bool HasBegunPlay() const { return true; }
	bool IsPaused() const { return false; }
	UGameInstance* GetGameInstance() const { return GameInstance; }
	APlayerController* GetFirstPlayerController() const { return nullptr; }

	/** Seconds since the world began, and since the frame before; they advance with the frames of a sequence. */
	double GetTimeSeconds() const { return TimeSeconds; }
	double GetRealTimeSeconds() const { return TimeSeconds; }
	float GetDeltaSeconds() const { return DeltaSeconds; }
	/** TimerManager.h */
	FTimerManager& GetTimerManager() const { return *TimerManager; }

	/** Null if no plugin brings it. */
	template<typename T>
	T* GetSubsystem() const
	{
		return Drydock::FSubsystems::Get().Find<T>(Drydock::ESubsystemKind::World);
	}
	template<typename T>
	static T* GetSubsystem(const UWorld* World)
	{
		return World ? World->GetSubsystem<T>() : nullptr;
	}

	/** A new actor, which the world owns, after BeginPlay of its components and of itself. */
	template<typename T>
	T* SpawnActor(const FVector& Location, const FRotator& Rotation = FRotator(0.0, 0.0, 0.0),
		const FActorSpawnParameters& = FActorSpawnParameters())
	{
		T* const Actor = SpawnActor<T>();
		Actor->SetActorLocationAndRotation(Location, Rotation);
		return Actor;
	}
	template<typename T>
	T* SpawnActor(const FActorSpawnParameters&)
	{
		return SpawnActor<T>();
	}
	template<typename T>
	T* SpawnActor()
	{
		const std::shared_ptr<T> Actor = std::make_shared<T>();
		Drydock::FinishNewObject(*Actor, typeid(T));
		AddActor(Actor);
		return Actor.get();
	}
	const std::vector<std::shared_ptr<AActor>>& GetActors() const { return Actors; }
	void RemoveActor(const AActor* Actor);

	/** Ours: an actor as a level has it, unless there is one of its class. */
	template<typename T>
	void PlaceActor()
	{
		for (const std::shared_ptr<AActor>& Actor : Actors)
		{
			if (dynamic_cast<const T*>(Actor.get()))
			{
				return;
			}
		}
		Placed.push_back(SpawnActor<T>());
	}
	/** Ours: an actor of a level, without components. */
	AActor* PlaceEmptyActor();
	/** Ours: ends the play of those. */
	void RemovePlacedActors();
	/** Ours: before a frame; the seconds since the frame before, and since the world began. Actors and components tick
	 * by their groups, timers come before TG_PostUpdateWork, and behind them FTickableGameObjects. */
	void Tick(float InDeltaSeconds, double InTimeSeconds);

private:
	void AddActor(const std::shared_ptr<AActor>& Actor);

	UGameInstance* GameInstance;
	AWorldSettings* WorldSettings;
	FTimerManager* TimerManager;
	double TimeSeconds = 0.0;
	float DeltaSeconds = 0.0f;
	std::vector<std::shared_ptr<AActor>> Actors;
	std::vector<AActor*> Placed;
};

/** The world. Always valid. */
extern DRYDOCK_API UWorld* GWorld;

/** The engine's context of a world: there is one, of the game. */
struct FWorldContext
{
	EWorldType::Type WorldType = EWorldType::Game;
	FName ContextHandle;
	UGameInstance* OwningGameInstance = nullptr;
	UGameViewportClient* GameViewport = nullptr; // there is no window

	UWorld* World() const { return GWorld; }
};
