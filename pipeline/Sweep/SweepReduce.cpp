// Draws figures over axes, puts pictures side by side, and writes all outputs in place of earlier ones.
#include "Sweep/SweepReduce.h"

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "RangeTools.h"
#include "Report/ChartData.h"
#include "Report/ReportPage.h"
#include "Report/ReportPng.h"
#include "Sequence/SequenceSheet.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"
#include "Text/Version.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** A row whose last picture is shown. */
struct FSweepTile
{
	size_t Row = 0;
	std::string Label;
	FImage Picture; // no wider than a page has it
};

/** The pictures of all rows, or of evenly chosen ones. */
std::vector<FSweepTile> ReadTiles(const FSweepFolder& Folder, const FSweepPlan& Plan, const FSweepTable& Table)
{
	constexpr size_t MostTiles = 96;
	constexpr int MostWidth = 480;
	std::vector<FSweepTile> Tiles;
	for (const size_t Row : ChooseSheetFrames(Table.Rows.size(), MostTiles))
	{
		if (!Table.Rows[Row].Pictures.empty())
		{
			const FImage Picture = ReadPicture(Folder.GetPath() / Table.Rows[Row].Pictures.back().File);
			Tiles.push_back({Row, DescribeTask(Plan, *Table.Rows[Row].Task),
				Picture.Width > MostWidth ? ScalePicture(Picture, MostWidth) : Picture});
		}
	}
	return Tiles;
}

FImage MakeSheet(const FSweepPlan& Plan, const FSweepTable& Table, const std::vector<FSweepTile>& Tiles)
{
	constexpr size_t MostColumns = 12;
	const size_t NumColumns = Plan.Axes.back().Values.size();
	const bool bGrid = Tiles.size() == Table.Rows.size() && NumColumns <= MostColumns && Tiles.size() % NumColumns == 0;
	FSheetOptions Options;
	Options.Columns = bGrid ? int(NumColumns) : 0;
	return MakeContactSheet(ToVector<FSheetTile>(Tiles,
								[](const FSweepTile& Tile) {
									return FSheetTile{Tile.Picture, Tile.Label};
								}),
		Options);
}

FChartAxis MakeAxis(
	const std::string& Name, const std::vector<double>& Values, const std::vector<std::string>& Names = {})
{
	constexpr int MostTicks = 6;
	const auto [Least, Most] = std::ranges::minmax(Values);
	const double Room = Most > Least ? 0.05 * (Most - Least) : std::max(0.5 * std::abs(Most), 0.5);
	return MakeLinearAxis(Name, Least - Room, Most + Room, MostTicks, Names);
}

/** The places of the values on the axis: their numbers where all are numbers, else 0, 1, 2, ... */
std::vector<double> PlaceValues(const FSweepAxis& Axis, bool& bOutNumbers)
{
	std::vector<double> Places(Axis.Values.size());
	std::iota(Places.begin(), Places.end(), 0.0);
	bOutNumbers = Axis.Name != "engine" && std::ranges::all_of(Axis.Values, [](const std::string& Value)
											   { return ParseAll<double>(Value).has_value(); });
	return bOutNumbers
			   ? ToVector<double>(Axis.Values, [](const std::string& Value) { return *ParseAll<double>(Value); })
			   : Places;
}

std::string MakePageData(
	const FSweepPlan& Plan, const FSweepTable& Table, const std::vector<FSweepTile>& Tiles, const std::string& When)
{
	auto Pictures = ToVector<FReportPicture>(Tiles,
		[](const FSweepTile& Tile)
		{
			const std::array<int, 2> Size = {Tile.Picture.Width, Tile.Picture.Height};
			return FReportPicture{.Id = std::to_string(Tile.Row),
				.Role = "frame",
				.Label = Tile.Label,
				.Extent = Size,
				.Size = Size,
				.Channels = {"R", "G", "B"},
				.Png = MakePng(Tile.Picture, true)};
		});
	std::vector<size_t> All(Pictures.size());
	std::iota(All.begin(), All.end(), 0);
	FitPictures(Pictures, {All}, MaxPagePictureBytes);
	FJsonWriter Writer('{');
	Writer.Members({{"format", "drydock-report"}, {"formatVersion", 1}, {"kind", "sweep"},
		{"name", Files::path(Plan.Config).stem().string()}, {"version", GetVersion()}, {"written", When}});
	Writer.Key("sweep").Raw(MakeSweepTableJson(Plan, Table));
	Writer.Member("seconds", ToVector<double>(Table.Rows, &FSweepRow::Seconds));
	Writer.Key("plots").BeginArray();
	for (size_t Axis = 0; Axis < Plan.Axes.size(); ++Axis)
	{
		Writer.BeginObject();
		Writer.Member("axis", Plan.Axes[Axis].Name);
		Writer.Array("panels", MakeSweepPanels(Plan, Table, Axis),
			[&](const FChartPanel& Panel) { WriteChartPanel(Writer, Panel); });
		Writer.EndObject();
	}
	Writer.EndArray();
	WriteReportPictures(Writer, Pictures);
	return Writer.GetText();
}

} // namespace

