// Writes what `drydock blend` says as JSON.
#include "Blend/BlendReport.h"
#include "Run/RunJson.h"
#include "SettingObjects.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

template<typename T>
void OptionalMember(FJsonWriter& Writer, const char* Name, const std::optional<T>& Value)
{
	Writer.Key(Name);
	if (Value)
	{
		Writer.Value(*Value);
	}
	else
	{
		Writer.Null();
	}
}

void OptionalText(FJsonWriter& Writer, const char* Name, const std::string& Text)
{
	OptionalMember(Writer, Name, Text.empty() ? std::optional<std::string>() : Text);
}

void WriteEntry(FJsonWriter& Writer, const FSettingField& Field, const FBlendLedgerEntry& Entry)
{
	Writer.BeginObject(true);
	Writer.Member("source", Entry.Source);
	Writer.Member("kind", ToString(Entry.Kind));
	Writer.Member("rule", Entry.Rule);
	OptionalMember(Writer, "weight", Entry.Weight);
	OptionalMember(Writer, "distance", Entry.Distance);
	Writer.Key("before").Raw(SettingToJson(Field, Entry.Before));
	Writer.Key("after").Raw(SettingToJson(Field, Entry.After));
	OptionalText(Writer, "skipped", Entry.Skipped);
	if (!Entry.Detail.empty())
	{
		Writer.Member("detail", Entry.Detail);
	}
	Writer.EndObject();
}

void WriteVolumes(FJsonWriter& Writer, const FBlendReport& Report)
{
	Writer.Key("volumes").BeginArray();
	for (const FVolumeAtPlace& Place : Report.Volumes)
	{
		const FPostProcessVolumeProperties& Properties = Report.VolumeProperties[Place.Volume];
		Writer.BeginObject(true);
		Writer.Member("name", Report.VolumeNames[Place.Volume]);
		Writer.Member("Priority", Properties.Priority);
		Writer.Member("bUnbound", Properties.bIsUnbound);
		OptionalMember(Writer, "distance", Place.Distance);
		Writer.Member("weight", Place.Influence.Weight);
		OptionalText(Writer, "skipped", ExplainSkip(Place.Influence.Skip, Properties, Place.Distance.value_or(0.0)));
		Writer.EndObject();
	}
	Writer.EndArray();
}

/** Writes contributions that cannot be one value: see FFinalPostProcessSettings. */
void WriteContributions(FJsonWriter& Writer, const FFinalPostProcessSettings& Settings)
{
	Writer.Key("luts").BeginArray();
	for (const FFinalPostProcessSettings::FLUTEntry& Entry : Settings.ContributingLUTs)
	{
		Writer.BeginObject(true);
		Writer.Member("texture", GetObjectPath(Entry.LUT.Get()));
		Writer.Member("weight", Entry.Weight);
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Key("cubemaps").BeginArray();
	for (const FFinalPostProcessSettings::FCubemapEntry& Entry : Settings.ContributingCubemaps)
	{
		const FLinearColor& Scale = Entry.AmbientCubemapTintMulScaleValue;
		Writer.BeginObject(true);
		Writer.Member("texture", GetObjectPath(Entry.AmbientCubemap.Get()));
		Writer.Key("color").BeginArray(true);
		for (const float Component : {Scale.R, Scale.G, Scale.B})
		{
			Writer.Value(Component);
		}
		Writer.EndArray();
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.Key("blendables").BeginArray();
	for (const FWeightedBlendable& Blendable : Settings.BlendableManager.Blendables)
	{
		Writer.BeginObject(true);
		Writer.Member("object", GetObjectPath(Blendable.Object.Get()));
		Writer.Member("weight", Blendable.Weight);
		Writer.EndObject();
	}
	Writer.EndArray();
}

} // namespace

std::string MakeBlendJson(const FBlendReport& Report, const std::vector<size_t>& Settings)
{
	FJsonWriter Writer;
	Writer.BeginObject();
	Writer.Key("location").BeginArray(true);
	for (const double Coordinate : {Report.Location.X, Report.Location.Y, Report.Location.Z})
	{
		Writer.Value(Coordinate);
	}
	Writer.EndArray();
	Writer.Member("locationFrom", Report.LocationFrom);
	Writer.Key("settings").BeginObject();
	for (const size_t Index : Settings)
	{
		const FSettingField& Field = GetSettingFields()[Index];
		Writer.Key(Field.Name).Raw(SettingToJson(Field, Field.Get(Report.Blended.Settings)));
	}
	Writer.EndObject();
	Writer.Key("ledger").BeginObject();
	for (const size_t Index : Settings)
	{
		const FSettingField& Field = GetSettingFields()[Index];
		Writer.Key(Field.Name).BeginArray();
		for (const FBlendLedgerEntry& Entry : Report.Ledger.GetEntries(Index))
		{
			WriteEntry(Writer, Field, Entry);
		}
		Writer.EndArray();
	}
	Writer.EndObject();
	WriteVolumes(Writer, Report);
	WriteContributions(Writer, Report.Blended.Settings);
	Writer.Key("warnings").BeginArray();
	for (const FDiagnostic& Diagnostic : Report.Diagnostics)
	{
		Writer.BeginObject(true);
		Writer.Member("code", FormatCode(Diagnostic.Code));
		Writer.Member("message", Diagnostic.Message);
		Writer.Member("where", Diagnostic.Where);
		Writer.EndObject();
	}
	Writer.EndArray();
	Writer.EndObject();
	return Writer.GetText();
}

} // namespace Drydock
