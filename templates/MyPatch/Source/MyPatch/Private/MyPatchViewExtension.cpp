#include "MyPatchViewExtension.h"

#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneView.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

#if UE_VERSION_OLDER_THAN(5, 4, 0)
#include "PostProcess/PostProcessMaterial.h"
#else
#include "PostProcess/PostProcessMaterialInputs.h"
#endif

static TAutoConsoleVariable<float> CVarMyPatchIntensity(TEXT("r.MyPatch.Intensity"), 0.8f,
	TEXT("How much of the corners' colour is MyPatch's tint, 0 (off) to 1."), ECVF_RenderThreadSafe);

namespace
{

// Display-encoded, as the picture is after the tonemapper.
const FLinearColor MyPatchTint(0.5f, 0.1f, 1.0f);

class FMyPatchPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMyPatchPS);
	SHADER_USE_PARAMETER_STRUCT(FMyPatchPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER(FLinearColor, Tint)
		SHADER_PARAMETER(float, Intensity)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FMyPatchPS, "/Plugin/MyPatch/Private/MyPatch.usf", "MainPS", SF_Pixel);

} // namespace

FMyPatchViewExtension::FMyPatchViewExtension(const FAutoRegister& AutoRegister)
	: FSceneViewExtensionBase(AutoRegister)
{
}

bool FMyPatchViewExtension::IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const
{
	return CVarMyPatchIntensity.GetValueOnGameThread() > 0.0f;
}

#if UE_VERSION_OLDER_THAN(5, 5, 0)
void FMyPatchViewExtension::SubscribeToPostProcessingPass(
	EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
#else
void FMyPatchViewExtension::SubscribeToPostProcessingPass(EPostProcessingPass Pass, const FSceneView& InView,
	FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool bIsPassEnabled)
#endif
{
	if (Pass == EPostProcessingPass::Tonemap && bIsPassEnabled)
	{
		InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FMyPatchViewExtension::AddPasses));
	}
}

FScreenPassTexture FMyPatchViewExtension::AddPasses(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	const FScreenPassTexture SceneColor(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	check(SceneColor.IsValid());

	// The last callback of the frame draws to where the engine says; any other makes a target of its own.
	FScreenPassRenderTarget Output = Inputs.OverrideOutput;
	if (!Output.IsValid())
	{
		Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, View.GetOverwriteLoadAction(), TEXT("MyPatch"));
	}

	FMyPatchPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FMyPatchPS::FParameters>();
	PassParameters->Input =
		GetScreenPassTextureInput(SceneColor, TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI());
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->Tint = MyPatchTint;
	PassParameters->Intensity = FMath::Clamp(CVarMyPatchIntensity.GetValueOnRenderThread(), 0.0f, 1.0f);
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.GetFeatureLevel());
	const TShaderMapRef<FMyPatchPS> PixelShader(ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap,
		RDG_EVENT_NAME("MyPatch %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader, PassParameters,
		Output.ViewRect);
	return MoveTemp(Output);
}
