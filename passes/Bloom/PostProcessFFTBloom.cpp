// The passes of a frame with convolution bloom. Source: engine file PostProcess/PostProcessFFTBloom.cpp.
#include "Bloom/PostProcessFFTBloom.h"

#include "Bloom/FFTConvolution.h"
#include "Bloom/PostProcessFFTBloomKernel.h"
#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "Math/ToInteger.h"
#include "PassFunctions.h"
#include "PixelShaderUtils.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "Screen/TextureAssets.h"
#include "SettingObjects.h"
#include "ShaderParameterStruct.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<float> CVarBloomScreenPercentage(TEXT("r.Bloom.ScreenPercentage"), 100.0f,
	TEXT("Resolution of FFT bloom in percent of the view's, 10 to 100 (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

/** The longest line that the engine's transforms can hold. */
constexpr int32 MaxScanLineLength = 4096;

constexpr const char* DefaultKernel = "Builtin/Airy";

class FFFTBloomPreFilterCS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FFFTBloomPreFilterCS);
	SHADER_USE_PARAMETER_STRUCT(FFFTBloomPreFilterCS, FGlobalShader);

	class FResampleDimension : SHADER_PERMUTATION_BOOL("RESAMPLE");
	using FPermutationDomain = TShaderPermutationDomain<FResampleDimension>;

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER(FIntPoint, OutputSize)
		SHADER_PARAMETER(FVector4f, PreFilter)
		SHADER_PARAMETER(float, PreExposure)
		SHADER_PARAMETER(float, OneOverPreExposure)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_SAMPLER(SamplerState, InputSampler)
		SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float4>, OutputTexture)
	END_SHADER_PARAMETER_STRUCT()
};

class FFFTBloomApplyPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FFFTBloomApplyPS);
	SHADER_USE_PARAMETER_STRUCT(FFFTBloomApplyPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Input)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float4>, SceneColorApplyParameters)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FFFTBloomPreFilterCS, "/Engine/Private/PostProcessFFTBloom.usf", "PreFilterCS", SF_Compute);
IMPLEMENT_GLOBAL_SHADER(FFFTBloomApplyPS, "/Engine/Private/PostProcessFFTBloom.usf", "ApplySceneColorPS", SF_Pixel);

