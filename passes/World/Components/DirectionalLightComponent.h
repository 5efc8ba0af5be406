// A directional light's settings: it lights nothing here. Source: engine files Components/DirectionalLightComponent.h,
// Components/LightComponentBase.h.
#pragma once

#include "Components/SceneComponent.h"

class DRYDOCK_API UDirectionalLightComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(UDirectionalLightComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	float Intensity = 10.0f; // lux
	FColor LightColor = FColor(255, 255, 255);

	FLinearColor GetLightColor() const { return FLinearColor(LightColor); }
	/** The direction in which the light travels. */
	FVector GetDirection() const { return GetComponentRotation().Vector(); }
};
