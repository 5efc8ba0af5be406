// Return protocol 2: a full-screen pixel shader into a new texture, which is returned with its rect.
#pragma once

#include "SceneViewExtension.h"

class FHalfBrightExtension final : public FSceneViewExtensionBase
{
public:
	FHalfBrightExtension(const FAutoRegister& AutoRegister, float InScale);

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override;

	FScreenPassTexture Render_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs);

private:
	const float Scale;
};
