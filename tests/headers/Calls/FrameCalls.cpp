// The extension that runs calls, and the list of all that ran.
#include "FrameCalls.h"

#include "Calls.h"
#include "DrydockFrame.h"
#include "PostProcess/PostProcessing.h"

namespace
{

class FCallsExtension : public FSceneViewExtensionBase
{
public:
	FCallsExtension(const FAutoRegister& AutoRegister, const Calls::FFrameCalls& InCalls)
		: FSceneViewExtensionBase(AutoRegister)
		, Calls(InCalls)
	{
	}

	void SetupViewFamily(FSceneViewFamily& InViewFamily) override
	{
		if (Calls.Family != nullptr)
		{
			Calls.Family(InViewFamily);
			++NumCalled;
		}
	}
	void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		if (Calls.View != nullptr)
		{
			Calls.View(GraphBuilder, View);
			++NumCalled;
		}
		if (Calls.Inputs != nullptr)
		{
			Calls.Inputs(GraphBuilder, View, Inputs);
			++NumCalled;
		}
	}
	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Calls.Pass != nullptr && Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FCallsExtension::CallPass));
		}
	}

	int32 NumCalled = 0;

private:
	FScreenPassTexture CallPass(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		++NumCalled;
		return Calls.Pass(GraphBuilder, View, Inputs);
	}

	Calls::FFrameCalls Calls;
};

} // namespace

void Calls::RunInFrame(const FFrameCalls& Calls)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FCallsExtension>(Calls);
	Drydock::FFrameDesc Frame;
	Frame.Extent = FIntPoint(FrameWidth, FrameHeight);
	Frame.SceneColor.Init(FLinearColor(0.25f, 0.25f, 0.25f, 1.0f), FrameWidth * FrameHeight);
	Drydock::RenderFrame(Frame);
	EXPECT_EQ((Calls.Family != nullptr) + (Calls.View != nullptr) + (Calls.Inputs != nullptr) + (Calls.Pass != nullptr),
		Extension->NumCalled);
}
