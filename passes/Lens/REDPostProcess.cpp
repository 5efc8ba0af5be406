// The passes of the RED post process and their chain. Source: article "RED post process".
#include "Lens/REDPostProcess.h"

#include "Blur/KernelAudit.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"

#include <vector>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarREDAsPrinted(TEXT("r.RED.AsPrinted"), 0,
	TEXT("1: as the article prints it: a blur that doubles the light, the extract after it, screen and pow of light "
		 "above 1. Alpha becomes 1. For depth of field: that blur and no weights. Default 0."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarREDKernel(TEXT("r.RED.Kernel"), 0,
	TEXT("How the corrected form reads the article's blur weights. 0: seven taps, one texel apart (default). 1: seven "
		 "bilinear fetches over thirteen texels. 2: nine taps, the half kernel of the article's comment."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarREDQuarterResolution(TEXT("r.RED.QuarterResolution"), 0,
	TEXT("1: the RED post process downsamples twice and blurs at a quarter of the resolution. Default 0: half."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarREDPostprocessAfterTranslucency(TEXT("r.REDPostprocessAfterTranslucency"), 0,
	TEXT("Place of the RED post process. 0: before separate translucency (default). 1: after it. 2: after bloom, "
		 "which is then composited before it."),
	ECVF_RenderThreadSafe);

/** The article's table, and the half kernel of its comment, which begins in the middle. */
constexpr float PrintedWeights[] = {0.0044f, 0.0540f, 0.2420f, 0.3990f, 0.2420f, 0.0540f, 0.0044f};
constexpr float CommentedWeights[] = {0.3990f, 0.2420f, 0.0540f, 0.0044f, 0.0001f};
constexpr int32 MaxFetches = UE_ARRAY_COUNT(PrintedWeights); // of one side, with the middle

/** The weights of a kernel's fetches, from the middle outwards. */
std::vector<double> GetFetchWeights(EREDBlurKernel Kernel)
{
	const auto* const PrintedEnd = PrintedWeights + UE_ARRAY_COUNT(PrintedWeights);
	if (Kernel == EREDBlurKernel::Printed)
	{
		return std::vector<double>(PrintedWeights, PrintedEnd);
	}
	std::vector<double> Weights =
		Kernel == EREDBlurKernel::NineTaps
			? std::vector<double>(CommentedWeights, CommentedWeights + UE_ARRAY_COUNT(CommentedWeights))
			: std::vector<double>(PrintedWeights + UE_ARRAY_COUNT(PrintedWeights) / 2, PrintedEnd);
	double Sum = 0.0;
	for (size_t Fetch = Weights.size(); Fetch-- > 0;)
	{
		Sum += Weights[Fetch] * (Fetch > 0 ? 2.0 : 1.0);
	}
	for (double& Weight : Weights)
	{
		Weight /= Sum;
	}
	return Weights;
}

class FREDPostProcessPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FREDPostProcessPS);
	SHADER_USE_PARAMETER_STRUCT(FREDPostProcessPS, FGlobalShader);

	class FPassDimension : SHADER_PERMUTATION_ENUM_CLASS("RED_PASS", EREDPostProcessPass);
	class FBlendDimension : SHADER_PERMUTATION_INT("RED_BLEND", 2);
	class FSepiaDimension : SHADER_PERMUTATION_BOOL("USE_SEPIA");
	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");
	class FKernelDimension : SHADER_PERMUTATION_ENUM_CLASS("RED_KERNEL", EREDBlurKernel);
	using FPermutationDomain = TShaderPermutationDomain<FPassDimension, FBlendDimension, FSepiaDimension,
		FAsPrintedDimension, FKernelDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Blurred)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BlurredSampler)
		SHADER_PARAMETER_SCALAR_ARRAY(float, BlurWeights, [MaxFetches])
		SHADER_PARAMETER(float, BlurStep)
		SHADER_PARAMETER(FLinearColor, SepiaTint)
		SHADER_PARAMETER(float, Sepia)
		SHADER_PARAMETER(float, LuminancePow)
		SHADER_PARAMETER(float, LuminanceThreshold)
		SHADER_PARAMETER(float, BlurredScale)
		SHADER_PARAMETER(float, DiffusionFilterPower)
		SHADER_PARAMETER(float, SoftFocusBlend)
		SHADER_PARAMETER(float, SoftFocusSaturation)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FREDPostProcessPS, "/Project/REDPostProcess.usf", "MainPS", SF_Pixel);

bool ReadsBlurred(EREDPostProcessPass Pass)
{
	return Pass == EREDPostProcessPass::DiffusionFilter2 || Pass == EREDPostProcessPass::SoftFocus ||
		   Pass == EREDPostProcessPass::Glow;
}

bool IsBlur(EREDPostProcessPass Pass)
{
	return Pass == EREDPostProcessPass::BlurH || Pass == EREDPostProcessPass::BlurV;
}

/** The article's loop is a fault that is declared; anything else that is none of a blur is refused. */
void CheckBlurKernel(FRDGBuilder& GraphBuilder, EREDBlurKernel Kernel)
{
	const int32 Reach = GetREDBlurReach(Kernel);
	std::vector<double> Weights;
	for (int32 Texel = -Reach; Texel <= Reach; ++Texel)
	{
		Weights.push_back(static_cast<double>(GetREDBlurWeight(Texel, Kernel)));
	}
	CheckKernel(GraphBuilder, "RED blur", Weights,
		Kernel == EREDBlurKernel::Printed ? EKernelFault::Printed : EKernelFault::None);
}

FScreenPassRenderTarget CreateOutput(FRDGBuilder& GraphBuilder, const FREDPostProcessPassInputs& Inputs)
{
	const TCHAR* const Name = Inputs.Name ? Inputs.Name : ToString(Inputs.Pass);
	return Inputs.Pass == EREDPostProcessPass::DownSample
			   ? CreateSmallRasterTarget(GraphBuilder, Inputs.SceneColor,
					 FIntPoint::DivideAndRoundUp(Inputs.SceneColor.ViewRect.Size(), 2), Name)
			   : CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, Name);
}

