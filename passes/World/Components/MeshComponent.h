// Meshes and the components that show them: code may set them up, and none is drawn. Source: engine files
// Components/MeshComponent.h, Components/StaticMeshComponent.h, Components/InstancedStaticMeshComponent.h,
// Components/SkeletalMeshComponent.h, Engine/StaticMesh.h, Engine/SkeletalMesh.h.
#pragma once

#include "Components/PrimitiveComponent.h"
#include "Materials/MaterialInterface.h"
#include "Math/Transform.h"

#define DRYDOCK_NO_MESH(Name) DRYDOCK_ABSENT(Name, "no mesh is drawn; frames come rendered")

class DRYDOCK_API UStaticMesh : public UObject
{
public:
	DRYDOCK_CLASS(UStaticMesh, UObject)
	using UObject::UObject;

	DRYDOCK_NO_MESH(GetRenderData) class FStaticMeshRenderData* GetRenderData() const;
	DRYDOCK_NO_MESH(GetNumVertices) int32 GetNumVertices(int32 LODIndex) const;
	DRYDOCK_NO_MESH(GetNumTriangles) int32 GetNumTriangles(int32 LODIndex) const;
};

class DRYDOCK_API USkeletalMesh : public UObject
{
public:
	DRYDOCK_CLASS(USkeletalMesh, UObject)
	using UObject::UObject;
};

class DRYDOCK_API UMeshComponent : public UPrimitiveComponent
{
public:
	DRYDOCK_CLASS(UMeshComponent, UPrimitiveComponent)
	using UPrimitiveComponent::UPrimitiveComponent;
};

class DRYDOCK_API UStaticMeshComponent : public UMeshComponent
{
public:
	DRYDOCK_CLASS(UStaticMeshComponent, UMeshComponent)
	using UMeshComponent::UMeshComponent;

	virtual bool SetStaticMesh(UStaticMesh* NewMesh)
	{
		StaticMesh = NewMesh;
		return true;
	}
	UStaticMesh* GetStaticMesh() const { return StaticMesh; }

private:
	TObjectPtr<UStaticMesh> StaticMesh;
};

/** Keeps the places of its instances. */
class DRYDOCK_API UInstancedStaticMeshComponent : public UStaticMeshComponent
{
public:
	DRYDOCK_CLASS(UInstancedStaticMeshComponent, UStaticMeshComponent)
	using UStaticMeshComponent::UStaticMeshComponent;

	int32 NumCustomDataFloats = 0;

	/** Its index. */
	virtual int32 AddInstance(const FTransform& Transform, bool = false) { return Instances.Add(Transform); }
	virtual TArray<int32> AddInstances(
		const TArray<FTransform>& Transforms, bool bReturnIndices, bool = false, bool = true);
	virtual bool UpdateInstanceTransform(
		int32 Index, const FTransform& Transform, bool = false, bool = false, bool = false);
	virtual bool BatchUpdateInstancesTransforms(
		int32 FirstIndex, const TArray<FTransform>& Transforms, bool = false, bool = false, bool = false);
	virtual bool RemoveInstance(int32 Index);
	virtual bool SetCustomDataValue(int32, int32, float, bool = false) { return true; }
	virtual void ClearInstances() { Instances.Reset(); }
	int32 GetInstanceCount() const { return Instances.Num(); }
	bool GetInstanceTransform(int32 Index, FTransform& OutTransform, bool = false) const;

private:
	TArray<FTransform> Instances;
};

class DRYDOCK_API UHierarchicalInstancedStaticMeshComponent : public UInstancedStaticMeshComponent
{
public:
	DRYDOCK_CLASS(UHierarchicalInstancedStaticMeshComponent, UInstancedStaticMeshComponent)
	using UInstancedStaticMeshComponent::UInstancedStaticMeshComponent;
};

class DRYDOCK_API USkeletalMeshComponent : public UMeshComponent
{
public:
	DRYDOCK_CLASS(USkeletalMeshComponent, UMeshComponent)
	using UMeshComponent::UMeshComponent;

	void SetSkeletalMesh(USkeletalMesh* NewMesh, bool = true) { SkeletalMesh = NewMesh; }
	USkeletalMesh* GetSkeletalMeshAsset() const { return SkeletalMesh; }

private:
	TObjectPtr<USkeletalMesh> SkeletalMesh;
};
