// The pass of temporal antialiasing.
#include "Screen/TemporalAA.h"

#include "GlobalShader.h"
#include "HAL/IConsoleManager.h"
#include "PixelShaderUtils.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Screen/RasterTarget.h"
#include "ShaderParameterStruct.h"
#include "SystemTextures.h"

#include <cmath>

namespace
{

TAutoConsoleVariable<float> CVarTemporalAACurrentFrameWeight(TEXT("r.TemporalAACurrentFrameWeight"), 0.04f,
	TEXT("Least share of a frame in the history of temporal antialiasing, 0 to 1. Lower averages more frames; 0.04 by "
		 "default."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<float> CVarTemporalAAFilterSize(TEXT("r.TemporalAAFilterSize"), 1.0f,
	TEXT("Size of the filter over a frame's samples in temporal antialiasing. 0: the nearest sample. 1: smooth "
		 "(default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

TAutoConsoleVariable<int32> CVarTemporalAACatmullRom(TEXT("r.TemporalAACatmullRom"), 0,
	TEXT("1: temporal antialiasing filters a frame's samples by Catmull-Rom, sharper. 0: by a Gaussian (default)."),
	ECVF_Scalability | ECVF_RenderThreadSafe);

class FTemporalAAPS : public FGlobalShader
{
public:
	DECLARE_GLOBAL_SHADER(FTemporalAAPS);
	SHADER_USE_PARAMETER_STRUCT(FTemporalAAPS, FGlobalShader);

	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_STRUCT_REF(FViewUniformShaderParameters, View)
		SHADER_PARAMETER_STRUCT_INCLUDE(FSceneTextureShaderParameters, SceneTextures)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Color)
		SHADER_PARAMETER_STRUCT(FScreenPassTextureViewportParameters, Output)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, ColorTexture)
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, HistoryTexture)
		SHADER_PARAMETER_ARRAY(FVector4f, SampleWeights, [9])
		SHADER_PARAMETER(FIntPoint, ColorSize)
		SHADER_PARAMETER(FIntPoint, HistoryMin)
		SHADER_PARAMETER(FIntPoint, HistorySize)
		SHADER_PARAMETER(FVector2f, HistoryScale)
		SHADER_PARAMETER(float, CurrentFrameWeight)
		SHADER_PARAMETER(float, LumaScale)
		SHADER_PARAMETER(int32, bHistory)
		SHADER_PARAMETER(int32, bWeighByLuma)
		RENDER_TARGET_BINDING_SLOTS()
	END_SHADER_PARAMETER_STRUCT()
};

IMPLEMENT_GLOBAL_SHADER(FTemporalAAPS, "/Drydock/Private/TemporalAA.usf", "MainPS", SF_Pixel);

/** The filter of Catmull and Rom, of a distance in pixels. */
double CatmullRom(double Distance)
{
	const double D = std::abs(Distance);
	return D >= 2.0 ? 0.0 : D >= 1.0 ? 2.0 + D * (-4.0 + D * (2.5 - 0.5 * D)) : 1.0 + D * D * (-2.5 + 1.5 * D);
}

} // namespace

namespace Drydock
{

FTemporalAAInputs FTemporalAAInputs::FromVariables()
{
	FTemporalAAInputs Inputs;
	Inputs.CurrentFrameWeight = FMath::Clamp(CVarTemporalAACurrentFrameWeight.GetValueOnRenderThread(), 0.0f, 1.0f);
	Inputs.FilterSize = FMath::Clamp(CVarTemporalAAFilterSize.GetValueOnRenderThread(), 0.0f, 4.0f);
	Inputs.bCatmullRom = CVarTemporalAACatmullRom.GetValueOnRenderThread() != 0;
	return Inputs;
}

TStaticArray<float, 9> MakeTemporalAAWeights(FVector2D Jitter, float FilterSize, bool bCatmullRom)
{
	constexpr double LeastSize = 1e-3; // narrower ones leave the middle pixel alone
	const double Sigma = 0.47 * static_cast<double>(FilterSize);
	double Weights[9];
	double Sum = 0.0;
	for (int32 Index = 0; Index < 9; ++Index)
	{
		// A pixel shows what is at its centre in the picture without jitter, less the jitter.
		const double X = Index % 3 - 1 - Jitter.X;
		const double Y = Index / 3 - 1 - Jitter.Y;
		if (bCatmullRom)
		{
			Weights[Index] = CatmullRom(X) * CatmullRom(Y);
		}
		else if (static_cast<double>(FilterSize) < LeastSize)
		{
			Weights[Index] = Index == 4 ? 1.0 : 0.0;
		}
		else
		{
			Weights[Index] = std::exp(-0.5 * (X * X + Y * Y) / (Sigma * Sigma));
		}
		Sum += Weights[Index];
	}
	TStaticArray<float, 9> Result;
	for (int32 Index = 0; Index < 9; ++Index)
	{
		// A jitter by many pixels leaves no weight: the middle pixel is the nearest that there is.
		Result[Index] = static_cast<float>(Sum > 0.0 ? Weights[Index] / Sum : Index == 4 ? 1.0 : 0.0);
	}
	return Result;
}

FTemporalAAOutputs AddTemporalAAPass(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTemporalAAInputs& Inputs)
{
	check(Inputs.SceneColor.IsValid());
	check(Inputs.SceneTextures);
	check(Inputs.ExposureScale > 0.0f);
	const FIntPoint Size = Inputs.SceneColor.ViewRect.Size();
	const bool bHistory = Inputs.History.IsValid();
	const FIntPoint HistorySize = bHistory ? Inputs.History.ViewRect.Size() : Size;
	const FScreenPassRenderTarget Output = CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("TemporalAA"));
	const FScreenPassRenderTarget History =
		CreateRasterTargetLike(GraphBuilder, Inputs.SceneColor, TEXT("TemporalAA.History"), PF_A32B32G32R32F);

