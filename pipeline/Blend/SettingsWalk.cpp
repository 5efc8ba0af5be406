// Samples the settings along a path and writes them as a table.
#include "Blend/SettingsWalk.h"

#include "PostProcessVolumeWeight.h"
#include "Text/TextFormat.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

double GetLength(const FVector& A, const FVector& B)
{
	return std::sqrt((B.X - A.X) * (B.X - A.X) + (B.Y - A.Y) * (B.Y - A.Y) + (B.Z - A.Z) * (B.Z - A.Z));
}

/** Places and distances only. */
std::vector<FWalkSample> MakeSamples(const std::vector<FPathPoint>& Points, int NumSteps)
{
	std::vector<FWalkSample> Samples;
	double Walked = 0.0;
	for (size_t Index = 0; Index < Points.size(); ++Index)
	{
		FWalkSample Sample;
		Sample.Distance = Walked;
		Sample.Location = Points[Index].Location;
		Sample.Point = static_cast<int>(Index);
		Samples.push_back(Sample);
		if (Index + 1 == Points.size())
		{
			break;
		}
		const FVector& From = Points[Index].Location;
		const FVector& To = Points[Index + 1].Location;
		const double Length = GetLength(From, To);
		Sample.Point = -1;
		for (int Step = 1; Step <= NumSteps; ++Step)
		{
			const double Part = static_cast<double>(Step) / (NumSteps + 1);
			Sample.Distance = Walked + Length * Part;
			Sample.Location = FVector(
				From.X + (To.X - From.X) * Part, From.Y + (To.Y - From.Y) * Part, From.Z + (To.Z - From.Z) * Part);
			Samples.push_back(Sample);
		}
		Walked += Length;
	}
	return Samples;
}

float GetVolumeWeight(const APostProcessVolume& Volume, const FVector& Location)
{
	return GetInfluence(Volume.GetProperties(), Volume.bUnbound ? 0.0 : Volume.Shape.GetDistance(Location)).Weight;
}

/** Only flags are kept of the values: a walk may have many samples, and the table has many settings. */
std::vector<size_t> FindChanging(const FSettingsBlender& Blender, const std::vector<FWalkSample>& Samples)
{
	const std::vector<FSettingField>& Fields = GetSettingFields();
	const FBlendedSettings First = Blender.At(Samples.front().Location);
	std::vector<bool> Changes(Fields.size(), false);
	for (const FWalkSample& Sample : Samples)
	{
		const FBlendedSettings Here = Blender.At(Sample.Location);
		for (size_t Index = 0; Index < Fields.size(); ++Index)
		{
			Changes[Index] = Changes[Index] || Fields[Index].Get(Here.Settings) != Fields[Index].Get(First.Settings);
		}
	}
	std::vector<size_t> Changing;
	for (size_t Index = 0; Index < Fields.size(); ++Index)
	{
		if (Changes[Index])
		{
			Changing.push_back(Index);
		}
	}
	return Changing;
}

std::string ValueText(const FSettingField& Field, const FSettingValue& Value, size_t Component)
{
	const bool bNumbers = Field.Type != ESettingType::Bool && Field.Type != ESettingType::Enum &&
						  Field.Type != ESettingType::Object && Field.Type != ESettingType::Int;
	return bNumbers ? NumberText(static_cast<float>(Value.Components[Component]))
					: CsvText(SettingToText(Field, Value));
}

} // namespace

int GetDefaultNumSteps(size_t NumPoints)
{
	constexpr size_t NumSamples = 240;
	const size_t NumSegments = std::max<size_t>(NumPoints, 2) - 1;
	return static_cast<int>((NumSamples + NumSegments - 1) / NumSegments);
}

FSettingsWalk WalkSettings(const FSettingsBlender& Blender, const std::vector<FPathPoint>& Points, int NumSteps,
	const std::vector<size_t>& Settings)
{
	FSettingsWalk Walk;
	Walk.Points = Points;
	const std::vector<APostProcessVolume>& Volumes = Blender.GetInputs().Volumes;
	for (const APostProcessVolume& Volume : Volumes)
	{
		Walk.Volumes.emplace_back(*Volume.Name);
		Walk.Unbound.push_back(Volume.bUnbound);
	}
	Walk.Samples = MakeSamples(Points, NumSteps);
	Walk.Settings = Settings.empty() ? FindChanging(Blender, Walk.Samples) : Settings;
	for (FWalkSample& Sample : Walk.Samples)
	{
		for (const APostProcessVolume& Volume : Volumes)
		{
			Sample.Weights.push_back(GetVolumeWeight(Volume, Sample.Location));
		}
		const FBlendedSettings Blended = Blender.At(Sample.Location);
		for (const size_t Index : Walk.Settings)
		{
			Sample.Values.push_back(GetSettingFields()[Index].Get(Blended.Settings));
		}
	}
	return Walk;
}

std::vector<std::string> GetComponentNames(const FSettingField& Field)
{
	switch (Field.Type)
	{
	case ESettingType::Color:
		return {".R", ".G", ".B", ".A"};
	case ESettingType::Vector2:
		return {".X", ".Y"};
	case ESettingType::Vector4:
		return {".X", ".Y", ".Z", ".W"};
	case ESettingType::ColorArray:
	{
		std::vector<std::string> Names;
		for (int32 Index = 0; Index < Field.GetNumComponents(); ++Index)
		{
			Names.push_back("[" + std::to_string(Index / 4) + "]." + "RGBA"[Index % 4]);
		}
		return Names;
	}
	default:
		return {""};
	}
}

std::string MakeWalkCsv(const FSettingsWalk& Walk)
{
	std::string Csv = "distance_cm,x,y,z,point";
	for (const std::string& Volume : Walk.Volumes)
	{
		Csv += "," + CsvText("weight:" + Volume);
	}
	for (const size_t Index : Walk.Settings)
	{
		for (const std::string& Component : GetComponentNames(GetSettingFields()[Index]))
		{
			Csv += "," + std::string(GetSettingFields()[Index].Name) + Component;
		}
	}
	Csv += "\n";
	for (const FWalkSample& Sample : Walk.Samples)
	{
		Csv += NumberText(Sample.Distance) + "," + NumberText(Sample.Location.X) + "," + NumberText(Sample.Location.Y) +
			   "," + NumberText(Sample.Location.Z) + ",";
		Csv += Sample.Point >= 0 ? Walk.Points[static_cast<size_t>(Sample.Point)].Label : "";
		for (const float Weight : Sample.Weights)
		{
			Csv += "," + NumberText(Weight);
		}
		for (size_t Setting = 0; Setting < Walk.Settings.size(); ++Setting)
		{
			const FSettingField& Field = GetSettingFields()[Walk.Settings[Setting]];
			const size_t NumComponents = GetComponentNames(Field).size();
			for (size_t Component = 0; Component < NumComponents; ++Component)
			{
				Csv += "," + ValueText(Field, Sample.Values[Setting], Component);
			}
		}
		Csv += "\n";
	}
	return Csv;
}

} // namespace Drydock
