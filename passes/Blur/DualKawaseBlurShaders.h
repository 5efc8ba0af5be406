// The shaders of the dual Kawase blur as classes, which their native kernels share.
#pragma once

#include "GlobalShader.h"
#include "RenderGraphResources.h"
#include "SceneView.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

/** The article's. */
constexpr int32 DualKawaseGroupSize = 32;

BEGIN_SHADER_PARAMETER_STRUCT(FDualKawaseParameters, )
	SHADER_PARAMETER(FVector4f, ViewSize)
	SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
	SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Intexture)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER(FVector2f, InputPerOutput)
	SHADER_PARAMETER(FVector2f, TapOffset)
END_SHADER_PARAMETER_STRUCT()

class FDualKawaseShader : public FGlobalShader
{
public:
	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");

	using FParameters = FDualKawaseParameters;
	using FPermutationDomain = TShaderPermutationDomain<FAsPrintedDimension>;

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZE"), DualKawaseGroupSize);
	}

protected:
	using FGlobalShader::FGlobalShader;
};

class FDualKawaseDownCS : public FDualKawaseShader
{
public:
	DECLARE_GLOBAL_SHADER(FDualKawaseDownCS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseDownCS, FDualKawaseShader);
};

class FDualKawaseUpCS : public FDualKawaseShader
{
public:
	DECLARE_GLOBAL_SHADER(FDualKawaseUpCS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseUpCS, FDualKawaseShader);
};

} // namespace Drydock
