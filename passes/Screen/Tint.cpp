// The pass that tints, and its factories as a pass and as a view extension.
#include "Screen/Tint.h"

#include "ExtensionFactory.h"
#include "GlobalShader.h"
#include "PassFactory.h"
#include "PixelShaderUtils.h"
#include "PostProcess/PostProcessing.h"
#include "RHIStaticStates.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

class FTintPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTintPS);
	SHADER_USE_PARAMETER_STRUCT(FTintPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER(FLinearColor, Color)
		SHADER_PARAMETER(FVector4f, Area)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTintPS, "/Drydock/Private/Tint.usf", "MainPS", SF_Pixel);

FTintInputs MakeInputs(const FParameterValues& Values)
{
	FTintInputs Inputs;
	Inputs.Color = Values.GetColor("Color");
	Inputs.Area =
		FVector4f(Values.GetFloat("Left"), Values.GetFloat("Top"), Values.GetFloat("Right"), Values.GetFloat("Bottom"));
	return Inputs;
}

/** Tints after a pass. */
class FTint : public FSceneViewExtensionBase
{
public:
	FTint(const FAutoRegister& AutoRegister, EPostProcessingPass InPass, const FTintInputs& InTint)
		: FSceneViewExtensionBase(AutoRegister)
		, Pass(InPass)
		, Tint(InTint)
	{
	}

	void SubscribeToPostProcessingPass(
		EPostProcessingPass InPass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass == InPass)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FTint::AddPasses));
		}
	}

private:
	FScreenPassTexture AddPasses(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		FTintInputs TintInputs = Tint;
		TintInputs.SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		TintInputs.OverrideOutput = Inputs.OverrideOutput;
		return AddTintPass(GraphBuilder, static_cast<const FViewInfo&>(View), TintInputs);
	}

	EPostProcessingPass Pass;
	FTintInputs Tint;
};

/** Tints scene colour in place, before the chain. */
class FTintInPlace : public FSceneViewExtensionBase
{
public:
	FTintInPlace(const FAutoRegister& AutoRegister, const FTintInputs& InTint)
		: FSceneViewExtensionBase(AutoRegister)
		, Tint(InTint)
	{
	}

	void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
		FTintInputs TintInputs = Tint;
		TintInputs.SceneColor = FScreenPassTexture((*Inputs.SceneTextures)->SceneColorTexture, ViewInfo.ViewRect);
		const FScreenPassTexture Tinted = AddTintPass(GraphBuilder, ViewInfo, TintInputs);
		AddCopyTexturePass(GraphBuilder, Tinted.Texture, TintInputs.SceneColor.Texture, Tinted.ViewRect.Min,
			Tinted.ViewRect.Min, Tinted.ViewRect.Size());
	}

private:
	FTintInputs Tint;
};

const std::vector<FParameterSpec>& GetParameters()
{
	static const std::vector<FParameterSpec> Parameters = {
		FParameterSpec::Color("Color", FLinearColor(1.0f, 0.5f, 0.5f, 1.0f), "Factor of each channel; not of alpha."),
		FParameterSpec::Number("Left", 0.0, 0.0, 1.0, "Left edge of the area, as a fraction of the picture's width."),
		FParameterSpec::Number("Top", 0.0, 0.0, 1.0, "Top edge, as a fraction of the height."),
		FParameterSpec::Number("Right", 1.0, 0.0, 1.0, "Right edge, as a fraction of the width."),
		FParameterSpec::Number("Bottom", 1.0, 0.0, 1.0, "Bottom edge, as a fraction of the height."),
	};
	return Parameters;
}

TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> CreateExtension(const FExtensionArguments& Arguments)
{
	const FTintInputs Tint = MakeInputs(Arguments.Values);
	if (const auto Pass = FindPassByName(Arguments.Pass))
	{
		return FSceneViewExtensions::NewExtension<FTint>(*Pass, Tint);
	}
	return FSceneViewExtensions::NewExtension<FTintInPlace>(Tint);
}

const FExtensionFactoryRegistration GExtensionFactory({
	.Type = "Tint",
	.Doc = "Multiplies a part of the picture by a colour: shows where a hook is.",
	.Passes = {"MotionBlur", PrePostProcessPassName, "BeforeDOF", "AfterDOF", "SSRInput", "Tonemap", "FXAA",
		"VisualizeDepthOfField"},
	.Parameters = GetParameters(),
	.Create = CreateExtension,
});

const FPassFactoryRegistration GPassFactory({
	.Type = "Tint",
	.Doc = "Multiplies a part of an image by a colour.",
	.Inputs = {{"Input", PictureResource, "The image."}},
	.Parameters = GetParameters(),
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FTintInputs Inputs = MakeInputs(Arguments.Values);
		Inputs.SceneColor = Arguments.GetInput("Input");
		return AddTintPass(GraphBuilder, View, Inputs);
	},
});

} // namespace

FScreenPassTexture AddTintPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTintInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid() ? Inputs.OverrideOutput
										: FScreenPassRenderTarget::CreateFromInput(GraphBuilder, Inputs.SceneColor,
											  ERenderTargetLoadAction::ENoAction, TEXT("Tint"));

	FTintPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FTintPS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = Inputs.SceneColor.Texture;
	PassParameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->Color = Inputs.Color;
	PassParameters->Area = Inputs.Area;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const TShaderMapRef<FTintPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("Tint %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader, PassParameters,
		Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

} // namespace Drydock
