// Reads camera and volumes that a scene's header suggests.
#include "SceneFile/SceneSuggestions.h"

#include "Config/ConfigReader.h"
#include "Picture/ImageFile.h"

#include <algorithm>

namespace Drydock
{

namespace
{

FJsonValue ParseAttribute(const std::string& CameraJson)
{
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(CameraJson, "drydock:camera_json", Ignored, bSyntaxError);
	return bSyntaxError ? FJsonValue() : Root;
}

double ReadNumber(const FJsonValue& Object, const char* Key, double Default)
{
	const FJsonValue* Value = Object.Find(Key);
	return Value != nullptr && Value->Type == EJsonType::Number ? Value->Number : Default;
}

FConfigVolume ReadSuggestedVolume(const FJsonValue& Value, FConfigMessages& Messages)
{
	FConfigVolume Volume;
	Volume.Place = PlaceOf(Value);
	if (const FJsonValue* Name = Value.Find("name"))
	{
		Volume.Name = Name->String;
	}
	Volume.Priority = ReadNumber(Value, "priority", 0.0);
	Volume.BlendWeight = std::clamp(ReadNumber(Value, "blend_weight", 1.0), 0.0, 1.0);
	Volume.BlendRadius = ReadNumber(Value, "blend_radius_uecm", 100.0);
	FConfigBounds Bounds;
	const FJsonValue* Center = Value.Find("center_uecm");
	const FJsonValue* Extent = Value.Find("extent_uecm");
	const bool bBounded = Center != nullptr && ReadConfigVector(*Center, Bounds.Center) && Extent != nullptr &&
						  ReadConfigVector(*Extent, Bounds.Extent);
	Volume.bUnbound = !bBounded;
	if (bBounded)
	{
		Volume.Bounds = Bounds;
	}
	if (const FJsonValue* Settings = Value.Find("settings"))
	{
		Volume.Settings = ReadConfigSettings(*Settings, Messages);
	}
	return Volume;
}

void ReportNoSuggestion(const FConfig& Config, const std::string& Message, std::vector<FDiagnostic>& Diagnostics)
{
	Diagnostics.push_back({.Code = ErrorNothingFromScene,
		.Message = "\"volumes\" is \"fromScene\", but " + Message,
		.File = Config.File,
		.Line = Config.VolumesFromScene.Place.Line,
		.Column = Config.VolumesFromScene.Place.Column,
		.Where = "/volumes"});
}

bool NeedsLocation(const FConfig& Config)
{
	const auto IsLocal = [](const FConfigVolume& Volume)
	{
		return Volume.bEnabled && !Volume.bUnbound;
	};
	return !Config.View.Location.IsSet() && std::any_of(Config.Volumes.begin(), Config.Volumes.end(), IsLocal);
}

} // namespace

std::vector<FConfigVolume> ReadSuggestedVolumes(
	const std::string& CameraJson, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FDiagnostic> Found;
	FConfigMessages Messages(File, Found);
	std::vector<FConfigVolume> Volumes;
	const FJsonValue Root = ParseAttribute(CameraJson);
	const FJsonValue* Suggested = Root.Find("post_process_volumes");
	for (size_t Index = 0; Suggested != nullptr && Index < Suggested->Elements.size(); ++Index)
	{
		if (Volumes.size() == MaxConfigVolumes)
		{
			Messages.Warn(WarnSuggestionLeftOut, Suggested->Elements[Index],
				"more than " + std::to_string(MaxConfigVolumes) + " volumes; no more are read");
			break;
		}
		Volumes.push_back(ReadSuggestedVolume(Suggested->Elements[Index], Messages));
	}
	for (FDiagnostic& Diagnostic : Found)
	{
		if (Diagnostic.Severity == ESeverity::Error)
		{
			// The scene's author is not the config's: what cannot be read is left out.
			Diagnostic.Severity = ESeverity::Warning;
			Diagnostic.Code = WarnSuggestionLeftOut;
			Diagnostic.Message += "; it is left out";
		}
		Diagnostics.push_back(Diagnostic);
	}
	return Volumes;
}

std::optional<FConfigVector> ReadSuggestedLocation(const std::string& CameraJson)
{
	const FJsonValue Root = ParseAttribute(CameraJson);
	const FJsonValue* Position = Root.Find("position_uecm");
	FConfigVector Location;
	return Position != nullptr && ReadConfigVector(*Position, Location) ? std::optional(Location) : std::nullopt;
}

void CompleteFromScene(FConfig& Config, std::vector<FDiagnostic>& Diagnostics)
{
	const bool bVolumes = Config.VolumesFromScene.Value;
	if (bVolumes && !Config.Scene.File.IsSet())
	{
		ReportNoSuggestion(Config, "the config names no scene", Diagnostics);
		return;
	}
	if (!bVolumes && !NeedsLocation(Config))
	{
		return;
	}
	if (Config.Scene.File.IsSet())
	{
		const FImageFile File(Config.Resolve(Config.Scene.File.Value));
		const std::string CameraJson = File.GetAttribute("drydock:camera_json");
		Config.Scene.CameraLocation = ReadSuggestedLocation(CameraJson);
		if (bVolumes)
		{
			Config.Volumes = ReadSuggestedVolumes(CameraJson, File.GetPath(), Diagnostics);
		}
		if (bVolumes && Config.Volumes.empty())
		{
			ReportNoSuggestion(Config, File.GetPath() + " suggests no volumes", Diagnostics);
		}
	}
	if (NeedsLocation(Config) && !Config.Scene.CameraLocation)
	{
		FConfigMessages(Config.File, Diagnostics)
			.Warn(WarnNoLocation, FConfigPlace(),
				std::string("bounded volumes are blended at 0, 0, 0: there is no view.location, and ") +
					(Config.Scene.File.IsSet() ? "the scene file has no camera" : "no scene"));
	}
}

} // namespace Drydock
