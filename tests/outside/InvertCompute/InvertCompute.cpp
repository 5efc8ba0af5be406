// Adds the compute pass, as a plugin does that ships its shader.
#include "InvertCompute.h"

#include "GlobalShader.h"
#include "RenderGraphUtils.h"
#include "ShaderParameterStruct.h"

class FInvertCS : public FGlobalShader
{
public:
	static constexpr int32 THREADGROUPSIZE_X = 8;
	static constexpr int32 THREADGROUPSIZE_Y = 8;

	class FKeepAlpha : SHADER_PERMUTATION_BOOL("KEEP_ALPHA");
	using FPermutationDomain = TShaderPermutationDomain<FKeepAlpha>;

	DECLARE_GLOBAL_SHADER(FInvertCS);
	SHADER_USE_PARAMETER_STRUCT(FInvertCS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER(FIntPoint, Size)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
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
		OutEnvironment.SetDefine(TEXT("THREADGROUPSIZE_Y"), THREADGROUPSIZE_Y);
	}
};

IMPLEMENT_GLOBAL_SHADER(FInvertCS, "/Plugin/InvertCompute/Invert.usf", "InvertCS", SF_Compute);

FScreenPassTexture AddInvertPass(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input)
{
	FRDGTextureDesc Desc = Input.Texture->Desc;
	Desc.Reset();
	Desc.Flags |= TexCreate_UAV | TexCreate_ShaderResource;
	FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("InvertOutput"));

	FInvertCS::FParameters* Parameters = GraphBuilder.AllocParameters<FInvertCS::FParameters>();
	Parameters->Size = Desc.Extent;
	Parameters->InputTexture = Input.Texture;
	Parameters->OutputTexture = GraphBuilder.CreateUAV(Output);

	FInvertCS::FPermutationDomain Permutation;
	Permutation.Set<FInvertCS::FKeepAlpha>(true);
	TShaderMapRef<FInvertCS> ComputeShader(GetGlobalShaderMap(GMaxRHIFeatureLevel), Permutation);
	FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Invert %dx%d", Desc.Extent.X, Desc.Extent.Y),
		ComputeShader, Parameters,
		FComputeShaderUtils::GetGroupCount(
			Desc.Extent, FIntPoint(FInvertCS::THREADGROUPSIZE_X, FInvertCS::THREADGROUPSIZE_Y)));
	return FScreenPassTexture(Output, Input.ViewRect);
}
