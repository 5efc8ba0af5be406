// Adds the passes of exposure: metering, adaptation, local exposure. Source: engine PostProcess/PostProcessing.cpp.
#include "Chain/ExposureChain.h"

#include "Effects/Effect.h"
#include "Exposure/PostProcessExposureCurve.h"
#include "Exposure/PostProcessHistogram.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphEvent.h"
#include "RenderTargetPool.h"
#include "SceneRendering.h"
#include "SceneViewState.h"
#include "Screen/TextureAssets.h"

using namespace Drydock;

namespace
{

/** The mask's pixels, where it has any. */
FRDGTextureRef RegisterMeterMask(FRDGBuilder& GraphBuilder, const FFinalPostProcessSettings& Settings)
{
	const UTexture* const Mask = Settings.AutoExposureMeterMask;
	const FTextureRHIRef Texture = Mask != nullptr ? Drydock::FindTexturePixels(Mask) : nullptr;
	return Texture ? GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("MeterMask"))) : nullptr;
}

/** Meters into Outputs and adapts. */
void AddMetering(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FExposureChainInputs& Inputs,
	EAutoExposureMethod Method, const FEyeAdaptationInputs& Adaptation, FExposureChainOutputs& Outputs)
{
	if (Method == AEM_Manual)
	{
		Outputs.EyeAdaptationBuffer = CreateManualEyeAdaptationBuffer(GraphBuilder, Adaptation.Parameters);
		return;
	}
	const FRDGTextureRef MeterMask = RegisterMeterMask(GraphBuilder, View.FinalPostProcessSettings);
	if (Method == AEM_Histogram)
	{
		Outputs.Histogram =
			AddHistogramPass(GraphBuilder, View, Adaptation.Parameters, Inputs.HalfResolution, MeterMask);
		Outputs.EyeAdaptationBuffer = AddHistogramEyeAdaptationPass(GraphBuilder, View, Adaptation, Outputs.Histogram);
		return;
	}
	// From the quarter resolution down, in a chain of its own: in the engine bloom reads these levels too, in half
	// floats.
	FSceneDownsampleChain Chain;
	Chain.Init(GraphBuilder, View,
		AddBasicEyeAdaptationSetupPass(
			GraphBuilder, View, Adaptation.Parameters, Inputs.SceneDownsampleChain->GetTexture(1)),
		GetDownsampleChainQuality(), TEXT("BasicEyeAdaptationDownsample"), FSceneDownsampleChain::StageCount - 1);
	Outputs.EyeAdaptationBuffer =
		AddBasicEyeAdaptationPass(GraphBuilder, View, Adaptation, Chain.GetLastTexture(), MeterMask);
}

} // namespace

FExposureChainOutputs AddExposurePasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FExposureChainInputs& Inputs)
{
	const EAutoExposureMethod Method = GetAutoExposureMethod(View.FinalPostProcessSettings);
	const FRDGBufferRef Last = Inputs.bAutoExposure && View.ViewState != nullptr
								   ? View.ViewState->RegisterLastBuffer(GraphBuilder, Drydock::EyeAdaptationName)
								   : nullptr;
	FEyeAdaptationInputs Adaptation;
	Adaptation.Parameters = GetEyeAdaptationParameters(View, Method, Last == nullptr);

	FExposureChainOutputs Outputs;
	Outputs.EyeAdaptationParameters = Adaptation.Parameters;
	FLocalExposureParameters LocalExposure;
	if (Inputs.bLocalExposure)
	{
		const Drydock::FRDGEffectScope Scope(GraphBuilder, *Drydock::GLocalExposureEffect.Name);
		const bool bManual = Inputs.bAutoExposure && Method == AEM_Manual;
		LocalExposure =
			GetLocalExposureParameters(View, Inputs.HalfResolution.ViewRect.Size(), Adaptation.Parameters, bManual);
		Adaptation.LocalExposure = &LocalExposure;
		Outputs.LocalExposure.Parameters = LocalExposure;
		Outputs.LocalExposure.EyeAdaptation = Adaptation.Parameters;
		Outputs.LocalExposure.BilateralGrid =
			AddLocalExposurePass(GraphBuilder, View, Adaptation.Parameters, Inputs.HalfResolution);
		Outputs.LocalExposure.BlurredLogLuminance = AddLocalExposureBlurredLogLuminancePass(GraphBuilder, View,
			Adaptation.Parameters, Inputs.SceneDownsampleChain->GetTexture(GBlurredLogLuminanceLevel),
			View.FinalPostProcessSettings.LocalExposureBlurredLuminanceKernelSizePercent);
	}
	if (!Inputs.bAutoExposure)
	{
		Outputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, Inputs.ExposureScale);
		return Outputs;
	}
	RDG_EVENT_SCOPE(GraphBuilder, "EyeAdaptation");
	Adaptation.LastEyeAdaptationBuffer = Last;
	AddMetering(GraphBuilder, View, Inputs, Method, Adaptation, Outputs);
	if (Last == nullptr && Method != AEM_Manual)
	{
		Outputs.EyeAdaptationBuffer =
			AddExposureCurvePass(GraphBuilder, View.FinalPostProcessSettings, Outputs.EyeAdaptationBuffer);
	}
	if (View.ViewState != nullptr)
	{
		View.ViewState->KeepBuffer(GraphBuilder, Drydock::EyeAdaptationName, Outputs.EyeAdaptationBuffer);
	}
	return Outputs;
}
