// Provides the exposure of passes that a config inserts by name: their parameter, and the buffer made from it.
#pragma once

#include "Exposure/PostProcessEyeAdaptation.h"
#include "FactoryParameters.h"

namespace Drydock
{

/** "ExposureScale": above 0, 1 by default. */
inline FParameterSpec MakeExposureScaleSpec()
{
	return FParameterSpec::Number("ExposureScale", 1.0, 1e-9, 1e9, "Factor that makes scene colour display-referred.");
}

/** Holds the "ExposureScale" of Values. */
inline FRDGBufferRef CreateEyeAdaptationBuffer(FRDGBuilder& GraphBuilder, const FParameterValues& Values)
{
	return CreateEyeAdaptationBuffer(GraphBuilder, Values.GetFloat("ExposureScale"));
}

} // namespace Drydock
