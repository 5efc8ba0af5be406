// The shaders of depth of field as classes, which native kernels share. Source: engine file
// PostProcess/DiaphragmDOF.cpp.
#pragma once

#include "GlobalShader.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

/** Pixels of half size on a side of a tile. */
constexpr int32 GDOFTileSize = 16;

BEGIN_SHADER_PARAMETER_STRUCT(FDOFParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER(FIntPoint, HalfSize)
	SHADER_PARAMETER(FIntPoint, TileCount)
	SHADER_PARAMETER(int32, TileReach)
	SHADER_PARAMETER(int32, BokehSampleCount)
	SHADER_PARAMETER(FVector4f, CocModel)  // focus distance, radius at infinity, least, largest
	SHADER_PARAMETER(FVector4f, DepthBlur) // radius, 1 / half depth
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SetupTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, TileTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BackgroundTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ForegroundTexture)
	SHADER_PARAMETER_SAMPLER(SamplerState, LayerSampler)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, BokehSamples)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, ReachSums)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FDOFSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFSetupPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFTileMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFTileMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFTileMaxPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFNeighborMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFNeighborMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFNeighborMaxPS, FGlobalShader);
	using FParameters = FDOFParameters;
};

class FDOFGatherPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFGatherPS);
	SHADER_USE_PARAMETER_STRUCT(FDOFGatherPS, FGlobalShader);

	class FForegroundDimension : SHADER_PERMUTATION_BOOL("DIM_FOREGROUND");
	using FPermutationDomain = TShaderPermutationDomain<FForegroundDimension>;
	using FParameters = FDOFParameters;
};

class FDOFRecombinePS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDOFRecombinePS);
	SHADER_USE_PARAMETER_STRUCT(FDOFRecombinePS, FGlobalShader);
	using FParameters = FDOFParameters;
};

} // namespace Drydock