	auto* const Parameters = GraphBuilder.AllocParameters<FTemporalAAPS::FParameters>();
	Parameters->View = View.ViewUniformBuffer;
	Parameters->SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
	Parameters->Color = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Inputs.SceneColor));
	Parameters->Output = GetScreenPassTextureViewportParameters(FScreenPassTextureViewport(Output));
	Parameters->ColorTexture = Inputs.SceneColor.Texture;
	Parameters->HistoryTexture = bHistory ? Inputs.History.Texture : GSystemTextures.GetBlackDummy(GraphBuilder);
	const TStaticArray<float, 9> Weights =
		MakeTemporalAAWeights(View.TemporalJitterPixels, Inputs.FilterSize, Inputs.bCatmullRom);
	for (int32 Index = 0; Index < 9; ++Index)
	{
		Parameters->SampleWeights[Index] = FVector4f(Weights[Index], 0.0f, 0.0f, 0.0f);
	}
	Parameters->ColorSize = Size;
	Parameters->HistoryMin = bHistory ? Inputs.History.ViewRect.Min : FIntPoint::ZeroValue;
	Parameters->HistorySize = HistorySize;
	Parameters->HistoryScale =
		FVector2f(static_cast<float>(HistorySize.X) / Size.X, static_cast<float>(HistorySize.Y) / Size.Y);
	Parameters->CurrentFrameWeight = Inputs.CurrentFrameWeight;
	Parameters->LumaScale = Inputs.ExposureScale / View.PreExposure;
	Parameters->bHistory = bHistory ? 1 : 0;
	Parameters->bWeighByLuma = Inputs.bCatmullRom ? 0 : 1;
	Parameters->RenderTargets[0] = Output.GetRenderTargetBinding();
	Parameters->RenderTargets[1] = History.GetRenderTargetBinding();

	TShaderMapRef<FTemporalAAPS> PixelShader(View.ShaderMap);
	FPixelShaderUtils::AddFullscreenPass(GraphBuilder, View.ShaderMap,
		RDG_EVENT_NAME("TemporalAA %dx%d", Size.X, Size.Y), PixelShader, Parameters, Output.ViewRect);
	return {FScreenPassTexture(Output.Texture, Output.ViewRect), FScreenPassTexture(History.Texture, History.ViewRect)};
}

} // namespace Drydock
