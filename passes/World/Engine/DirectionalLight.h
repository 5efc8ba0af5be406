// A directional light in the world. Source: engine file Engine/DirectionalLight.h.
#pragma once

#include "Components/DirectionalLightComponent.h"
#include "GameFramework/Actor.h"

class DRYDOCK_API ADirectionalLight : public AActor
{
public:
	DRYDOCK_CLASS(ADirectionalLight, AActor)

	ADirectionalLight()
	{
		SetRootComponent(CreateDefaultSubobject<UDirectionalLightComponent>(TEXT("LightComponent0")));
	}

	UDirectionalLightComponent* GetComponent() const { return FindComponentByClass<UDirectionalLightComponent>(); }
};
