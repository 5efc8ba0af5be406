// Reads a config object by object: one function for each object of the format, in the order of its keys.
#include "Config/ReadConfig.h"

#include "Config/ConfigFields.h"
#include "Config/ConfigKeys.h"
#include "Config/ConfigReader.h"
#include "Config/ReadConfigScene.h"
#include "RangeTools.h"
#include "ShowFlags.h"
#include "Text/LimitErrors.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <tuple>

namespace Drydock
{

namespace
{

FConfigVolume ReadVolume(const FJsonValue& Value, FConfigMessages& Messages)
{
	FConfigVolume Volume;
	Volume.Place = PlaceOf(Value);
	WithMember(Value, "name", EJsonType::String, [&](const FJsonValue& Name) { Volume.Name = Name.String; });
	ReadBool(Value, "bEnabled", Volume.bEnabled);
	ReadBool(Value, "bUnbound", Volume.bUnbound);
	ReadNumber(Value, "Priority", Volume.Priority);
	ReadNumber(Value, "BlendRadius", Volume.BlendRadius);
	ReadWeight(Value, "BlendWeight", Volume.BlendWeight, Messages);
	WithMember(Value, "bounds", EJsonType::Object,
		[&](const FJsonValue& Bounds) { Volume.Bounds = ReadConfigBounds(Bounds, Messages); });
	WithMember(Value, "Settings", EJsonType::Object,
		[&](const FJsonValue& Settings) { Volume.Settings = ReadConfigSettings(Settings, Messages); });
	WithMember(Value, "unknownSettings", EJsonType::Array,
		[&](const FJsonValue& Unknown) { Volume.UnknownSettings = ReadConfigUnknownSettings(Unknown); });
	if (!Volume.bUnbound && Value.Find("bounds") == nullptr)
	{
		Messages.Error(ErrorVolumeWithoutBounds, Value, "the volume has no \"bounds\" and is not bUnbound");
	}
	else if (!Volume.bUnbound && Volume.BlendRadius < 0.0)
	{
		Messages.Warn(WarnOutOfRange, *Value.Find("BlendRadius"),
			"BlendRadius is below 0, so the volume has no effect, not even inside");
	}
	return Volume;
}

void ReadVolumes(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages)
{
	WithMember(Root, "volumes", EJsonType::Array,
		[&](const FJsonValue& Volumes)
		{
			for (const FJsonValue& Value : Volumes.Elements)
			{
				if (Value.Type != EJsonType::Object)
				{
					continue;
				}
				if (Config.Volumes.size() == MaxConfigVolumes)
				{
					Messages.Error(ErrorBadValue, Value,
						"more than " + std::to_string(MaxConfigVolumes) + " volumes; no more are read");
					break;
				}
				Config.Volumes.push_back(ReadVolume(Value, Messages));
			}
		});
	WithMember(Root, "volumes", EJsonType::String,
		[&](const FJsonValue& Volumes) {
			Config.VolumesFromScene = {Volumes.String == "fromScene", PlaceOf(Volumes)};
		});
}

/** JSON value of a console variable as the text it is set with; false when it has no such text. */
bool VariableText(const FJsonValue& Value, std::string& OutText)
{
	switch (Value.Type)
	{
	case EJsonType::String:
		OutText = Value.String;
		return true;
	case EJsonType::Bool:
		OutText = Value.Bool ? "1" : "0";
		return true;
	case EJsonType::Number:
		OutText = FormatShortest(Value.Number);
		return true;
	default:
		return false;
	}
}

void ReadVariables(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages)
{
	WithMember(Root, "cvars", EJsonType::Object,
		[&](const FJsonValue& Variables)
		{
			for (const auto& [Name, Value] : Variables.Members)
			{
				FConfigVariable Variable{Name, "", {Value.KeyLine, Value.KeyColumn, Value.Pointer}};
				if (VariableText(Value, Variable.Value))
				{
					CheckVariable(Variable, Messages);
					Config.Variables.push_back(Variable);
				}
				else if (Value.Type != EJsonType::Invalid)
				{
					Messages.Error(ErrorWrongType, Value,
						std::string("expected a number, a string or true or false, found ") + Value.Describe());
				}
			}
		});
}

void ReadShowFlags(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages)
{
	std::vector<std::string> Names = ToVector<std::string>(GetShowFlagInfos(), &FShowFlagInfo::Name);
	WithMember(Root, "showFlags", EJsonType::Object,
		[&](const FJsonValue& Flags)
		{
			for (const auto& [Name, Value] : Flags.Members)
			{
				if (!Contains(Names, Name))
				{
					Messages.ErrorAtKey(
						ErrorUnknownShowFlag, Value, "unknown show flag" + Messages.Suggest(Name, Names));
				}
				else if (Value.Type != EJsonType::Bool)
				{
					Messages.Error(
						ErrorWrongType, Value, std::string("expected true or false, found ") + Value.Describe());
				}
				else
				{
					Config.ShowFlags.push_back({Name, Value.Bool, PlaceOf(Value)});
				}
			}
		});
}

/** The objects of an array, as they stand. */
void ReadObjects(const FJsonValue& Root, const char* Key, std::vector<FJsonValue>& Objects)
{
	WithMember(Root, Key, EJsonType::Array,
		[&](const FJsonValue& Array)
		{
			std::copy_if(Array.Elements.begin(), Array.Elements.end(), std::back_inserter(Objects),
				[](const FJsonValue& Value) { return Value.Type == EJsonType::Object; });
		});
}

/** The texts of an array. */
void ReadTexts(const FJsonValue& Root, const char* Key, std::vector<TConfigValue<std::string>>& Texts)
{
	for (const FJsonValue& Element : Root.GetElements(Key))
	{
		if (Element.Type == EJsonType::String)
		{
			Texts.push_back({Element.String, PlaceOf(Element)});
		}
	}
}

/** A folder's name, {"folder": NAME, "over": NAME or names}, or a list of these. Anything else is reported elsewhere.
 */
void ReadOverlay(const FJsonValue& Value, FConfig& Config)
{
	if (Value.Type == EJsonType::String)
	{
		Config.Overlays.push_back({{Value.String, PlaceOf(Value)}, {}});
	}
	else if (Value.Type == EJsonType::Array)
	{
		std::for_each(Value.Elements.begin(), Value.Elements.end(),
			[&](const FJsonValue& Element) { ReadOverlay(Element, Config); });
	}
	else if (Value.Type == EJsonType::Object)
	{
		FConfigOverlay Overlay;
		WithMember(Value, "folder", EJsonType::String,
			[&](const FJsonValue& Folder) {
				Overlay.Folder = {Folder.String, PlaceOf(Folder)};
			});
		const FJsonValue* const Over = Value.Find("over");
		if (Over != nullptr && Over->Type == EJsonType::Array)
		{
			for (const FJsonValue& Below : Over->Elements)
			{
				Overlay.Over.push_back(Below.String);
			}
		}
		else if (Over != nullptr)
		{
			Overlay.Over.push_back(Over->String);
		}
		if (Overlay.Folder.IsSet())
		{
			Config.Overlays.push_back(std::move(Overlay));
		}
	}
}

void ReadPlugins(const FJsonValue& Root, FConfig& Config)
{
	ReadTexts(Root, "plugins", Config.Plugins);
	if (const FJsonValue* const Overlay = Root.Type == EJsonType::Object ? Root.Find("overlay") : nullptr)
	{
		ReadOverlay(*Overlay, Config);
	}
	WithMember(Root, "objects", EJsonType::Object, [&](const FJsonValue& Objects) { Config.Objects = Objects; });
	WithMember(Root, "assets", EJsonType::Object, [&](const FJsonValue& Assets) { Config.Assets = Assets; });
}

void ReadRoot(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages)
{
	ReadString(Root, "engine", Config.Engine);
	ReadPlugins(Root, Config);
	WithMember(
		Root, "scene", EJsonType::Object, [&](const FJsonValue& Scene) { ReadScene(Scene, Config.Scene, Messages); });
	WithMember(Root, "view", EJsonType::Object, [&](const FJsonValue& View) { ReadView(View, Config.View, Messages); });
	ReadViews(Root, Config, Messages);
	ReadObjects(Root, "extensions", Config.Extensions);
	ReadObjects(Root, "passes", Config.Passes);
	WithMember(Root, "study", EJsonType::Object, [&](const FJsonValue& Study) { Config.Study = Study; });
	WithMember(Root, "budget", EJsonType::Object, [&](const FJsonValue& Budget) { Config.Budget = Budget; });
	ReadVolumes(Root, Config, Messages);
	WithMember(Root, "camera", EJsonType::Object,
		[&](const FJsonValue& Camera)
		{
			ReadWeight(Camera, "PostProcessBlendWeight", Config.Camera.PostProcessBlendWeight, Messages);
			WithMember(Camera, "Settings", EJsonType::Object,
				[&](const FJsonValue& Settings) { Config.Camera.Settings = ReadConfigSettings(Settings, Messages); });
		});
	ReadVariables(Root, Config, Messages);
	ReadShowFlags(Root, Config, Messages);
	WithMember(Root, "outputs", EJsonType::Object,
		[&](const FJsonValue& Outputs)
		{
			WithMember(Outputs, "write", EJsonType::Array,
				[&](const FJsonValue& Kinds)
				{
					std::vector<std::string> Names = ToVector<std::string>(Kinds.Elements, &FJsonValue::String);
					Config.Write = MakeOutputKinds(Names);
				});
			ReadString(Outputs, "report", Config.Report);
			ReadTexts(Outputs, "dump", Config.Dump);
		});
}

} // namespace

FConfigDocument ParseConfigDocument(const std::string& Text, const std::string& File)
{
	FConfigDocument Document;
	Document.File = File;
	Document.Root = ParseJson(Text, File, Document.Diagnostics, Document.bSyntaxError);
	return Document;
}

FConfigDocument LoadConfigDocument(const std::string& File)
{
	return ParseConfigDocument(ReadTextFile(File, "the config cannot be read"), File);
}

FConfig ReadConfigPlugins(const FConfigDocument& Document)
{
	FConfig Config;
	Config.File = Document.File;
	if (!Document.bSyntaxError)
	{
		ReadPlugins(Document.Root, Config);
		ReadObjects(Document.Root, "passes", Config.Passes); // whose shaders an overlay may bring
	}
	return Config;
}

FConfig ReadConfig(const FConfigDocument& Document, std::vector<FDiagnostic>& Diagnostics)
{
	FConfig Config;
	Config.File = Document.File;
	std::vector<FDiagnostic> Found = Document.Diagnostics;
	if (!Document.bSyntaxError)
	{
		FConfigMessages Messages(Document.File, Found);
		ValidateConfigShape(Document.Root, Messages);
		ReadRoot(Document.Root, Config, Messages);
	}
	const auto GetOrder = [](const FDiagnostic& Diagnostic)
	{
		return std::tuple(Diagnostic.Code == MoreMessages, Diagnostic.Line, Diagnostic.Column);
	};
	std::stable_sort(Found.begin(), Found.end(),
		[&](const FDiagnostic& A, const FDiagnostic& B) { return GetOrder(A) < GetOrder(B); });
	Diagnostics.insert(Diagnostics.end(), Found.begin(), Found.end());
	return Config;
}

FConfig ReadConfig(const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	return ReadConfig(ParseConfigDocument(Text, File), Diagnostics);
}

FConfig LoadConfig(const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	return ReadConfig(LoadConfigDocument(File), Diagnostics);
}

} // namespace Drydock
