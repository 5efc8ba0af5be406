// Puts a study's files and pictures into one JSON.
#include "Report/StudyPage.h"

#include "Report/ChartData.h"
#include "Study/StudyChart.h"
#include "Study/StudyReport.h"
#include "Text/TextFormat.h"

namespace Drydock
{

std::string MakeStudyPageData(
	const FStudyResult& Result, const std::vector<FStudyInsetRow>& Insets, const std::string& When)
{
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "study"}, {"name", Result.Name},
		{"written", When}});
	Writer.Key("study").Raw(MakeStudyJson(Result));
	Writer.Key("timing").Raw(MakeStudyTimingJson(Result));
	Writer.Array("charts", Result.Jobs,
		[&](const FStudyJob& Job)
		{
			Writer.BeginObject();
			for (const auto& [Name, Cost] : {std::pair("time", EStudyCost::Milliseconds), {"taps", EStudyCost::Taps}})
			{
				Writer.Key(Name).BeginObject();
				for (const std::string& Metric : GetMetricNames())
				{
					Writer.Key(Metric);
					WriteChartPanel(Writer, MakeStudyPanel(Result, Job, Cost, Metric));
				}
				Writer.EndObject();
			}
			Writer.EndObject();
		});
	Writer.Array("insets", Insets,
		[&](const FStudyInsetRow& Row)
		{
			Writer.BeginObject();
			Writer.Member("title", Row.Title);
			Writer.Array("pictures", Row.Insets,
				[&](const FStudyInset& Inset)
				{
					Writer.BeginObject();
					Writer.Members(
						{{"title", Inset.Title}, {"subtitle", Inset.Subtitle}, {"png", EncodeBase64(Inset.Png)},
							{"heat", EncodeBase64(Inset.HeatPng)}, {"heatTitle", Inset.HeatTitle}});
					Writer.EndObject();
				});
			Writer.EndObject();
		});
	return Writer.GetText();
}

} // namespace Drydock