BEGIN_SHADER_PARAMETER_STRUCT(FFinalizeApplyConstantsParameters, )
	RDG_TEXTURE_ACCESS(KernelSpectrum, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(KernelConstants, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(KernelSum, ERHIAccess::SRVCompute)
	RDG_BUFFER_ACCESS(SceneColorApplyParameters, ERHIAccess::UAVCompute)
	RDG_BUFFER_ACCESS(FFTMulParameters, ERHIAccess::UAVCompute)
END_SHADER_PARAMETER_STRUCT()

FTextureRHIRef FindKernelTexture(const FFinalPostProcessSettings& Settings)
{
	return Settings.BloomConvolutionTexture != nullptr
			   ? Drydock::FindTexturePixels(Settings.BloomConvolutionTexture.Get())
			   : Drydock::FindTexturePixels(DefaultKernel);
}

FIntPoint GetImageSize(FIntPoint ViewSize, float Fraction)
{
	const auto Scale = [&](int32 Size)
	{
		return Drydock::ToCount(std::ceil(static_cast<float>(Size) * Fraction), 1, Size);
	};
	return FIntPoint(Scale(ViewSize.X), Scale(ViewSize.Y));
}

/** The transform holds picture and padding, and the whole kernel; of both no more than what reaches from one end of the
 * picture to the other. */
void SetSizes(Drydock::FBloomFFTKernel& Wanted, FIntPoint ImageSize, const FFinalPostProcessSettings& Settings)
{
	const FRHITexture& KernelTexture = *Wanted.Texture;
	const int32 Padding =
		Drydock::ComputeFFTBloomPadding(ImageSize, Settings.BloomConvolutionSize, Settings.BloomConvolutionBufferScale);
	const auto Pad = [&](int32 Size)
	{
		return FMath::Max(Size, FMath::Min(Size + Padding, MaxScanLineLength));
	};
	const FVector2D KernelSize =
		Drydock::GetBloomKernelSize(ImageSize, KernelTexture.GetSizeXY(), Settings.BloomConvolutionSize);
	// A kernel picture much higher than wide is cut: its size follows from its width.
	const int32 LargestKernel = FMath::Max(MaxScanLineLength, ImageSize.GetMax());
	const auto Hold = [&](int32 Size, double KernelSide)
	{
		return FMath::Max(Pad(Size), Drydock::ToCount(std::ceil(KernelSide), 1, LargestKernel));
	};
	const FIntPoint Whole(Hold(ImageSize.X, KernelSize.X), Hold(ImageSize.Y, KernelSize.Y));
	const auto Reach = [](int32 Held, int32 Size)
	{
		return FMath::Min(Held, 2 * Size - 1);
	};
	Wanted.WholeSize = Drydock::FFFTDomain::Make(ImageSize, Whole).FrequencySize;
	Wanted.Domain =
		Drydock::FFFTDomain::Make(ImageSize, FIntPoint(Reach(Whole.X, ImageSize.X), Reach(Whole.Y, ImageSize.Y)));
}

/** The smallest picture that has the resolution of the bloom. */
const FScreenPassTexture& ChooseInput(const FFFTBloomInputs& Inputs, float Fraction)
{
	if (Fraction <= 0.25f && Inputs.QuarterResolution.IsValid())
	{
		return Inputs.QuarterResolution;
	}
	return Fraction <= 0.5f && Inputs.HalfResolution.IsValid() ? Inputs.HalfResolution : Inputs.SceneColor;
}

FScreenPassTexture AddPreFilterPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, FIntPoint ImageSize)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FRDGTextureRef Output =
		GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(ImageSize, PF_A32B32G32R32F, FClearValueBinding::None,
									   TexCreate_ShaderResource | TexCreate_UAV),
			TEXT("Bloom.PreFiltered"));

	FFFTBloomPreFilterCS::FParameters* PassParameters =
		GraphBuilder.AllocParameters<FFFTBloomPreFilterCS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Input));
	PassParameters->OutputSize = ImageSize;
	PassParameters->PreFilter = FVector4f(FMath::Max(0.0f, Settings.BloomConvolutionPreFilterMin),
		Settings.BloomConvolutionPreFilterMax, Settings.BloomConvolutionPreFilterMult, 0.0f);
	PassParameters->PreExposure = View.PreExposure;
	PassParameters->OneOverPreExposure = 1.0f / View.PreExposure;
	PassParameters->InputTexture = Input.Texture;
	PassParameters->InputSampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp>::GetRHI();
	PassParameters->OutputTexture = GraphBuilder.CreateUAV(Output);

	FFFTBloomPreFilterCS::FPermutationDomain Permutation;
	Permutation.Set<FFFTBloomPreFilterCS::FResampleDimension>(Input.ViewRect.Size() != ImageSize);
	FComputeShaderUtils::AddPass(GraphBuilder,
		RDG_EVENT_NAME("FFTBloom.PreFilter %dx%d (CS)", ImageSize.X, ImageSize.Y),
		TShaderMapRef<FFFTBloomPreFilterCS>(View.ShaderMap, Permutation), PassParameters,
		FComputeShaderUtils::GetGroupCount(ImageSize, FComputeShaderUtils::kGolden2DGroupSize));
	return FScreenPassTexture(Output);
}

/** Factors of one channel: of the scene colour, and of the spectra's product. */
struct FApplyConstants
{
	double SceneColor = 1.0;
	double Spectrum = 0.0;
};

/** Energies of one channel; MaxTotal is of all. KernelSum: of the shape that is convolved with. */
FApplyConstants ComputeApplyConstants(
	double Total, double Scatter, double MaxTotal, double KernelSum, double ScatterDispersion)
{
	if (!(MaxTotal > 0.0))
	{
		return {};
	}
	if (!(Total > 0.0))
	{
		return {0.0, 0.0};
	}
	const double Tint = Total / MaxTotal;
	const double Moved = Scatter * ScatterDispersion;
	FApplyConstants Constants;
	Constants.SceneColor = Tint * FMath::Clamp((Total - Moved) / Total, 0.0, 1.0);
	Constants.Spectrum = KernelSum > 0.0 ? Tint * FMath::Clamp(Moved / Total, 0.0, 1.0) / KernelSum : 0.0;
	return Constants;
}

