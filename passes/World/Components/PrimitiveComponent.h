// A component that would be drawn: there are no meshes here, so it has no proxy. Source: engine files
// Components/PrimitiveComponent.h, Engine/EngineTypes.h.
#pragma once

#include "Components/SceneComponent.h"

class FPrimitiveSceneProxy;
class UMaterialInstanceDynamic;
class UMaterialInterface;

/** The ways in which components touch each other: nothing touches anything here. */
namespace ECollisionEnabled
{
enum Type : int
{
	NoCollision,
	QueryOnly,
	PhysicsOnly,
	QueryAndPhysics,
	ProbeOnly,
	QueryAndProbe
};
} // namespace ECollisionEnabled
enum ECollisionChannel : int
{
	ECC_WorldStatic,
	ECC_WorldDynamic,
	ECC_Pawn,
	ECC_Visibility,
	ECC_Camera,
	ECC_PhysicsBody,
	ECC_Vehicle,
	ECC_Destructible
};
enum ECollisionResponse : int
{
	ECR_Ignore,
	ECR_Overlap,
	ECR_Block
};

/** A warning says once for each class that no mesh is drawn. */
class DRYDOCK_API UPrimitiveComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(UPrimitiveComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	bool bRenderCustomDepth = false;
	int32 CustomDepthStencilValue = 0; // 0..255
	bool CastShadow = true;

	void OnRegister() override;
	virtual FPrimitiveSceneProxy* CreateSceneProxy() { return nullptr; }
	void SetRenderCustomDepth(bool bValue) { bRenderCustomDepth = bValue; }
	void SetCustomDepthStencilValue(int32 Value) { CustomDepthStencilValue = Value; }
	void SetCastShadow(bool bValue) { CastShadow = bValue; }
	virtual void SetCollisionEnabled(ECollisionEnabled::Type) {}
	virtual void SetCollisionProfileName(FName, bool = true) {}
	void SetCollisionResponseToAllChannels(ECollisionResponse) {}
	void SetCollisionResponseToChannel(ECollisionChannel, ECollisionResponse) {}
	void SetCanEverAffectNavigation(bool) {}
	void SetGenerateOverlapEvents(bool) {}
	void SetSimulatePhysics(bool) {}

	/** Null where none was set. */
	virtual UMaterialInterface* GetMaterial(int32 Index) const
	{
		return Materials.IsValidIndex(Index) ? Materials[Index] : nullptr;
	}
	virtual int32 GetNumMaterials() const { return Materials.Num(); }
	virtual void SetMaterial(int32 Index, UMaterialInterface* Material);
	/** A new one of Source, or of the material that is set, which is set in its place. */
	virtual UMaterialInstanceDynamic* CreateDynamicMaterialInstance(
		int32 Index, UMaterialInterface* Source = nullptr, FName OptionalName = NAME_None);
	UMaterialInstanceDynamic* CreateAndSetMaterialInstanceDynamic(int32 Index)
	{
		return CreateDynamicMaterialInstance(Index);
	}

private:
	TArray<UMaterialInterface*> Materials;
};
