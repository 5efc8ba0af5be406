// Reads what metering left in its buffers.
#include "Effects/ExposureReport.h"

#include "Effects/Exposure.h"
#include "Exposure/PostProcessEyeAdaptation.h"

#include <cstring>

namespace Drydock
{

FExposureReport MakeExposureReport(
	const FViewInfo& View, EAutoExposureMethod Method, FRDGPooledBuffer& Buffer, IPooledRenderTarget* Histogram)
{
	FVector4f Entries[GEyeAdaptationBufferEntries];
	std::memcpy(Entries, Buffer.GetRHI()->GetData(), sizeof(Entries));
	FExposureReport Report;
	Report.Method = GetAutoExposureMethodName(Method);
	Report.Scale = Entries[0].X;
	Report.TargetScale = Entries[0].Y;
	Report.AverageLuminance = Entries[0].Z;
	Report.EV100 = LuminanceToEV100(Report.AverageLuminance);
	Report.Compensation = Entries[0].W;
	Report.AverageLocalExposure = Entries[1].X;
	if (Histogram != nullptr)
	{
		const FEyeAdaptationParameters Parameters = GetEyeAdaptationParameters(View, Method, true);
		const FVector2f Range = GetHistogramLogRange(View.FinalPostProcessSettings, Method);
		FExposureHistogram Metered;
		Metered.LogMin = Range.X;
		Metered.LogMax = Range.Y;
		Metered.LowPercent = 100.0f * Parameters.ExposureLowPercent;
		Metered.HighPercent = 100.0f * Parameters.ExposureHighPercent;
		Metered.Buckets = ReadHistogram(*Histogram->GetRHI());
		Report.Histogram = Metered;
	}
	return Report;
}

} // namespace Drydock