void FinalizeApplyConstants(const FFinalizeApplyConstantsParameters& Parameters, double ScatterDispersion)
{
	const auto GetEntries = [](FRDGBufferRef Buffer)
	{
		return reinterpret_cast<FVector4f*>(Buffer->GetRHI()->GetData());
	};
	const FVector4f* const Constants = GetEntries(Parameters.KernelConstants);
	const FVector4f Total = Constants[static_cast<uint32>(Drydock::EBloomKernelConstant::Total)];
	const FVector4f Scatter = Constants[static_cast<uint32>(Drydock::EBloomKernelConstant::Scatter)];
	// Frequency 0 is the sum.
	const FVector4 Sum = Parameters.KernelSum ? FVector4(GetEntries(Parameters.KernelSum)[0])
											  : Parameters.KernelSpectrum->GetRHI()->ReadTexelDouble(0, 0);
	const double MaxTotal = double(FMath::Max(Total.X, FMath::Max(Total.Y, Total.Z)));
	const FApplyConstants R =
		ComputeApplyConstants(double(Total.X), double(Scatter.X), MaxTotal, Sum.X, ScatterDispersion);
	const FApplyConstants G =
		ComputeApplyConstants(double(Total.Y), double(Scatter.Y), MaxTotal, Sum.Y, ScatterDispersion);
	const FApplyConstants B =
		ComputeApplyConstants(double(Total.Z), double(Scatter.Z), MaxTotal, Sum.Z, ScatterDispersion);
	GetEntries(Parameters.SceneColorApplyParameters)[0] = FVector4f(
		static_cast<float>(R.SceneColor), static_cast<float>(G.SceneColor), static_cast<float>(B.SceneColor), 1.0f);
	GetEntries(Parameters.FFTMulParameters)[0] =
		FVector4f(static_cast<float>(R.Spectrum), static_cast<float>(G.Spectrum), static_cast<float>(B.Spectrum), 0.0f);
}

const FFinalizeApplyConstantsParameters* AddFinalizeApplyConstantsPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const Drydock::FBloomKernel& Kernel)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	// Max with 0 on the right: a NaN counts as 0.
	const double ScatterDispersion =
		std::fmax(double(Settings.BloomConvolutionScatterDispersion) * double(Settings.BloomIntensity), 0.0);
	FFinalizeApplyConstantsParameters* Parameters = GraphBuilder.AllocParameters<FFinalizeApplyConstantsParameters>();
	const FRDGBufferDesc Desc = FRDGBufferDesc::CreateStructuredDesc(sizeof(FVector4f), 1);
	Parameters->KernelSpectrum = Kernel.Spectrum;
	Parameters->KernelConstants = Kernel.Constants;
	Parameters->KernelSum = Kernel.Sum;
	Parameters->SceneColorApplyParameters = GraphBuilder.CreateBuffer(Desc, TEXT("Bloom.SceneColorApplyParameters"));
	Parameters->FFTMulParameters = GraphBuilder.CreateBuffer(Desc, TEXT("Bloom.FFTMulParameters"));
	GraphBuilder.AddPass(RDG_EVENT_NAME("FFTBloom.FinalizeApplyConstants"), Parameters, ERDGPassFlags::Compute,
		[Parameters, ScatterDispersion](FRHIComputeCommandList&)
		{ FinalizeApplyConstants(*Parameters, ScatterDispersion); });
	return Parameters;
}

} // namespace

namespace Drydock
{

std::string GetFFTBloomObstacle(const FFinalPostProcessSettings& Settings, bool bHasViewState)
{
	if (!bHasViewState)
	{
		return "the view has no state to keep the kernel in";
	}
	if (!FindKernelTexture(Settings))
	{
		return "there are no pixels for BloomConvolutionTexture " +
			   GetObjectPath(Settings.BloomConvolutionTexture.Get());
	}
	return "";
}

FScreenPassTexture AddApplyFFTBloomPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, FRDGBufferRef SceneColorApplyParameters)
{
	const FScreenPassRenderTarget Output =
		CreateRasterTargetLike(GraphBuilder, SceneColor, TEXT("Bloom.AppliedSceneColor"));
	FFFTBloomApplyPS::FParameters* PassParameters = GraphBuilder.AllocParameters<FFFTBloomApplyPS::FParameters>();
	PassParameters->Input = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(SceneColor));
	PassParameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	PassParameters->InputTexture = SceneColor.Texture;
	PassParameters->SceneColorApplyParameters = GraphBuilder.CreateSRV(SceneColorApplyParameters);
	PassParameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("FFTBloom.ApplySceneColor %dx%d", Output.ViewRect.Width(), Output.ViewRect.Height()),
		TShaderMapRef<FFFTBloomApplyPS>(View.ShaderMap), PassParameters, Output.ViewRect);
	return FScreenPassTexture(Output.Texture, Output.ViewRect);
}

