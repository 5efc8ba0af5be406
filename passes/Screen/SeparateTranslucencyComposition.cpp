// The pass that composes separate translucency. Source: engine ComposeSeparateTranslucency.usf.
#include "Screen/SeparateTranslucencyComposition.h"

#include "GlobalShader.h"
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

class FComposeSeparateTranslucencyPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FComposeSeparateTranslucencyPS);
	SHADER_USE_PARAMETER_STRUCT(FComposeSeparateTranslucencyPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Translucency)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, TranslucencyTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BilinearSampler)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(
	FComposeSeparateTranslucencyPS, "/Engine/Private/ComposeSeparateTranslucency.usf", "MainPS", SF_Pixel);

} // namespace

FScreenPassTexture AddSeparateTranslucencyCompositionPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, const FScreenPassTexture& SeparateTranslucency)
{
	check(SceneColor.IsValid());
	check(SeparateTranslucency.IsValid());
	const FScreenPassRenderTarget Output =
		CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("SceneColorWithTranslucency"));

	auto* PassParameters = GraphBuilder.AllocParameters<FComposeSeparateTranslucencyPS::FParameters>();
	PassParameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	PassParameters->Translucency =
		GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SeparateTranslucency));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->ColorTexture = SceneColor.Texture;
	PassParameters->TranslucencyTexture = SeparateTranslucency.Texture;
	PassParameters->BilinearSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const TShaderMapRef<FComposeSeparateTranslucencyPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("ComposeSeparateTranslucency %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

} // namespace Drydock
