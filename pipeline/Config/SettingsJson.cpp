// Writes volumes of engine text as a config has them, and back.
#include "Config/SettingsJson.h"

#include "PostProcessSettingsReflection.h"
#include "SettingObjects.h"

#include <algorithm>

namespace Drydock
{

namespace
{

void WriteBox(FJsonWriter& Writer, const FVolumeTextBox& Box)
{
	Writer.Key("bounds").BeginObject(true);
	Writer.Members({{"type", "box"}, {"center", Box.Center}, {"extent", Box.Extent}});
	if (std::any_of(std::begin(Box.Rotation), std::end(Box.Rotation), [](double Angle) { return Angle != 0.0; }))
	{
		Writer.Member("rotation", Box.Rotation);
	}
	Writer.EndObject();
}

void WriteObjectPath(FJsonWriter& Writer, const UObject* Object)
{
	Object == nullptr ? Writer.Null() : Writer.Value(GetObjectPath(Object));
}

void WriteSettings(FJsonWriter& Writer, const FPostProcessSettings& Settings)
{
	Writer.Key("Settings").BeginObject();
	for (const FSettingField& Field : GetSettingFields())
	{
		const FSettingValue Value = Field.Get(Settings);
		const bool bOverridden = Field.IsOverridden(Settings);
		if (!bOverridden && SettingToText(Field, Value) == SettingToText(Field, Field.Default))
		{
			continue;
		}
		Writer.Key(Field.Name);
		Field.Type == ESettingType::Object ? WriteObjectPath(Writer, Value.Object)
										   : Writer.Raw(SettingToJson(Field, Value));
		if (!bOverridden)
		{
			Writer.Member(Field.OverrideName, false);
		}
	}
	if (Settings.WeightedBlendables.Array.Num() > 0)
	{
		Writer.Key("WeightedBlendables").BeginArray();
		for (const FWeightedBlendable& Blendable : Settings.WeightedBlendables.Array)
		{
			Writer.BeginObject(true);
			WriteObjectPath(Writer.Key("Object"), Blendable.Object.Get());
			Writer.Member("Weight", Blendable.Weight);
			Writer.EndObject();
		}
		Writer.EndArray();
	}
	Writer.EndObject();
}

void WriteVolume(FJsonWriter& Writer, const FVolumeText& Volume)
{
	const FVolumeText Defaults;
	Writer.BeginObject();
	Writer.MemberIfAny("name", Volume.Name);
	if (!Volume.bEnabled)
	{
		Writer.Member("bEnabled", false);
	}
	Writer.Member("bUnbound", Volume.bUnbound);
	if (Volume.Box)
	{
		WriteBox(Writer, *Volume.Box);
	}
	Writer.Member("Priority", Volume.Priority);
	if (Volume.BlendRadius != Defaults.BlendRadius)
	{
		Writer.Member("BlendRadius", Volume.BlendRadius);
	}
	if (Volume.BlendWeight != Defaults.BlendWeight)
	{
		Writer.Member("BlendWeight", Volume.BlendWeight);
	}
	WriteSettings(Writer, Volume.Settings.Settings);
	if (!Volume.Settings.Unknown.empty())
	{
		Writer.Array("unknownSettings", Volume.Settings.Unknown,
			[&](const FUnknownSetting& Setting) {
				Writer.Object({{"name", Setting.Key}, {"text", Setting.Text}, {"after", Setting.After}});
			});
	}
	Writer.EndObject();
}

/** Text from a config is not written unseen: it could break what is around it. */
bool IsEngineText(const FUnknownSetting& Setting)
{
	const std::string Pair = Setting.Key + "=" + Setting.Text;
	std::vector<FDiagnostic> Unused;
	const FSettingsText Read = ReadSettingsText("(" + Pair + ")", "", Unused);
	return Read.Unknown.size() == 1 && Read.Unknown[0].Key + "=" + Read.Unknown[0].Text == Pair;
}

} // namespace

void WriteVolumes(FJsonWriter& Writer, const std::vector<FVolumeText>& Volumes)
{
	Writer.BeginArray();
	for (const FVolumeText& Volume : Volumes)
	{
		WriteVolume(Writer, Volume);
	}
	Writer.EndArray();
}

FVolumeText MakeVolumeText(const FConfigVolume& Volume, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	FVolumeText Text;
	Text.Name = Volume.Name;
	Text.bEnabled = Volume.bEnabled;
	Text.bUnbound = Volume.bUnbound;
	Text.Priority = Volume.Priority;
	Text.BlendRadius = Volume.BlendRadius;
	Text.BlendWeight = Volume.BlendWeight;
	Text.Settings.Settings = Volume.Settings.Settings;
	for (const FUnknownSetting& Setting : Volume.UnknownSettings)
	{
		if (IsEngineText(Setting))
		{
			Text.Settings.Unknown.push_back(Setting);
			continue;
		}
		Diagnostics.push_back({ESeverity::Error, ErrorTextSyntax,
			"this is not engine text for a setting that drydock does not have: " + Setting.Key + "=" + Setting.Text,
			File, Volume.Place.Line, Volume.Place.Column, Volume.Place.Pointer + "/unknownSettings"});
	}
	if (Volume.Bounds && Volume.Bounds->Shape == EConfigShape::Box)
	{
		FVolumeTextBox Box;
		std::copy(Volume.Bounds->Center.begin(), Volume.Bounds->Center.end(), Box.Center);
		std::copy(Volume.Bounds->Extent.begin(), Volume.Bounds->Extent.end(), Box.Extent);
		std::copy(Volume.Bounds->Rotation.begin(), Volume.Bounds->Rotation.end(), Box.Rotation);
		Text.Box = Box;
	}
	else if (Volume.Bounds)
	{
		Diagnostics.push_back({ESeverity::Warning, WarnTextShape,
			"the volume's shape is not a box, and only boxes are exported: set the shape in the editor", File,
			Volume.Place.Line, Volume.Place.Column, Volume.Place.Pointer});
	}
	return Text;
}

} // namespace Drydock
