// The shaders of motion blur as classes, which native kernels share. Source: engine file
// PostProcess/PostProcessMotionBlur.cpp (passes).
#pragma once

#include "GlobalShader.h"
#include "SceneRendering.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

/** Pixels on a side of a tile; as in the engine. */
constexpr int32 GMotionBlurTileSize = 16;

BEGIN_SHADER_PARAMETER_STRUCT(FMotionBlurParameters, )
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER(FIntPoint, FlatSize)
	SHADER_PARAMETER(FIntPoint, TileCount)
	SHADER_PARAMETER(int32, TileReach)
	SHADER_PARAMETER(int32, MaxSamples)
	SHADER_PARAMETER(float, VelocityScale)
	SHADER_PARAMETER(float, MaxLength)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, FlatTexture)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, TileTexture)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FMotionBlurVelocityFlattenPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMotionBlurVelocityFlattenPS);
	SHADER_USE_PARAMETER_STRUCT(FMotionBlurVelocityFlattenPS, FGlobalShader);
	using FParameters = FMotionBlurParameters;
};

class FMotionBlurVelocityTileMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMotionBlurVelocityTileMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FMotionBlurVelocityTileMaxPS, FGlobalShader);
	using FParameters = FMotionBlurParameters;
};

class FMotionBlurVelocityNeighborMaxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMotionBlurVelocityNeighborMaxPS);
	SHADER_USE_PARAMETER_STRUCT(FMotionBlurVelocityNeighborMaxPS, FGlobalShader);
	using FParameters = FMotionBlurParameters;
};

class FMotionBlurFilterPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FMotionBlurFilterPS);
	SHADER_USE_PARAMETER_STRUCT(FMotionBlurFilterPS, FGlobalShader);
	using FParameters = FMotionBlurParameters;
};

} // namespace Drydock
