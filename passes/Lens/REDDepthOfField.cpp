// The passes of RED depth of field, and their factory. Source: article "RED post process".
#include "Lens/REDDepthOfField.h"

#include "Blur/PostProcessWeightedSampleSum.h"
#include "GlobalShader.h"
#include "Lens/REDPostProcess.h"
#include "PassFactory.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

enum class ELayer : uint8
{
	Far,  // colour * far, far
	Near, // colour, 1
};

BEGIN_SHADER_PARAMETER_STRUCT(FREDDepthOfFieldParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Layer)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, FarTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, NearTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, LayerSampler)
	SHADER_PARAMETER(FVector4f, Focus) // distance, region, 1 / near transition, 1 / far transition
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FREDDepthOfFieldSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FREDDepthOfFieldSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FREDDepthOfFieldSetupPS, FGlobalShader);

	class FWeightDimension : SHADER_PERMUTATION_BOOL("WEIGHT_BY_FAR");
	using FPermutationDomain = TShaderPermutationDomain<FWeightDimension>;
	using FParameters = FREDDepthOfFieldParameters;
};

class FREDDepthOfFieldPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FREDDepthOfFieldPS);
	SHADER_USE_PARAMETER_STRUCT(FREDDepthOfFieldPS, FGlobalShader);

	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");
	using FPermutationDomain = TShaderPermutationDomain<FAsPrintedDimension>;
	using FParameters = FREDDepthOfFieldParameters;
};

IMPLEMENT_GLOBAL_SHADER(FREDDepthOfFieldSetupPS, "/Project/REDDepthOfField.usf", "SetupPS", SF_Pixel);
IMPLEMENT_GLOBAL_SHADER(FREDDepthOfFieldPS, "/Project/REDDepthOfField.usf", "CombinePS", SF_Pixel);

/** A transition of no length is a step: infinite where there is any distance, and the shader never multiplies it by 0.
 */
float InvertTransition(float Transition)
{
	constexpr float Steepest = 1e30f;
	return Transition > 1.0f / Steepest ? 1.0f / Transition : Steepest;
}

FREDDepthOfFieldParameters* MakeParameters(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FREDDepthOfFieldInputs& Inputs, const FScreenPassRenderTarget& Output)
{
	auto* Parameters = GraphBuilder.AllocParameters<FREDDepthOfFieldParameters>();
	Parameters->View = View.ViewUniformBuffer;
	Parameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
	Parameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters->ColorTexture = Inputs.SceneColor.Texture;
	Parameters->LayerSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	Parameters->Focus = FVector4f(Inputs.FocalDistance, Inputs.FocalRegion, InvertTransition(Inputs.NearTransition),
		InvertTransition(Inputs.FarTransition));
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	return Parameters;
}

/** The article's loop, widened until its last taps lie on the kernel's radius. */
FScreenPassTexture BlurAsPrinted(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FGaussianBlurInputs& Blur)
{
	const float Radius = static_cast<float>(Blur.Filter.ViewRect.Width()) * Blur.KernelSizePercent / 200.0f;
	FREDPostProcessPassInputs Inputs;
	Inputs.Parameters.bAsPrinted = true;
	Inputs.BlurStep = Radius / static_cast<float>(GetREDBlurReach(EREDBlurKernel::Printed));
	Inputs.Pass = EREDPostProcessPass::BlurH;
	Inputs.Name = Blur.NameX;
	Inputs.SceneColor = Blur.Filter;
	Inputs.SceneColor = AddREDPostProcessPass(GraphBuilder, View, Inputs);
	Inputs.Pass = EREDPostProcessPass::BlurV;
	Inputs.Name = Blur.NameY;
	return AddREDPostProcessPass(GraphBuilder, View, Inputs);
}

/** A layer at half resolution, blurred. */
FScreenPassTexture AddLayer(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDDepthOfFieldInputs& Inputs, ELayer Layer)
{
	const bool bFar = Layer == ELayer::Far;
	const FScreenPassRenderTarget Output = CreateSmallRasterTarget(GraphBuilder, Inputs.SceneColor,
		FIntPoint::DivideAndRoundUp(Inputs.SceneColor.ViewRect.Size(), 2),
		bFar ? TEXT("REDDofFarSetup") : TEXT("REDDofNearSetup"), PF_FloatRGBA);
	FREDDepthOfFieldSetupPS::FPermutationDomain Permutation;
	Permutation.Set<FREDDepthOfFieldSetupPS::FWeightDimension>(bFar && !Inputs.bAsPrinted);
	TShaderMapRef<FREDDepthOfFieldSetupPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("REDDepthOfField.%s %dx%d", bFar ? TEXT("FarSetup") : TEXT("NearSetup"), Output.ViewRect.Width(),
			Output.ViewRect.Height()),
		PixelShader, MakeParameters(GraphBuilder, View, Inputs, Output), Output.ViewRect);

	FGaussianBlurInputs Blur;
	Blur.NameX = bFar ? TEXT("REDDofFarX") : TEXT("REDDofNearX");
	Blur.NameY = bFar ? TEXT("REDDofFarY") : TEXT("REDDofNearY");
	Blur.Filter = Output;
	Blur.KernelSizePercent = bFar ? Inputs.FarBlurSize : Inputs.NearBlurSize;
	Blur.UseClampAddressMode = true;
	return Inputs.bAsPrinted ? BlurAsPrinted(GraphBuilder, View, Blur) : AddGaussianBlurPass(GraphBuilder, View, Blur);
}

