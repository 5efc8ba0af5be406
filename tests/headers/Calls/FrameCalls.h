// Runs calls inside a frame of drydock, in the hooks of an extension.
#pragma once

#include "SceneRendering.h"
#include "SceneViewExtension.h"

struct FPostProcessingInputs;

namespace Calls
{

constexpr int32 FrameWidth = 24;
constexpr int32 FrameHeight = 12;

/** Called once each, where not null. */
struct FFrameCalls
{
	void (*Family)(FSceneViewFamily& Family) = nullptr; // SetupViewFamily
	void (*View)(FRDGBuilder& GraphBuilder, const FSceneView& View) = nullptr;
	void (*Inputs)(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) = nullptr;
	FScreenPassTexture (*Pass)(FRDGBuilder& GraphBuilder, const FSceneView& View,
		const FPostProcessMaterialInputs& Inputs) = nullptr; // after MotionBlur
};

/** Renders a frame of FrameWidth x FrameHeight, grey 0.25; a failure if one of them was not called. */
void RunInFrame(const FFrameCalls& Calls);

} // namespace Calls
