// The tonemapper's shaders as classes, which their native kernel shares. Source: engine file PostProcessTonemap.cpp.
#pragma once

#include "Exposure/PostProcessLocalExposure.h"
#include "SceneRendering.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"
#include "Tonemap/PostProcessCombineLUTs.h"

namespace Drydock
{

BEGIN_SHADER_PARAMETER_STRUCT(FTonemapParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FColorRemapParameters, Remap)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Bloom)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BloomTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, BloomSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BloomDirtMaskTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, BloomDirtMaskSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorGradingLUT)
	SHADER_PARAMETER_SAMPLER(SamplerState, ColorGradingSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, EyeAdaptationBuffer)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, SceneColorApplyParamaters)
	SHADER_PARAMETER(FLinearColor, ColorScale0)
	SHADER_PARAMETER(FVector3f, BloomDirtMaskTint)
	SHADER_PARAMETER(FVector4f, ChromaticAberrationParams)
	SHADER_PARAMETER(FVector3f, FilmGrainIntensities)
	SHADER_PARAMETER(FVector4f, FilmGrainRanges)
	SHADER_PARAMETER(uint32, FilmGrainFrame)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, FilmGrainTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, FilmGrainSampler)
	SHADER_PARAMETER(FVector2f, FilmGrainUVPerPixel)
	SHADER_PARAMETER(FVector2f, FilmGrainUVOffset)
	SHADER_PARAMETER(FVector3f, FilmGrainMeanInverse)
	SHADER_PARAMETER(float, GrainQuantizationStep)
	SHADER_PARAMETER(float, SharpenAmount)
	SHADER_PARAMETER(FVector2f, VignetteScale)
	SHADER_PARAMETER(float, VignetteIntensity)
	SHADER_PARAMETER(float, bWriteLumaToAlpha)
	SHADER_PARAMETER_STRUCT(FEyeAdaptationParameters, EyeAdaptation)
	SHADER_PARAMETER_STRUCT(FLocalExposureParameters, LocalExposure)
	SHADER_PARAMETER_RDG_TEXTURE(Texture3D, LumBilateralGrid)
	SHADER_PARAMETER_SAMPLER(SamplerState, LumBilateralGridSampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredLogLum)
	SHADER_PARAMETER_SAMPLER(SamplerState, BlurredLogLumSampler)
END_SHADER_PARAMETER_STRUCT()

class FTonemapGammaOnlyDimension : SHADER_PERMUTATION_BOOL("USE_GAMMA_ONLY");
class FTonemapBloomDimension : SHADER_PERMUTATION_BOOL("USE_BLOOM");
class FTonemapDirtMaskDimension : SHADER_PERMUTATION_BOOL("USE_DIRT_MASK");
class FTonemapVignetteDimension : SHADER_PERMUTATION_BOOL("USE_VIGNETTE");
class FTonemapSharpenDimension : SHADER_PERMUTATION_BOOL("USE_SHARPEN");
class FTonemapFilmGrainDimension : SHADER_PERMUTATION_BOOL("USE_FILM_GRAIN");
class FTonemapFilmGrainTextureDimension : SHADER_PERMUTATION_BOOL("USE_FILM_GRAIN_TEXTURE");
class FTonemapGrainQuantizationDimension : SHADER_PERMUTATION_BOOL("USE_GRAIN_QUANTIZATION");
class FTonemapColorFringeDimension : SHADER_PERMUTATION_BOOL("USE_COLOR_FRINGE");
class FTonemapLocalExposureDimension : SHADER_PERMUTATION_BOOL("USE_LOCAL_EXPOSURE");
class FTonemapLUTDimension : SHADER_PERMUTATION_BOOL("USE_LUT");
class FTonemapSceneColorApplyDimension : SHADER_PERMUTATION_BOOL("USE_SCENE_COLOR_APPLY");

using FTonemapPermutation = TShaderPermutationDomain<FTonemapGammaOnlyDimension, FTonemapBloomDimension,
	FTonemapDirtMaskDimension, FTonemapVignetteDimension, FTonemapSharpenDimension, FTonemapFilmGrainDimension,
	FTonemapFilmGrainTextureDimension, FTonemapGrainQuantizationDimension, FTonemapColorFringeDimension,
	FTonemapLocalExposureDimension, FTonemapLUTDimension, FTonemapSceneColorApplyDimension, FColorRemapPermutation>;

DRYDOCK_SCREEN_SHADERS(FTonemap, FTonemapParameters, FTonemapPermutation, RWOutputTexture);

} // namespace Drydock
