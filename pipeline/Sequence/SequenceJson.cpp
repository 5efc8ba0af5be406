// Writes and reads frame.json and sequence.json.
#include "Sequence/SequenceJson.h"

#include "Run/FinalSettings.h"
#include "Sequence/SequenceErrors.h"
#include "Sequence/ViewStateFile.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"
#include "Text/Version.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

void AddImage(FFingerprint& Fingerprint, const FImage& Image)
{
	const int Shape[] = {Image.Width, Image.Height, Image.NumChannels};
	Fingerprint.Add(Shape, sizeof(Shape));
	Fingerprint.Add(Image.Values.data(), Image.Values.size() * sizeof(double));
}

void AddPicture(FFingerprint& Fingerprint, const FPicture& Picture)
{
	const int Shape[] = {Picture.Width, Picture.Height, Picture.NumChannels};
	Fingerprint.Add(Shape, sizeof(Shape));
	std::vector<float> Row(static_cast<size_t>(Picture.Width) * static_cast<size_t>(Picture.NumChannels));
	for (int Y = 0; Y < Picture.Height; ++Y)
	{
		Picture.ReadRow(Y, Row.data());
		Fingerprint.Add(Row.data(), Row.size() * sizeof(float));
	}
}

std::string FingerprintPictures(const FRunResult& Result)
{
	FFingerprint Fingerprint;
	AddPicture(Fingerprint, Result.Final);
	AddPicture(Fingerprint, Result.SceneLinear);
	for (const auto& [Id, Figures] : Result.Figures)
	{
		for (const FEffectPicture& Picture : Figures.Pictures)
		{
			AddImage(Fingerprint, Picture.Image);
		}
	}
	for (const FRunDump& Dump : Result.Dumps)
	{
		AddPicture(Fingerprint, Dump.Image);
	}
	return Fingerprint.Get();
}

FJsonValue Parse(const std::string& Text, const std::string& File, const char* What)
{
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	FJsonValue Root = ParseJson(Text, File, Diagnostics, bSyntaxError);
	if (bSyntaxError || Root.Type != EJsonType::Object)
	{
		throw FError(
			{.Code = ErrorSequenceBroken,
				.Message = std::string("is not a ") + What + " of drydock's: --restart renders all frames again",
				.File = File},
			ExitFiles);
	}
	return Root;
}

/** Objects and arrays below the first level on one line. */
void WriteValue(FJsonWriter& Writer, const FJsonValue& Value)
{
	switch (Value.Type)
	{
	case EJsonType::Bool:
		Writer.Value(Value.Bool);
		return;
	case EJsonType::Number:
		Writer.Value(Value.Number);
		return;
	case EJsonType::String:
		Writer.Value(Value.String);
		return;
	case EJsonType::Array:
		Writer.BeginArray(true);
		for (const FJsonValue& Element : Value.Elements)
		{
			WriteValue(Writer, Element);
		}
		Writer.EndArray();
		return;
	case EJsonType::Object:
		Writer.BeginObject(true);
		for (const FJsonMember& Member : Value.Members)
		{
			Writer.Key(Member.Key);
			WriteValue(Writer, Member.Value);
		}
		Writer.EndObject();
		return;
	case EJsonType::Null:
	case EJsonType::Invalid:
		Writer.Null();
		return;
	}
}

void WriteHead(FJsonWriter& Writer, const FConfig& Config, const FRunInputs& Inputs, bool bComplete)
{
	Writer.Members({{"version", GetVersion()}, {"config", Config.File}, {"scene", Config.Scene.Sequence},
		{"complete", bComplete}});
	Writer.Key("inputs").BeginObject();
	for (const auto& [Name, Text] : Inputs)
	{
		Writer.Member(Name, Text);
	}
	Writer.EndObject();
}

/** By frame, then setting: the value as JSON text. */
using FSettingTexts = std::vector<std::map<std::string, std::string>>;

/** Only those that are not the same in all frames. A frame's report is read, looked at and let go of. */
FSettingTexts FindVarying(const FSequenceFolder& Folder, const std::vector<int>& Frames)
{
	FSettingTexts Texts;
	std::map<std::string, std::string> First;
	std::set<std::string> Varying;
	const auto ForEachSetting = [&](int Frame, const auto& Function)
	{
		const std::string File = (std::filesystem::path(Folder.GetFramePath(Frame)) / "run.json").string();
		const FJsonValue Root = Parse(ReadTextFile(File), File, "run.json");
		const FJsonValue* Settings = Root.Find("settings");
		for (size_t Index = 0; Settings != nullptr && Index < Settings->Members.size(); ++Index)
		{
			FJsonWriter Writer;
			WriteValue(Writer, Settings->Members[Index].Value);
			std::string Text = Writer.GetText();
			Text.pop_back(); // the line break
			Function(Settings->Members[Index].Key, Text);
		}
	};
	for (const int Frame : Frames)
	{
		ForEachSetting(Frame,
			[&](const std::string& Name, const std::string& Text)
			{
				if (First.emplace(Name, Text).first->second != Text)
				{
					Varying.insert(Name);
				}
			});
	}
	for (const int Frame : Frames)
	{
		Texts.emplace_back();
		ForEachSetting(Frame,
			[&](const std::string& Name, const std::string& Text)
			{
				if (Varying.count(Name) > 0)
				{
					Texts.back()[Name] = Text;
				}
			});
	}
	return Texts;
}

} // namespace

