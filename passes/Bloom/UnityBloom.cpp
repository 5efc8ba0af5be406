// The four passes of the Unity-style bloom and their chain. Source: article "Unity bloom".
#include "Bloom/UnityBloom.h"

#include "Blur/KernelAudit.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "PostProcessSettings.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/LimitErrors.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarUnityBloomAsPrinted(TEXT("r.UnityBloom.AsPrinted"), 0,
	TEXT("1: as the article prints it: 8-bit temporaries, sizes truncated, after the tonemapper. Default 0."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarUnityBloomInsertion(TEXT("r.UnityBloom.Insertion"), 0,
	TEXT("0: before the tonemapper, on linear light (default). 1: after it, on the display-encoded picture."),
	ECVF_RenderThreadSafe);

/** Weights of the texels at 0, 1 and 2 times the spread. */
constexpr float PrintedWeights[] = {0.4026f, 0.2442f, 0.0545f};
constexpr float SumOfPrintedWeights = PrintedWeights[0] + 2.0f * (PrintedWeights[1] + PrintedWeights[2]);

FVector4f GetWeights(bool bAsPrinted)
{
	const float Scale = bAsPrinted ? 1.0f : 1.0f / SumOfPrintedWeights;
	return FVector4f(PrintedWeights[0] * Scale, PrintedWeights[1] * Scale, PrintedWeights[2] * Scale, 0.0f);
}

void CheckBlurKernel(FRDGBuilder& GraphBuilder, bool bAsPrinted)
{
	const FVector4f Weights = GetWeights(bAsPrinted);
	const double Center = static_cast<double>(Weights.X), Near = static_cast<double>(Weights.Y),
				 Far = static_cast<double>(Weights.Z);
	CheckKernel(GraphBuilder, "Unity bloom's blur", {Far, Near, Center, Near, Far}, EKernelFault::None);
}

class FUnityBloomPassDimension : SHADER_PERMUTATION_ENUM_CLASS("UNITY_BLOOM_PASS", EUnityBloomPass);

class FUnityBloomPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FUnityBloomPS);
	SHADER_USE_PARAMETER_STRUCT(FUnityBloomPS, FGlobalShader);

	using FPermutationDomain = TShaderPermutationDomain<FUnityBloomPassDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Source)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Bloom)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SourceTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, SourceSampler)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BloomTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BloomSampler)
		SHADER_PARAMETER(FVector4f, Weights)
		SHADER_PARAMETER(float, Threshold)
		SHADER_PARAMETER(float, SoftKnee)
		SHADER_PARAMETER(float, BloomHasAlpha)
		SHADER_PARAMETER(float, Spread)
		SHADER_PARAMETER(float, Intensity)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FUnityBloomPS, "/Project/UnityBloom.usf", "MainPS", SF_Pixel);

/** The target of extract and blurs. */
FScreenPassRenderTarget CreateSmallTarget(FRDGBuilder& GraphBuilder, const FUnityBloomInputs& Inputs)
{
	const FIntPoint FullSize = Inputs.SceneColor.ViewRect.Size();
	const int32 Divisor = FMath::Clamp(Inputs.DownSample, 1, FullSize.GetMax());
	const FIntPoint Size = Inputs.bAsPrinted ? FIntPoint(FullSize.X / Divisor, FullSize.Y / Divisor)
											 : FIntPoint::DivideAndRoundUp(FullSize, Divisor);
	return CreateSmallRasterTarget(GraphBuilder, Inputs.SceneColor, Size, TEXT("UnityBloom.Extract"),
		Inputs.bAsPrinted ? PF_B8G8R8A8 : PF_FloatRGBA);
}

} // namespace

const TCHAR* ToString(EUnityBloomPass Pass)
{
	constexpr const TCHAR* Names[] = {
		TEXT("Extract"), TEXT("GaussianBlurVertical"), TEXT("GaussianBlurHorizontal"), TEXT("Composite")};
	static_assert(UE_ARRAY_COUNT(Names) == static_cast<uint32>(EUnityBloomPass::MAX));
	check(Pass < EUnityBloomPass::MAX);
	return Names[static_cast<uint32>(Pass)];
}

TOptional<EUnityBloomPass> FindUnityBloomPass(const TCHAR* Name)
{
	for (uint8 Index = 0; Index < static_cast<uint8>(EUnityBloomPass::MAX); ++Index)
	{
		const EUnityBloomPass Pass = static_cast<EUnityBloomPass>(Index);
		if (FCString::Stricmp(Name, ToString(Pass)) == 0)
		{
			return Pass;
		}
	}
	return {};
}

