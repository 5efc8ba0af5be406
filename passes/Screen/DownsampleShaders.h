// The shaders that halve an image as classes, which their native kernel shares. Source: engine file
// PostProcessDownsample.cpp.
#pragma once

#include "ScreenPass.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

BEGIN_SHADER_PARAMETER_STRUCT(FDownsampleParameters, )
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
END_SHADER_PARAMETER_STRUCT()

/** An EDownsampleQuality. */
class FDownsampleQualityDimension : SHADER_PERMUTATION_INT("DOWNSAMPLE_QUALITY", 2);

using FDownsamplePermutation = TShaderPermutationDomain<FDownsampleQualityDimension>;

DRYDOCK_SCREEN_SHADERS(FDownsample, FDownsampleParameters, FDownsamplePermutation, OutComputeTexture);

} // namespace Drydock
