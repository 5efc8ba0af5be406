// The shaders of the weighted sample sum as classes, which their native kernel shares. Source: engine file
// PostProcessWeightedSampleSum.cpp.
#pragma once

#include "ScreenPass.h"
#include "Screen/ScreenShaderPass.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

constexpr int32 MaxFilterSamples = 128;
constexpr int32 MaxFilterOffsets = MaxFilterSamples / 2; // two to a register

/** Source of the texels outside the filter's rect. */
enum class ERectBorder : uint8
{
	Sampler, // the rect is the whole texture
	Black,
	Mirror,
	Clamp,
	MAX
};

BEGIN_SHADER_PARAMETER_STRUCT(FFilterParameters, )
	SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Filter)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureInput, Additive)
	SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
	SHADER_PARAMETER_ARRAY(FVector4f, SampleOffsets, [MaxFilterOffsets])
	SHADER_PARAMETER_ARRAY(FVector4f, SampleWeights, [MaxFilterSamples])
	SHADER_PARAMETER(int32, SampleCount)
	SHADER_PARAMETER(float, SampleSteps)
	SHADER_PARAMETER(int32, bSnapTaps)
END_SHADER_PARAMETER_STRUCT()

class FAdditiveDimension : SHADER_PERMUTATION_BOOL("USE_ADDITIVE");
class FRectBorderDimension : SHADER_PERMUTATION_ENUM_CLASS("RECT_BORDER", ERectBorder);

using FFilterPermutation = TShaderPermutationDomain<FAdditiveDimension, FRectBorderDimension>;

template<typename TBase>
class TFilterShader : public TBase
{
public:
	using TBase::TBase;

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		TBase::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("MAX_FILTER_SAMPLES"), MaxFilterSamples);
	}
};

DRYDOCK_SCREEN_SHADERS_OF(FFilter, TFilterShader<FGlobalShader>, TFilterShader<FScreenComputeShader>, FFilterParameters,
	FFilterPermutation, RWOutputTexture);

} // namespace Drydock
