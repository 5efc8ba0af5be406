// The pass that posterizes: one pixel shader over the picture.
#include "Lens/Posterize.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

class FPosterizePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FPosterizePS);
	SHADER_USE_PARAMETER_STRUCT(FPosterizePS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER(float, Levels)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FPosterizePS, "/Drydock/Private/Posterize.usf", "MainPS", SF_Pixel);

} // namespace

FScreenPassTexture AddPosterizePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor, float Levels)
{
	check(SceneColor.IsValid());
	const FScreenPassRenderTarget Output = CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("Posterize"));
	FPosterizePS::FParameters* PassParameters = GraphBuilder.AllocParameters<FPosterizePS::FParameters>();
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->Levels = Levels;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const TShaderMapRef<FPosterizePS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("Posterize %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()), PixelShader,
		PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

} // namespace Drydock
