// Writes charts as JSON. Numbers are floats: these are shorter, and more than a chart shows.
#include "Report/ChartData.h"

namespace Drydock
{

namespace
{

void WriteCurve(FJsonWriter& Writer, const char* Key, const FChartCurve& Curve)
{
	Writer.Key(Key).BeginArray(true);
	for (const auto& [X, Y] : Curve)
	{
		Writer.BeginArray(true);
		Writer.Value(static_cast<float>(X));
		Writer.Value(static_cast<float>(Y));
		Writer.EndArray();
	}
	Writer.EndArray();
}

void WriteTicks(FJsonWriter& Writer, const char* Key, const std::vector<FChartTick>& Ticks)
{
	Writer.Key(Key).BeginArray(true);
	for (const FChartTick& Tick : Ticks)
	{
		Writer.BeginObject(true);
		Writer.Member("value", static_cast<float>(Tick.Value));
		Writer.Member("text", Tick.Text);
		Writer.EndObject();
	}
	Writer.EndArray();
}

void WriteAxis(FJsonWriter& Writer, const char* Key, const FChartAxis& Axis)
{
	Writer.Key(Key).BeginObject(true);
	Writer.Member("name", Axis.Name);
	Writer.Member("log", Axis.bLog);
	Writer.Member("low", static_cast<float>(Axis.Low));
	Writer.Member("high", static_cast<float>(Axis.High));
	WriteTicks(Writer, "ticks", Axis.Ticks);
	Writer.Key("valueNames").BeginArray(true);
	for (const std::string& Name : Axis.ValueNames)
	{
		Writer.Value(Name);
	}
	Writer.EndArray();
	Writer.EndObject();
}

/** Members that say nothing are left out. */
void WritePoint(FJsonWriter& Writer, const FChartPoint& Point)
{
	Writer.BeginObject(true);
	Writer.Member("x", static_cast<float>(Point.X));
	Writer.Member("y", static_cast<float>(Point.Y));
	if (Point.Low < Point.High)
	{
		Writer.Member("low", static_cast<float>(Point.Low));
		Writer.Member("high", static_cast<float>(Point.High));
	}
	if (!Point.Label.empty())
	{
		Writer.Member("label", Point.Label);
	}
	for (const auto& [Key, bSet] : {std::pair("pale", Point.bPale), {"now", Point.bNow}, {"pick", Point.bPick}})
	{
		if (bSet)
		{
			Writer.Member(Key, true);
		}
	}
	Writer.EndObject();
}

} // namespace

void WriteChartPanel(FJsonWriter& Writer, const FChartPanel& Panel)
{
	Writer.BeginObject(true);
	Writer.Member("title", Panel.Title);
	Writer.Member("unit", Panel.Unit);
	WriteAxis(Writer, "x", Panel.X);
	WriteAxis(Writer, "y", Panel.Y);
	Writer.Member("limit", Panel.Limit);
	Writer.Key("series").BeginArray(true);
	for (const FChartSeries& Series : Panel.Series)
	{
		Writer.BeginObject(true);
		Writer.Member("name", Series.Name);
		Writer.Member("color", Series.Color);
		WriteCurve(Writer, "line", Series.Line);
		Writer.Member("steps", Series.bSteps);
		Writer.Key("points").BeginArray(true);
		for (const FChartPoint& Point : Series.Points)
		{
			WritePoint(Writer, Point);
		}
		Writer.EndArray();
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
}

void WriteChart(FJsonWriter& Writer, const FChart& Chart)
{
	Writer.BeginObject();
	Writer.Member("markName", Chart.MarkName);
	WriteTicks(Writer, "marks", Chart.Marks);
	Writer.Key("shades").BeginArray();
	for (const FChartShade& Shade : Chart.Shades)
	{
		Writer.BeginObject();
		Writer.Member("name", Shade.Name);
		Writer.Member("color", Shade.Color);
		WriteCurve(Writer, "weights", Shade.Weights);
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Key("panels").BeginArray();
	for (const FChartPanel& Panel : Chart.Panels)
	{
		WriteChartPanel(Writer, Panel);
	}
	Writer.EndArray();
	Writer.EndObject();
}

} // namespace Drydock
