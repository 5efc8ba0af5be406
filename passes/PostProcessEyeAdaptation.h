// The eye-adaptation buffer: what exposure the frame has. For now it is made from a given scale; metering and
// adaptation over time write the same buffer later. Source: engine file PostProcessEyeAdaptation.h.
#pragma once

#include "CoreMinimal.h"
#include "RenderGraphFwd.h"

class FRDGBuilder;

/** Two float4: [0] = (exposure scale, target scale, average scene luminance, middle-grey compensation), [1].x = average
 *  local exposure. */
constexpr uint32 GEyeAdaptationBufferEntries = 2;

/** A settled exposure: scale and target alike, no compensation, local exposure 1. ExposureScale: above 0, finite. */
DRYDOCK_API FRDGBufferRef CreateEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, float ExposureScale);
