// The uniform buffer through which shaders read scene textures (SceneTexturesStruct.X) and its makers.
// Source: engine file SceneTextureParameters.h.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphResources.h"
#include "SceneTextures.h"
#include "SceneTexturesConfig.h"
#include "ShaderParameterMacros.h"
#include "ShaderParameterStruct.h"

class FRDGBuilder;
class FSceneView;

BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FSceneTextureUniformParameters, DRYDOCK_API)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneColorTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneDepthTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferATexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferBTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferCTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferDTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferETexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferFTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferVelocityTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ScreenSpaceAOTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, CustomDepthTexture)
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D<uint2>, CustomStencilTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, PointClampSampler)
	// One for each texture, as shaders of older engines name them; all point, clamped.
	SHADER_PARAMETER_SAMPLER(SamplerState, SceneColorTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, SceneDepthTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferATextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferBTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferCTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferDTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferETextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferFTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, GBufferVelocityTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, ScreenSpaceAOTextureSampler)
	SHADER_PARAMETER_SAMPLER(SamplerState, CustomDepthTextureSampler)
END_GLOBAL_SHADER_PARAMETER_STRUCT()

/** Included by a shader's parameters to reach the scene textures. */
BEGIN_SHADER_PARAMETER_STRUCT(FSceneTextureShaderParameters, DRYDOCK_API)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
END_SHADER_PARAMETER_STRUCT()

/** The scene textures one by one, for passes that do without the uniform buffer. */
BEGIN_SHADER_PARAMETER_STRUCT(FSceneTextureParameters, DRYDOCK_API)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneDepthTexture)
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D<uint2>, SceneStencilTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferVelocityTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferATexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferBTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferCTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferDTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferETexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, GBufferFTexture)
END_SHADER_PARAMETER_STRUCT()

/** Those textures of SceneTextures that SetupMode names; black dummies for the rest and for absent ones. SceneTextures
 * may be null: all black. */
DRYDOCK_API void SetupSceneTextureUniformParameters(FRDGBuilder& GraphBuilder, const FSceneTextures* SceneTextures,
	ESceneTextureSetupMode SetupMode, FSceneTextureUniformParameters& OutParameters);

DRYDOCK_API TRDGUniformBufferRef<FSceneTextureUniformParameters> CreateSceneTextureUniformBuffer(
	FRDGBuilder& GraphBuilder, const FSceneTextures* SceneTextures,
	ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All);
DRYDOCK_API TRDGUniformBufferRef<FSceneTextureUniformParameters> CreateSceneTextureUniformBuffer(
	FRDGBuilder& GraphBuilder, const FSceneView& View, ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All);

DRYDOCK_API FSceneTextureShaderParameters CreateSceneTextureShaderParameters(FRDGBuilder& GraphBuilder,
	const FSceneTextures* SceneTextures, ERHIFeatureLevel::Type FeatureLevel,
	ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All);
DRYDOCK_API FSceneTextureShaderParameters CreateSceneTextureShaderParameters(
	FRDGBuilder& GraphBuilder, const FSceneView& View, ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All);

inline FSceneTextureShaderParameters GetSceneTextureShaderParameters(
	TRDGUniformBufferRef<FSceneTextureUniformParameters> UniformBuffer)
{
	FSceneTextureShaderParameters Parameters;
	Parameters.SceneTextures = UniformBuffer;
	return Parameters;
}

/** The same by reference, and with the feature level of older engines. */
inline FSceneTextureShaderParameters CreateSceneTextureShaderParameters(FRDGBuilder& GraphBuilder,
	const FSceneTextures& SceneTextures, ERHIFeatureLevel::Type FeatureLevel,
	ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All)
{
	return CreateSceneTextureShaderParameters(GraphBuilder, &SceneTextures, FeatureLevel, SetupMode);
}
inline TRDGUniformBufferRef<FSceneTextureUniformParameters> CreateSceneTextureUniformBuffer(FRDGBuilder& GraphBuilder,
	const FSceneTextures* SceneTextures, ERHIFeatureLevel::Type,
	ESceneTextureSetupMode SetupMode = ESceneTextureSetupMode::All)
{
	return CreateSceneTextureUniformBuffer(GraphBuilder, SceneTextures, SetupMode);
}

/** The renderer's scene textures one by one: black where the frame has none, and a stencil of 0. */
DRYDOCK_API FSceneTextureParameters GetSceneTextureParameters(
	FRDGBuilder& GraphBuilder, const FSceneTextures& SceneTextures);
DRYDOCK_API FSceneTextureParameters GetSceneTextureParameters(FRDGBuilder& GraphBuilder, const FSceneView& View);
DRYDOCK_API FSceneTextureParameters GetSceneTextureParameters(
	FRDGBuilder& GraphBuilder, TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextureUniformBuffer);
