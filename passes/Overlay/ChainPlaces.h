// Places of the post-processing chain whose code an engine overlay can bring along. Each struct holds the local
// variables that the engine's PostProcessing.cpp has at that place, as far as public patches print them, under their
// names. Source: engine file PostProcess/PostProcessing.cpp (names).
#pragma once

#include "Exposure/PostProcessLocalExposure.h"
#include "PassFunctions.h"
#include "PostProcess/PostProcessInputs.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** A console variable as code at a place reads it. */
struct FPlaceVariable
{
	bool bValue = false;

	bool GetValueOnRenderThread() const { return bValue; }
};

/** The block `if (bBloomSetupRequiredEnabled)`, which calls AddBloomSetupPass. */
struct FBloomSetupPlace
{
	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FPostProcessingInputs& Inputs;
	const float BloomThreshold;
	/** A threshold above -1, or local exposure that acts on bloom. The overlay's file may define it anew. */
	const bool bBloomSetupRequiredEnabled;
	/** The picture at half resolution; the block puts its result there. */
	FScreenPassTexture& DownsampleInput;
	const FRDGBufferRef EyeAdaptationBuffer;
	const FEyeAdaptationParameters& EyeAdaptationParameters;
	const FLocalExposureParameters& LocalExposureParameters;
	/** Null where local exposure is off. */
	const FRDGTextureRef LocalExposureTexture;
	const FRDGTextureRef LocalExposureBlurredLogLumTexture;
	/** r.Bloom.ApplyLocalExposure. */
	const FPlaceVariable CVarBloomApplyLocalExposure;
};

/** A place, as the code of an overlay is found and written. */
struct FChainPlaceOfOverlay
{
	const char* Name = "";      // under which FPassReplacement knows it
	const char* Struct = "";    // FBloomSetupPlace
	const char* Condition = ""; // of the block's if
	const char* Call = "";      // the pass function that the block calls
};

inline constexpr const char* BloomSetupPlaceName = "PostProcessing.cpp: if (bBloomSetupRequiredEnabled)";

/** Whether an overlay brings the bloom setup: its function or its block. */
inline bool IsBloomSetupReplaced()
{
	return FindPassReplacement("AddBloomSetupPass") != nullptr || FindPassReplacement(BloomSetupPlaceName) != nullptr;
}

inline constexpr FChainPlaceOfOverlay ChainPlacesOfOverlays[] = {
	{BloomSetupPlaceName, "FBloomSetupPlace", "bBloomSetupRequiredEnabled", "AddBloomSetupPass"},
};

} // namespace Drydock