FFrameRecord MakeFrameRecord(const FRunResult& Result, const std::string& FileFingerprint)
{
	FFrameRecord Record;
	Record.Frame = Result.Config.Scene.Frame.value_or(0);
	Record.File = Result.Config.Scene.File.Value;
	Record.FileFingerprint = FileFingerprint;
	Record.Picture = FingerprintPictures(Result);
	Record.State = FingerprintViewStates(Result.ViewStates);
	return Record;
}

std::string MakeFrameJson(const FRunResult& Result, const FFrameRecord& Record)
{
	FVector Location = GetViewLocation(Result.Config);
	if (!Result.ViewStates.empty() && Result.ViewStates[0].Projection)
	{
		Location = Result.ViewStates[0].Projection->ViewOrigin; // where extensions left it
	}
	FJsonWriter Writer('{');
	Writer.Member("frame", Record.Frame);
	if (Record.After >= 0)
	{
		Writer.Member("after", Record.After);
	}
	Writer.Members({{"file", Record.File}, {"fileFingerprint", Record.FileFingerprint},
		{"location", std::array{Location.X, Location.Y, Location.Z}}});
	Writer.Key("volumes").BeginObject(true);
	const FSettingsBlender Blender = MakeSettingsBlender(Result.Config);
	std::vector<FVolumeAtPlace> Volumes = Blender.FindVolumes(Location);
	std::ranges::sort(Volumes, {}, &FVolumeAtPlace::Volume);
	for (const FVolumeAtPlace& Volume : Volumes)
	{
		Writer.Member(GetVolumeName(Result.Config, Volume.Volume), Volume.Influence.Weight);
	}
	Writer.EndObject();
	Writer.Key("exposure")
		.Object({{"scale", Result.ExposureScale}, {"preExposure", Result.Config.View.PreExposure.Value}});
	const auto NumPasses =
		std::ranges::count_if(Result.Graph.Passes, [](const FRDGCompiledPass& Pass) { return !Pass.bIsSentinel; });
	Writer.Key("passes").Object({{"executed", static_cast<int64_t>(Result.Passes.size())},
		{"culled", static_cast<int64_t>(NumPasses) - static_cast<int64_t>(Result.Passes.size())}});
	Writer.Member("picture", Record.Picture);
	Writer.MemberIfAny("seen", Record.Seen);
	Writer.Member("state", Record.State);
	return Writer.GetText();
}

FFrameRecord ReadFrameRecord(const std::string& FrameJson, const std::string& File)
{
	const FJsonValue Root = Parse(FrameJson, File, "frame.json");
	FFrameRecord Record;
	Record.Frame = static_cast<int>(Root.GetNumber("frame", 0.0));
	Record.After = static_cast<int>(Root.GetNumber("after", -1.0));
	Record.File = Root.GetString("file");
	Record.FileFingerprint = Root.GetString("fileFingerprint");
	Record.Picture = Root.GetString("picture");
	Record.Seen = Root.GetString("seen");
	Record.State = Root.GetString("state");
	return Record;
}

std::string MakeSequenceHead(const FConfig& Config, const FRunInputs& Inputs)
{
	FJsonWriter Writer('{');
	WriteHead(Writer, Config, Inputs, false);
	return Writer.GetText();
}

std::string MakeSequenceJson(
	const FConfig& Config, const FRunInputs& Inputs, const FSequenceFolder& Folder, const std::vector<int>& Frames)
{
	const FSettingTexts Varying = FindVarying(Folder, Frames);
	FJsonWriter Writer('{');
	WriteHead(Writer, Config, Inputs, true);
	Writer.Member("varying", std::views::keys(Varying.front()));
	Writer.Key("frames").BeginArray();
	for (size_t Index = 0; Index < Frames.size(); ++Index)
	{
		const std::string File = Folder.GetFramePath(Frames[Index]);
		const FJsonValue Root = Parse(Folder.ReadFrameJson(Frames[Index]), File, "frame.json");
		Writer.BeginObject();
		for (const FJsonMember& Member : Root.Members)
		{
			Writer.Key(Member.Key);
			WriteValue(Writer, Member.Value);
		}
		Writer.Object("settings", Varying[Index], [&](const auto& Each) { Writer.Key(Each.first).Raw(Each.second); });
		Writer.EndObject();
	}
	return Writer.GetText();
}

bool IsSequenceComplete(const std::string& SequenceJson, const std::string& File, const std::vector<int>& Frames)
{
	const FJsonValue Root = Parse(SequenceJson, File, "sequence.json");
	const FJsonValue* Complete = Root.Find("complete");
	const FJsonValue* Records = Root.Find("frames");
	if (Complete == nullptr || !Complete->Bool || Records == nullptr)
	{
		return false;
	}
	return std::ranges::equal(Records->Elements, Frames,
		[](const FJsonValue& Record, int Frame) { return Record.GetNumber("frame", -1.0) == Frame; });
}

FRunInputs ReadSequenceInputs(const std::string& SequenceJson, const std::string& File)
{
	const FJsonValue Root = Parse(SequenceJson, File, "sequence.json");
	FRunInputs Inputs;
	if (const FJsonValue* Found = Root.Find("inputs"))
	{
		for (const FJsonMember& Member : Found->Members)
		{
			Inputs[Member.Key] = Member.Value.String;
		}
	}
	return Inputs;
}

} // namespace Drydock