const FPassFactoryRegistration GREDDepthOfField({
	.Type = "REDDepthOfField",
	.Doc = "Blurs what lies before and behind the focus, by the scene's depth.",
	.Inputs = {{"Input", PictureResource, "The picture."}},
	.Parameters =
		{
			FParameterSpec::Number("FocalDistance", 500, 0.01, 1e7, "In cm."),
			FParameterSpec::Number("FocalRegion", 0, 0, 1e7, "Behind it, in focus too; cm."),
			FParameterSpec::Number(
				"NearTransition", 300, 0, 1e7, "From in focus to all blurred, towards the camera; cm."),
			FParameterSpec::Number("FarTransition", 500, 0, 1e7, "The same, away from it; cm."),
			FParameterSpec::Number("NearBlurSize", 1, 0, 100, "Diameter in percent of the width."),
			FParameterSpec::Number("FarBlurSize", 1, 0, 100, "The same."),
			FParameterSpec::Bool("AsPrinted", false, "The article's form, with its faults."),
		},
	.Add =
		[](FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPassArguments& Arguments)
	{
		FREDDepthOfFieldInputs Inputs;
		Inputs.SceneColor = Arguments.GetInput("Input");
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
		Inputs.FocalDistance = Arguments.Values.GetFloat("FocalDistance");
		Inputs.FocalRegion = Arguments.Values.GetFloat("FocalRegion");
		Inputs.NearTransition = Arguments.Values.GetFloat("NearTransition");
		Inputs.FarTransition = Arguments.Values.GetFloat("FarTransition");
		Inputs.NearBlurSize = Arguments.Values.GetFloat("NearBlurSize");
		Inputs.FarBlurSize = Arguments.Values.GetFloat("FarBlurSize");
		Inputs.bAsPrinted = Arguments.Values.GetBool("AsPrinted");
		return AddREDDepthOfFieldPasses(GraphBuilder, View, Inputs);
	},
});

} // namespace

FREDDepthOfFieldInputs FREDDepthOfFieldInputs::FromSettings(
	const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor)
{
	FREDDepthOfFieldInputs Inputs;
	Inputs.SceneColor = SceneColor;
	Inputs.FocalDistance = Settings.REDDofFocalDistance;
	Inputs.FocalRegion = Settings.REDDofFocalRegion;
	Inputs.NearTransition = Settings.REDDofNearTransition;
	Inputs.FarTransition = Settings.REDDofFarTransition;
	Inputs.NearBlurSize = Settings.REDDofNearBlurSize;
	Inputs.FarBlurSize = Settings.REDDofFarBlurSize;
	Inputs.bAsPrinted = FREDPostProcessParameters::FromSettings(Settings).bAsPrinted;
	return Inputs;
}

FScreenPassTexture AddREDDepthOfFieldPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDDepthOfFieldInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.SceneTextures);
	if (!(Inputs.FocalDistance > 0.0f))
	{
		return Inputs.SceneColor;
	}
	RDG_EVENT_SCOPE(GraphBuilder, "REDDepthOfField");
	const FScreenPassTexture Far = AddLayer(GraphBuilder, View, Inputs, ELayer::Far);
	const FScreenPassTexture Near = AddLayer(GraphBuilder, View, Inputs, ELayer::Near);

	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid()
			? Inputs.OverrideOutput
			: CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("REDDepthOfField"));
	FREDDepthOfFieldParameters* Parameters = MakeParameters(GraphBuilder, View, Inputs, Output);
	Parameters->Layer = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Far));
	Parameters->FarTexture = Far.Texture;
	Parameters->NearTexture = Near.Texture;
	FREDDepthOfFieldPS::FPermutationDomain Permutation;
	Permutation.Set<FREDDepthOfFieldPS::FAsPrintedDimension>(Inputs.bAsPrinted);
	TShaderMapRef<FREDDepthOfFieldPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("REDDepthOfField %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		Parameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

} // namespace Drydock
