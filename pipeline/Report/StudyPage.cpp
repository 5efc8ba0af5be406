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
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("format", "drydock-report");
	Writer.Member("formatVersion", 1);
	Writer.Member("kind", "study");
	Writer.Member("name", Result.Name);
	Writer.Member("written", When);
	Writer.Key("study").Raw(MakeStudyJson(Result));
	Writer.Key("timing").Raw(MakeStudyTimingJson(Result));
	Writer.Key("charts").BeginArray();
	for (const FStudyJob& Job : Result.Jobs)
	{
		Writer.BeginObject();
		for (const auto& [Name, Cost] : {std::pair("time", EStudyCost::Milliseconds), {"taps", EStudyCost::Taps}})
		{
			Writer.Key(Name).BeginObject();
			for (const char* Metric : {"max", "rms", "relative", "psnr", "ssim"})
			{
				Writer.Key(Metric);
				WriteChartPanel(Writer, MakeStudyPanel(Result, Job, Cost, Metric));
			}
			Writer.EndObject();
		}
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Key("insets").BeginArray();
	for (const FStudyInsetRow& Row : Insets)
	{
		Writer.BeginObject();
		Writer.Member("title", Row.Title);
		Writer.Key("pictures").BeginArray();
		for (const FStudyInset& Inset : Row.Insets)
		{
			Writer.BeginObject();
			Writer.Member("title", Inset.Title);
			Writer.Member("subtitle", Inset.Subtitle);
			Writer.Member("png", EncodeBase64(Inset.Png));
			Writer.Member("heat", EncodeBase64(Inset.HeatPng));
			Writer.Member("heatTitle", Inset.HeatTitle);
			Writer.EndObject();
		}
		Writer.EndArray();
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
