// The box pass of CharaGlow as a shader class, which its native kernel shares.
#pragma once

#include "GlobalShader.h"
#include "RenderGraphResources.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

BEGIN_SHADER_PARAMETER_STRUCT(FCharaGlowBoxParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Source)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, RowsTexture)
	SHADER_PARAMETER(int32, Radius)
	SHADER_PARAMETER(float, Fraction)
	SHADER_PARAMETER(float, Scale)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

/** One direction of the box: rows of the mask, or columns of those rows. */
class FCharaGlowBoxPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FCharaGlowBoxPS);
	SHADER_USE_PARAMETER_STRUCT(FCharaGlowBoxPS, FGlobalShader);

	class FColumnsDimension : SHADER_PERMUTATION_BOOL("COLUMNS");
	using FPermutationDomain = TShaderPermutationDomain<FColumnsDimension>;
	using FParameters = FCharaGlowBoxParameters;
};

} // namespace Drydock
