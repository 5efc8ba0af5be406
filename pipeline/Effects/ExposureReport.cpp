// Reads what metering left in its buffers.
#include "Effects/ExposureReport.h"

#include "Effects/Exposure.h"
#include "Exposure/PostProcessEyeAdaptation.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace Drydock
{

bool FExposureReport::IsMetered() const
{
	return !Histogram || std::ranges::any_of(Histogram->Buckets, [](double Share) { return Share > 0.0; });
}

FDiagnostic FExposureReport::DescribeUnmetered(const std::string& View) const
{
	return {.Severity = ESeverity::Warning,
		.Code = WarnNothingMetered,
		.Message =
			"nothing is metered: the histogram takes luminances from " + NumberText(std::exp2(Histogram->LogMin)) +
			" on, and every pixel is darker. The exposure is that of a luminance of 1; lower HistogramLogMin, or "
			"take AEM_Basic",
		.Where = (View.empty() ? "" : View + ", ") + "AutoExposureMethod " + Method};
}

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