FScreenPassTexture AddUnityBloomPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUnityBloomPassInputs& Inputs)
{
	check(Inputs.Source.IsValid());
	const bool bComposite = Inputs.Pass == EUnityBloomPass::Composite;
	check(!bComposite || Inputs.Bloom.IsValid());

	if (Inputs.Pass == EUnityBloomPass::GaussianBlurVertical || Inputs.Pass == EUnityBloomPass::GaussianBlurHorizontal)
	{
		CheckBlurKernel(GraphBuilder, Inputs.bAsPrinted);
	}

	const TCHAR* const Name = Inputs.Name ? Inputs.Name : ToString(Inputs.Pass);
	const FScreenPassRenderTarget Output = Inputs.OverrideOutput.IsValid()
											   ? Inputs.OverrideOutput
											   : CreateRasterTargetLike(GraphBuilder, Inputs.Source, Name);
	FRHISamplerState* const BilinearClamp = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	FUnityBloomPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FUnityBloomPS::FParameters>();
	PassParameters->Source = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.Source));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->SourceTexture = Inputs.Source.Texture;
	PassParameters->SourceSampler = BilinearClamp;
	if (bComposite)
	{
		PassParameters->Bloom = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.Bloom));
		PassParameters->BloomTexture = Inputs.Bloom.Texture;
		PassParameters->BloomSampler = BilinearClamp;
	}
	PassParameters->Weights = GetWeights(Inputs.bAsPrinted);
	PassParameters->Threshold = Inputs.Threshold;
	PassParameters->SoftKnee = Inputs.bAsPrinted ? 0.0f : Inputs.SoftKnee;
	PassParameters->BloomHasAlpha = Inputs.bAsPrinted ? 1.0f : 0.0f;
	PassParameters->Spread = Inputs.Spread;
	PassParameters->Intensity = Inputs.Intensity;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	FUnityBloomPS::FPermutationDomain Permutation;
	Permutation.Set<FUnityBloomPassDimension>(Inputs.Pass);
	TShaderMapRef<FUnityBloomPS> PixelShader(View.ShaderMap, Permutation);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("%s%s %dx%d", Inputs.Name ? TEXT("") : TEXT("UnityBloom."), Name, Output.ViewRect.Width(),
			Output.ViewRect.Height()),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FUnityBloomInputs FUnityBloomInputs::FromSettings(
	const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor)
{
	FUnityBloomInputs Inputs;
	Inputs.SceneColor = SceneColor;
	Inputs.Threshold = Settings.UnityBloomThreshold;
	Inputs.SoftKnee = Settings.UnityBloomSoftKnee;
	Inputs.Iterations = Settings.UnityBloomIterations;
	Inputs.Spread = Settings.UnityBloomSpread;
	Inputs.DownSample = Settings.UnityBloomDownSample;
	Inputs.Intensity = Settings.UnityBloomIntensity;
	Inputs.bAsPrinted = CVarUnityBloomAsPrinted.GetValueOnRenderThread() != 0;
	return Inputs;
}

FScreenPassTexture AddUnityBloomPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FUnityBloomInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	RDG_EVENT_SCOPE(GraphBuilder, "UnityBloom");

	FUnityBloomPassInputs Extract;
	Extract.Pass = EUnityBloomPass::Extract;
	Extract.Source = Inputs.SceneColor;
	Extract.Threshold = Inputs.Threshold;
	Extract.SoftKnee = Inputs.SoftKnee;
	Extract.OverrideOutput = CreateSmallTarget(GraphBuilder, Inputs);
	Extract.bAsPrinted = Inputs.bAsPrinted;
	FScreenPassTexture Bloom = AddUnityBloomPass(GraphBuilder, View, Extract);

	if (Inputs.Iterations > GUnityBloomMaxIterations)
	{
		AddLimitNote(GraphBuilder, "UnityBloom",
			"UnityBloomIterations is " + std::to_string(Inputs.Iterations) + "; " +
				std::to_string(GUnityBloomMaxIterations) + " rounds of blur are made");
	}
	for (int32 Iteration = 0; Iteration < FMath::Min(Inputs.Iterations, GUnityBloomMaxIterations); ++Iteration)
	{
		for (const EUnityBloomPass Pass :
			{EUnityBloomPass::GaussianBlurVertical, EUnityBloomPass::GaussianBlurHorizontal})
		{
			FUnityBloomPassInputs Blur;
			Blur.Pass = Pass;
			Blur.Source = Bloom;
			Blur.Spread = 1.0f + static_cast<float>(Iteration) * Inputs.Spread;
			Blur.bAsPrinted = Inputs.bAsPrinted;
			Bloom = AddUnityBloomPass(GraphBuilder, View, Blur);
		}
	}

	FUnityBloomPassInputs Composite;
	Composite.Pass = EUnityBloomPass::Composite;
	Composite.Source = Inputs.SceneColor;
	Composite.Bloom = Bloom;
	Composite.Intensity = Inputs.Intensity;
	Composite.OverrideOutput = Inputs.OverrideOutput;
	Composite.bAsPrinted = Inputs.bAsPrinted;
	return AddUnityBloomPass(GraphBuilder, View, Composite);
}

bool IsUnityBloomAfterTonemap()
{
	return CVarUnityBloomAsPrinted.GetValueOnRenderThread() != 0 ||
		   CVarUnityBloomInsertion.GetValueOnRenderThread() != 0;
}

} // namespace Drydock
