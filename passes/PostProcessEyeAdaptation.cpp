// Source: engine file PostProcessEyeAdaptation.cpp.
#include "PostProcessEyeAdaptation.h"

#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"

#include <cmath>

FRDGBufferRef CreateEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, float ExposureScale)
{
	check(ExposureScale > 0.0f && std::isfinite(ExposureScale));
	// The average luminance that this scale would have been chosen for: middle grey over the scale.
	const FVector4f Entries[GEyeAdaptationBufferEntries] = {
		FVector4f(ExposureScale, ExposureScale, 0.18f / ExposureScale, 1.0f),
		FVector4f(1.0f, 0.0f, 0.0f, 0.0f),
	};
	return CreateStructuredBuffer(
		GraphBuilder, TEXT("EyeAdaptation"), sizeof(FVector4f), GEyeAdaptationBufferEntries, Entries, sizeof(Entries));
}
