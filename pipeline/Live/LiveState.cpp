// Writes the state of a session: settings, volumes, variables, show flags and the rest.
#include "Blend/WalkPath.h"
#include "Config/FrameSequence.h"
#include "HAL/ConsoleVariableTools.h"
#include "Live/LiveJson.h"
#include "Live/LiveSession.h"
#include "Picture/ImageFormat.h"
#include "RangeTools.h"
#include "Run/FinalSettings.h"
#include "SettingDisplayNames.h"
#include "ShowFlags.h"
#include "Text/JsonWriter.h"
#include "Text/TextFormat.h"
#include "TextTools.h"

#include <cmath>
#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

/** Why a setting does nothing in this frame; empty where an active effect reads it. */
std::string ExplainUnread(const std::string& Name, const FRunResult& Frame)
{
	const std::string NotBuilt = GetSettingNotBuiltReason(Name);
	const FEffect* const Owner = FindSettingOwner(Name);
	if (!NotBuilt.empty() || Owner == nullptr)
	{
		return NotBuilt.empty() ? "no effect reads it" : NotBuilt;
	}
	const FEffectDecision* const Decision = FindEffect(Frame.Effects, Owner->Id);
	return Decision == nullptr || Decision->bActive ? ""
													: std::string(*Owner->Name) + " does not run: " + Decision->Reason;
}

void WriteRange(FJsonWriter& Writer, const FSettingRange& Range)
{
	// In the float that the setting is: 0.1 is 0.1.
	const auto Narrow = [](double Bound)
	{
		return std::isfinite(Bound) ? std::optional(static_cast<float>(Bound)) : std::nullopt;
	};
	Writer.Key("range").Object({{"clampMin", Narrow(Range.ClampMin)}, {"clampMax", Narrow(Range.ClampMax)},
		{"uiMin", Narrow(Range.UIMin)}, {"uiMax", Narrow(Range.UIMax)}});
}

/** As a config takes it: a truth value, a number or a text. */
std::string MakeVariableJson(const FConsoleVariableInfo& Info, const FString& Value)
{
	const std::string Text = *Value;
	const std::string Type = *Info.Type;
	const std::optional<double> Number = ParseAll<double>(Text);
	return Type == "bool"                                          ? (Text == "1" || Text == "true" ? "true" : "false")
		   : Type != "FString" && Number && std::isfinite(*Number) ? NumberText(*Number)
																   : FJsonWriter::Quote(Text);
}

class FStateWriter
{
public:
	FStateWriter(const FLiveSession& InSession, const FConfig& InConfig)
		: Session(InSession)
		, Config(InConfig)
	{
	}

	std::string Write()
	{
		const FEditHistory& History = Session.GetHistory();
		Writer.Members(
			{{"revision", History.GetRevision()}, {"name", std::filesystem::path(History.GetFile()).stem().string()},
				{"config", History.GetFile()}, {"canUndo", History.CanUndo()}, {"canRedo", History.CanRedo()},
				{"changed", History.GetText() != History.GetStart()}});
		WriteSettings();
		WriteVolumes();
		WriteView();
		WriteFrames();
		WriteVariables();
		WriteShowFlags();
		Writer.Objects("pins", Session.GetPins(),
			[&](const FLivePin& Pin) {
				Writer.Members({{"pin", Pin.Number}, {"name", Pin.Name}, {"revision", Pin.Revision}});
			});
		Writer.Objects("dots", Session.GetDots(),
			[&](const FLiveDot& Dot)
			{
				Writer.Members({{"revision", Dot.Revision}, {"label", Dot.Label}, {"milliseconds", Dot.Milliseconds},
					{"error", Dot.Error}, {"metric", Dot.Metric}});
			});
		Writer.Member("files", Session.GetFiles());
		Writer.Key("frame").Raw(Trim(Session.GetFrameJson()));
		Writer.Key("fault").Raw(Trim(Session.GetFaultJson()));
		return Writer.GetText();
	}

private:
	void WriteSettings()
	{
		const FRunResult* const Frame = Session.GetFrame();
		const FFinalPostProcessSettings& Values = Frame != nullptr ? Frame->Settings : Defaults;
		const FFinalPostProcessSettings& Start = Session.GetStartSettings().value_or(Values);
		Writer.Array("settings", GetSettingFields(),
			[&](const FSettingField& Field)
			{
				Writer.BeginObject(true);
				Writer.Members({{"name", Field.Name}, {"display", GetDisplayName(Field)}, {"category", Field.Category},
					{"type", ToString(Field.Type)}});
				Writer.Key("value").Raw(SettingToJson(Field, Field.Get(Values)));
				Writer.Key("default").Raw(SettingToJson(Field, Field.Default));
				Writer.Key("start").Raw(SettingToJson(Field, Field.Get(Start)));
				Writer.Member("overridden", Field.IsOverridden(Config.Camera.Settings.Settings));
				std::vector<std::string> InVolumes;
				for (size_t Index = 0; Index < Config.Volumes.size(); ++Index)
				{
					if (Field.IsOverridden(Config.Volumes[Index].Settings.Settings))
					{
						InVolumes.push_back(GetVolumeName(Config, Index));
					}
				}
				Writer.Member("inVolumes", InVolumes);
				WriteRange(Writer, Field.Range);
				if (Field.EnumNames.Num() > 0)
				{
					Writer.Member("enum", Field.EnumNames);
				}
				const FEffect* const Owner = FindSettingOwner(Field.Name);
				Writer.Members(
					{{"unit", Field.Unit}, {"doc", Field.Doc}, {"effect", Owner != nullptr ? *Owner->Name : ""},
						{"unread", Frame != nullptr ? ExplainUnread(Field.Name, *Frame) : ""},
						{"plugin", Field.AddedId != 0 ? "added" : ""}});
				Writer.EndObject();
			});
	}

