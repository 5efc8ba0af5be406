// Reads a config object by object: one function for each object of the format, in the order of its keys. A little past
// 500 lines for that reason.
#include "Config/ReadConfig.h"

#include "Config/ConfigReader.h"
#include "Config/ConfigKeys.h"
#include "Config/FrameList.h"
#include "Config/FrameSequence.h"
#include "Math/ToInteger.h"
#include "ShowFlags.h"
#include "Text/LimitErrors.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <tuple>

namespace Drydock
{

namespace
{

/** Largest picture side that a rect may name. */
constexpr double MaxExtent = 65536.0;
constexpr double MaxPadding = 4096.0;
constexpr double MaxScreenPercentage = 400.0;
/** Each holds all settings, some kilobytes. */
constexpr size_t MaxVolumes = 10'000;

template<typename TFunction>
void WithMember(const FJsonValue& Object, const char* Key, EJsonType Type, const TFunction& Function)
{
	const FJsonValue* Member = Object.Find(Key);
	if (Member != nullptr && Member->Type == Type)
	{
		Function(*Member);
	}
}

void ReadString(const FJsonValue& Object, const char* Key, TConfigValue<std::string>& OutValue)
{
	WithMember(Object, Key, EJsonType::String,
		[&](const FJsonValue& Member) {
			OutValue = {Member.String, PlaceOf(Member)};
		});
}

void ReadNumber(const FJsonValue& Object, const char* Key, double& OutNumber)
{
	WithMember(Object, Key, EJsonType::Number, [&](const FJsonValue& Member) { OutNumber = Member.Number; });
}

void ReadBool(const FJsonValue& Object, const char* Key, bool& OutBool)
{
	WithMember(Object, Key, EJsonType::Bool, [&](const FJsonValue& Member) { OutBool = Member.Bool; });
}

/** A factor of brightness: finite and above 0. */
void ReadScale(const FJsonValue& Object, const char* Key, TConfigValue<double>& OutValue, FConfigMessages& Messages)
{
	WithMember(Object, Key, EJsonType::Number,
		[&](const FJsonValue& Member)
		{
			if (!(Member.Number > 0.0) || !std::isfinite(static_cast<float>(Member.Number)) ||
				static_cast<float>(Member.Number) == 0.0f)
			{
				Messages.Error(ErrorBadValue, Member, std::string(Key) + " must be above 0");
				return;
			}
			OutValue = {Member.Number, PlaceOf(Member)};
		});
}

void ReadWeight(const FJsonValue& Object, const char* Key, double& OutWeight, FConfigMessages& Messages)
{
	WithMember(Object, Key, EJsonType::Number,
		[&](const FJsonValue& Member)
		{
			OutWeight = std::clamp(Member.Number, 0.0, 1.0);
			if (OutWeight != Member.Number)
			{
				Messages.Warn(WarnWeightClamped, Member, std::string(Key) + " is clamped to 0..1");
			}
		});
}

/** A number of texels to pad one side with; empty (and reported) when it is none. */
std::optional<int> ReadPaddingSide(const FJsonValue& Value, FConfigMessages& Messages)
{
	if (Value.Type != EJsonType::Number)
	{
		return std::nullopt; // reported
	}
	if (Value.Number != std::floor(Value.Number) || Value.Number < 0.0 || Value.Number > MaxPadding)
	{
		Messages.Error(ErrorBadValue, Value, "padding is a whole number of texels, 0 to 4096");
		return std::nullopt;
	}
	return ToInteger<int>(Value.Number);
}

void ReadPadding(const FJsonValue& Value, FConfigPadding& Padding, FConfigMessages& Messages)
{
	const std::pair<const char*, int FConfigPadding::*> Sides[] = {{"left", &FConfigPadding::Left},
		{"top", &FConfigPadding::Top}, {"right", &FConfigPadding::Right}, {"bottom", &FConfigPadding::Bottom}};
	for (size_t Side = 0; Side < std::size(Sides); ++Side)
	{
		const FJsonValue* Number = &Value;
		if (Value.Type == EJsonType::Object)
		{
			Number = Value.Find(Sides[Side].first);
		}
		else if (Value.Type == EJsonType::Array)
		{
			Number = Value.Elements.size() == std::size(Sides) ? &Value.Elements[Side] : nullptr;
		}
		const std::optional<int> Texels = Number != nullptr ? ReadPaddingSide(*Number, Messages) : std::nullopt;
		Padding.*Sides[Side].second = Texels.value_or(0);
		if (Value.Type == EJsonType::Number && !Texels)
		{
			return; // once is enough
		}
	}
}

FSceneUnits ReadUnits(const FJsonValue& Value)
{
	const auto Is = [&Value](const char* Key, const char* Unit)
	{
		const FJsonValue* Member = Value.Find(Key);
		return Member != nullptr && Member->String == Unit;
	};
	return {Is("depth", "cm"), Is("velocity", "ndc"), Is("normal", "leftHanded")};
}

void ReadFrames(const FJsonValue& Value, FConfigScene& Scene, FConfigMessages& Messages)
{
	std::string Error;
	if (!ParseFrameList(Value.String, Error))
	{
		Messages.Error(ErrorBadValue, Value, Error);
	}
	else if (!IsFrameSequence(Scene.File.Value))
	{
		Messages.Error(ErrorBadValue, Value, "frames are those of a sequence, which scene.file names with ####");
	}
	Scene.Frames = {Value.String, PlaceOf(Value)};
}

void ReadScene(const FJsonValue& Value, FConfigScene& Scene, FConfigMessages& Messages)
{
	WithMember(Value, "units", EJsonType::Object, [&](const FJsonValue& Units) { Scene.Units = ReadUnits(Units); });
	ReadString(Value, "file", Scene.File);
	WithMember(
		Value, "frames", EJsonType::String, [&](const FJsonValue& Frames) { ReadFrames(Frames, Scene, Messages); });
	WithMember(Value, "fps", EJsonType::Number,
		[&](const FJsonValue& Fps)
		{
			if (!(Fps.Number >= 0.01 && Fps.Number <= 10000.0))
			{
				Messages.Error(ErrorBadValue, Fps, "fps is 0.01 to 10000 frames per second");
				return;
			}
			Scene.Fps = {Fps.Number, PlaceOf(Fps)};
		});
	WithMember(Value, "channels", EJsonType::Object,
		[&](const FJsonValue& Channels)
		{
			for (const auto& [Name, Channel] : Channels.Members)
			{
				if (Channel.Type == EJsonType::String)
				{
					Scene.Channels[Name] = {Channel.String, PlaceOf(Channel)};
				}
			}
		});
	WithMember(Value, "defaults", EJsonType::Object,
		[&](const FJsonValue& Defaults)
		{
			for (const auto& [Name, Default] : Defaults.Members)
			{
				Scene.Defaults[Name] = {Default.Number, PlaceOf(Default)};
			}
		});
	if (const FJsonValue* Padding = Value.Find("padding"))
	{
		ReadPadding(*Padding, Scene.Padding, Messages);
	}
	WithMember(Value, "screenPercentage", EJsonType::Number,
		[&](const FJsonValue& Percentage)
		{
			if (!(Percentage.Number > 0.0 && Percentage.Number <= MaxScreenPercentage))
			{
				Messages.Error(ErrorBadValue, Percentage, "screenPercentage must be above 0 and at most 400");
				return;
			}
			Scene.ScreenPercentage = Percentage.Number;
		});
}

void ReadRect(const FJsonValue& Value, FConfigView& View, FConfigMessages& Messages)
{
	WithMember(Value, "rect", EJsonType::Array,
		[&](const FJsonValue& Rect)
		{
			std::array<int, 4> Corners = {};
			if (Rect.Elements.size() != Corners.size())
			{
				return; // reported
			}
			for (size_t Index = 0; Index < Corners.size(); ++Index)
			{
				const FJsonValue& Corner = Rect.Elements[Index];
				if (Corner.Type != EJsonType::Number)
				{
					return; // reported
				}
				if (Corner.Number != std::floor(Corner.Number) || Corner.Number < 0.0 || Corner.Number > MaxExtent)
				{
					Messages.Error(
						ErrorBadValue, Corner, "a corner of the rect is a whole number of pixels, 0 or more");
					return;
				}
				Corners[Index] = ToInteger<int>(Corner.Number);
			}
			if (Corners[0] >= Corners[2] || Corners[1] >= Corners[3])
			{
				Messages.Error(
					ErrorBadValue, Rect, "the rect is empty: it is [MinX, MinY, MaxX, MaxY] with Max above Min");
				return;
			}
			View.Rect = {Corners, PlaceOf(Rect)};
		});
}

void ReadView(const FJsonValue& Value, FConfigView& View, FConfigMessages& Messages)
{
	const auto ReadVector = [&Value](const char* Key, auto Read, TConfigValue<FConfigVector>& OutVector)
	{
		const FJsonValue* Member = Value.Find(Key);
		FConfigVector Vector;
		if (Member != nullptr && Read(*Member, Vector))
		{
			OutVector = {Vector, PlaceOf(*Member)};
		}
	};
	ReadVector("location", ReadConfigVector, View.Location);
	ReadVector("rotation", ReadConfigRotator, View.Rotation);
	WithMember(Value, "fov", EJsonType::Number,
		[&](const FJsonValue& Fov)
		{
			if (!(Fov.Number >= 1.0 && Fov.Number <= 179.0))
			{
				Messages.Error(ErrorBadValue, Fov, "fov is an angle of 1 to 179 degrees");
				return;
			}
			View.Fov = {Fov.Number, PlaceOf(Fov)};
		});
	ReadRect(Value, View, Messages);
	ReadScale(Value, "exposure", View.Exposure, Messages);
	WithMember(Value, "exposure", EJsonType::String,
		[&](const FJsonValue& Exposure) { View.bAutoExposure = Exposure.String == "auto"; });
	ReadScale(Value, "preExposure", View.PreExposure, Messages);
	WithMember(Value, "preExposure", EJsonType::String,
		[&](const FJsonValue& PreExposure) { View.bAutoPreExposure = PreExposure.String == "auto"; });
}

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
			"BlendRadius is below 0: the volume acts nowhere, not even inside");
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
				if (Config.Volumes.size() == MaxVolumes)
				{
					Messages.Error(
						ErrorBadValue, Value, "more than " + std::to_string(MaxVolumes) + " volumes; no more are read");
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
	{
		char Buffer[64];
		OutText = std::string(Buffer, std::to_chars(Buffer, Buffer + sizeof(Buffer), Value.Number).ptr);
		return true;
	}
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
	std::vector<std::string> Names;
	for (const FShowFlagInfo& Info : GetShowFlagInfos())
	{
		Names.emplace_back(Info.Name);
	}
	WithMember(Root, "showFlags", EJsonType::Object,
		[&](const FJsonValue& Flags)
		{
			for (const auto& [Name, Value] : Flags.Members)
			{
				if (std::find(Names.begin(), Names.end(), Name) == Names.end())
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

/** Several views: each has its rect, and the first one stands for them where there can be only one. */
void ReadViews(const FJsonValue& Root, FConfig& Config, FConfigMessages& Messages)
{
	WithMember(Root, "views", EJsonType::Array,
		[&](const FJsonValue& Views)
		{
			for (const FJsonValue& Value : Views.Elements)
			{
				FConfigView View;
				ReadView(Value, View, Messages);
				if (Views.Elements.size() > 1 && Value.Find("rect") == nullptr)
				{
					Messages.Error(ErrorMissingKey, Value, "\"rect\" is missing: each of several views has its own");
				}
				Config.Views.push_back(View);
			}
			if (Root.Find("view") != nullptr)
			{
				Messages.ErrorAtKey(ErrorBadValue, Views, "\"views\" stands in place of \"view\": give one of them");
			}
			else if (!Config.Views.empty())
			{
				Config.View = Config.Views[0];
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

void ReadPlugins(const FJsonValue& Root, FConfig& Config)
{
	WithMember(Root, "plugins", EJsonType::Array,
		[&](const FJsonValue& Plugins)
		{
			for (const FJsonValue& Plugin : Plugins.Elements)
			{
				if (Plugin.Type == EJsonType::String)
				{
					Config.Plugins.push_back({Plugin.String, PlaceOf(Plugin)});
				}
			}
		});
	WithMember(Root, "objects", EJsonType::Object, [&](const FJsonValue& Objects) { Config.Objects = Objects; });
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
					std::vector<std::string> Names;
					for (const FJsonValue& Kind : Kinds.Elements)
					{
						Names.push_back(Kind.String);
					}
					Config.Write = MakeOutputKinds(Names);
				});
			ReadString(Outputs, "report", Config.Report);
			WithMember(Outputs, "dump", EJsonType::Array,
				[&](const FJsonValue& Patterns)
				{
					for (const FJsonValue& Pattern : Patterns.Elements)
					{
						if (Pattern.Type == EJsonType::String)
						{
							Config.Dump.push_back({Pattern.String, PlaceOf(Pattern)});
						}
					}
				});
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
