// GEngine: what code from outside reaches through it. Source: engine file Engine/Engine.h.
#pragma once

#include "CoreMinimal.h"
#include "UObject/Object.h"

class FSceneViewExtensions;

class DRYDOCK_API UEngine : public UObject
{
public:
	UEngine();
	~UEngine() override;

	/** Always valid. */
	TSharedPtr<FSceneViewExtensions> ViewExtensions;
};

/** Valid from the moment the library is loaded. */
extern DRYDOCK_API UEngine* GEngine;