	void WriteVolumes()
	{
		const FSettingsBlender Blender = MakeSettingsBlender(Config);
		const std::vector<APostProcessVolume>& Volumes = Blender.GetInputs().Volumes;
		std::vector<FVolumeAtPlace> ByIndex(Volumes.size());
		for (const FVolumeAtPlace& Place : Blender.FindVolumes(GetViewLocation(Config)))
		{
			ByIndex[Place.Volume] = Place;
		}
		Writer.Array("volumes", ByIndex,
			[&](const FVolumeAtPlace& Place)
			{
				const size_t Index = static_cast<size_t>(&Place - ByIndex.data());
				const FConfigVolume& Volume = Config.Volumes[Index];
				const FPostProcessVolumeProperties Properties = Volumes[Index].GetProperties();
				Writer.BeginObject(true);
				Writer.Members({{"name", GetVolumeName(Config, Index)}, {"priority", Volume.Priority},
					{"blendWeight", Volume.BlendWeight}, {"blendRadius", Volume.BlendRadius},
					{"unbound", Volume.bUnbound}, {"enabled", Volume.bEnabled}});
				WriteBounds(Volume);
				Writer.Members({{"distance", Place.Distance}, {"weight", Place.Influence.Weight},
					{"skipped", ExplainSkip(Place.Influence.Skip, Properties, Place.Distance.value_or(0.0))}});
				Writer.EndObject();
			});
	}

	void WriteBounds(const FConfigVolume& Volume)
	{
		if (!Volume.Bounds)
		{
			Writer.Key("bounds").Null();
			return;
		}
		constexpr const char* Shapes[] = {"box", "sphere", "capsule", "convex"};
		const FConfigBounds& Bounds = *Volume.Bounds;
		Writer.Key("bounds").Object({{"type", Shapes[static_cast<size_t>(Bounds.Shape)]}, {"center", Bounds.Center},
			{"extent", Bounds.Extent}, {"rotation", Bounds.Rotation}, {"radius", Bounds.Radius},
			{"halfHeight", Bounds.HalfHeight}, {"points", Bounds.Points}});
	}

	/** The places of the cameras of a sequence, by the headers of its files. */
	std::vector<FConfigVector> FindPath() const
	{
		std::vector<FConfigVector> Path;
		if (Config.Scene.Sequence.empty())
		{
			return Path;
		}
		try
		{
			for (const FPathPoint& Point : ReadScenePath(Config))
			{
				Path.push_back({Point.Location.X, Point.Location.Y, Point.Location.Z});
			}
		}
		catch (const FError&)
		{
			Path.clear(); // a frame has no camera, or there is one frame only
		}
		return Path;
	}