FREDPostProcessPS::FPermutationDomain GetPermutation(const FREDPostProcessPassInputs& Inputs)
{
	const bool bCombine = Inputs.Pass == EREDPostProcessPass::DiffusionFilter2;
	const bool bHasTwoForms = ReadsBlurred(Inputs.Pass) || Inputs.Pass == EREDPostProcessPass::DiffusionFilter;
	FREDPostProcessPS::FPermutationDomain Permutation;
	Permutation.Set<FREDPostProcessPS::FPassDimension>(Inputs.Pass);
	Permutation.Set<FREDPostProcessPS::FBlendDimension>(
		bCombine ? static_cast<int32>(Inputs.Parameters.DiffusionFilterBlend) : 0);
	Permutation.Set<FREDPostProcessPS::FSepiaDimension>(bCombine && Inputs.Parameters.Sepia > 0.0f);
	Permutation.Set<FREDPostProcessPS::FAsPrintedDimension>(bHasTwoForms && Inputs.Parameters.bAsPrinted);
	Permutation.Set<FREDPostProcessPS::FKernelDimension>(
		IsBlur(Inputs.Pass) ? Inputs.Parameters.GetKernel() : EREDBlurKernel::SevenTaps);
	return Permutation;
}

/** The blurred pictures of one chain, each made when it is first asked for. */
class FBlurs
{
public:
	FBlurs(FRDGBuilder& InGraphBuilder, const FViewInfo& InView, const FScreenPassTexture& InSceneColor,
		const FREDPostProcessParameters& InParameters)
		: GraphBuilder(InGraphBuilder)
		, View(InView)
		, SceneColor(InSceneColor)
		, Parameters(InParameters)
	{
	}

	/** The texture that a pass of the chain combines its picture with. */
	FScreenPassTexture GetFor(EREDPostProcessPass Pass)
	{
		// As printed the diffusion filter's extract comes after the blur.
		if (Pass == EREDPostProcessPass::DiffusionFilter2 && !Parameters.bAsPrinted)
		{
			return Blur(Extract(Parameters));
		}
		if (Pass == EREDPostProcessPass::Glow && Parameters.WantsGlowExtract())
		{
			FREDPostProcessParameters Glow = Parameters;
			Glow.LuminancePow = 1.0f;
			Glow.LuminanceThreshold = Parameters.GlowLuminanceThreshold;
			return Blur(Extract(Glow));
		}
		if (!Plain.IsValid())
		{
			Plain = Blur(GetSmall());
		}
		return Plain;
	}

private:
	FScreenPassTexture GetSmall()
	{
		if (!Small.IsValid())
		{
			Small = Add(EREDPostProcessPass::DownSample, SceneColor, Parameters);
			if (Parameters.bQuarterResolution)
			{
				Small = Add(EREDPostProcessPass::DownSample, Small, Parameters, TEXT("DownSampleQuarter"));
			}
		}
		return Small;
	}

