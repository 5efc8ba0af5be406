// Registers the setting, and an extension that draws with what the view's volumes make of it.
#include "LiftSetting.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "PostProcessSetting.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "SceneViewExtension.h"
#include "ShaderParameterStruct.h"

static const Drydock::TPostProcessSetting<float> GOutsideLift(
	TEXT("OutsideLift"), 0.0f, 0.0f, 8.0f, TEXT("Light added."));

namespace
{
class FLiftPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FLiftPS)
	SHADER_USE_PARAMETER_STRUCT(FLiftPS, FGlobalShader)

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Source)
		SHADER_PARAMETER(float, Lift)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FLiftPS, "/Plugin/LiftSetting/Lift.usf", "LiftPS", SF_Pixel)

class FLiftExtension : public FSceneViewExtensionBase
{
public:
	FLiftExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateLambda(
				[](FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
				{
					return AddLiftPass(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor),
						View.FinalPostProcessSettings);
				}));
		}
	}
};

const TSharedRef<FLiftExtension, ESPMode::ThreadSafe> GExtension = FSceneViewExtensions::NewExtension<FLiftExtension>();
} // namespace

void SetOutsideLift(FPostProcessSettings& Settings, float Lift)
{
	GOutsideLift.Set(Settings, Lift);
}

FScreenPassTexture AddLiftPass(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, const FPostProcessSettings& Settings)
{
	FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
		GraphBuilder, Input, ERenderTargetLoadAction::ENoAction, TEXT("LiftOutput"));

	auto* Parameters = GraphBuilder.AllocParameters<FLiftPS::FParameters>();
	Parameters->Source = Input.Texture;
	Parameters->Lift = GOutsideLift.Get(Settings);
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Lift"),
		TShaderMapRef<FLiftPS>(ShaderMap), Parameters, Output.ViewRect);
	return MoveTemp(Output);
}
