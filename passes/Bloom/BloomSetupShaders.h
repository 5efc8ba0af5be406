// The shaders of the bloom setup as classes, which their native kernel shares. Source: engine file
// PostProcessBloomSetup.cpp; toon bloom: the article's patch of it, and its correction.
#pragma once

#include "Exposure/PostProcessLocalExposure.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

enum class EToonBloom : uint8
{
	None,
	Corrected,
	AsPrinted,
	MAX
};

BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER(float, BloomThreshold)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
	SHADER_PARAMETER(float, ToonIntensity)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Toon)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonTexture)
	SHADER_PARAMETER_STRUCT(FLocalExposureShaderParameters, LocalExposure)
END_SHADER_PARAMETER_STRUCT()

class FThresholdDimension : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");
class FToonBloomDimension : SHADER_PERMUTATION_ENUM_CLASS("TOON_BLOOM", EToonBloom);
class FLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");

using FBloomSetupPermutation =
	TShaderPermutationDomain<FThresholdDimension, FToonBloomDimension, FLocalExposureDimension>;

class FBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupPS, FGlobalShader);

	using FPermutationDomain = FBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, Common)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FBloomSetupCS : public FScreenComputeShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupCS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupCS, FScreenComputeShader);

	using FPermutationDomain = FBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, Common)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, BloomOutput)
	END_SHADER_PARAMETER_STRUCT()
};

} // namespace Drydock
