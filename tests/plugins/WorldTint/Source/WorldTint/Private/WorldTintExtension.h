#pragma once

#include "SceneViewExtension.h"

class FWorldTintExtension : public FWorldSceneViewExtension
{
public:
	FWorldTintExtension(const FAutoRegister& AutoRegister, UWorld* InWorld);

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override;
	virtual void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override;

private:
	FLinearColor Tint_RenderThread = FLinearColor::White;
};
