// Turns a walk into what its chart shows.
#include "Blend/SettingsWalk.h"
#include "Blend/WalkChart.h"
#include "Text/Fmt.inl"

#include <charconv>

namespace Drydock
{

namespace
{

std::string LengthText(double Length)
{
	char Buffer[64];
	return std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Length, std::chars_format::fixed, 1).ptr);
}

bool CanBeDrawn(const FSettingField& Field)
{
	return Field.Type != ESettingType::Object && Field.Type != ESettingType::ColorArray;
}

FWalkChartRow MakeRow(const FSettingsWalk& Walk, size_t Setting)
{
	const FSettingField& Field = GetSettingFields()[Walk.Settings[Setting]];
	FWalkChartRow Row;
	Row.Name = Field.Name;
	Row.Unit = Field.Unit;
	Row.bSteps = !Field.bInterpolates;
	for (const char* Name : Field.EnumNames)
	{
		Row.ValueNames.emplace_back(Name);
	}
	if (Field.Type == ESettingType::Bool)
	{
		Row.ValueNames = {"false", "true"};
	}
	const std::vector<std::string> Components = GetComponentNames(Field);
	for (size_t Component = 0; Component < Components.size(); ++Component)
	{
		FWalkChartLine Line;
		Line.Label = Components[Component].substr(Components[Component].empty() ? 0 : 1);
		for (const FWalkSample& Sample : Walk.Samples)
		{
			Line.Values.emplace_back(Sample.Distance, Sample.Values[Setting].Components[Component]);
		}
		Row.Lines.push_back(std::move(Line));
	}
	return Row;
}

} // namespace

FWalkChart MakeWalkChart(const FSettingsWalk& Walk, const std::string& Title, const std::string& MarkName)
{
	FWalkChart Chart;
	Chart.Title = Title;
	Chart.MarkName = MarkName;
	Chart.Length = Walk.Samples.empty() ? 0.0 : Walk.Samples.back().Distance;
	for (const FWalkSample& Sample : Walk.Samples)
	{
		if (Sample.Point >= 0)
		{
			Chart.Marks.push_back({Sample.Distance, Walk.Points[static_cast<size_t>(Sample.Point)].Label});
		}
	}
	for (size_t Volume = 0; Volume < Walk.Volumes.size(); ++Volume)
	{
		FWalkChartVolume Lane{Walk.Volumes[Volume], Walk.Unbound[Volume], {}};
		for (const FWalkSample& Sample : Walk.Samples)
		{
			Lane.Weights.emplace_back(Sample.Distance, static_cast<double>(Sample.Weights[Volume]));
		}
		Chart.Volumes.push_back(std::move(Lane));
	}
	for (size_t Setting = 0; Setting < Walk.Settings.size(); ++Setting)
	{
		if (CanBeDrawn(GetSettingFields()[Walk.Settings[Setting]]))
		{
			Chart.Rows.push_back(MakeRow(Walk, Setting));
		}
	}
	Chart.Subtitle = fmt::format("{} {}s, {} cm, {} {}", Walk.Points.size(), MarkName, LengthText(Chart.Length),
		Chart.Rows.size(), Chart.Rows.size() == 1 ? "setting" : "settings");
	return Chart;
}

} // namespace Drydock
