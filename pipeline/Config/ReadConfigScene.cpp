// Reads the scene and its views, key by key in the order of the format.
#include "Config/ReadConfigScene.h"

#include "Config/ConfigFields.h"
#include "Config/FrameList.h"
#include "Config/FrameSequence.h"
#include "Math/ToInteger.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace Drydock
{

namespace
{

/** Largest picture side that a rect may name. */
constexpr double MaxExtent = 65536.0;
constexpr double MaxPadding = 4096.0;
constexpr double MaxScreenPercentage = 400.0;

/** A number of texels to pad one side with; empty (and reported) when it is none. */
std::optional<int> ReadPaddingSide(const FJsonValue& Value, FConfigMessages& Messages)
{
	if (Value.Type != EJsonType::Number)
	{
		return std::nullopt; // reported
	}
	if (Value.Number != std::floor(Value.Number) || Value.Number < 0.0 || Value.Number > MaxPadding)
	{
		Messages.Error(ErrorBadValue, Value, "padding must be a whole number of texels, 0 to 4096");
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
		return Value.GetString(Key) == Unit;
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
		Messages.Error(ErrorBadValue, Value, "frames need a sequence: scene.file must have #### in its name");
	}
	Scene.Frames = {Value.String, PlaceOf(Value)};
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
						ErrorBadValue, Corner, "a corner of the rect must be a whole number of pixels, 0 or more");
					return;
				}
				Corners[Index] = ToInteger<int>(Corner.Number);
			}
			if (Corners[0] >= Corners[2] || Corners[1] >= Corners[3])
			{
				Messages.Error(
					ErrorBadValue, Rect, "the rect is empty: it must be [MinX, MinY, MaxX, MaxY] with Max above Min");
				return;
			}
			View.Rect = {Corners, PlaceOf(Rect)};
		});
}

/** The texts of an object, by key. */
void ReadStrings(const FJsonValue& Value, const char* Key, std::map<std::string, TConfigValue<std::string>>& Strings)
{
	WithMember(Value, Key, EJsonType::Object,
		[&](const FJsonValue& Object)
		{
			for (const auto& [Name, Text] : Object.Members)
			{
				if (Text.Type == EJsonType::String)
				{
					Strings[Name] = {Text.String, PlaceOf(Text)};
				}
			}
		});
}

} // namespace

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
				Messages.Error(ErrorBadValue, Fps, "fps must be 0.01 to 10000 frames per second");
				return;
			}
			Scene.Fps = {Fps.Number, PlaceOf(Fps)};
		});
	ReadStrings(Value, "channels", Scene.Channels);
	ReadStrings(Value, "textures", Scene.Textures);
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
				Messages.Error(ErrorBadValue, Fov, "fov must be an angle of 1 to 179 degrees");
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
					Messages.Error(ErrorMissingKey, Value, "\"rect\" is missing: each of several views must have one");
				}
				Config.Views.push_back(View);
			}
			if (Root.Find("view") != nullptr)
			{
				Messages.ErrorAtKey(
					ErrorBadValue, Views, "\"view\" and \"views\" exclude each other: give only one of them");
			}
			else if (!Config.Views.empty())
			{
				Config.View = Config.Views[0];
			}
		});
}

} // namespace Drydock
