// Walks a scene's path and writes the walk as JSON.
#include "Report/WalkData.h"

#include "Blend/SettingsWalk.h"
#include "Run/FinalSettings.h"
#include "Run/RunSetup.h"
#include "Text/JsonWriter.h"

namespace Drydock
{

namespace
{

void WriteNumbers(FJsonWriter& Writer, const char* Key, const FWalkCurve& Curve, double FWalkCurve::value_type::*Member)
{
	Writer.Key(Key).BeginArray(true);
	for (const auto& Place : Curve)
	{
		Writer.Value(static_cast<float>(Place.*Member)); // shorter, and more than a chart shows
	}
	Writer.EndArray();
}

void WriteRow(FJsonWriter& Writer, const FWalkChartRow& Row)
{
	Writer.BeginObject();
	Writer.Member("name", Row.Name);
	Writer.Member("unit", Row.Unit);
	Writer.Member("steps", Row.bSteps);
	Writer.Key("valueNames").BeginArray(true);
	for (const std::string& Name : Row.ValueNames)
	{
		Writer.Value(Name);
	}
	Writer.EndArray();
	Writer.Key("lines").BeginArray();
	for (const FWalkChartLine& Line : Row.Lines)
	{
		Writer.BeginObject();
		Writer.Member("label", Line.Label);
		WriteNumbers(Writer, "values", Line.Values, &FWalkCurve::value_type::second);
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
}

} // namespace

std::string MakeWalkJson(const FWalkChart& Chart, const std::string& At)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Member("markName", Chart.MarkName);
	Writer.Member("at", At);
	Writer.Key("marks").BeginArray();
	for (const FWalkChartMark& Mark : Chart.Marks)
	{
		Writer.BeginObject(true);
		Writer.Member("distance", Mark.Distance);
		Writer.Member("label", Mark.Label);
		Writer.EndObject();
	}
	Writer.EndArray();
	const FWalkCurve First = Chart.Rows.empty() ? FWalkCurve() : Chart.Rows.front().Lines.front().Values;
	WriteNumbers(Writer, "distances", First, &FWalkCurve::value_type::first);
	Writer.Key("volumes").BeginArray();
	for (const FWalkChartVolume& Volume : Chart.Volumes)
	{
		Writer.BeginObject();
		Writer.Member("name", Volume.Name);
		Writer.Member("unbound", Volume.bUnbound);
		WriteNumbers(Writer, "weights", Volume.Weights, &FWalkCurve::value_type::second);
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Key("rows").BeginArray();
	for (const FWalkChartRow& Row : Chart.Rows)
	{
		WriteRow(Writer, Row);
	}
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

std::string MakeSceneWalkJson(const FRunOptions& Options)
{
	const FRunSetup Setup(Options);
	std::vector<FPathPoint> Points;
	try
	{
		Points = ReadScenePath(Setup.Config);
	}
	catch (const FError&)
	{
		return ""; // there is no path
	}
	const FSettingsWalk Walk =
		WalkSettings(MakeSettingsBlender(Setup.Config), Points, GetDefaultNumSteps(Points.size()), {});
	const FWalkChart Chart = MakeWalkChart(Walk, "", "frame");
	const std::optional<int>& Frame = Setup.Config.Scene.Frame;
	return Chart.Rows.empty() ? "" : MakeWalkJson(Chart, Frame ? std::to_string(*Frame) : "");
}

} // namespace Drydock
