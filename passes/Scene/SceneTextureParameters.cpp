// Fills the uniform buffer of the scene textures. Source: engine file SceneTextureParameters.cpp.
#include "SceneTextureParameters.h"

#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "SystemTextures.h"

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FSceneTextureUniformParameters, "SceneTexturesStruct");

namespace
{

const FSceneTextures* FindSceneTextures(const FSceneView& View)
{
	return View.bIsViewInfo ? static_cast<const FViewInfo&>(View).SceneTextures : nullptr;
}

} // namespace

void SetupSceneTextureUniformParameters(FRDGBuilder& GraphBuilder, const FSceneTextures* SceneTextures,
	ESceneTextureSetupMode SetupMode, FSceneTextureUniformParameters& OutParameters)
{
	const FRDGSystemTextures& SystemTextures = FRDGSystemTextures::Get(GraphBuilder);
	const FSceneTextures Absent;
	const FSceneTextures& Source = SceneTextures ? *SceneTextures : Absent;

	const auto ChooseOr = [SetupMode](ESceneTextureSetupMode Part, FRDGTextureRef Texture, FRDGTextureRef Dummy)
	{
		return Texture && EnumHasAnyFlags(SetupMode, Part) ? Texture : Dummy;
	};
	const auto Choose = [&](ESceneTextureSetupMode Part, FRDGTextureRef Texture)
	{
		return ChooseOr(Part, Texture, SystemTextures.Black);
	};

	OutParameters.SceneColorTexture = Choose(ESceneTextureSetupMode::SceneColor, Source.Color);
	OutParameters.SceneDepthTexture = Choose(ESceneTextureSetupMode::SceneDepth, Source.Depth);
	OutParameters.GBufferATexture = Choose(ESceneTextureSetupMode::GBufferA, Source.GBufferA);
	OutParameters.GBufferBTexture = Choose(ESceneTextureSetupMode::GBufferB, Source.GBufferB);
	OutParameters.GBufferCTexture = Choose(ESceneTextureSetupMode::GBufferC, Source.GBufferC);
	OutParameters.GBufferDTexture = Choose(ESceneTextureSetupMode::GBufferD, Source.GBufferD);
	OutParameters.GBufferETexture = Choose(ESceneTextureSetupMode::GBufferE, Source.GBufferE);
	OutParameters.GBufferFTexture = Choose(ESceneTextureSetupMode::GBufferF, Source.GBufferF);
	OutParameters.GBufferVelocityTexture = Choose(ESceneTextureSetupMode::SceneVelocity, Source.Velocity);
	OutParameters.ScreenSpaceAOTexture =
		ChooseOr(ESceneTextureSetupMode::SSAO, Source.ScreenSpaceAO, SystemTextures.White);
	OutParameters.CustomDepthTexture =
		ChooseOr(ESceneTextureSetupMode::CustomDepth, Source.CustomDepth, SystemTextures.DepthDummy);
	OutParameters.CustomStencilTexture =
		Source.CustomStencil && EnumHasAnyFlags(SetupMode, ESceneTextureSetupMode::CustomDepth)
			? Source.CustomStencil
			: SystemTextures.StencilDummySRV;
	OutParameters.PointClampSampler = TStaticSamplerState<SF_Point, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	using FParameters = FSceneTextureUniformParameters;
	for (const auto Sampler : {&FParameters::SceneColorTextureSampler, &FParameters::SceneDepthTextureSampler,
			 &FParameters::GBufferATextureSampler, &FParameters::GBufferBTextureSampler,
			 &FParameters::GBufferCTextureSampler, &FParameters::GBufferDTextureSampler,
			 &FParameters::GBufferETextureSampler, &FParameters::GBufferFTextureSampler,
			 &FParameters::GBufferVelocityTextureSampler, &FParameters::ScreenSpaceAOTextureSampler,
			 &FParameters::CustomDepthTextureSampler})
	{
		OutParameters.*Sampler = OutParameters.PointClampSampler;
	}
}

TRDGUniformBufferRef<FSceneTextureUniformParameters> CreateSceneTextureUniformBuffer(
	FRDGBuilder& GraphBuilder, const FSceneTextures* SceneTextures, ESceneTextureSetupMode SetupMode)
{
	FSceneTextureUniformParameters* Parameters = GraphBuilder.AllocParameters<FSceneTextureUniformParameters>();
	SetupSceneTextureUniformParameters(GraphBuilder, SceneTextures, SetupMode, *Parameters);
	return GraphBuilder.CreateUniformBuffer(Parameters);
}

TRDGUniformBufferRef<FSceneTextureUniformParameters> CreateSceneTextureUniformBuffer(
	FRDGBuilder& GraphBuilder, const FSceneView& View, ESceneTextureSetupMode SetupMode)
{
	return CreateSceneTextureUniformBuffer(GraphBuilder, FindSceneTextures(View), SetupMode);
}

FSceneTextureShaderParameters CreateSceneTextureShaderParameters(FRDGBuilder& GraphBuilder,
	const FSceneTextures* SceneTextures, ERHIFeatureLevel::Type, ESceneTextureSetupMode SetupMode)
{
	return GetSceneTextureShaderParameters(CreateSceneTextureUniformBuffer(GraphBuilder, SceneTextures, SetupMode));
}

FSceneTextureShaderParameters CreateSceneTextureShaderParameters(
	FRDGBuilder& GraphBuilder, const FSceneView& View, ESceneTextureSetupMode SetupMode)
{
	return GetSceneTextureShaderParameters(CreateSceneTextureUniformBuffer(GraphBuilder, View, SetupMode));
}

namespace
{

FSceneTextureParameters TakeTextures(FRDGBuilder& GraphBuilder, const FSceneTextureUniformParameters& Source)
{
	FSceneTextureParameters Parameters;
	Parameters.SceneDepthTexture = Source.SceneDepthTexture;
	Parameters.SceneStencilTexture = FRDGSystemTextures::Get(GraphBuilder).StencilDummySRV;
	Parameters.GBufferVelocityTexture = Source.GBufferVelocityTexture;
	Parameters.GBufferATexture = Source.GBufferATexture;
	Parameters.GBufferBTexture = Source.GBufferBTexture;
	Parameters.GBufferCTexture = Source.GBufferCTexture;
	Parameters.GBufferDTexture = Source.GBufferDTexture;
	Parameters.GBufferETexture = Source.GBufferETexture;
	Parameters.GBufferFTexture = Source.GBufferFTexture;
	return Parameters;
}

} // namespace

FSceneTextureParameters GetSceneTextureParameters(FRDGBuilder& GraphBuilder, const FSceneTextures& SceneTextures)
{
	FSceneTextureUniformParameters Source;
	SetupSceneTextureUniformParameters(GraphBuilder, &SceneTextures, ESceneTextureSetupMode::All, Source);
	return TakeTextures(GraphBuilder, Source);
}

FSceneTextureParameters GetSceneTextureParameters(FRDGBuilder& GraphBuilder, const FSceneView& View)
{
	FSceneTextureUniformParameters Source;
	SetupSceneTextureUniformParameters(GraphBuilder, FindSceneTextures(View), ESceneTextureSetupMode::All, Source);
	return TakeTextures(GraphBuilder, Source);
}

FSceneTextureParameters GetSceneTextureParameters(
	FRDGBuilder& GraphBuilder, TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextureUniformBuffer)
{
	return TakeTextures(GraphBuilder, *SceneTextureUniformBuffer->GetParameters());
}
