// A uniform buffer of one's own, which the shader reads by its name.
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "ShaderParameterMacros.h"
#include "UniformBuffer.h"

BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FGradingUniformParameters, )
	SHADER_PARAMETER(FVector4f, Slope)
	SHADER_PARAMETER(FVector4f, Offset)
	SHADER_PARAMETER_ARRAY(FVector4f, Steps, [2])
END_GLOBAL_SHADER_PARAMETER_STRUCT()

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FGradingUniformParameters, "Grading");

class FGradingPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FGradingPS);
	SHADER_USE_PARAMETER_STRUCT(FGradingPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_REF(FGradingUniformParameters, Grading)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FGradingPS, "/Plugin/Grading/Private/Grading.usf", "GradingPS", SF_Pixel);

class FGradingExtension : public FSceneViewExtensionBase
{
public:
	FGradingExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
		FGradingUniformParameters Parameters;
		Parameters.Slope = FVector4f(2.0f, 1.0f, 0.0f, 1.0f);
		Parameters.Offset = FVector4f(0.0f, 0.5f, 3.0f, 0.0f);
		Parameters.Steps[0] = FVector4f(0.0f, 0.0f, 0.0f, 0.0f);
		Parameters.Steps[1] = FVector4f(0.0f, 0.0f, 1.0f, 0.0f);
		UniformBuffer = TUniformBufferRef<FGradingUniformParameters>::CreateUniformBufferImmediate(
			Parameters, UniformBuffer_MultiFrame);
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FGradingExtension::Grade));
		}
	}

private:
	FScreenPassTexture Grade(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		const FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, ERenderTargetLoadAction::EClear, TEXT("Grading"));
		FGradingPS::FParameters* Parameters = GraphBuilder.AllocParameters<FGradingPS::FParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->Grading = UniformBuffer;
		Parameters->Input = SceneColor.Texture;
		Parameters->InputSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(View.FeatureLevel);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Grading"),
			TShaderMapRef<FGradingPS>(ShaderMap), Parameters, Output.ViewRect);
		return Output;
	}

	TUniformBufferRef<FGradingUniformParameters> UniformBuffer;
};

class FGradingModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FGradingExtension>(); }

private:
	TSharedPtr<FGradingExtension, ESPMode::ThreadSafe> Extension;
};
IMPLEMENT_MODULE(FGradingModule, Grading)
