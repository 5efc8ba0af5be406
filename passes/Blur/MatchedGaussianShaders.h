// The shader of the Gaussian with a given standard deviation as a class, which its native kernel shares.
#pragma once

#include "GlobalShader.h"
#include "RenderGraphResources.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

/** As in the dual Kawase passes. */
constexpr int32 MatchedGaussianGroupSize = 32;

class FDualKawaseGaussianCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FDualKawaseGaussianCS);
	SHADER_USE_PARAMETER_STRUCT(FDualKawaseGaussianCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, Weights)
		SHADER_PARAMETER(FIntPoint, Reach)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Intexture)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
	END_SHADER_PARAMETER_STRUCT()

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZE"), MatchedGaussianGroupSize);
		OutEnvironment.SetDefine(TEXT("AS_PRINTED"), 0);
	}
};

} // namespace Drydock
