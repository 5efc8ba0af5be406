// Reports the result of a metered exposure, read back from a frame that ran.
#pragma once

#include "Diagnostics.h"
#include "Exposure/PostProcessHistogram.h"
#include "RenderGraphResourcePool.h"
#include "RendererInterface.h"
#include "SceneRendering.h"

#include <array>
#include <optional>
#include <string>

namespace Drydock
{

/** The histogram that an exposure was metered with. */
struct FExposureHistogram
{
	float LogMin = 0.0f; // log2 luminance of the first bucket
	float LogMax = 0.0f; // of the last
	float LowPercent = 0.0f;
	float HighPercent = 0.0f;
	std::array<double, GHistogramSize> Buckets = {}; // shares of the pixels
};

struct FExposureReport
{
	std::string Method; // "AEM_Histogram"
	float Scale = 1.0f;
	float TargetScale = 1.0f;      // where adaptation leads
	float AverageLuminance = 0.0f; // scene units, before the limits; of AEM_Manual that of the camera's settings
	float EV100 = 0.0f;            // of it
	float Compensation = 1.0f;     // 2^bias
	float AverageLocalExposure = 1.0f;
	std::optional<FExposureHistogram> Histogram;

	/** False: the histogram is empty, since every pixel is darker than what it counts. */
	bool IsMetered() const;
	/** The warning about that (DD4005). View: its name, where there are several. */
	FDiagnostic DescribeUnmetered(const std::string& View) const;
};

/** Buffer: of the eye adaptation; Histogram: null where the method has none. */
DRYDOCK_API FExposureReport MakeExposureReport(
	const FViewInfo& View, EAutoExposureMethod Method, FRDGPooledBuffer& Buffer, IPooledRenderTarget* Histogram);

} // namespace Drydock