	void WriteView()
	{
		const FVector Location = GetViewLocation(Config);
		Writer.Key("view").BeginObject(true);
		Writer.Member("location", {Location.X, Location.Y, Location.Z});
		Writer.Member("rotation", Config.View.Rotation.Value);
		Writer.Member("given", Config.View.Location.IsSet());
		Writer.Member("path", FindPath());
		Writer.EndObject();
	}

	/** The frames of a sequence, and the one that is shown. */
	void WriteFrames()
	{
		if (!Config.Scene.Frame)
		{
			Writer.Key("sequence").Null();
			return;
		}
		Writer.Key("sequence")
			.Object({{"frame", *Config.Scene.Frame},
				{"frames", ToVector<int>(
							   FindSequenceFrames(Config.Resolve(Config.Scene.Sequence)), &FSequenceFrame::Number)}});
	}

	/** Whether a variable is set here, or named like an effect that runs. */
	bool DoesMatter(const FConsoleVariableInfo& Info, const std::set<std::string>& Effects) const
	{
		const std::string SetBy = *Info.SetBy;
		if (Info.bNotSimulated || SetBy != "Constructor")
		{
			return !Info.bNotSimulated;
		}
		const std::string Name = ToLowerCase(std::string(*Info.Name));
		return std::ranges::any_of(Effects, [&](const std::string& Effect) { return Name.starts_with("r." + Effect); });
	}

	void WriteVariables()
	{
		std::set<std::string> Effects = {"drydock"};
		if (const FRunResult* const Frame = Session.GetFrame())
		{
			for (const FEffectDecision& Decision : Frame->Effects)
			{
				if (Decision.bActive)
				{
					Effects.insert(ToLowerCase(Decision.GetName()));
				}
			}
		}
		Writer.Array("variables", ListConsoleVariables(),
			[&](const FConsoleVariableInfo& Info)
			{
				Writer.BeginObject(true);
				Writer.Members({{"name", *Info.Name}, {"type", *Info.Type}});
				Writer.Key("value").Raw(MakeVariableJson(Info, Info.Value));
				Writer.Key("default").Raw(MakeVariableJson(Info, Info.Default));
				Writer.Members({{"setBy", *Info.SetBy}, {"matters", DoesMatter(Info, Effects)}, {"doc", *Info.Help}});
				Writer.EndObject();
			});
	}

	void WriteShowFlags()
	{
		Writer.Array("showFlags", GetShowFlagInfos(),
			[&](const FShowFlagInfo& Info)
			{
				bool bValue = Info.bInGame;
				bool bGiven = false;
				for (const FConfigShowFlag& Flag : Config.ShowFlags)
				{
					if (ToLowerCase(Flag.Name) == ToLowerCase(std::string(Info.Name)))
					{
						bValue = Flag.bValue;
						bGiven = true;
					}
				}
				Writer.Object({{"name", Info.Name}, {"value", bValue}, {"default", Info.bInGame},
					{"matters", bGiven || FindEffectByName(Info.Name) != nullptr}, {"doc", Info.Doc}});
			});
	}

	const FLiveSession& Session;
	const FConfig& Config;
	const FFinalPostProcessSettings Defaults;
	FJsonWriter Writer{'{'};
};

} // namespace

std::string ListPictures(FLiveSession& Session, const FJsonValue&)
{
	namespace Files = std::filesystem;
	constexpr size_t Most = 200;
	const Files::path Home = Files::path(Session.GetHistory().GetFile()).parent_path();
	std::set<std::string> Pictures;
	std::error_code Error;
	for (Files::recursive_directory_iterator Entry(Home.empty() ? "." : Home, Error), End;
		 !Error && Entry != End && Pictures.size() < Most; Entry.increment(Error))
	{
		if (Entry.depth() > 0)
		{
			Entry.disable_recursion_pending();
		}
		if (IsImagePath(Entry->path().string()))
		{
			Pictures.insert(Entry->path().lexically_relative(Home.empty() ? "." : Home).generic_string());
		}
	}
	FJsonWriter Writer('{');
	Writer.Member("pictures", Pictures);
	return Writer.GetText();
}

std::string MakeStateJson(FLiveSession& Session, const FJsonValue&)
{
	return FStateWriter(Session, Session.BeginRun()).Write();
}

} // namespace Drydock
