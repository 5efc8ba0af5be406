// Writes the outputs of a sweep in place of earlier ones.
#include "Sweep/SweepReduce.h"

#include "Picture/ContactSheet.h"
#include "Picture/ImageFile.h"
#include "Picture/PictureFile.h"
#include "RangeTools.h"
#include "Report/ChartData.h"
#include "Report/ReportPage.h"
#include "Report/ReportPng.h"
#include "Sweep/SweepCharts.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "Text/Version.h"

#include <ctime>
#include <numeric>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

std::string NamePlot(const FSweepAxis& Axis)
{
	return MakeFileNamePart(Axis.Name) + ".svg";
}

FOutputNames MakeReduceOutputNames(const FSweepPlan& Plan)
{
	FOutputNames Names = {.Name = "sweep",
		.Files = {"table.json", "table.csv", "timing.csv", "sheet.png", "sweep.html"},
		.Last = "table.json",
		.Folders = {"plots", "timing"},
		.Unsteady = {"timing.csv", "sweep.html"}};
	for (const FSweepAxis& Axis : Plan.Axes)
	{
		Names.Unsteady.insert("timing/" + NamePlot(Axis));
	}
	return Names;
}

FReportPicture MakeCellPicture(const FSweepFolder& Folder, const FSweepTable& Table, size_t Index)
{
	constexpr int MaxWidth = 480;
	const FSweepRow& Row = Table.Rows[Index];
	const FSweepTask& Task = Table.Plan.Tasks[Row.Task];
	const FImage Image = ReadPicture((Folder.GetPath() / Row.Pictures.back().File).string());
	FReportPicture Picture;
	Picture.Id = std::to_string(Index); // hashes of two tasks may be the same
	Picture.Role = "frame";
	Picture.Label = DescribeTask(Table.Plan, Task);
	Picture.Extent = Picture.Size = {Image.Width, Image.Height};
	Picture.Channels = {"R", "G", "B"};
	Picture.Png = MakePng(Image.Width > MaxWidth ? ScalePicture(Image, MaxWidth) : Image, true);
	return Picture;
}

} // namespace

std::string MakeSweepPageData(const FSweepFolder& Folder, const FSweepTable& Table, const std::string& When)
{
	std::vector<FReportPicture> Pictures = ToVector<FReportPicture>(
		ChooseSweepRows(Table), [&](size_t Row) { return MakeCellPicture(Folder, Table, Row); });
	std::vector<size_t> All(Pictures.size());
	std::iota(All.begin(), All.end(), 0);
	FitPictures(Pictures, {All}, MaxPagePictureBytes);
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "sweep"},
		{"name", Files::path(Table.Plan.Config).stem().string()}, {"version", GetVersion()}, {"written", When}});
	Writer.Key("sweep").Raw(MakeSweepTableJson(Table));
	Writer.Member("seconds", ToVector<double>(Table.Rows, &FSweepRow::Seconds));
	Writer.Key("charts").BeginArray();
	for (size_t Axis = 0; Axis < Table.Plan.Axes.size(); ++Axis)
	{
		FChart Chart = MakeSweepChart(Table, Axis, false);
		const FChart Times = MakeSweepChart(Table, Axis, true);
		Chart.Panels.insert(Chart.Panels.end(), Times.Panels.begin(), Times.Panels.end());
		Writer.BeginObject();
		Writer.Member("axis", Table.Plan.Axes[Axis].Name);
		Writer.Array("panels", Chart.Panels, [&](const FChartPanel& Panel) { WriteChartPanel(Writer, Panel); });
		Writer.EndObject();
	}
	Writer.EndArray();
	WriteReportPictures(Writer, Pictures);
	return Writer.GetText();
}

FSweepTable ReduceSweep(const FSweepFolder& Folder, bool bPage)
{
	const FSweepPlan Plan = Folder.ReadPlan();
	const FSweepTable Table = MakeSweepTable(Folder, Plan);
	FOutputFolder Output(Folder.GetPath(), MakeReduceOutputNames(Plan));
	const auto Write = [&](const Files::path& Name, const std::string& Text)
	{
		std::error_code Ignored;
		Files::create_directories((Output.GetAside() / Name).parent_path(), Ignored);
		WriteWholeFile((Output.GetAside() / Name).string(), Text);
	};
	Write("table.json", MakeSweepTableJson(Table));
	Write("table.csv", MakeSweepCsv(Table, false));
	Write("timing.csv", MakeSweepCsv(Table, true));
	WritePng((Output.GetAside() / "sheet.png").string(), MakeSweepSheet(Folder, Table), EPngEffort::Small);
	for (size_t Axis = 0; Axis < Plan.Axes.size(); ++Axis)
	{
		for (const bool bSeconds : {false, true})
		{
			const FChart Chart = MakeSweepChart(Table, Axis, bSeconds);
			if (!Chart.Panels.empty())
			{
				Write(Files::path(bSeconds ? "timing" : "plots") / NamePlot(Plan.Axes[Axis]), DrawChart(Chart));
			}
		}
	}
	if (bPage)
	{
		Write("sweep.html", MakeReportPage(MakeSweepPageData(Folder, Table, FormatReportTime(std::time(nullptr)))));
	}
	Output.PutInPlace();
	return Table;
}

} // namespace Drydock
