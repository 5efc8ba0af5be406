// Turns a walk into its chart.
#include "Blend/WalkChart.h"

#include "Blend/SettingsWalk.h"
#include "Picture/SvgTools.h"
#include "Text/Fmt.inl"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

bool CanBeDrawn(const FSettingField& Field)
{
	return Field.Type != ESettingType::Object && Field.Type != ESettingType::ColorArray;
}

/** A volume's lane: its weight as height. */
FChartPanel MakeLane(
	const FChartAxis& X, const std::string& Volume, const std::string& Color, const FChartCurve& Weights)
{
	constexpr size_t MostCharacters = 17;
	FChartPanel Panel;
	Panel.Height = 14.0;
	Panel.X = X;
	Panel.Y.Ticks = {{0.5, ShortenText(Volume, MostCharacters)}};
	Panel.Series = {{Volume, Color, Weights, false, true, {}}};
	return Panel;
}

/** One component of a setting along the path, with a dot at each of its points. */
FChartSeries MakeSeries(
	const FSettingsWalk& Walk, size_t Setting, size_t Component, const FChartAxis& Y, const std::string& MarkName)
{
	FChartSeries Series;
	for (const FWalkSample& Sample : Walk.Samples)
	{
		const double Value = Sample.Values[Setting].Components[Component];
		Series.Line.emplace_back(Sample.Distance, Value);
		if (Sample.Point >= 0)
		{
			const std::string& Label = Walk.Points[static_cast<size_t>(Sample.Point)].Label;
			Series.Points.push_back(
				{.X = Sample.Distance, .Y = Value, .Tip = MarkName + " " + Label + ": " + Y.NameValue(Value)});
		}
	}
	return Series;
}

FChartPanel MakePanel(const FSettingsWalk& Walk, size_t Setting, const FChartAxis& X, const std::string& MarkName)
{
	const FSettingField& Field = GetSettingFields()[Walk.Settings[Setting]];
	std::vector<std::string> ValueNames(Field.EnumNames.begin(), Field.EnumNames.end());
	if (Field.Type == ESettingType::Bool)
	{
		ValueNames = {"false", "true"};
	}
	const std::vector<std::string> Components = GetComponentNames(Field);
	double Low = HUGE_VAL;
	double High = -HUGE_VAL;
	for (const FWalkSample& Sample : Walk.Samples)
	{
		for (size_t Component = 0; Component < Components.size(); ++Component)
		{
			const double Value = Sample.Values[Setting].Components[Component];
			Low = std::min(Low, Value);
			High = std::max(High, Value);
		}
	}
	FChartPanel Panel;
	Panel.Title = Field.Name;
	Panel.Unit = Field.Unit;
	Panel.Height = 92.0;
	Panel.bShaded = true;
	Panel.X = X;
	if (!(Low <= High) || !std::isfinite(High - Low))
	{
		return Panel;
	}
	const double Room = High > Low ? 0.1 * (High - Low) : std::max(0.1 * std::abs(High), 0.5);
	Panel.Y = MakeLinearAxis("", Low - Room, High + Room, 5, ValueNames);
	for (size_t Component = 0; Component < Components.size(); ++Component)
	{
		static const char* const Colors[] = {"red", "green", "blue", "grey"};
		FChartSeries& Series = Panel.Series.emplace_back(MakeSeries(Walk, Setting, Component, Panel.Y, MarkName));
		Series.Name = Components[Component].substr(Components[Component].empty() ? 0 : 1);
		Series.Color = Components.size() > 1 ? Colors[Component % 4] : "ink";
		Series.bSteps = !Field.bInterpolates;
	}
	const FChartCurve& Line = Panel.Series[0].Line;
	if (Components.size() == 1 && Line.front().second != Line.back().second)
	{
		Panel.Aside = Panel.Y.NameValue(Line.front().second) + " \u2192 " + Panel.Y.NameValue(Line.back().second);
	}
	return Panel;
}

} // namespace

FChart MakeWalkChart(const FSettingsWalk& Walk, const std::string& Title, const std::string& MarkName)
{
	constexpr size_t NumColors = 6;
	const double Length = Walk.Samples.empty() ? 0.0 : Walk.Samples.back().Distance;
	FChart Chart;
	Chart.Title = Title;
	Chart.MarkName = MarkName;
	Chart.AxisRoom = 126.0;
	for (const FWalkSample& Sample : Walk.Samples)
	{
		if (Sample.Point >= 0)
		{
			Chart.Marks.push_back({Sample.Distance, Walk.Points[static_cast<size_t>(Sample.Point)].Label});
		}
	}
	FChartAxis X = MakeLinearAxis("", 0.0, Length > 0.0 ? Length : 1.0, 8);
	for (size_t Volume = 0; Volume < Walk.Volumes.size(); ++Volume)
	{
		FChartCurve Weights;
		for (const FWalkSample& Sample : Walk.Samples)
		{
			Weights.emplace_back(Sample.Distance, static_cast<double>(Sample.Weights[Volume]));
		}
		// A volume that acts everywhere has a lane, but no shade.
		const std::string Color = Walk.Unbound[Volume] ? "grey" : "c" + std::to_string(Chart.Shades.size() % NumColors);
		Chart.Panels.push_back(MakeLane(X, Walk.Volumes[Volume], Color, Weights));
		if (!Walk.Unbound[Volume])
		{
			Chart.Shades.push_back({Walk.Volumes[Volume], Color, std::move(Weights)});
		}
	}
	size_t NumSettings = 0;
	for (size_t Setting = 0; Setting < Walk.Settings.size(); ++Setting)
	{
		if (CanBeDrawn(GetSettingFields()[Walk.Settings[Setting]]))
		{
			Chart.Panels.push_back(MakePanel(Walk, Setting, X, MarkName));
			++NumSettings;
		}
	}
	if (!Chart.Panels.empty())
	{
		Chart.Panels.back().X.Name = "distance along the path, cm";
	}
	Chart.Notes = {fmt::format("{} {}s, {:.1f} cm, {} {}", Walk.Points.size(), MarkName, Length, NumSettings,
		NumSettings == 1 ? "setting" : "settings")};
	return Chart;
}

} // namespace Drydock
