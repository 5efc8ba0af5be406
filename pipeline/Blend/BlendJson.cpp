// Writes what `drydock blend` says as JSON.
#include "Blend/BlendReport.h"
#include "Run/RunJson.h"
#include "SettingObjects.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"

#include <array>

namespace Drydock
{

namespace
{

/** Nothing in place of an empty text. */
std::optional<std::string> OptionalText(const std::string& Text)
{
	return Text.empty() ? std::optional<std::string>() : Text;
}

void WriteEntry(FJsonWriter& Writer, const FSettingField& Field, const FBlendLedgerEntry& Entry)
{
	Writer.BeginObject(true);
	Writer.Members({{"source", Entry.Source}, {"kind", ToString(Entry.Kind)}, {"rule", Entry.Rule},
		{"weight", Entry.Weight}, {"distance", Entry.Distance}});
	Writer.Key("before").Raw(SettingToJson(Field, Entry.Before));
	Writer.Key("after").Raw(SettingToJson(Field, Entry.After));
	Writer.Member("skipped", OptionalText(Entry.Skipped));
	Writer.MemberIfAny("detail", Entry.Detail);
	Writer.EndObject();
}

void WriteVolumes(FJsonWriter& Writer, const FBlendReport& Report)
{
	Writer.Array("volumes", Report.Volumes,
		[&](const FVolumeAtPlace& Place)
		{
			const FPostProcessVolumeProperties& Properties = Report.VolumeProperties[Place.Volume];
			Writer.Object({{"name", Report.VolumeNames[Place.Volume]}, {"Priority", Properties.Priority},
				{"bUnbound", Properties.bIsUnbound}, {"distance", Place.Distance}, {"weight", Place.Influence.Weight},
				{"skipped",
					OptionalText(ExplainSkip(Place.Influence.Skip, Properties, Place.Distance.value_or(0.0)))}});
		});
}

/** Writes contributions that cannot be one value: see FFinalPostProcessSettings. */
void WriteContributions(FJsonWriter& Writer, const FFinalPostProcessSettings& Settings)
{
	Writer.Array("luts", Settings.ContributingLUTs,
		[&](const FFinalPostProcessSettings::FLUTEntry& Entry) {
			Writer.Object({{"texture", GetObjectPath(Entry.LUT.Get())}, {"weight", Entry.Weight}});
		});
	Writer.Array("cubemaps", Settings.ContributingCubemaps,
		[&](const FFinalPostProcessSettings::FCubemapEntry& Entry)
		{
			const FLinearColor& Scale = Entry.AmbientCubemapTintMulScaleValue;
			Writer.Object({{"texture", GetObjectPath(Entry.AmbientCubemap.Get())},
				{"color", std::array{Scale.R, Scale.G, Scale.B}}});
		});
	Writer.Array("blendables", Settings.BlendableManager.Blendables,
		[&](const FWeightedBlendable& Blendable) {
			Writer.Object({{"object", GetObjectPath(Blendable.Object.Get())}, {"weight", Blendable.Weight}});
		});
}

} // namespace

std::string MakeBlendJson(const FBlendReport& Report, const std::vector<size_t>& Settings)
{
	FJsonWriter Writer('{');
	Writer.Member("location", {Report.Location.X, Report.Location.Y, Report.Location.Z});
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
		Writer.Array(Field.Name, Report.Ledger.GetEntries(Index),
			[&](const FBlendLedgerEntry& Entry) { WriteEntry(Writer, Field, Entry); });
	}
	Writer.EndObject();
	WriteVolumes(Writer, Report);
	WriteContributions(Writer, Report.Blended.Settings);
	Writer.Array("warnings", Report.Diagnostics,
		[&](const FDiagnostic& Diagnostic)
		{
			Writer.Object(
				{{"code", FormatCode(Diagnostic.Code)}, {"message", Diagnostic.Message}, {"where", Diagnostic.Where}});
		});
	return Writer.GetText();
}

} // namespace Drydock
