// The shaders of the bloom setup with toon bloom as classes, which their native kernel shares.
#pragma once

#include "Bloom/BloomSetupShaders.h"
#include "SceneTextureParameters.h"

namespace Drydock
{

BEGIN_SHADER_PARAMETER_STRUCT(FToonBloomSetupParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FBloomSetupParameters, BloomSetup)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FSceneTextureUniformParameters, SceneTextures)
	SHADER_PARAMETER(float, ToonIntensity)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ToonTexture)
	SHADER_PARAMETER(FScreenTransform, SvPositionToToonTextureUV)
END_SHADER_PARAMETER_STRUCT()

class FToonAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");

using FToonBloomSetupPermutation = TShaderPermutationDomain<FToonAsPrintedDimension, FBloomSetupPS::FPermutationDomain>;

DRYDOCK_SCREEN_SHADERS(FToonBloomSetup, FToonBloomSetupParameters, FToonBloomSetupPermutation, BloomOutput);

} // namespace Drydock
