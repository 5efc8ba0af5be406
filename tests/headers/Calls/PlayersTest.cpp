// Calls on meshes and players, of which there are none: their names, and what they keep.
#include "Calls.h"

#include "Components/BoxComponent.h"
#include "Components/StaticMeshComponent.h"
#include "EngineModule.h"
#include "Engine/Engine.h"
#include "GameFramework/Character.h"
#include "GameFramework/GameModeBase.h"
#include "GameFramework/PlayerController.h"
#include "Kismet/BlueprintAsyncActionBase.h"
#include "Kismet/GameplayStatics.h"

#include <memory>

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Objects;

} // namespace

TEST(CallsOfObjects, MeshesAndPlayers)
{
	Calls::FLogLines Log;
	ACharacter* const Character = GWorld->SpawnActor<ACharacter>();
	NEUTRAL("ACharacter::GetMesh, USkeletalMeshComponent",
		Character->GetRootComponent() == Character->GetMesh() && Log.Has("USkeletalMeshComponent"));
	UInputComponent Input;
	Input.BindAction(TEXT("Jump"), IE_Pressed, Character, &ACharacter::Jump);
	NEUTRAL("UInputComponent::BindAction, BindAxis, EInputEvent", Log.Has("input never comes"));
	CALL("APawn, SetupPlayerInputComponent (never called), GetController (null)",
		(Character->SetupPlayerInputComponent(&Input), Character->GetController() == nullptr));
	CALL("APlayerController, AGameModeBase::DefaultPawnClass",
		AGameModeBase().DefaultPawnClass.Get() == nullptr && APlayerController().GetPawn() == nullptr);
	UStaticMeshComponent* const Component = NewObject<UStaticMeshComponent>(Character);
	const std::unique_ptr<UStaticMeshComponent> Owned(Component);
	Component->RegisterComponent();
	NEUTRAL("UStaticMeshComponent", Log.Has("UStaticMeshComponent") && Log.Has("no mesh is drawn"));
	UStaticMesh Mesh;
	CALL("UStaticMeshComponent::SetStaticMesh, GetStaticMesh",
		Component->SetStaticMesh(&Mesh) && Component->GetStaticMesh() == &Mesh);
	UMaterial Material;
	Component->SetMaterial(1, &Material);
	const std::unique_ptr<UMaterialInstanceDynamic> Made(Component->CreateDynamicMaterialInstance(1));
	CALL("UPrimitiveComponent::SetMaterial, GetMaterial, GetNumMaterials, CreateDynamicMaterialInstance",
		Made->GetParent() == &Material && Component->GetMaterial(1) == Made.get() &&
			Component->GetMaterial(0) == nullptr && Component->GetNumMaterials() == 2);
	CALL("ECollisionEnabled, ECollisionChannel, SetCollisionEnabled (nothing touches anything)",
		(Component->SetCollisionEnabled(ECollisionEnabled::NoCollision), ECC_Visibility == 3));
	UBoxComponent Box;
	Box.SetBoxExtent(FVector(1, 2, 3));
	Box.SetWorldTransform(FTransform(FRotator(0, 90, 0), FVector(4, 5, 6), FVector(2, 3, 4)));
	CALL("UBoxComponent::SetBoxExtent, GetUnscaledBoxExtent, GetScaledBoxExtent, USceneComponent::SetWorldTransform",
		Box.GetUnscaledBoxExtent() == FVector(1, 2, 3) && Box.GetScaledBoxExtent() == FVector(2, 6, 12) &&
			Box.GetComponentLocation() == FVector(4, 5, 6));
	CALL("USceneComponent::GetComponentTransform, AActor::GetActorTransform",
		Box.GetComponentTransform().TransformPosition(FVector(1, 0, 0)).Equals(FVector(4, 7, 6), 1e-6) &&
			Character->GetActorTransform().GetLocation() == Character->GetActorLocation());
	UInstancedStaticMeshComponent Instances;
	FTransform Place;
	CALL("UInstancedStaticMeshComponent::AddInstance, AddInstances, UpdateInstanceTransform, GetInstanceCount",
		Instances.AddInstance(FTransform(FVector(1, 2, 3))) == 0 &&
			Instances.AddInstances({FTransform(), FTransform()}, true)[1] == 2 &&
			Instances.UpdateInstanceTransform(1, FTransform(FVector(4, 5, 6))) &&
			!Instances.UpdateInstanceTransform(3, FTransform()) && Instances.GetInstanceCount() == 3 &&
			Instances.GetInstanceTransform(1, Place) && Place.GetLocation() == FVector(4, 5, 6));
	CALL("UInstancedStaticMeshComponent::BatchUpdateInstancesTransforms, RemoveInstance, ClearInstances",
		Instances.BatchUpdateInstancesTransforms(0, {FTransform(FVector(7, 8, 9))}) && Instances.RemoveInstance(2) &&
			!Instances.RemoveInstance(2) && Instances.GetInstanceTransform(0, Place) &&
			Place.GetLocation() == FVector(7, 8, 9) && (Instances.ClearInstances(), Instances.GetInstanceCount() == 0));
	CALL("USceneComponent::AttachToComponent, AttachTo, FAttachmentTransformRules",
		Component->AttachToComponent(Character->GetMesh(), FAttachmentTransformRules::KeepRelativeTransform) &&
			Component->AttachTo(Character->GetMesh()) && Component->GetAttachParent() == Character->GetMesh());
	Character->SetActorLocationAndRotation(FVector(1, 0, 0), FRotator(0, 90, 0));
	Character->AddActorLocalTransform(FTransform(FRotator(0, 10, 0), FVector(2, 0, 0)));
	CALL("AActor::AddActorLocalTransform, AddActorLocalRotation",
		Character->GetActorLocation().Equals(FVector(1, 2, 0), 1e-6) &&
			Character->AddActorLocalRotation(FRotator(0, 20, 0)) &&
			Character->GetActorRotation().Equals(FRotator(0, 120, 0), 1e-6));
	CALL("AActor::GetActorRightVector, GetActorUpVector",
		Character->GetActorRightVector().Equals(FRotator(0, 120, 0).GetRight(), 1e-6) &&
			Character->GetActorUpVector().Equals(FVector(0, 0, 1), 1e-6));
	CALL("USceneComponent::GetForwardVector, GetRightVector, GetUpVector",
		Character->GetMesh()->GetForwardVector().Equals(FRotator(0, 120, 0).Vector(), 1e-6) &&
			Character->GetMesh()->GetUpVector().Equals(FVector(0, 0, 1), 1e-6));
	Character->Tags.Add(TEXT("left"));
	TArray<AActor*> Tagged;
	UGameplayStatics::GetAllActorsWithTag(GWorld, TEXT("left"), Tagged);
	CALL("UGameplayStatics::GetAllActorsWithTag, AActor::Tags, ActorHasTag",
		Tagged.Num() == 1 && Tagged[0] == Character && Character->ActorHasTag(TEXT("left")));
	Character->AddToRoot();
	const bool bRooted = Character->IsRooted();
	Character->RemoveFromRoot();
	CALL("UObject::AddToRoot, RemoveFromRoot, IsRooted (nothing is collected)", bRooted && !Character->IsRooted());
	CALL("UWorld::GetFeatureLevel, FeatureLevel", GWorld->GetFeatureLevel() == ERHIFeatureLevel::SM5);
	CALL("UBlueprintAsyncActionBase::RegisterWithGameInstance, Activate, SetReadyToDestroy",
		UBlueprintAsyncActionBase::StaticClass()->IsChildOf<UObject>());
	CALL("UEngine::GetPreRenderDelegateEx, GetPostRenderDelegateEx, IRendererModule::GetResolvedSceneColorCallbacks",
		!GEngine->GetPreRenderDelegateEx().IsBound() && !GEngine->GetPostRenderDelegateEx().IsBound() &&
			!GetRendererModule().GetResolvedSceneColorCallbacks().IsBound());
	Component->UnregisterComponent();
	Character->Destroy();
}
