// The view extension that blurs the picture after a post-processing pass by dual Kawase, as in the article:
//
//     Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.0f, 3, false);
//
// or from a config: "extensions": [{"type": "DualKawaseBlur", "pass": "MotionBlur", "Offset": 1, "PassNum": 3}].
//
// The post-process settings have the last word, where they are not at their defaults: DualKawaseBlurPassNum above 0 for
// the number of levels, DualKawaseBlurOffset other than 1 for the offset; then a wanted standard deviation is put
// aside. r.DualKawase.AsPrinted chooses the article's form, r.DualKawase.SeparableGaussian how UseGaussian blurs. Docs:
// docs/dual-kawase.md.
#pragma once

#include "Blur/DualKawaseBlurWidth.h"
#include "CoreMinimal.h"
#include "SceneViewExtension.h"

namespace Drydock
{

class DRYDOCK_API FDualKawaseBlur : public FSceneViewExtensionBase
{
public:
	/** Offset: distance of the taps, 1 is the published filter. PassNum: levels down, and as many up, 0 to 8; 0 leaves
	 * the picture as it is. UseGaussian: a Gaussian of the same width instead, to compare with; as printed it has no
	 * effect, because the article's constructor takes it and drops it. */
	FDualKawaseBlur(const FAutoRegister& AutoRegister, float InOffset, int32 InPassNum, bool bInUseGaussian);

	/** Levels and offset for this standard deviation, in pixels of the picture, in place of the given ones; 0: the
	 * given ones. If the deviation cannot be reached, a remark on the graph reports it. */
	void SetStandardDeviation(float InStandardDeviation) { StandardDeviation = InStandardDeviation; }

	/** Sets the pass after which the blur runs; the motion blur unless this is called. */
	void SetPass(EPostProcessingPass InPass) { Pass = InPass; }

	void SubscribeToPostProcessingPass(
		EPostProcessingPass InPass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override;

private:
	FScreenPassTexture AddPasses(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs);

	/** Levels and offset for a picture of this size. */
	FDualKawaseSetting ChooseSetting(FRDGBuilder& GraphBuilder, const FSceneView& View, FIntPoint Size) const;

	float Offset;
	int32 PassNum;
	bool bUseGaussian;
	float StandardDeviation = 0.0f;
	EPostProcessingPass Pass = EPostProcessingPass::MotionBlur;
};

} // namespace Drydock
