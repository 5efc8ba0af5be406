// The block of the engine's PostProcessing.cpp that adds the bloom setup. drydock takes the block alone, wherever it
// stands in this file; the variables around it are the engine's.
#include "PostProcess/PostProcessBloomSetup.h"
#include "PostProcess/PostProcessing.h"

void AddPostProcessingPasses()
{
	if (bBloomSetupRequiredEnabled)
	{
		const float BloomThreshold = View.FinalPostProcessSettings.BloomThreshold;

		FBloomSetupInputs SetupPassInputs;
		SetupPassInputs.SceneColor = DownsampleInput;
		SetupPassInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
		SetupPassInputs.EyeAdaptationParameters = &EyeAdaptationParameters;
		SetupPassInputs.LocalExposureParameters = &LocalExposureParameters;
		SetupPassInputs.LocalExposureTexture =
			CVarBloomApplyLocalExposure.GetValueOnRenderThread() ? LocalExposureTexture : nullptr;
		SetupPassInputs.BlurredLogLuminanceTexture = LocalExposureBlurredLogLumTexture;
		SetupPassInputs.Threshold = BloomThreshold;

		DownsampleInput = AddBloomSetupPass(GraphBuilder, View, SetupPassInputs);
	}
}
