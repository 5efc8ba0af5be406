// Reads a path from JSON, or from the cameras of a scene's frames.
#include "Blend/WalkPath.h"

#include "Config/ConfigReader.h"
#include "Config/FrameSequence.h"
#include "Picture/ImageFile.h"
#include "RangeTools.h"
#include "SceneFile/SceneSuggestions.h"
#include "Text/TextFile.h"
#include "Text/TextFormat.h"

#include <cmath>

namespace Drydock
{

namespace
{

const std::vector<std::string> PointKeys = {"location", "frame", "t"};

FVector ToLocation(const FConfigVector& Vector)
{
	return FVector(Vector[0], Vector[1], Vector[2]);
}

/** The number at Key as a label; reports a value that is none. */
std::string ReadLabel(const FJsonValue& Point, const char* Key, bool bWhole, FConfigMessages& Messages)
{
	const FJsonValue* Value = Point.Find(Key);
	if (Value == nullptr || Value->Type == EJsonType::Invalid)
	{
		return "";
	}
	if (Value->Type != EJsonType::Number || (bWhole && Value->Number != std::floor(Value->Number)))
	{
		Messages.Error(ErrorWrongType, *Value,
			std::string("expected a ") + (bWhole ? "whole " : "") + "number, found " +
				(Value->Type == EJsonType::Number ? NumberText(Value->Number) : Value->Describe()));
		return "";
	}
	return NumberText(Value->Number);
}

FPathPoint ReadPoint(const FJsonValue& Value, size_t Index, FConfigMessages& Messages)
{
	FPathPoint Point{FVector(0.0, 0.0, 0.0), std::to_string(Index + 1)};
	if (Value.Type != EJsonType::Object)
	{
		Messages.Error(ErrorWrongType, Value,
			std::string("expected a point {\"location\": [x, y, z]}, found ") + Value.Describe());
		return Point;
	}
	for (const auto& [Key, Member] : Value.Members)
	{
		if (!Contains(PointKeys, Key))
		{
			Messages.ErrorAtKey(ErrorUnknownKey, Member, "unknown key" + Messages.Suggest(Key, PointKeys));
		}
	}
	const FJsonValue* Location = Value.Find("location");
	FConfigVector Vector = {};
	if (Location == nullptr)
	{
		Messages.Error(ErrorMissingKey, Value, "the point has no \"location\"");
	}
	else if (!ReadConfigVector(*Location, Vector))
	{
		Messages.Error(ErrorWrongType, *Location, "expected [x, y, z] in cm");
	}
	Point.Location = ToLocation(Vector);
	const std::string Frame = ReadLabel(Value, "frame", true, Messages);
	const std::string Time = ReadLabel(Value, "t", false, Messages);
	Point.Label = !Frame.empty() ? Frame : !Time.empty() ? Time : Point.Label;
	return Point;
}

[[noreturn]] void ThrowNoScenePath(const FConfig& Config, const std::string& File, const std::string& Message)
{
	throw FError({.Code = ErrorBadArgument,
					 .Message = Message,
					 .File = File.empty() ? Config.File : File,
					 .Where = "--path scene"},
		ExitUsage);
}

} // namespace

std::vector<FPathPoint> ReadPath(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics)
{
	std::vector<FPathPoint> Points;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(Text, File, Diagnostics, bSyntaxError);
	if (bSyntaxError)
	{
		return Points;
	}
	FConfigMessages Messages(File, Diagnostics);
	if (Root.Type != EJsonType::Array)
	{
		Messages.Error(ErrorWrongType, Root, std::string("expected an array of points, found ") + Root.Describe());
		return Points;
	}
	for (const FJsonValue& Element : Root.Elements)
	{
		Points.push_back(ReadPoint(Element, Points.size(), Messages));
	}
	if (Points.size() < 2)
	{
		Messages.Error(ErrorWrongLength, Root, "a path has two points or more");
	}
	return Points;
}

std::vector<FPathPoint> LoadPath(const std::string& File)
{
	std::vector<FDiagnostic> Diagnostics;
	std::vector<FPathPoint> Points = ReadPath(ReadTextFile(File, "the path cannot be read"), File, Diagnostics);
	if (HasErrors(Diagnostics))
	{
		throw FError(Diagnostics, ExitUsage);
	}
	return Points;
}

std::vector<FPathPoint> ReadScenePath(const FConfig& Config)
{
	if (Config.Scene.Sequence.empty())
	{
		ThrowNoScenePath(Config, "", "the scene is not a sequence of frames: its file's name has no ####");
	}
	const std::vector<FSequenceFrame> Frames = FindSequenceFrames(Config.Resolve(Config.Scene.Sequence));
	if (Frames.size() < 2)
	{
		ThrowNoScenePath(Config, "", "a path needs two frames, and there is one");
	}
	std::vector<FPathPoint> Points;
	for (const FSequenceFrame& Frame : Frames)
	{
		const FImageFile File(Frame.Path);
		const std::optional<FConfigVector> Location = ReadSuggestedLocation(File.GetAttribute("drydock:camera_json"));
		if (!Location)
		{
			ThrowNoScenePath(Config, Frame.Path, "the frame has no camera (drydock:camera_json)");
		}
		Points.push_back({ToLocation(*Location), std::to_string(Frame.Number)});
	}
	return Points;
}

} // namespace Drydock
