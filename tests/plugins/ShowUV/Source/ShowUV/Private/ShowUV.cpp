// Return protocol 3: draws to the override output where there is one, with AddDrawScreenPass, and moves it out.
#include "Runtime/Engine/Public/SceneViewExtension.h"
#include "Runtime/Renderer/Private/ScreenPass.h"
#include "PostProcess/PostProcessMaterialInputs.h"

namespace
{

class FShowUVPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FShowUVPS);
	SHADER_USE_PARAMETER_STRUCT(FShowUVPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FShowUVPS, "/Plugin/ShowUV/ShowUV.usf", "ShowUVPS", SF_Pixel);

FScreenPassTexture DrawUV(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	Inputs.Validate();
	const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	FScreenPassRenderTarget Output = Inputs.OverrideOutput;
	if (!Output.IsValid())
	{
		Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, View.GetOverwriteLoadAction(), TEXT("ShowUV"));
	}
	const FScreenPassTextureViewport OutputViewport(Output);
	FShowUVPS::FParameters* Parameters = GraphBuilder.AllocParameters<FShowUVPS::FParameters>();
	Parameters->Output = GetScreenPassTextureViewportParameters(OutputViewport);
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("ShowUV"), View, OutputViewport,
		FScreenPassTextureViewport(SceneColor), TShaderMapRef<FShowUVPS>(GetGlobalShaderMap(View.GetFeatureLevel())),
		Parameters);
	return MoveTemp(Output);
}

class FShowUVExtension : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;

	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::Tonemap && bIsPassEnabled)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateStatic(&DrawUV));
		}
	}
};

const TSharedRef<FShowUVExtension, ESPMode::ThreadSafe> GShowUV =
	FSceneViewExtensions::NewExtension<FShowUVExtension>();

} // namespace