	FScreenPassTexture Extract(const FREDPostProcessParameters& ExtractParameters)
	{
		return Add(EREDPostProcessPass::DiffusionFilter, GetSmall(), ExtractParameters);
	}

	FScreenPassTexture Blur(const FScreenPassTexture& Picture)
	{
		return Add(EREDPostProcessPass::BlurV, Add(EREDPostProcessPass::BlurH, Picture, Parameters), Parameters);
	}

	FScreenPassTexture Add(EREDPostProcessPass Pass, const FScreenPassTexture& Picture,
		const FREDPostProcessParameters& PassParameters, const TCHAR* Name = nullptr)
	{
		FREDPostProcessPassInputs Inputs;
		Inputs.Pass = Pass;
		Inputs.Name = Name;
		Inputs.SceneColor = Picture;
		Inputs.Parameters = PassParameters;
		return AddREDPostProcessPass(GraphBuilder, View, Inputs);
	}

	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FScreenPassTexture& SceneColor;
	const FREDPostProcessParameters& Parameters;
	FScreenPassTexture Small;
	FScreenPassTexture Plain; // blurred without an extract
};

} // namespace

const TCHAR* ToString(EREDPostProcessPass Pass)
{
	constexpr const TCHAR* Names[] = {TEXT("DownSample"), TEXT("BlurH"), TEXT("BlurV"), TEXT("DiffusionFilter"),
		TEXT("DiffusionFilter2"), TEXT("SoftFocus"), TEXT("Glow")};
	static_assert(UE_ARRAY_COUNT(Names) == static_cast<uint32>(EREDPostProcessPass::MAX));
	check(Pass < EREDPostProcessPass::MAX);
	return Names[static_cast<uint32>(Pass)];
}

const TCHAR* ToString(EREDBlurKernel Kernel)
{
	constexpr const TCHAR* Names[] = {TEXT("SevenTaps"), TEXT("ThirteenTexels"), TEXT("NineTaps"), TEXT("Printed")};
	static_assert(UE_ARRAY_COUNT(Names) == static_cast<uint32>(EREDBlurKernel::MAX));
	check(Kernel < EREDBlurKernel::MAX);
	return Names[static_cast<uint32>(Kernel)];
}

float GetREDBlurWeight(int32 Texel, EREDBlurKernel Kernel)
{
	const int32 Distance = FMath::Abs(Texel);
	if (Distance > GetREDBlurReach(Kernel))
	{
		return 0.0f;
	}
	const std::vector<double> Weights = GetFetchWeights(Kernel);
	if (Kernel == EREDBlurKernel::ThirteenTexels && Distance > 0)
	{
		return static_cast<float>(Weights[static_cast<size_t>(Distance + 1) / 2] / 2.0);
	}
	return static_cast<float>(Weights[static_cast<size_t>(Distance)]);
}

int32 GetREDBlurReach(EREDBlurKernel Kernel)
{
	const int32 LastFetch = static_cast<int32>(GetFetchWeights(Kernel).size()) - 1;
	return Kernel == EREDBlurKernel::ThirteenTexels ? 2 * LastFetch : LastFetch;
}

FREDPostProcessParameters FREDPostProcessParameters::FromSettings(const FFinalPostProcessSettings& Settings)
{
	FREDPostProcessParameters Parameters;
	Parameters.LuminancePow = Settings.DiffusionFilterLuminancePow;
	Parameters.LuminanceThreshold = Settings.DiffusionFilterLuminanceThreshold;
	Parameters.DiffusionFilterIntensity = Settings.DiffusionFilterIntensity;
	Parameters.DiffusionFilterPower = Settings.DiffusionFilterPower;
	Parameters.DiffusionFilterBlend = Settings.DiffusionFilterBlend;
	Parameters.Sepia = Settings.DiffusionFilterSepia;
	Parameters.SepiaTint = Settings.DiffusionFilterSepiaTint;
	Parameters.SoftFocusBlend = Settings.SoftFocusBlend;
	Parameters.SoftFocusSaturation = Settings.SoftFocusSaturation;
	Parameters.GlowIntensity = Settings.GlowIntensity;
	Parameters.GlowLuminanceThreshold = Settings.GlowLuminanceThreshold;
	Parameters.Kernel = static_cast<EREDBlurKernel>(
		FMath::Clamp(CVarREDKernel.GetValueOnRenderThread(), 0, static_cast<int32>(EREDBlurKernel::Printed) - 1));
	Parameters.bQuarterResolution = CVarREDQuarterResolution.GetValueOnRenderThread() != 0;
	Parameters.bAsPrinted = CVarREDAsPrinted.GetValueOnRenderThread() != 0;
	return Parameters;
}

