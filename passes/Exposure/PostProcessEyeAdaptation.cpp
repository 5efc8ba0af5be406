// The passes that meter an exposure and adapt it. Source: engine file PostProcessEyeAdaptation.cpp.
#include "Exposure/PostProcessEyeAdaptation.h"

#include "GlobalShader.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace
{

/** The forms of PostProcessEyeAdaptation.usf. */
enum class EEyeAdaptationShader : int32
{
	Setup,
	Histogram,
	Basic
};

template<EEyeAdaptationShader Form>
class TEyeAdaptationShader : public FGlobalShader
{
public:
	using FGlobalShader::FGlobalShader;

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("SHADER_EYE_ADAPTATION"), static_cast<int32>(Form));
	}
};

/** Parameters of both ways of metering. */
BEGIN_SHADER_PARAMETER_STRUCT(FAdaptationParameters, )
	SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, EyeAdaptation)
	SHADER_PARAMETER_STRUCT(FLocalExposureParameters, LocalExposure)
	SHADER_PARAMETER(float, bAverageLocalExposure)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, LastEyeAdaptationBuffer)
	SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<float4>, RWEyeAdaptationBuffer)
END_SHADER_PARAMETER_STRUCT()

class FEyeAdaptationCS : public TEyeAdaptationShader<EEyeAdaptationShader::Histogram>
{
public:
	DECLARE_GLOBAL_SHADER(FEyeAdaptationCS);
	SHADER_USE_PARAMETER_STRUCT(FEyeAdaptationCS, TEyeAdaptationShader<EEyeAdaptationShader::Histogram>);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FAdaptationParameters, Adaptation)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, HistogramTexture)
	END_SHADER_PARAMETER_STRUCT()
};

class FBasicEyeAdaptationCS : public TEyeAdaptationShader<EEyeAdaptationShader::Basic>
{
public:
	DECLARE_GLOBAL_SHADER(FBasicEyeAdaptationCS);
	SHADER_USE_PARAMETER_STRUCT(FBasicEyeAdaptationCS, TEyeAdaptationShader<EEyeAdaptationShader::Basic>);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FAdaptationParameters, Adaptation)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, MeterMaskTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, MeterMaskSampler)
	END_SHADER_PARAMETER_STRUCT()
};

class FBasicEyeAdaptationSetupPS : public TEyeAdaptationShader<EEyeAdaptationShader::Setup>
{
public:
	DECLARE_GLOBAL_SHADER(FBasicEyeAdaptationSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBasicEyeAdaptationSetupPS, TEyeAdaptationShader<EEyeAdaptationShader::Setup>);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, EyeAdaptation)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(
	FEyeAdaptationCS, "/Engine/Private/PostProcessEyeAdaptation.usf", "EyeAdaptationCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(
	FBasicEyeAdaptationCS, "/Engine/Private/PostProcessEyeAdaptation.usf", "BasicEyeAdaptationCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(
	FBasicEyeAdaptationSetupPS, "/Engine/Private/PostProcessEyeAdaptation.usf", "BasicEyeAdaptationSetupPS", SF_Pixel);

FRDGBufferRef CreateBuffer(FRDGBuilder& GraphBuilder, const FVector4f& Entry)
{
	const FVector4f Entries[Drydock::GEyeAdaptationBufferEntries] = {Entry, FVector4f(1.0f, 0.0f, 0.0f, 0.0f)};
	return CreateStructuredBuffer(GraphBuilder, TEXT("EyeAdaptation"), sizeof(FVector4f),
		Drydock::GEyeAdaptationBufferEntries, Entries, sizeof(Entries));
}

FAdaptationParameters MakeAdaptationParameters(
	FRDGBuilder& GraphBuilder, const FEyeAdaptationInputs& Inputs, FRDGBufferRef Output)
{
	check(Inputs.LastEyeAdaptationBuffer || Inputs.Parameters.ForceTarget > 0.5f);
	FAdaptationParameters Parameters;
	Parameters.EyeAdaptation = Inputs.Parameters;
	if (Inputs.LocalExposure != nullptr)
	{
		Parameters.LocalExposure = *Inputs.LocalExposure;
		Parameters.bAverageLocalExposure = 1.0f;
	}
	const FRDGBufferRef Last = Inputs.LastEyeAdaptationBuffer ? Inputs.LastEyeAdaptationBuffer
															  : Drydock::CreateEyeAdaptationBuffer(GraphBuilder, 1.0f);
	Parameters.LastEyeAdaptationBuffer = GraphBuilder.CreateSRV(Last);
	Parameters.RWEyeAdaptationBuffer = GraphBuilder.CreateUAV(Output);
	return Parameters;
}

