// The renderer's scene, as much as extensions ask of it: which world it shows. Source: engine file SceneInterface.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"

class UWorld;

class DRYDOCK_API FSceneInterface
{
public:
	explicit FSceneInterface(UWorld* InWorld)
		: World(InWorld)
	{
	}
	virtual ~FSceneInterface();

	virtual UWorld* GetWorld() const { return World; }
	ERHIFeatureLevel::Type GetFeatureLevel() const { return GMaxRHIFeatureLevel; }
	EShaderPlatform GetShaderPlatform() const { return GMaxRHIShaderPlatform; }

private:
	UWorld* World;
};
