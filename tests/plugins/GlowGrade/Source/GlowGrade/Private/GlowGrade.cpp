// A glow in four passes, fog and a grade behind the tonemapper, with ten mistakes to choose from: for the tools that
// find them. r.GlowGrade.Fault says which; 0: none.
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RenderGraphUtils.h"
#include "SceneViewExtension.h"
#include "ScreenPass.h"
#include "ShaderCore.h"

namespace
{

TAutoConsoleVariable<int32> CVarFault(TEXT("r.GlowGrade.Fault"), 0,
	TEXT(
		"1: channels swapped; 2: half a texel off; 3: sRGB twice; 4: pow of a negative number; 5: a clamp is missing; ")
		TEXT("6: a variable is not set behind an if; 7: a barrier is missing; 8: UV by the extent; 9: exposure twice; ")
			TEXT("10: premultiplied twice"));

class FFault : SHADER_PERMUTATION_INT("FAULT", 11);

class FGlowShader : public FGlobalShader
{
public:
	using FPermutationDomain = TShaderPermutationDomain<FFault>;
	using FGlobalShader::FGlobalShader;
};

class FGlowSetupPS : public FGlowShader
{
public:
	DECLARE_GLOBAL_SHADER(FGlowSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FGlowSetupPS, FGlowShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FGlowBlurCS : public FGlowShader
{
public:
	DECLARE_GLOBAL_SHADER(FGlowBlurCS);
	SHADER_USE_PARAMETER_STRUCT(FGlowBlurCS, FGlowShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER(FIntPoint, Size)
		SHADER_PARAMETER(int32, Columns)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutGlow)
	END_SHADER_PARAMETER_STRUCT()
};

class FGlowComposePS : public FGlowShader
{
public:
	DECLARE_GLOBAL_SHADER(FGlowComposePS);
	SHADER_USE_PARAMETER_STRUCT(FGlowComposePS, FGlowShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTexturesStruct)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Glow)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GlowTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, GlowSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FGlowGradePS : public FGlowShader
{
public:
	DECLARE_GLOBAL_SHADER(FGlowGradePS);
	SHADER_USE_PARAMETER_STRUCT(FGlowGradePS, FGlowShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FGlowSetupPS, "/Plugin/GlowGrade/GlowGrade.usf", "SetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FGlowBlurCS, "/Plugin/GlowGrade/GlowBlur.usf", "BlurCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FGlowComposePS, "/Plugin/GlowGrade/GlowGrade.usf", "ComposePS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FGlowGradePS, "/Plugin/GlowGrade/GlowGrade.usf", "GradePS", SF_Pixel);

template<typename TShader>
TShaderMapRef<TShader> FindShader()
{
	typename TShader::FPermutationDomain Permutation;
	Permutation.template Set<FFault>(CVarFault.GetValueOnRenderThread());
	return TShaderMapRef<TShader>(GetGlobalShaderMap(GMaxRHIFeatureLevel), Permutation);
}

FRDGTextureRef CreateFloat(FRDGBuilder& GraphBuilder, FIntPoint Extent, const TCHAR* Name)
{
	return GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(Extent, PF_FloatRGBA, FClearValueBinding::Black,
										  TexCreate_ShaderResource | TexCreate_RenderTargetable | TexCreate_UAV),
		Name);
}

template<typename TShader>
void AddPixelPass(FRDGBuilder& GraphBuilder, FRDGEventName&& Name, typename TShader::FParameters* Parameters,
	FRDGTextureRef Target, const FIntRect& Rect)
{
	Parameters->RenderTargets[0] = FRenderTargetBinding(Target, ERenderTargetLoadAction::ENoAction);
	FPixelShaderUtils::AddFullscreenPass(
		GraphBuilder, GetGlobalShaderMap(GMaxRHIFeatureLevel), MoveTemp(Name), FindShader<TShader>(), Parameters, Rect);
}

FRDGTextureRef AddBlur(
	FRDGBuilder& GraphBuilder, FRDGEventName&& Name, FRDGTextureRef Input, FIntPoint Size, bool bColumns)
{
	FRDGTextureRef Output = CreateFloat(GraphBuilder, Size, TEXT("Glow"));
	auto* Parameters = GraphBuilder.AllocParameters<FGlowBlurCS::FParameters>();
	Parameters->InputTexture = Input;
	Parameters->Size = Size;
	Parameters->Columns = bColumns;
	Parameters->OutGlow = GraphBuilder.CreateUAV(Output);
	const FIntPoint Threads = bColumns ? FIntPoint(Size.Y, Size.X) : Size;
	FComputeShaderUtils::AddPass(GraphBuilder, MoveTemp(Name), FindShader<FGlowBlurCS>(), Parameters,
		FComputeShaderUtils::GetGroupCount(Threads, FIntPoint(64, 1)));
	return Output;
}

class FGlowGradeExtension : public FSceneViewExtensionBase
{
public:
	FGlowGradeExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	virtual void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool bIsPassEnabled) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FGlowGradeExtension::AddGlow));
		}
		if (Pass == EPostProcessingPass::Tonemap)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FGlowGradeExtension::AddGrade));
		}
	}

