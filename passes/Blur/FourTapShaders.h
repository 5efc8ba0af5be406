// The shaders of the blurs of four taps as classes, which their native kernels share.
#pragma once

#include "GlobalShader.h"
#include "RenderGraphResources.h"
#include "ScreenPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

constexpr int32 FourTapGroupSize = 16;

BEGIN_SHADER_PARAMETER_STRUCT(FFourTapParameters, )
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER(FVector2f, InputCorner)
	SHADER_PARAMETER(FVector2f, InputPerOutput)
	SHADER_PARAMETER(float, TapDistance)
	SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Intexture)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutTexture)
END_SHADER_PARAMETER_STRUCT()

class FFourTapShader : public FGlobalShader
{
public:
	using FParameters = FFourTapParameters;

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZE"), FourTapGroupSize);
	}

protected:
	using FGlobalShader::FGlobalShader;
};

class FFourTapCS : public FFourTapShader
{
public:
	DECLARE_GLOBAL_SHADER(FFourTapCS);
	SHADER_USE_PARAMETER_STRUCT(FFourTapCS, FFourTapShader);
};

class FOneTapCS : public FFourTapShader
{
public:
	DECLARE_GLOBAL_SHADER(FOneTapCS);
	SHADER_USE_PARAMETER_STRUCT(FOneTapCS, FFourTapShader);
};

} // namespace Drydock
