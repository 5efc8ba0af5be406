// Questions about the game: there is a world with its actors, and nobody plays. Source: engine files
// Kismet/GameplayStatics.h, Kismet/KismetSystemLibrary.h.
#pragma once

#include "Engine/Engine.h"
#include "GameFramework/Actor.h"
#include "HAL/IConsoleManager.h"
#include "Kismet/BlueprintFunctionLibrary.h"

class APawn;
class APlayerCameraManager;

class DRYDOCK_API UGameplayStatics : public UBlueprintFunctionLibrary
{
public:
	/** Null: nobody plays. So are the next ones. */
	static APlayerController* GetPlayerController(const UObject*, int32)
	{
		return NoPlayer<APlayerController>("UGameplayStatics::GetPlayerController");
	}
	static APawn* GetPlayerPawn(const UObject*, int32) { return NoPlayer<APawn>("UGameplayStatics::GetPlayerPawn"); }
	static APlayerCameraManager* GetPlayerCameraManager(const UObject*, int32)
	{
		return NoPlayer<APlayerCameraManager>("UGameplayStatics::GetPlayerCameraManager");
	}

	static void GetAllActorsOfClass(const UObject*, TSubclassOf<AActor> ActorClass, TArray<AActor*>& OutActors)
	{
		OutActors.Reset();
		for (const std::shared_ptr<AActor>& Actor : GWorld->GetActors())
		{
			if (ActorClass.Get() != nullptr && Actor->IsA(ActorClass.Get()))
			{
				OutActors.Add(Actor.get());
			}
		}
	}
	static void GetAllActorsWithTag(const UObject*, FName Tag, TArray<AActor*>& OutActors)
	{
		OutActors.Reset();
		for (const std::shared_ptr<AActor>& Actor : GWorld->GetActors())
		{
			if (Actor->ActorHasTag(Tag))
			{
				OutActors.Add(Actor.get());
			}
		}
	}
	/** The first one, or null. */
	static AActor* GetActorOfClass(const UObject* WorldContextObject, TSubclassOf<AActor> ActorClass)
	{
		TArray<AActor*> Actors;
		GetAllActorsOfClass(WorldContextObject, ActorClass, Actors);
		return Actors.IsEmpty() ? nullptr : Actors[0];
	}
	static double GetWorldDeltaSeconds(const UObject*) { return static_cast<double>(GWorld->GetDeltaSeconds()); }
	static double GetTimeSeconds(const UObject*) { return GWorld->GetTimeSeconds(); }
	static double GetRealTimeSeconds(const UObject*) { return GWorld->GetRealTimeSeconds(); }

private:
	template<typename T>
	static T* NoPlayer(const TCHAR* Name)
	{
		Drydock::SayNeutral(Name, TEXT("nobody plays here, and the answer is null"));
		return nullptr;
	}
};

class DRYDOCK_API UKismetSystemLibrary : public UBlueprintFunctionLibrary
{
public:
	/** A line of the log; each text once. */
	static void PrintString(const UObject*, const FString& Text = TEXT("Hello"), bool = true, bool = true,
		FLinearColor Color = FLinearColor(0.0f, 0.66f, 1.0f), float Duration = 2.0f, FName = NAME_None)
	{
		GEngine->AddOnScreenDebugMessage(0, Duration, Color.ToFColor(true), Text);
	}
	/** "r.Name Value"; other commands are left out, and a warning names them. */
	static void ExecuteConsoleCommand(const UObject*, const FString& Command, APlayerController* = nullptr)
	{
		FString Name, Value;
		IConsoleVariable* const Variable =
			Command.Split(TEXT(" "), &Name, &Value) ? IConsoleManager::Get().FindConsoleVariable(*Name) : nullptr;
		if (Variable == nullptr)
		{
			Drydock::SayNeutral(*FString::Printf("console command '%s'", *Command), TEXT("it does nothing here"));
			return;
		}
		Variable->Set(*Value, ECVF_SetByConsole);
	}
	static double GetGameTimeInSeconds(const UObject*) { return GWorld->GetTimeSeconds(); }
};
