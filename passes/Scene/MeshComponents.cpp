// Keeps what code gives to components of meshes, although nothing of them is drawn.
#include "Components/MeshComponent.h"

#include "SceneViewExtensionHooks.h"

const FAttachmentTransformRules FAttachmentTransformRules::KeepRelativeTransform(EAttachmentRule::KeepRelative, false);
const FAttachmentTransformRules FAttachmentTransformRules::KeepWorldTransform(EAttachmentRule::KeepWorld, false);
const FAttachmentTransformRules FAttachmentTransformRules::SnapToTargetNotIncludingScale(
	EAttachmentRule::SnapToTarget, false);
const FAttachmentTransformRules FAttachmentTransformRules::SnapToTargetIncludingScale(
	EAttachmentRule::SnapToTarget, false);

void UPrimitiveComponent::OnRegister()
{
	Drydock::SayNeutral(Drydock::GetTypeName(typeid(*this)).c_str(), TEXT("no mesh is drawn; frames come rendered"));
}

void UPrimitiveComponent::SetMaterial(int32 Index, UMaterialInterface* Material)
{
	Materials.SetNum(FMath::Max(Materials.Num(), Index + 1));
	Materials[Index] = Material;
}

UMaterialInstanceDynamic* UPrimitiveComponent::CreateDynamicMaterialInstance(
	int32 Index, UMaterialInterface* Source, FName)
{
	UMaterialInstanceDynamic* const Made =
		UMaterialInstanceDynamic::Create(Source != nullptr ? Source : GetMaterial(Index), this);
	SetMaterial(Index, Made);
	return Made;
}

TArray<int32> UInstancedStaticMeshComponent::AddInstances(
	const TArray<FTransform>& Transforms, bool bReturnIndices, bool, bool)
{
	TArray<int32> Indices;
	for (const FTransform& Transform : Transforms)
	{
		Indices.Add(AddInstance(Transform));
	}
	return bReturnIndices ? Indices : TArray<int32>();
}

bool UInstancedStaticMeshComponent::UpdateInstanceTransform(int32 Index, const FTransform& Transform, bool, bool, bool)
{
	const bool bThere = Instances.IsValidIndex(Index);
	if (bThere)
	{
		Instances[Index] = Transform;
	}
	return bThere;
}

bool UInstancedStaticMeshComponent::BatchUpdateInstancesTransforms(
	int32 FirstIndex, const TArray<FTransform>& Transforms, bool, bool, bool)
{
	bool bAll = true;
	for (const FTransform& Transform : Transforms)
	{
		bAll = UpdateInstanceTransform(FirstIndex++, Transform) && bAll;
	}
	return bAll;
}

bool UInstancedStaticMeshComponent::RemoveInstance(int32 Index)
{
	const bool bThere = Instances.IsValidIndex(Index);
	if (bThere)
	{
		Instances.RemoveAt(Index);
	}
	return bThere;
}

bool UInstancedStaticMeshComponent::GetInstanceTransform(int32 Index, FTransform& OutTransform, bool) const
{
	const bool bThere = Instances.IsValidIndex(Index);
	if (bThere)
	{
		OutTransform = Instances[Index];
	}
	return bThere;
}
