// Walks a scene's path and writes the walk as JSON.
#include "Report/WalkData.h"

#include "Blend/SettingsWalk.h"
#include "Blend/WalkChart.h"
#include "Report/ChartData.h"
#include "Run/FinalSettings.h"
#include "Run/RunSetup.h"

namespace Drydock
{

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
	const FChart Chart = MakeWalkChart(Walk, "", "frame");
	if (Chart.Panels.size() == Walk.Volumes.size())
	{
		return ""; // no setting changes
	}
	const std::optional<int>& Frame = Setup.Config.Scene.Frame;
	FJsonWriter Writer('{');
	Writer.Member("at", Frame ? std::to_string(*Frame) : "");
	Writer.Key("chart");
	WriteChart(Writer, Chart);
	return Writer.GetText();
}

} // namespace Drydock