FScreenPassTexture AddREDPostProcessPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDPostProcessPassInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(!ReadsBlurred(Inputs.Pass) || Inputs.Blurred.IsValid());

	const FREDPostProcessParameters& Parameters = Inputs.Parameters;
	if (IsBlur(Inputs.Pass))
	{
		CheckBlurKernel(GraphBuilder, Parameters.GetKernel());
	}
	const FScreenPassRenderTarget Output =
		Inputs.OverrideOutput.IsValid() ? Inputs.OverrideOutput : CreateOutput(GraphBuilder, Inputs);
	FRHISamplerState* const BilinearClamp = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();

	auto* PassParameters = GraphBuilder.AllocParameters<FREDPostProcessPS::FParameters>();
	PassParameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->ColorTexture = Inputs.SceneColor.Texture;
	PassParameters->ColorSampler = BilinearClamp;
	if (ReadsBlurred(Inputs.Pass))
	{
		PassParameters->Blurred = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.Blurred));
		PassParameters->BlurredTexture = Inputs.Blurred.Texture;
		PassParameters->BlurredSampler = BilinearClamp;
	}
	const std::vector<double> FetchWeights = GetFetchWeights(Parameters.GetKernel());
	for (size_t Fetch = 0; Fetch < FetchWeights.size(); ++Fetch)
	{
		GET_SCALAR_ARRAY_ELEMENT(PassParameters->BlurWeights, Fetch) = static_cast<float>(FetchWeights[Fetch]);
	}
	PassParameters->BlurStep = Inputs.BlurStep;
	PassParameters->SepiaTint = Parameters.SepiaTint;
	PassParameters->Sepia = Parameters.Sepia;
	PassParameters->LuminancePow = Parameters.LuminancePow;
	PassParameters->LuminanceThreshold = Parameters.LuminanceThreshold;
	PassParameters->BlurredScale =
		Inputs.Pass == EREDPostProcessPass::Glow ? Parameters.GlowIntensity : Parameters.DiffusionFilterIntensity;
	PassParameters->DiffusionFilterPower = Parameters.DiffusionFilterPower;
	PassParameters->SoftFocusBlend = Parameters.SoftFocusBlend;
	PassParameters->SoftFocusSaturation = Parameters.SoftFocusSaturation;
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();

	TShaderMapRef<FREDPostProcessPS> PixelShader(View.ShaderMap, GetPermutation(Inputs));
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("RED.%s %dx%d", ToString(Inputs.Pass), Output.ViewRect.Width(), Output.ViewRect.Height()),
		PixelShader, PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

FScreenPassTexture BuiltInAddREDPostProcessPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, const FREDPostProcessParameters& Parameters,
	const FScreenPassRenderTarget& OverrideOutput)
{
	check(SceneColor.IsValid());
	TArray<EREDPostProcessPass> Passes;
	if (Parameters.WantsDiffusionFilter())
	{
		Passes.Add(EREDPostProcessPass::DiffusionFilter2);
	}
	if (Parameters.WantsSoftFocus())
	{
		Passes.Add(EREDPostProcessPass::SoftFocus);
	}
	if (Parameters.WantsGlow())
	{
		Passes.Add(EREDPostProcessPass::Glow);
	}
	if (Passes.Num() == 0)
	{
		return SceneColor;
	}

	RDG_EVENT_SCOPE(GraphBuilder, "REDPostProcess");
	FBlurs Blurs(GraphBuilder, View, SceneColor, Parameters);
	FScreenPassTexture Result = SceneColor;
	for (int32 Index = 0; Index < Passes.Num(); ++Index)
	{
		FREDPostProcessPassInputs Inputs;
		Inputs.Pass = Passes[Index];
		Inputs.SceneColor = Result;
		Inputs.Parameters = Parameters;
		Inputs.Blurred = Blurs.GetFor(Inputs.Pass);
		if (Index == Passes.Num() - 1)
		{
			Inputs.OverrideOutput = OverrideOutput;
		}
		Result = AddREDPostProcessPass(GraphBuilder, View, Inputs);
	}
	return Result;
}

EREDPostProcessInsertion GetREDPostProcessInsertion()
{
	return static_cast<EREDPostProcessInsertion>(
		FMath::Clamp(CVarREDPostprocessAfterTranslucency.GetValueOnRenderThread(), 0, 2));
}

} // namespace Drydock
