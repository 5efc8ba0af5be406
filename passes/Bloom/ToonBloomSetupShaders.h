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

class FToonBloomSetupPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FToonBloomSetupPS);
	SHADER_USE_PARAMETER_STRUCT(FToonBloomSetupPS, FGlobalShader);

	using FPermutationDomain = FToonBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FToonBloomSetupParameters, Common)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

class FToonBloomSetupCS : public FScreenComputeShader
{
public:
	DECLARE_GLOBAL_SHADER(FToonBloomSetupCS);
	SHADER_USE_PARAMETER_STRUCT(FToonBloomSetupCS, FScreenComputeShader);

	using FPermutationDomain = FToonBloomSetupPermutation;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_INCLUDE(FToonBloomSetupParameters, Common)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, BloomOutput)
	END_SHADER_PARAMETER_STRUCT()
};

} // namespace Drydock
