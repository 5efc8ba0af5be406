// Components whose values the engine hands to the view: the config does that here. Source: engine files
// Camera/CameraComponent.h, Components/PostProcessComponent.h.
#pragma once

#include "Camera/CameraTypes.h"
#include "Components/SceneComponent.h"

class DRYDOCK_API UCameraComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(UCameraComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	float FieldOfView = 90.0f; // degrees
	float AspectRatio = 1.777778f;
	float PostProcessBlendWeight = 1.0f;
	FPostProcessSettings PostProcessSettings;

	virtual void SetFieldOfView(float InFieldOfView) { FieldOfView = InFieldOfView; }
	/** Its values as a view point has them. */
	virtual void GetCameraView(float, FMinimalViewInfo& DesiredView)
	{
		DesiredView.Location = GetComponentLocation();
		DesiredView.Rotation = GetComponentRotation();
		DesiredView.FOV = FieldOfView;
		DesiredView.AspectRatio = AspectRatio;
		DesiredView.PostProcessBlendWeight = PostProcessBlendWeight;
		DesiredView.PostProcessSettings = PostProcessSettings;
	}
	void OnRegister() override
	{
		Drydock::SayNeutral(TEXT("UCameraComponent"), TEXT("no view looks through it: the config's \"camera\" does"));
	}
};

class DRYDOCK_API UPostProcessComponent : public USceneComponent
{
public:
	DRYDOCK_CLASS(UPostProcessComponent, USceneComponent)
	using USceneComponent::USceneComponent;

	FPostProcessSettings Settings;
	float Priority = 0.0f;
	float BlendRadius = 100.0f; // cm
	float BlendWeight = 1.0f;
	uint8 bEnabled : 1 = 1;
	uint8 bUnbound : 1 = 1;

	void OnRegister() override
	{
		Drydock::SayNeutral(TEXT("UPostProcessComponent"),
			TEXT("its settings are not blended: give them to a volume of the config's \"volumes\""));
	}
};
