// A plugin without a module: a static variable holds its extension, which turns the picture red after the tonemapper.
#include "PostProcess/PostProcessing.h"

namespace
{

class FStaticExtension final : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass == EPostProcessingPass::Tonemap)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateLambda(
				[](FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
				{
					AddClearRenderTargetPass(GraphBuilder, Inputs.OverrideOutput.Texture, FLinearColor::Red);
					return FScreenPassTexture(Inputs.OverrideOutput);
				}));
		}
	}
};

const TSharedRef<FStaticExtension, ESPMode::ThreadSafe> GExtension =
	FSceneViewExtensions::NewExtension<FStaticExtension>();

} // namespace
