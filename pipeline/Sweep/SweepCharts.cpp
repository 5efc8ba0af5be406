// Gathers figures by the values of an axis, and makes panels and tiles of them.
#include "Sweep/SweepCharts.h"

#include "Picture/ContactSheet.h"
#include "Picture/PictureFile.h"
#include "RangeTools.h"
#include "Sequence/SequenceSheet.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace Drydock
{

namespace
{

constexpr size_t MostLines = 8;
constexpr size_t MostPictures = 96;

/** The place of each value on the axis: its number where all values are numbers, else its index. */
std::vector<double> PlaceValues(const FSweepAxis& Axis, bool& bOutNumbers)
{
	std::vector<double> Places;
	for (const std::string& Value : Axis.Values)
	{
		const std::optional<double> Number = ParseAll<double>(Value);
		if (Number)
		{
			Places.push_back(*Number);
		}
	}
	bOutNumbers = Places.size() == Axis.Values.size() && Axis.Name != "engine";
	if (!bOutNumbers)
	{
		Places.resize(Axis.Values.size());
		std::iota(Places.begin(), Places.end(), 0.0);
	}
	return Places;
}

FChartAxis MakeAxis(const std::string& Name, const std::vector<double>& Values, const std::vector<std::string>& Names)
{
	constexpr int MaxTicks = 6;
	const auto [Least, Most] = std::ranges::minmax(Values);
	const double Room = Most > Least ? 0.05 * (Most - Least) : std::max(0.5 * std::abs(Most), 0.5);
	return MakeLinearAxis(Name, Least - Room, Most + Room, MaxTicks, Names);
}

/** The line's points by place: sums and counts, for means. */
using FSums = std::map<double, std::pair<double, int>>;

FChartPanel MakePanel(const FSweepTable& Table, size_t AxisIndex, const std::string& Figure, bool bSeconds)
{
	const FSweepAxis& Axis = Table.Plan.Axes[AxisIndex];
	bool bNumbers = false;
	const std::vector<double> Places = PlaceValues(Axis, bNumbers);
	std::map<std::string, FSums> Lines;
	std::vector<std::string> Order; // of lines, as in the plan
	std::vector<double> Values;
	for (const FSweepRow& Row : Table.Rows)
	{
		const auto Found = Row.Figures.find(Figure);
		if (!bSeconds && (Found == Row.Figures.end() || !std::isfinite(Found->second)))
		{
			continue;
		}
		const FSweepTask& Task = Table.Plan.Tasks[Row.Task];
		const size_t Index = static_cast<size_t>(
			std::ranges::find(Axis.Values, Task.Values[AxisIndex]) - Axis.Values.begin());
		FSweepTask Others = Task;
		FSweepPlan OtherAxes;
		OtherAxes.Axes = Table.Plan.Axes;
		OtherAxes.Axes.erase(OtherAxes.Axes.begin() + static_cast<std::ptrdiff_t>(AxisIndex));
		Others.Values.erase(Others.Values.begin() + static_cast<std::ptrdiff_t>(AxisIndex));
		const std::string Name = DescribeTask(OtherAxes, Others);
		AddUnique(Order, Name);
		const double Value = bSeconds ? Row.Seconds : Found->second;
		Values.push_back(Value);
		for (const std::string& Line : {Name, std::string("mean")})
		{
			auto& [Sum, Count] = Lines[Line][Places[Index]];
			Sum += Value;
			++Count;
		}
	}
	FChartPanel Panel;
	Panel.Title = Figure;
	Panel.X = MakeAxis(Axis.Name, Places, bNumbers ? std::vector<std::string>() : Axis.Values);
	Panel.Y = MakeAxis("", Values.empty() ? std::vector<double>{0.0} : Values, {});
	Panel.NumColumns = 2;
	Panel.Height = 150.0;
	Order = Order.size() > MostLines ? std::vector<std::string>{"mean"} : Order;
	for (size_t Line = 0; Line < Order.size(); ++Line)
	{
		FChartSeries Series;
		Series.Name = Order[Line];
		Series.Color = "c" + std::to_string(Line);
		for (const auto& [Place, Sum] : Lines[Order[Line]])
		{
			Series.Line.push_back({Place, Sum.first / Sum.second});
		}
		Panel.Series.push_back(std::move(Series));
	}
	return Panel;
}

} // namespace

FChart MakeSweepChart(const FSweepTable& Table, size_t Axis, bool bSeconds)
{
	FChart Chart;
	Chart.Title = (bSeconds ? "Seconds over " : "Figures over ") + Table.Plan.Axes[Axis].Name;
	if (Table.Plan.Axes[Axis].Values.size() < 2)
	{
		return Chart;
	}
	for (const std::string& Figure : bSeconds ? std::vector<std::string>{"seconds"} : Table.Figures)
	{
		Chart.Panels.push_back(MakePanel(Table, Axis, Figure, bSeconds));
	}
	if (!Chart.Panels.empty() && Chart.Panels[0].Series.size() > 1)
	{
		for (const FChartSeries& Series : Chart.Panels[0].Series)
		{
			Chart.Legend.push_back({{Series.Name, Series.Color, {}}});
		}
	}
	return Chart;
}

std::vector<size_t> ChooseSweepRows(const FSweepTable& Table)
{
	std::vector<size_t> WithPicture;
	for (size_t Row = 0; Row < Table.Rows.size(); ++Row)
	{
		if (!Table.Rows[Row].Pictures.empty())
		{
			WithPicture.push_back(Row);
		}
	}
	return ToVector<size_t>(ChooseSheetFrames(WithPicture.size(), MostPictures), [&](size_t At) { return WithPicture[At]; });
}

FImage MakeSweepSheet(const FSweepFolder& Folder, const FSweepTable& Table)
{
	constexpr size_t MostColumns = 12;
	FSheetOptions Options;
	std::vector<FSheetTile> Tiles;
	for (const size_t Index : ChooseSweepRows(Table))
	{
		const FSweepRow& Row = Table.Rows[Index];
		Tiles.push_back(
			{ScalePicture(ReadPicture((Folder.GetPath() / Row.Pictures.back().File).string()), Options.TileWidth),
				DescribeTask(Table.Plan, Table.Plan.Tasks[Row.Task])});
	}
	const size_t LastAxis = Table.Plan.Axes.empty() ? 1 : Table.Plan.Axes.back().Values.size();
	const bool bGrid = Tiles.size() == Table.Rows.size() && LastAxis > 1 && LastAxis <= MostColumns;
	Options.Columns = bGrid ? static_cast<int>(LastAxis) : 0;
	return MakeContactSheet(Tiles, Options);
}

} // namespace Drydock
