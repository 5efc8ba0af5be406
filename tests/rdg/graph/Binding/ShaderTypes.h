// Shader classes that several tests of this room use, declared in the ways that plugins declare them.
#pragma once

#include "GlobalShader.h"
#include "rdg/graph/Shader/ShaderParameterStructs.h"

/** Output[p] = Input.Load(p) * Tint + PreExposure of the uniform buffer, or without it. */
class FTestTintCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestTintCS);
	SHADER_USE_PARAMETER_STRUCT(FTestTintCS, FGlobalShader);

	class FUseViewDim : SHADER_PERMUTATION_BOOL("USE_VIEW");
	using FPermutationDomain = TShaderPermutationDomain<FUseViewDim>;

	static constexpr int32 THREADGROUPSIZE_X = 8;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FVector4f, Tint)
		SHADER_PARAMETER(FMatrix44f, Transform)
		SHADER_PARAMETER_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_TEXTURE(Texture2D, UnusedTexture)
		SHADER_PARAMETER_UAV(RWTexture2D<float4>, OutputTexture)
		SHADER_PARAMETER_STRUCT_REF(FTestViewUniforms, View)
	END_SHADER_PARAMETER_STRUCT()

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return IsFeatureLevelSupported(Parameters.Platform, ERHIFeatureLevel::SM5);
	}

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUPSIZE_X"), THREADGROUPSIZE_X);
	}
};

/** The shader reads ToonIntensity; the struct spells it otherwise. */
class FTestMisspelledPS final : public FGlobalShader
{
public:
	DECLARE_SHADER_TYPE(FTestMisspelledPS, Global);
	SHADER_USE_PARAMETER_STRUCT_WITH_LEGACY_BASE(FTestMisspelledPS, FGlobalShader)

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(float, ToonIntensty)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

/** Reads the graph's resources, some of them only in one permutation. */
class FTestGraphCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestGraphCS);
	SHADER_USE_PARAMETER_STRUCT(FTestGraphCS, FGlobalShader);

	class FUseSceneDim : SHADER_PERMUTATION_BOOL("USE_SCENE");
	using FPermutationDomain = TShaderPermutationDomain<FUseSceneDim>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, UnusedTexture)
		SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D, UnusedView)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, UnusedBuffer)
		SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FTestSceneUniforms, Scene)
		SHADER_PARAMETER_TEXTURE(Texture2D, UnusedRHITexture)
		RDG_TEXTURE_ACCESS(CopySource, ERHIAccess::CopySrc)
	END_SHADER_PARAMETER_STRUCT()
};

/** Its threads work together. */
class FTestGroupsCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestGroupsCS);
	SHADER_USE_PARAMETER_STRUCT(FTestGroupsCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<uint>, Output)
		SHADER_PARAMETER(FUintVector2, Size)
	END_SHADER_PARAMETER_STRUCT()
};

/** Appends to a buffer. */
class FTestKeepCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestKeepCS);
	SHADER_USE_PARAMETER_STRUCT(FTestKeepCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<uint>, Numbers)
		SHADER_PARAMETER_RDG_BUFFER_UAV(AppendStructuredBuffer<uint>, Kept)
		SHADER_PARAMETER(uint32, Limit)
	END_SHADER_PARAMETER_STRUCT()
};

/** Consumes what was appended, and counts. */
class FTestTakeCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestTakeCS);
	SHADER_USE_PARAMETER_STRUCT(FTestTakeCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_BUFFER_UAV(ConsumeStructuredBuffer<uint>, Taken)
		SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<uint>, Places)
		SHADER_PARAMETER(uint32, Count)
	END_SHADER_PARAMETER_STRUCT()
};

/** Does not compile. */
class FTestBrokenCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestBrokenCS);
	SHADER_USE_PARAMETER_STRUCT(FTestBrokenCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(float, Value)
	END_SHADER_PARAMETER_STRUCT()
};

/** Reads UnusedTexture. */
class FTestVS : public FGlobalShader
{
	DECLARE_EXPORTED_SHADER_TYPE(FTestVS, Global, );

	FTestVS() = default;
	explicit FTestVS(const ShaderMetaType::CompiledShaderInitializerType& Initializer)
		: FGlobalShader(Initializer)
	{
	}
};

/** Writes the faces of a cube, as slices of an array: slice, column, row, 1. */
class FTestCubeFacesCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestCubeFacesCS);
	SHADER_USE_PARAMETER_STRUCT(FTestCubeFacesCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2DArray<float4>, OutputFaces)
	END_SHADER_PARAMETER_STRUCT()
};

/** Samples a cube and a cube array, their faces as an array, and compares a depth. */
class FTestCubeSamplesCS : public FGlobalShader
{
	DECLARE_GLOBAL_SHADER(FTestCubeSamplesCS);
	SHADER_USE_PARAMETER_STRUCT(FTestCubeSamplesCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(TextureCube, Sky)
		SHADER_PARAMETER_RDG_TEXTURE(TextureCubeArray, Skies)
		SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2DArray, Faces)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Depth)
		SHADER_PARAMETER_SAMPLER(SamplerState, SkySampler)
		SHADER_PARAMETER_SAMPLER(SamplerComparisonState, DepthSampler)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()
};