private:
	FScreenPassTexture AddGlow(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture Scene(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		const FIntPoint Half = FIntPoint::DivideAndRoundUp(Scene.ViewRect.Size(), 2);
		FRHISamplerState* const Bilinear = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

		FRDGTextureRef Setup = CreateFloat(GraphBuilder, Half, TEXT("GlowSetup"));
		auto* SetupParameters = GraphBuilder.AllocParameters<FGlowSetupPS::FParameters>();
		SetupParameters->View = View.ViewUniformBuffer;
		SetupParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Scene));
		SetupParameters->InputTexture = Scene.Texture;
		SetupParameters->InputSampler = Bilinear;
		AddPixelPass<FGlowSetupPS>(
			GraphBuilder, RDG_EVENT_NAME("GlowSetup"), SetupParameters, Setup, FIntRect(FIntPoint(0, 0), Half));

		FRDGTextureRef Glow = AddBlur(GraphBuilder, RDG_EVENT_NAME("GlowBlurX"), Setup, Half, false);
		Glow = AddBlur(GraphBuilder, RDG_EVENT_NAME("GlowBlurY"), Glow, Half, true);

		FRDGTextureRef Target = CreateFloat(GraphBuilder, Scene.Texture->Desc.Extent, TEXT("GlowCompose"));
		auto* Parameters = GraphBuilder.AllocParameters<FGlowComposePS::FParameters>();
		Parameters->View = View.ViewUniformBuffer;
		Parameters->SceneTexturesStruct = Inputs.SceneTextures.SceneTextures;
		Parameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Scene));
		Parameters->Glow = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Glow));
		Parameters->InputTexture = Scene.Texture;
		Parameters->GlowTexture = Glow;
		Parameters->GlowSampler = Bilinear;
		AddPixelPass<FGlowComposePS>(GraphBuilder, RDG_EVENT_NAME("GlowCompose"), Parameters, Target, Scene.ViewRect);
		return FScreenPassTexture(Target, Scene.ViewRect);
	}

	FScreenPassTexture AddGrade(FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture Picture(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		FScreenPassRenderTarget Output = Inputs.OverrideOutput;
		if (!Output.IsValid())
		{
			Output = FScreenPassRenderTarget(CreateFloat(GraphBuilder, Picture.Texture->Desc.Extent, TEXT("GlowGrade")),
				Picture.ViewRect, ERenderTargetLoadAction::ENoAction);
		}
		auto* Parameters = GraphBuilder.AllocParameters<FGlowGradePS::FParameters>();
		Parameters->InputTexture = Picture.Texture;
		AddPixelPass<FGlowGradePS>(
			GraphBuilder, RDG_EVENT_NAME("GlowGrade"), Parameters, Output.Texture, Output.ViewRect);
		return FScreenPassTexture(Output);
	}
};

class FGlowGradeModule final : public IModuleInterface
{
public:
	virtual void StartupModule() override
	{
		const FString Folder = IPluginManager::Get().FindPlugin(TEXT("GlowGrade"))->GetBaseDir();
		AddShaderSourceDirectoryMapping(TEXT("/Plugin/GlowGrade"), FPaths::Combine(Folder, TEXT("Shaders")));
		Extension = FSceneViewExtensions::NewExtension<FGlowGradeExtension>();
	}

	virtual void ShutdownModule() override { Extension.Reset(); }

private:
	TSharedPtr<FGlowGradeExtension, ESPMode::ThreadSafe> Extension;
};

} // namespace

IMPLEMENT_MODULE(FGlowGradeModule, GlowGrade)
