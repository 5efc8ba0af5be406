// A sky atmosphere's settings: no sky is drawn here. Source: engine file Components/SkyAtmosphereComponent.h.
#pragma once

#include "Components/SceneComponent.h"

class DRYDOCK_API USkyAtmosphereComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(USkyAtmosphereComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	float BottomRadius = 6360.0f;    // km
	float AtmosphereHeight = 100.0f; // km
};
