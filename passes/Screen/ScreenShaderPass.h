// Passes over a picture whose shader exists twice, as a pixel shader that is drawn and as a compute shader that is
// dispatched: one function adds either, from parameters that are filled once.
#pragma once

#include "GlobalShader.h"
#include "PixelShaderUtils.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "ShaderParameterStruct.h"
#include "SourceLocation.h"

#include <optional>

namespace Drydock
{

/** Base of compute shaders with a thread for each pixel: gives them THREADGROUP_SIZEX and THREADGROUP_SIZEY. */
class FScreenComputeShader : public FGlobalShader
{
public:
	using FGlobalShader::FGlobalShader;

	static void ModifyCompilationEnvironment(
		const FGlobalShaderPermutationParameters& Parameters, FShaderCompilerEnvironment& OutEnvironment)
	{
		FGlobalShader::ModifyCompilationEnvironment(Parameters, OutEnvironment);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEX"), FComputeShaderUtils::kGolden2DGroupSize);
		OutEnvironment.SetDefine(TEXT("THREADGROUP_SIZEY"), FComputeShaderUtils::kGolden2DGroupSize);
	}
};

// clang-format off
/** Declares the two shaders of such a pass, the classes ClassName##PS and ClassName##CS. CommonParameters: the struct
 * that the parameters of both hold. ComputeOutput: the compute shader's parameter for the texture that it writes. */
#define DRYDOCK_SCREEN_SHADERS(ClassName, CommonParameters, Permutation, ComputeOutput) \
	DRYDOCK_SCREEN_SHADERS_OF( \
		ClassName, FGlobalShader, Drydock::FScreenComputeShader, CommonParameters, Permutation, ComputeOutput)

/** The same with base classes: PixelBase derives from FGlobalShader, ComputeBase from FScreenComputeShader. */
#define DRYDOCK_SCREEN_SHADERS_OF( \
	ClassName, PixelBase, ComputeBase, CommonParameters, Permutation, ComputeOutput) \
	class ClassName##PS : public PixelBase \
	{ \
	public: \
		DECLARE_GLOBAL_SHADER(ClassName##PS); \
		SHADER_USE_PARAMETER_STRUCT(ClassName##PS, PixelBase); \
		using FPermutationDomain = Permutation; \
		BEGIN_SHADER_PARAMETER_STRUCT(FParameters, ) \
			SHADER_PARAMETER_STRUCT_INCLUDE(CommonParameters, Common) \
			RENDER_TARGET_BINDING_SLOTS() \
		END_SHADER_PARAMETER_STRUCT() \
	}; \
	class ClassName##CS : public ComputeBase \
	{ \
	public: \
		DECLARE_GLOBAL_SHADER(ClassName##CS); \
		SHADER_USE_PARAMETER_STRUCT(ClassName##CS, ComputeBase); \
		using FPermutationDomain = Permutation; \
		BEGIN_SHADER_PARAMETER_STRUCT(FParameters, ) \
			SHADER_PARAMETER_STRUCT_INCLUDE(CommonParameters, Common) \
			SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, ComputeOutput) \
		END_SHADER_PARAMETER_STRUCT() \
	}
// clang-format on

/** Name and target of a pass, and which of its two shaders runs. */
struct FScreenShaderPass
{
	/** The event's name without its end, " (PS)" or " (CS)". */
	FString Name;
	/** A render target, or, with bCompute, a UAV. */
	FScreenPassRenderTarget Output;
	bool bCompute = false;
	/** Texels of Output that are drawn, the others stay; not set: its rect. Pixel shaders only. */
	std::optional<FIntRect> DrawRect = std::nullopt;
};

/** Adds the pass. The parameter structs of both shaders hold Common under that name; Permutation is that of both;
 * ComputeOutput is the compute shader's parameter for the texture that it writes. Gives the output. */
template<typename TPixelShader, typename TComputeShader, typename TCommonParameters, typename TOutputParameter>
FScreenPassTexture AddScreenShaderPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenShaderPass& Pass,
	const TCommonParameters& Common, const typename TPixelShader::FPermutationDomain& Permutation,
	TOutputParameter TComputeShader::FParameters::*ComputeOutput, FSourceLocation Location = FSourceLocation::Current())
{
	check(!Pass.bCompute || !Pass.DrawRect);
	if (Pass.bCompute)
	{
		TShaderMapRef<TComputeShader> ComputeShader(View.ShaderMap, Permutation);
		auto* const Parameters = GraphBuilder.AllocParameters<typename TComputeShader::FParameters>();
		Parameters->Common = Common;
		Parameters->*ComputeOutput = GraphBuilder.CreateUAV(Pass.Output.Texture);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("%s (CS)", *Pass.Name), ComputeShader, Parameters,
			FComputeShaderUtils::GetGroupCount(Pass.Output.ViewRect.Size(), FComputeShaderUtils::kGolden2DGroupSize),
			Location);
	}
	else
	{
		TShaderMapRef<TPixelShader> PixelShader(View.ShaderMap, Permutation);
		auto* const Parameters = GraphBuilder.AllocParameters<typename TPixelShader::FParameters>();
		Parameters->Common = Common;
		Parameters->RenderTargets[0] = Pass.Output.GetRenderTargetBinding();
		FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap, RDG_EVENT_NAME("%s (PS)", *Pass.Name),
			PixelShader, Parameters, Pass.DrawRect.value_or(Pass.Output.ViewRect), nullptr, nullptr, nullptr, 0,
			Location);
	}
	return FScreenPassTexture(Pass.Output.Texture, Pass.Output.ViewRect);
}

} // namespace Drydock
