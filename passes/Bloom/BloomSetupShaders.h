// The shaders of the bloom setup as classes, which their native kernel shares. Source: engine file
// PostProcessBloomSetup.cpp.
#pragma once

#include "Exposure/PostProcessLocalExposure.h"
#include "SceneRendering.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

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

class FThresholdDimension : SHADER_PERMUTATION_BOOL("USE_THRESHOLD");
class FLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");

using FBloomSetupPermutation = TShaderPermutationDomain<FThresholdDimension, FLocalExposureDimension>;

DRYDOCK_SCREEN_SHADERS(FBloomSetup, FBloomSetupParameters, FBloomSetupPermutation, BloomOutput);

/** The permutation for a threshold: whether there is a ramp, and local exposure. A threshold of NaN or -infinity means
 * none in every engine. */
FBloomSetupPS::FPermutationDomain ChooseBloomSetupPermutation(
	const FViewInfo& View, float Threshold, bool bLocalExposure);

} // namespace Drydock
