// Names the eye of a view: here none. Source: engine files StereoRendering.h, SceneView.h (EStereoscopicPass).
#pragma once

#include "CoreMinimal.h"
#include "SceneView.h"

enum EStereoscopicPass : int
{
	eSSP_FULL,
	eSSP_PRIMARY,
	eSSP_SECONDARY
};

class IStereoRendering
{
public:
	static bool IsStereoEyeView(const FSceneView&) { return false; }
	static bool IsAPrimaryView(const FSceneView&) { return true; }
	static bool IsASecondaryView(const FSceneView&) { return false; }
};
