// The shaders of the bloom setup as classes, which their native kernel shares. Source: engine file
// PostProcessBloomSetup.cpp.
#pragma once

#include "Exposure/PostProcessLocalExposure.h"
#include "SceneRendering.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

BEGIN_SHADER_PARAMETER_STRUCT(FBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture3D, LumBilateralGrid)
	SHADER_PARAMETER_SAMPLER(SamplerState, LumBilateralGridSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredLogLum)
	SHADER_PARAMETER_SAMPLER(SamplerState, BlurredLogLumSampler)
	SHADER_PARAMETER_STRUCT(FLocalExposureParameters, LocalExposure)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, EyeAdaptation)
	SHADER_PARAMETER(float, BloomThreshold)
	SHADER_PARAMETER(FScreenTransform, SvPositionToInputTextureUV)
END_SHADER_PARAMETER_STRUCT()

namespace Drydock
{

class FThresholdDimension : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");
class FLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");

class FBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FBloomSetupPS, FGlobalShader);

	using FPermutationDomain = TShaderPermutationDomain<FThresholdDimension, FLocalExposureDimension>;

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

	using FPermutationDomain = FBloomSetupPS::FPermutationDomain;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, Common)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, BloomOutput)
	END_SHADER_PARAMETER_STRUCT()
};

/** The permutation for a threshold: whether there is a ramp, and local exposure. A threshold of NaN or -infinity means
 * none in every engine. */
FBloomSetupPS::FPermutationDomain ChooseBloomSetupPermutation(
	const FViewInfo& View, float Threshold, bool bLocalExposure);

} // namespace Drydock
