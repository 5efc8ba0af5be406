// The passes of the RED post process and their chain. Source: article "RED post process".
#include "Lens/REDPostProcess.h"

#include "Blur/KernelAudit.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
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
	TEXT("1: as the article prints it: a blur that doubles the light, screen and pow of light above 1, no extract. "
		 "Default 0."),
	ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarREDPostprocessAfterTranslucency(TEXT("r.REDPostprocessAfterTranslucency"), 0,
	TEXT("Where the RED post process runs. 0: before separate translucency (default). 1: after it. 2: after bloom, "
		 "which "
		 "is then composited before it."),
	ECVF_RenderThreadSafe);

/** The article's table; the taps that a kernel does not have weigh 0. */
constexpr float PrintedWeights[] = {0.0044f, 0.0540f, 0.2420f, 0.3990f, 0.2420f, 0.0540f, 0.0044f};
constexpr int32 NumPrintedWeights = 7;
constexpr int32 CorrectedReach = NumPrintedWeights / 2;
constexpr int32 PrintedReach = NumPrintedWeights - 1;

class FREDPostProcessPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FREDPostProcessPS);
	SHADER_USE_PARAMETER_STRUCT(FREDPostProcessPS, FGlobalShader);

	class FPassDimension : SHADER_PERMUTATION_ENUM_CLASS("RED_PASS", EREDPostProcessPass);
	class FBlendDimension : SHADER_PERMUTATION_INT("RED_BLEND", 2);
	class FSepiaDimension : SHADER_PERMUTATION_BOOL("USE_SEPIA");
	class FAsPrintedDimension : SHADER_PERMUTATION_BOOL("AS_PRINTED");
	using FPermutationDomain =
		TShaderPermutationDomain<FPassDimension, FBlendDimension, FSepiaDimension, FAsPrintedDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Blurred)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, ColorSampler)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, BlurredTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, BlurredSampler)
		SHADER_PARAMETER_SCALAR_ARRAY(float, BlurWeights, [PrintedReach + 1])
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

/** The article's table is a fault that is declared; anything else that is none of a blur is refused. */
void CheckBlurKernel(FRDGBuilder& GraphBuilder, bool bAsPrinted)
{
	const int32 Reach = GetREDBlurReach(bAsPrinted);
	std::vector<double> Weights;
	for (int32 Tap = -Reach; Tap <= Reach; ++Tap)
	{
		Weights.push_back(static_cast<double>(GetREDBlurWeight(Tap, bAsPrinted)));
	}
	CheckKernel(GraphBuilder, "RED blur", Weights, bAsPrinted ? EKernelFault::Printed : EKernelFault::None);
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
	const bool bHasTwoForms = Inputs.Pass != EREDPostProcessPass::DownSample;
	FREDPostProcessPS::FPermutationDomain Permutation;
	Permutation.Set<FREDPostProcessPS::FPassDimension>(Inputs.Pass);
	Permutation.Set<FREDPostProcessPS::FBlendDimension>(
		bCombine ? static_cast<int32>(Inputs.Parameters.DiffusionFilterBlend) : 0);
	Permutation.Set<FREDPostProcessPS::FSepiaDimension>(bCombine && Inputs.Parameters.Sepia > 0.0f);
	Permutation.Set<FREDPostProcessPS::FAsPrintedDimension>(bHasTwoForms && Inputs.Parameters.bAsPrinted);
	return Permutation;
}

/** The picture, half as large, blurred both ways. */
FScreenPassTexture AddBlur(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor,
	const FREDPostProcessParameters& Parameters, bool bExtract)
{
	FREDPostProcessPassInputs Inputs;
	Inputs.Parameters = Parameters;
	Inputs.SceneColor = SceneColor;
	for (const EREDPostProcessPass Pass : {EREDPostProcessPass::DownSample, EREDPostProcessPass::DiffusionFilter,
			 EREDPostProcessPass::BlurH, EREDPostProcessPass::BlurV})
	{
		if (Pass != EREDPostProcessPass::DiffusionFilter || bExtract)
		{
			Inputs.Pass = Pass;
			Inputs.SceneColor = AddREDPostProcessPass(GraphBuilder, View, Inputs);
		}
	}
	return Inputs.SceneColor;
}

} // namespace

const TCHAR* ToString(EREDPostProcessPass Pass)
{
	constexpr const TCHAR* Names[] = {TEXT("DownSample"), TEXT("BlurH"), TEXT("BlurV"), TEXT("DiffusionFilter"),
		TEXT("DiffusionFilter2"), TEXT("SoftFocus"), TEXT("Glow")};
	static_assert(UE_ARRAY_COUNT(Names) == static_cast<uint32>(EREDPostProcessPass::MAX));
	check(Pass < EREDPostProcessPass::MAX);
	return Names[static_cast<uint32>(Pass)];
}

float GetREDBlurWeight(int32 Tap, bool bAsPrinted)
{
	const int32 Distance = FMath::Abs(Tap);
	if (Distance > GetREDBlurReach(bAsPrinted))
	{
		return 0.0f;
	}
	if (bAsPrinted)
	{
		return PrintedWeights[Distance];
	}
	double Sum = 0.0;
	for (const float Weight : PrintedWeights)
	{
		Sum += Weight;
	}
	return static_cast<float>(PrintedWeights[CorrectedReach + Distance] / Sum);
}

int32 GetREDBlurReach(bool bAsPrinted)
{
	return bAsPrinted ? PrintedReach : CorrectedReach;
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
	Parameters.bAsPrinted = CVarREDAsPrinted.GetValueOnRenderThread() != 0;
	return Parameters;
}

FScreenPassTexture AddREDPostProcessPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FREDPostProcessPassInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(!ReadsBlurred(Inputs.Pass) || Inputs.Blurred.IsValid());

	const FREDPostProcessParameters& Parameters = Inputs.Parameters;
	if (Inputs.Pass == EREDPostProcessPass::BlurH || Inputs.Pass == EREDPostProcessPass::BlurV)
	{
		CheckBlurKernel(GraphBuilder, Parameters.bAsPrinted);
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
	for (int32 Tap = 0; Tap <= PrintedReach; ++Tap)
	{
		GET_SCALAR_ARRAY_ELEMENT(PassParameters->BlurWeights, Tap) = GetREDBlurWeight(Tap, Parameters.bAsPrinted);
	}
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

FScreenPassTexture AddREDPostProcessPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
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
	FScreenPassTexture Plain; // blurred without the extract, made when first needed
	FScreenPassTexture Result = SceneColor;
	for (int32 Index = 0; Index < Passes.Num(); ++Index)
	{
		FREDPostProcessPassInputs Inputs;
		Inputs.Pass = Passes[Index];
		Inputs.SceneColor = Result;
		Inputs.Parameters = Parameters;
		if (Inputs.Pass == EREDPostProcessPass::DiffusionFilter2 && !Parameters.bAsPrinted)
		{
			Inputs.Blurred = AddBlur(GraphBuilder, View, SceneColor, Parameters, true);
		}
		else
		{
			if (!Plain.IsValid())
			{
				Plain = AddBlur(GraphBuilder, View, SceneColor, Parameters, false);
			}
			Inputs.Blurred = Plain;
		}
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