std::vector<FChartPanel> MakeSweepPanels(const FSweepPlan& Plan, const FSweepTable& Table, size_t Axis)
{
	constexpr size_t MostLines = 8;
	const std::string Mean = "mean";
	bool bNumbers = false;
	const std::vector<double> Places = PlaceValues(Plan.Axes[Axis], bNumbers);
	std::vector<std::string> Lines;
	std::ranges::for_each(
		Table.Rows, [&](const FSweepRow& Row) { AddUnique(Lines, DescribeTask(Plan, *Row.Task, int(Axis))); });
	Lines = Lines.size() > MostLines ? std::vector<std::string>{Mean} : Lines;
	std::vector<FChartPanel> Panels;
	for (const std::string& Figure : Places.size() > 1 ? Table.Figures : std::vector<std::string>())
	{
		std::map<std::string, std::map<double, std::pair<double, double>>> Sums; // and counts, by line and place
		std::vector<double> Values;
		for (const FSweepRow& Row : Table.Rows)
		{
			const auto Found = Row.Figures.find(Figure);
			if (Found != Row.Figures.end() && std::isfinite(Found->second))
			{
				const auto& Labels = Plan.Axes[Axis].Values;
				const auto Index = std::ranges::find(Labels, Row.Task->Values[Axis]) - Labels.begin();
				const std::string Line = Lines[0] == Mean ? Mean : DescribeTask(Plan, *Row.Task, int(Axis));
				auto& [Sum, Count] = Sums[Line][Places[size_t(Index)]];
				Sum += Found->second;
				Count += 1.0;
				Values.push_back(Found->second);
			}
		}
		if (Values.empty())
		{
			continue;
		}
		FChartPanel Panel;
		Panel.Title = Figure;
		Panel.NumColumns = 2;
		Panel.Height = 150.0;
		Panel.X =
			MakeAxis(Plan.Axes[Axis].Name, Places, bNumbers ? std::vector<std::string>() : Plan.Axes[Axis].Values);
		Panel.Y = MakeAxis("", Values);
		for (size_t Line = 0; Line < Lines.size(); ++Line)
		{
			FChartSeries Series;
			Series.Name = Lines[Line];
			Series.Color = "c" + std::to_string(Line);
			for (const auto& [Place, Sum] : Sums[Lines[Line]])
			{
				Series.Line.push_back({Place, Sum.first / Sum.second});
			}
			Panel.Series.push_back(std::move(Series));
		}
		Panels.push_back(std::move(Panel));
	}
	return Panels;
}

std::vector<std::string> ReduceSweep(const FSweepFolder& Folder, bool bPage)
{
	const FSweepPlan Plan = Folder.ReadPlan();
	const FSweepTable Table = MakeSweepTable(Folder, Plan);
	const FOutputNames Names = {.Name = "sweep",
		.Files = {"table.json", "table.csv", "timing.csv", "sheet.png", "sweep.html"},
		.Last = "table.json",
		.Folders = {"plots"},
		.Unsteady = {"timing.csv", "sweep.html"}};
	FOutputFolder Output(Folder.GetPath(), Names);
	const std::vector<FSweepTile> Tiles = ReadTiles(Folder, Plan, Table);
	WriteWholeFile(Output.GetAside() / "table.json", MakeSweepTableJson(Plan, Table));
	WriteWholeFile(Output.GetAside() / "table.csv", MakeSweepCsv(Plan, Table, false));
	WriteWholeFile(Output.GetAside() / "timing.csv", MakeSweepCsv(Plan, Table, true));
	if (!Tiles.empty())
	{
		WritePng(Output.GetAside() / "sheet.png", MakeSheet(Plan, Table, Tiles), EPngEffort::Small);
	}
	Files::create_directory(Output.GetAside() / "plots");
	for (size_t Axis = 0; Axis < Plan.Axes.size(); ++Axis)
	{
		FChart Chart;
		Chart.Title = "Figures over " + Plan.Axes[Axis].Name;
		Chart.Panels = MakeSweepPanels(Plan, Table, Axis);
		const size_t NumLines = Chart.Panels.empty() ? 0 : Chart.Panels[0].Series.size();
		for (size_t Line = 0; NumLines > 1 && Line < NumLines; ++Line)
		{
			const FChartSeries& Series = Chart.Panels[0].Series[Line];
			Chart.Legend.push_back({{Series.Name, Series.Color, {}}});
		}
		if (NumLines > 0)
		{
			WriteWholeFile(
				Output.GetAside() / "plots" / (MakeFileNamePart(Plan.Axes[Axis].Name) + ".svg"), DrawChart(Chart));
		}
	}
	if (bPage)
	{
		WriteWholeFile(Output.GetAside() / "sweep.html",
			MakeReportPage(MakePageData(Plan, Table, Tiles, FormatReportTime(std::time(nullptr)))));
	}
	Output.PutInPlace();
	return Table.Notes;
}

} // namespace Drydock
