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

	/** Once for each time that settings name it, after they were blended. Weight: 0..1. */
	virtual void OverrideBlendableSettings(FSceneView& View, float Weight) const;
};
