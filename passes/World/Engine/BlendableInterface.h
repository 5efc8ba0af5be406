// Objects that post-process volumes mix by weight. Source: engine file Engine/BlendableInterface.h.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "UObject/Object.h"

class FSceneView;

class UBlendableInterface : public UObject
{
};

class DRYDOCK_API IBlendableInterface
{
public:
	virtual ~IBlendableInterface();

	/** Called once for each time that settings name the object, after they were blended. Weight: 0..1. */
	virtual void OverrideBlendableSettings(FSceneView& View, float Weight) const;
};
