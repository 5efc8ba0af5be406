// Actors that somebody plays: nobody does here, so input never comes. Source: engine files GameFramework/Pawn.h,
// GameFramework/Character.h, GameFramework/PlayerController.h, GameFramework/GameModeBase.h,
// Components/InputComponent.h.
#pragma once

#include "Components/MeshComponent.h"
#include "GameFramework/Actor.h"

enum EInputEvent : int
{
	IE_Pressed,
	IE_Released,
	IE_Repeat,
	IE_DoubleClick,
	IE_Axis
};
namespace EAutoReceiveInput
{
enum Type : int
{
	Disabled,
	Player0
};
} // namespace EAutoReceiveInput

/** Binds nothing, with one warning. */
class DRYDOCK_API UInputComponent : public UActorComponent
{
public:
	DRYDOCK_CLASS(UInputComponent, UActorComponent)
	using UActorComponent::UActorComponent;

	template<typename... TArguments>
	void BindAction(const TArguments&...)
	{
		SayNoInput();
	}
	template<typename... TArguments>
	void BindAxis(const TArguments&...)
	{
		SayNoInput();
	}

private:
	static void SayNoInput()
	{
		Drydock::SayNeutral(TEXT("UInputComponent"), TEXT("nobody plays here, and input never comes"));
	}
};

class APlayerController;

class DRYDOCK_API APawn : public AActor
{
public:
	DRYDOCK_CLASS(APawn, AActor)
	using AActor::AActor;

	EAutoReceiveInput::Type AutoPossessPlayer = EAutoReceiveInput::Disabled;
	bool bUseControllerRotationPitch = false;
	bool bUseControllerRotationYaw = false;
	bool bUseControllerRotationRoll = false;

	/** Never called: nobody plays. */
	virtual void SetupPlayerInputComponent(UInputComponent*) {}
	APlayerController* GetController() const { return nullptr; }
	void AddMovementInput(FVector, float = 1.0f, bool = false) {}
	void AddControllerPitchInput(float) {}
	void AddControllerYawInput(float) {}
};

class DRYDOCK_API ACharacter : public APawn
{
public:
	DRYDOCK_CLASS(ACharacter, APawn)
	using APawn::APawn;

	ACharacter() { RootComponent = Mesh = CreateDefaultSubobject<USkeletalMeshComponent>(TEXT("CharacterMesh0")); }
	USkeletalMeshComponent* GetMesh() const { return Mesh.Get(); }
	void Jump() {}
	void StopJumping() {}

private:
	TObjectPtr<USkeletalMeshComponent> Mesh;
};

/** Nobody makes one but code: UWorld::GetFirstPlayerController is null. */
class DRYDOCK_API APlayerController : public AActor
{
public:
	DRYDOCK_CLASS(APlayerController, AActor)
	using AActor::AActor;

	bool bShowMouseCursor = false;

	APawn* GetPawn() const { return nullptr; }
};

/** Its classes are not spawned: the world has the actors that code and config place. */
class DRYDOCK_API AGameModeBase : public AActor
{
public:
	DRYDOCK_CLASS(AGameModeBase, AActor)
	using AActor::AActor;

	TSubclassOf<APawn> DefaultPawnClass;
	TSubclassOf<APlayerController> PlayerControllerClass;

	virtual void InitGame(const FString&, const FString&, FString&) {}
	virtual void StartPlay() {}
};
