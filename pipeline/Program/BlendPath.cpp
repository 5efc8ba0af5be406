// `drydock blend --path`: the settings along a path, as a table, a chart and a summary.
#include "Blend/BlendReport.h"
#include "Blend/SettingsWalk.h"
#include "Blend/WalkChart.h"
#include "Program/ProgramOutput.h"
#include "Program/SettingStory.h"
#include "Program/VerbOptions.h"
#include "Run/FinalSettings.h"
#include "Run/RunOutputs.h"
#include "Run/RunSetup.h"
#include "Text/Fmt.inl"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/TextTable.h"
#include "TextTools.h"
#include "RangeTools.h"

#include <array>
#include <filesystem>

namespace Drydock
{

namespace
{

/** The summary for a person: every point of the path with its weights. */
std::string MakeWalkSummary(const FSettingsWalk& Walk, const std::string& MarkName)
{
	std::vector<std::vector<std::string>> Rows = {{MarkName, "cm"}};
	Rows[0].insert(Rows[0].end(), Walk.Volumes.begin(), Walk.Volumes.end());
	for (const FWalkSample& Sample : Walk.Samples)
	{
		if (Sample.Point < 0)
		{
			continue;
		}
		Rows.push_back({Walk.Points[static_cast<size_t>(Sample.Point)].Label, fmt::format("{:.1f}", Sample.Distance)});
		for (const float Weight : Sample.Weights)
		{
			Rows.back().push_back(fmt::format("{:.4f}", static_cast<double>(Weight)));
		}
	}
	std::vector<FTextColumn> Columns;
	for (int Column = 0; Column < static_cast<int>(Rows[0].size()); ++Column)
	{
		Columns.push_back({ETextColumn::Number, Column < 2 ? 0 : Column}); // without room, the last volumes go first
	}
	return FTextTable{Columns, Rows}.Format(GetOutputWidth());
}

std::vector<std::string> GetNames(const FSettingsWalk& Walk)
{
	return ToVector<std::string>(Walk.Settings, [&](const size_t Index) { return GetSettingFields()[Index].Name; });
}

std::string ListSettings(const FSettingsWalk& Walk)
{
	const std::string Text = JoinText(GetNames(Walk));
	return Text.empty() ? "no setting changes on the way" : Text;
}

/** {csv, svg, settings: [names], points: [{point, distance, location, weights: {volume: weight}}]} */
std::string MakeWalkJson(const FSettingsWalk& Walk, const std::string& Csv, const std::string& Svg)
{
	FJsonWriter Writer('{');
	Writer.Members({{"csv", Csv}, {"svg", Svg}, {"settings", GetNames(Walk)}});
	Writer.Array("points", Walk.Samples,
		[&](const FWalkSample& Sample)
		{
			if (Sample.Point < 0)
			{
				return;
			}
			Writer.BeginObject(true);
			Writer.Members(
				{{"point", Walk.Points[static_cast<size_t>(Sample.Point)].Label}, {"distance", Sample.Distance},
					{"location", std::array{Sample.Location.X, Sample.Location.Y, Sample.Location.Z}}});
			Writer.Key("weights").BeginObject(true);
			for (size_t Volume = 0; Volume < Walk.Volumes.size(); ++Volume)
			{
				Writer.Member(Walk.Volumes[Volume], Sample.Weights[Volume]);
			}
			Writer.EndObject();
			Writer.EndObject();
		});
	return Writer.GetText();
}

} // namespace

int WalkAlongPath(const FBlendOptions& Options)
{
	const std::vector<size_t> Chosen = Options.Names.empty() ? std::vector<size_t>() : FindSettings(Options.Names);
	const FRunSetup Setup(Options.Run);
	PrintDiagnostics(Setup.Diagnostics);
	const bool bScene = Options.Path == "scene";
	const std::vector<FPathPoint> Points = bScene ? ReadScenePath(Setup.Config) : LoadPath(Options.Path);
	const FSettingsWalk Walk = WalkSettings(
		MakeSettingsBlender(Setup.Config), Points, Options.Steps.value_or(GetDefaultNumSteps(Points.size())), Chosen);
	const std::string MarkName = bScene ? "frame" : "point";
	const std::string Title = "Settings along the path: " + std::filesystem::path(Setup.Config.File).stem().string();
	const std::string Folder = ChooseOutputFolder(Options.OutputFolder, Options.Run);
	const std::string Csv = (std::filesystem::path(Folder) / "walk.csv").string();
	const std::string Svg = (std::filesystem::path(Folder) / "walk.svg").string();
	WriteTextFile(Csv, MakeWalkCsv(Walk));
	WriteTextFile(Svg, DrawChart(MakeWalkChart(Walk, Title, MarkName)));
	const std::string Text = Options.bJson ? MakeWalkJson(Walk, Csv, Svg)
										   : fmt::format("{}\nsettings  {}\ntable     {}\nchart     {}\n",
												 MakeWalkSummary(Walk, MarkName), ListSettings(Walk), Csv, Svg);
	PrintResult(Text, Options.bJson);
	return ExitDone;
}

} // namespace Drydock