int32 ComputeFFTBloomPadding(FIntPoint ImageSize, float Size, float BufferScale)
{
	const float KernelSupport = FMath::Clamp(Size, 0.0f, 1.0f);
	const float Support = BufferScale > 0.0f ? FMath::Min(KernelSupport, BufferScale) : KernelSupport;
	return ToCount(std::ceil(0.5f * Support * static_cast<float>(ImageSize.X)), 0, ImageSize.X);
}

} // namespace Drydock

bool IsFFTBloomEnabled(const FViewInfo& View)
{
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	return Settings.BloomMethod == BM_FFT && Settings.BloomIntensity > 0.0f &&
		   Drydock::GetFFTBloomObstacle(Settings, View.State != nullptr).empty();
}

float GetFFTBloomResolutionFraction(FIntPoint ViewSize)
{
	constexpr int32 MaxTextureDimensions = 16384;
	const float Percentage = CVarBloomScreenPercentage.GetValueOnRenderThread();
	const float Largest =
		0.5f * MaxTextureDimensions / static_cast<float>(FMath::Max(1, FMath::Max(ViewSize.X, ViewSize.Y)));
	return FMath::Clamp(Percentage / 100.0f, 0.1f, FMath::Min(Largest, 1.0f));
}

FFFTBloomOutput Drydock::BuiltInAddFFTBloomPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FFFTBloomInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FTextureRHIRef KernelTexture = FindKernelTexture(Settings);
	check(KernelTexture);

	const FIntPoint ViewSize = Inputs.SceneColor.ViewRect.Size();
	const float Fraction = GetFFTBloomResolutionFraction(ViewSize);
	const FIntPoint ImageSize = GetImageSize(ViewSize, Fraction);

	RDG_EVENT_SCOPE(GraphBuilder, "FFTBloom %dx%d", ImageSize.X, ImageSize.Y);
	const FScreenPassTexture Image = AddPreFilterPass(GraphBuilder, View, ChooseInput(Inputs, Fraction), ImageSize);

	Drydock::FBloomFFTKernel Wanted;
	Wanted.Texture = KernelTexture;
	Wanted.NumMips = KernelTexture->GetNumMips();
	Wanted.Size = Settings.BloomConvolutionSize;
	Wanted.CenterUV = Settings.BloomConvolutionCenterUV;
	SetSizes(Wanted, ImageSize, Settings);
	Wanted.Storage = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Storage"))->GetInt();
	const Drydock::FBloomKernel Kernel = Drydock::FindOrAddBloomKernel(GraphBuilder, View, Wanted);
	const FFinalizeApplyConstantsParameters* Constants = AddFinalizeApplyConstantsPass(GraphBuilder, View, Kernel);

	const FRDGTextureRef Spectrum =
		Drydock::AddForwardFFTPasses(GraphBuilder, Wanted.Domain, Image, TEXT("Bloom.ImageSpectrum"));
	const FRDGTextureRef Product = Drydock::AddMultiplySpectraPass(
		GraphBuilder, View, Wanted.Domain, Spectrum, Kernel.Spectrum, Constants->FFTMulParameters);

	const EPixelFormat SceneFormat = Inputs.SceneColor.Texture->Desc.Format;
	const FScreenPassTexture Bloom(GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(ImageSize, SceneFormat == PF_A32B32G32R32F ? SceneFormat : PF_FloatRGBA,
			FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
		TEXT("Bloom.FFT")));
	Drydock::AddInverseFFTPasses(GraphBuilder, Wanted.Domain, Product, Bloom);
	return {Bloom, Constants->SceneColorApplyParameters};
}
