// The window of a game, of which there is none: nobody makes one. Source: engine files Engine/GameViewportClient.h,
// Engine/LocalPlayer.h.
#pragma once

#include "Engine/World.h"

class FViewport;

class DRYDOCK_API UGameViewportClient : public UObject
{
public:
	FViewport* Viewport = nullptr;

	void GetViewportSize(FVector2D& OutViewportSize) const { OutViewportSize = FVector2D(0.0, 0.0); }
	UWorld* GetWorld() const override { return GWorld; }
};

class DRYDOCK_API ULocalPlayer : public UObject
{
public:
	UGameViewportClient* ViewportClient = nullptr;
};
