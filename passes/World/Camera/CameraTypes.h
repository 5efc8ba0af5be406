// The camera as the game hands it to a view. Source: engine file Camera/CameraTypes.h (the part that view extensions
// edit).
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "PostProcessSubSettings.h"

/** Lengths in cm, angles in degrees. */
struct FMinimalViewInfo
{
	FVector Location = FVector(0.0, 0.0, 0.0);
	FRotator Rotation = FRotator(0.0, 0.0, 0.0);
	float FOV = 90.0f; // horizontal
	float DesiredFOV = 90.0f;
	float AspectRatio = 1.33333333f;
	float PostProcessBlendWeight = 0.0f;
	FPostProcessSettings PostProcessSettings;
};
