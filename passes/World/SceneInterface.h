// Declares the renderer's scene as far as extensions need it: the world that it shows. Source: engine file
// SceneInterface.h.
#pragma once

#include "CoreMinimal.h"
#include "RHI.h"

class FScene;
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
	/** The renderer's; never null for the world's scene. */
	virtual FScene* GetRenderScene() { return nullptr; }
	ERHIFeatureLevel::Type GetFeatureLevel() const { return GMaxRHIFeatureLevel; }
	EShaderPlatform GetShaderPlatform() const { return GMaxRHIShaderPlatform; }

protected:
	UWorld* World;
};