FRDGBufferRef CreateOutput(FRDGBuilder& GraphBuilder)
{
	return GraphBuilder.CreateBuffer(
		FRDGBufferDesc::CreateStructuredDesc(sizeof(FVector4f), Drydock::GEyeAdaptationBufferEntries),
		TEXT("EyeAdaptation"));
}

} // namespace

namespace Drydock
{

FRDGBufferRef CreateEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, float ExposureScale)
{
	check(ExposureScale > 0.0f && std::isfinite(ExposureScale));
	// The average luminance that this scale would have been chosen for: middle grey over the scale.
	return CreateBuffer(GraphBuilder, FVector4f(ExposureScale, ExposureScale, 0.18f / ExposureScale, 1.0f));
}

FRDGBufferRef CreateManualEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, const FEyeAdaptationParameters& Parameters)
{
	const float Compensation = Parameters.ExposureCompensationSettings * Parameters.ExposureCompensationCurve;
	const float Scale = Compensation / FMath::Max(0.0001f, Parameters.MinAverageLuminance / 0.18f);
	return CreateBuffer(GraphBuilder, FVector4f(Scale, Scale, Parameters.MinAverageLuminance, Compensation));
}

} // namespace Drydock

FRDGBufferRef Drydock::BuiltInAddHistogramEyeAdaptationPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationInputs& Inputs, FRDGTextureRef HistogramTexture)
{
	check(HistogramTexture);
	const FRDGBufferRef Output = CreateOutput(GraphBuilder);
	auto* PassParameters = GraphBuilder.AllocParameters<FEyeAdaptationCS::FParameters>();
	PassParameters->Adaptation = MakeAdaptationParameters(GraphBuilder, Inputs, Output);
	PassParameters->HistogramTexture = HistogramTexture;
	TShaderMapRef<FEyeAdaptationCS> ComputeShader(View.ShaderMap);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("HistogramEyeAdaptation (CS)"), ComputeShader,
		PassParameters, FIntVector(1, 1, 1));
	return Output;
}

FScreenPassTexture Drydock::BuiltInAddBasicEyeAdaptationSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor)
{
	check(SceneColor.IsValid());
	const FScreenPassRenderTarget Output =
		Drydock::CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("BasicEyeAdaptationSetup"), PF_FloatRGBA);
	auto* PassParameters = GraphBuilder.AllocParameters<FBasicEyeAdaptationSetupPS::FParameters>();
	PassParameters->View = View.ViewUniformBuffer;
	PassParameters->EyeAdaptation = Parameters;
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	TShaderMapRef<FBasicEyeAdaptationSetupPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("BasicEyeAdaptationSetup %dx%d (PS)", Output.ViewRect.Width(), Output.ViewRect.Height()),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FRDGBufferRef Drydock::BuiltInAddBasicEyeAdaptationPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationInputs& Inputs, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask)
{
	check(SceneColor.IsValid());
	const FRDGBufferRef Output = CreateOutput(GraphBuilder);
	auto* PassParameters = GraphBuilder.AllocParameters<FBasicEyeAdaptationCS::FParameters>();
	PassParameters->Adaptation = MakeAdaptationParameters(GraphBuilder, Inputs, Output);
	PassParameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	PassParameters->ColorTexture = SceneColor.Texture;
	PassParameters->MeterMaskTexture = MeterMask ? MeterMask : GSystemTextures.GetWhiteDummy(GraphBuilder);
	PassParameters->MeterMaskSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	TShaderMapRef<FBasicEyeAdaptationCS> ComputeShader(View.ShaderMap);
	FComputeShaderUtils::AddPass(
		GraphBuilder, RDG_EVENT_NAME("BasicEyeAdaptation (CS)"), ComputeShader, PassParameters, FIntVector(1, 1, 1));
	return Output;
}
