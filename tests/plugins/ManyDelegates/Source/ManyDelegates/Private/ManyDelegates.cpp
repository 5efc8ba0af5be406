// Every way to bind a callback, in one chain: each adds to the picture, or scales it, by raw clears and blends of one
// shader.
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "UObject/Object.h"

class FScaleAddPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FScaleAddPS);
	SHADER_USE_PARAMETER_STRUCT(FScaleAddPS, FGlobalShader);
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Input)
		SHADER_PARAMETER(FLinearColor, Scale)
		SHADER_PARAMETER(FLinearColor, Add)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};
IMPLEMENT_GLOBAL_SHADER(FScaleAddPS, "/Plugin/ManyDelegates/ManyDelegates.usf", "ScaleAddPS", SF_Pixel);

static FScreenPassTexture ScaleAdd(
	FRDGBuilder& GraphBuilder, const FPostProcessMaterialInputs& Inputs, float Scale, const FLinearColor& Add)
{
	const FScreenPassTexture Input = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	const FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
		GraphBuilder, Input, ERenderTargetLoadAction::ENoAction, TEXT("ScaleAdd"));
	auto* Parameters = GraphBuilder.AllocParameters<FScaleAddPS::FParameters>();
	Parameters->Input = Input.Texture;
	Parameters->Scale = FLinearColor(Scale, Scale, Scale, 1.0f);
	Parameters->Add = Add;
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("ScaleAdd"),
		TShaderMapRef<FScaleAddPS>(ShaderMap), Parameters, Output.ViewRect);
	return Output;
}

static FScreenPassTexture Double(FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
{
	return ScaleAdd(GraphBuilder, Inputs, 2.0f, FLinearColor(0, 0, 0, 0));
}

class UAdder : public UObject
{
public:
	FScreenPassTexture Run(FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
	{
		return ScaleAdd(GraphBuilder, Inputs, 1.0f, FLinearColor(4, 0, 0, 0));
	}
};

struct FSharedAdder
{
	FScreenPassTexture Run(FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
	{
		return ScaleAdd(GraphBuilder, Inputs, 1.0f, FLinearColor(0, 0, 1, 0));
	}
};

class FManyDelegatesExtension : public FSceneViewExtensionBase
{
public:
	FManyDelegatesExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
		, Shared(MakeShared<FSharedAdder, ESPMode::ThreadSafe>())
		, Object(NewObject<UAdder>())
	{
	}
	virtual ~FManyDelegatesExtension() { delete Object; }

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass != EPostProcessingPass::MotionBlur)
		{
			return;
		}
		const float Amount = 1.0f;
		Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(
			this, &FManyDelegatesExtension::AddPayload, FLinearColor(1, 0, 0, 0)));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateLambda(
			[this, Amount](FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
			{ return AddPayload(GraphBuilder, View, Inputs, FLinearColor(0, Amount, 0, 0)); }));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(Shared.ToSharedRef(), &FSharedAdder::Run));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateStatic(&Double));
		FAfterPassCallbackDelegate OfObject;
		OfObject.BindUObject(Object, &UAdder::Run);
		Callbacks.Add(OfObject);
	}

private:
	FScreenPassTexture AddPayload(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs, FLinearColor Add)
	{
		return ScaleAdd(GraphBuilder, Inputs, 1.0f, Add);
	}

	TSharedPtr<FSharedAdder, ESPMode::ThreadSafe> Shared;
	UAdder* Object;
};

class FManyDelegatesModule : public IModuleInterface
{
public:
	virtual void StartupModule() override { Extension = FSceneViewExtensions::NewExtension<FManyDelegatesExtension>(); }

private:
	TSharedPtr<FManyDelegatesExtension, ESPMode::ThreadSafe> Extension;
};
IMPLEMENT_MODULE(FManyDelegatesModule, ManyDelegates)
