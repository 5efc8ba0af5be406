// A pass of a lambda, whose shader nothing tells before it runs, and shader classes of many permutations and of broken
// ones.
#include "HAL/IConsoleManager.h"
#include "PostProcess/PostProcessing.h"
#include "ShaderPermutation.h"

namespace LambdaPass
{

static TAutoConsoleVariable<int32> CVarBroken(
	TEXT("r.LambdaPass.Broken"), 0, TEXT("1: the broken permutation is allowed."), ECVF_RenderThreadSafe);

BEGIN_SHADER_PARAMETER_STRUCT(FLambdaPassParameters, )
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, Output)
END_SHADER_PARAMETER_STRUCT()

class FLambdaWideCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FLambdaWideCS)
	SHADER_USE_PARAMETER_STRUCT(FLambdaWideCS, FGlobalShader)

	class FWidth : SHADER_PERMUTATION_RANGE_INT("WIDTH", 0, 300);
	using FPermutationDomain = TShaderPermutationDomain<FWidth>;
	using FParameters = FLambdaPassParameters;
};

IMPLEMENT_GLOBAL_SHADER(FLambdaWideCS, "/Plugin/LambdaPass/LambdaPass.usf", "WideCS", SF_Compute)

class FLambdaBrokenCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FLambdaBrokenCS)
	SHADER_USE_PARAMETER_STRUCT(FLambdaBrokenCS, FGlobalShader)

	class FBroken : SHADER_PERMUTATION_BOOL("BROKEN");
	class FMany : SHADER_PERMUTATION_RANGE_INT("MANY", 0, 3);
	using FPermutationDomain = TShaderPermutationDomain<FBroken, FMany>;
	using FParameters = FLambdaPassParameters;

	static bool ShouldCompilePermutation(const FGlobalShaderPermutationParameters& Parameters)
	{
		return !FPermutationDomain(Parameters.PermutationId).Get<FBroken>() || CVarBroken.GetValueOnAnyThread() != 0;
	}
};

IMPLEMENT_GLOBAL_SHADER(FLambdaBrokenCS, "/Plugin/LambdaPass/LambdaPass.usf", "BrokenCS", SF_Compute)

class FExtension : public FSceneViewExtensionBase
{
public:
	FExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs&) override
	{
		auto* Parameters = GraphBuilder.AllocParameters<FLambdaPassParameters>();
		Parameters->Output = GraphBuilder.CreateUAV(
			GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(8, 8), PF_FloatRGBA,
										   FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
				TEXT("LambdaPass")));
		FLambdaWideCS::FPermutationDomain PermutationVector;
		PermutationVector.Set<FLambdaWideCS::FWidth>(7);
		TShaderMapRef<FLambdaWideCS> Shader(GetGlobalShaderMap(View.FeatureLevel), PermutationVector);
		GraphBuilder.AddPass(RDG_EVENT_NAME("LambdaPass"), Parameters,
			ERDGPassFlags::Compute | ERDGPassFlags::NeverCull,
			[Shader, Parameters](FRHIComputeCommandList& RHICmdList)
			{ FComputeShaderUtils::Dispatch(RHICmdList, Shader, *Parameters, FIntVector(1, 1, 1)); });
	}
};

TSharedPtr<FExtension, ESPMode::ThreadSafe> GExtension = FSceneViewExtensions::NewExtension<FExtension>();

} // namespace LambdaPass
