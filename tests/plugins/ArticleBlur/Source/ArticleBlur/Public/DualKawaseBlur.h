// The view extension of the article on dual Kawase, by its own name and in its form: a class that a project's module
// has, which takes how far the taps lie, how many passes go down, and whether a Gaussian is meant.
#pragma once

#include "CoreMinimal.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"

class GAMES202_API FDualKawaseBlur : public FSceneViewExtensionBase
{
public:
	FDualKawaseBlur(const FAutoRegister& AutoRegister, float InOffset, int InPassNum, bool InUseGaussian);

	virtual void SetupViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SetupView(FSceneViewFamily& InViewFamily, FSceneView& InView) override {}
	virtual void BeginRenderViewFamily(FSceneViewFamily& InViewFamily) override {}
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled) override;

	/** The article's name; it is called after the motion blur. */
	FScreenPassTexture PostProcessPassAfterTonemap_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& InOutInputs);

	float Offset;
	int PassNum;
};
