// Adds the full-screen pass, with a parameter struct that the shader mirrors.
#include "TintPixel.h"

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "ShaderParameterStruct.h"

namespace
{
class FTintPS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTintPS)
	SHADER_USE_PARAMETER_STRUCT(FTintPS, FGlobalShader)

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Source)
		SHADER_PARAMETER(FLinearColor, Tint)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTintPS, "/Plugin/TintPixel/Tint.usf", "TintPS", SF_Pixel)
} // namespace

FScreenPassTexture AddTintPass(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, const FLinearColor& Tint)
{
	FScreenPassRenderTarget Output = FScreenPassRenderTarget::CreateFromInput(
		GraphBuilder, Input, ERenderTargetLoadAction::ENoAction, TEXT("TintOutput"));

	auto* Parameters = GraphBuilder.AllocParameters<FTintPS::FParameters>();
	Parameters->Source =
		GetScreenPassTextureInput(Input, TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI());
	Parameters->Tint = Tint;
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	const FGlobalShaderMap* ShaderMap = GetGlobalShaderMap(GMaxRHIFeatureLevel);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, ShaderMap, RDG_EVENT_NAME("Tint"),
		TShaderMapRef<FTintPS>(ShaderMap), Parameters, Output.ViewRect);
	return MoveTemp(Output);
}
