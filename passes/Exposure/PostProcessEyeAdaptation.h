// Makes the eye-adaptation buffer, which holds the frame's exposure. Made from a given scale, from the camera's
// settings (manual), or metered: from a histogram of log2 luminance (PostProcessHistogram.h) or from its average
// (basic); then it adapts from last frame's buffer. Source: engine file PostProcessEyeAdaptation.h.
//
// An average luminance A, in scene units, gives the target T = clamp(A, Min, Max) / 0.18. Last frame's exposure value
// Compensation / scale moves towards it in log2: by time * speed while it is farther than r.EyeAdaptation.
// ExponentialTransitionDistance EV, nearer by distance * (1 - 2^(-time * speed)) * M, where M makes both speeds meet;
// the engine's formulas. The result is kept within Min / 0.18 and Max / 0.18; scale = Compensation / result. Without a
// last frame, at a camera cut, where Min is not below Max or a speed is negative, it is there at once.
//
// Contract. Scale and target scale are above 0 and finite for every picture and every last frame. Neither step goes
// beyond its target (drydock: however long the frame). Black: A is the histogram's when black counts for nothing, 1.
// Divisors are at least 1e-4 as in the engine: a scale is never above Compensation * 10^4. Average local exposure is
// that of a flat area as bright as A.
#pragma once

#include "CoreMinimal.h"
#include "Exposure/PostProcessEyeAdaptationParameters.h"
#include "Exposure/PostProcessLocalExposure.h"
#include "RenderGraphFwd.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** Two float4: [0] = (exposure scale, target scale, average scene luminance, middle-grey compensation), [1].x = average
 *  local exposure. */
constexpr uint32 GEyeAdaptationBufferEntries = 2;

/** A settled exposure: scale and target alike, no compensation, local exposure 1. ExposureScale: above 0, finite. */
DRYDOCK_API FRDGBufferRef CreateEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, float ExposureScale);

/** A settled exposure of the parameters' MinAverageLuminance, which stands for the average. */
DRYDOCK_API FRDGBufferRef CreateManualEyeAdaptationBuffer(
	FRDGBuilder& GraphBuilder, const FEyeAdaptationParameters& Parameters);

} // namespace Drydock

/** The inputs of both ways of metering. */
struct FEyeAdaptationInputs
{
	FEyeAdaptationParameters Parameters;
	/** Null: local exposure is off. */
	const FLocalExposureParameters* LocalExposure = nullptr;
	/** Null: Parameters.ForceTarget is 1. */
	FRDGBufferRef LastEyeAdaptationBuffer = nullptr;
};

/** HistogramTexture: of AddHistogramPass. */
DRYDOCK_API FRDGBufferRef AddHistogramEyeAdaptationPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationInputs& Inputs, FRDGTextureRef HistogramTexture);

/** A picture with the place of its log2 luminance in the histogram's range in alpha, PF_FloatRGBA: to be downsampled.
 */
DRYDOCK_API FScreenPassTexture AddBasicEyeAdaptationSetupPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationParameters& Parameters, FScreenPassTexture SceneColor);

/** SceneColor: what AddBasicEyeAdaptationSetupPass made, downsampled. MeterMask: weights over the view in its red, at
 * least 0.05; null: all alike. */
DRYDOCK_API FRDGBufferRef AddBasicEyeAdaptationPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FEyeAdaptationInputs& Inputs, FScreenPassTexture SceneColor, FRDGTextureRef MeterMask = nullptr);
