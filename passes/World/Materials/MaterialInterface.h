// Materials as settings name them: no material is compiled or drawn here. Source: engine files
// Materials/MaterialInterface.h, Materials/Material.h, Materials/MaterialInstanceDynamic.h.
#pragma once

#include "CoreMinimal.h"
#include "Engine/BlendableInterface.h"
#include "UObject/Object.h"

class UTexture;

class DRYDOCK_API UMaterialInterface : public UObject, public IBlendableInterface
{
public:
	DRYDOCK_CLASS(UMaterialInterface, UObject)
	using UObject::UObject;
};

class DRYDOCK_API UMaterial : public UMaterialInterface
{
public:
	DRYDOCK_CLASS(UMaterial, UMaterialInterface)
	using UMaterialInterface::UMaterialInterface;
};

/** Keeps its parameters for whoever asks; a warning says once that no material is drawn. */
class DRYDOCK_API UMaterialInstanceDynamic : public UMaterialInterface
{
public:
	DRYDOCK_CLASS(UMaterialInstanceDynamic, UMaterialInterface)
	using UMaterialInterface::UMaterialInterface;

	/** A new one, which the caller owns. */
	static UMaterialInstanceDynamic* Create(UMaterialInterface* Parent, UObject* Outer);

	void SetScalarParameterValue(FName Name, float Value) { Scalars.Add(Name, Value); }
	void SetVectorParameterValue(FName Name, FLinearColor Value) { Vectors.Add(Name, Value); }
	void SetTextureParameterValue(FName Name, UTexture* Value) { Textures.Add(Name, Value); }
	/** 0 of a parameter that was not set. */
	float GetScalarParameterValue(FName Name) const { return Scalars.FindRef(Name); }
	FLinearColor K2_GetVectorParameterValue(FName Name) const { return Vectors.FindRef(Name); }
	UTexture* K2_GetTextureParameterValue(FName Name) const { return Textures.FindRef(Name); }
	UMaterialInterface* GetParent() const { return Parent; }

private:
	UMaterialInterface* Parent = nullptr;
	TMap<FName, float> Scalars;
	TMap<FName, FLinearColor> Vectors;
	TMap<FName, UTexture*> Textures;
};
