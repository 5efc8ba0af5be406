// Return protocol 4, the early-out: console variables of every type decide whether anything happens. Everything lies in
// namespaces.
#include "SceneViewExtension.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"

namespace GateNames
{
namespace
{

TAutoConsoleVariable<int32> CVarEnable(TEXT("r.Gate.Enable"), 0, TEXT("0: off, 1: on."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarLevel(TEXT("r.Gate.Level"), 0.5f, TEXT("What is above it passes."), ECVF_Default);
bool bGateInvert = false;
FAutoConsoleVariableRef CVarInvert(TEXT("r.Gate.Invert"), bGateInvert, TEXT("What is below it passes."));
auto* CVarFill = new TAutoConsoleVariable<float>(TEXT("r.Gate.Fill"), 0.0f, TEXT("What the rest becomes."));

BEGIN_SHADER_PARAMETER_STRUCT(FGateCommon, )
	SHADER_PARAMETER(float, Level)
	SHADER_PARAMETER(float, Fill)
	SHADER_PARAMETER(uint32, bInvert)
END_SHADER_PARAMETER_STRUCT()

class FGatePS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FGatePS);
	SHADER_USE_PARAMETER_STRUCT(FGatePS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FGateCommon, Common)
		SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D<float4>, Input)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FGatePS, "/Plugin/Gate/Gate.usf", "GatePS", SF_Pixel);

} // namespace

class FGateExtension : public FSceneViewExtensionBase
{
public:
	FGateExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
		FSceneViewExtensionIsActiveFunctor IsActive;
		IsActive.IsActiveFunction = [](const ISceneViewExtension*, const FSceneViewExtensionContext&)
		{
			return TOptional<bool>(CVarEnable.GetValueOnGameThread() >= 0);
		};
		IsActiveThisFrameFunctions.Add(IsActive);
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FGateExtension::Apply));
		}
	}

private:
	FScreenPassTexture Apply(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		if (CVarEnable->GetInt() == 0)
		{
			return Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder);
		}
		const FScreenPassTextureSlice Slice = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		const FScreenPassTexture SceneColor(Slice);
		const FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
			GraphBuilder, SceneColor, ERenderTargetLoadAction::ENoAction, TEXT("Gate"));
		FGatePS::FParameters* Parameters = GraphBuilder.AllocParameters<FGatePS::FParameters>();
		Parameters->Common.Level = CVarLevel.GetValueOnRenderThread();
		Parameters->Common.Fill = CVarFill->GetValueOnAnyThread();
		Parameters->Common.bInvert = bGateInvert;
		Parameters->Input = Slice.TextureSRV;
		Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
		const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ViewInfo.ShaderMap,
			RDG_EVENT_NAME("Gate above %.2f", Parameters->Common.Level), TShaderMapRef<FGatePS>(ViewInfo.ShaderMap),
			Parameters, Output.ViewRect);
		UE_LOG(LogTemp, Verbose, TEXT("Gate over %s"), *FString::Printf(TEXT("%d pixels"), Output.ViewRect.Area()));
		return FScreenPassTexture(Output);
	}
};

static TSharedPtr<FGateExtension, ESPMode::ThreadSafe> GGateExtension =
	FSceneViewExtensions::NewExtension<FGateExtension>();

} // namespace GateNames
