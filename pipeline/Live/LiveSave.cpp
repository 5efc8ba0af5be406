// Writes the state of a session where a person may have it written.
#include "Live/LiveSave.h"

#include "Config/ReadConfig.h"
#include "Config/SettingsJson.h"
#include "Live/LiveErrors.h"
#include "Live/LiveSession.h"
#include "PostProcessSettingsReflection.h"
#include "Run/FinalSettings.h"
#include "Text/JsonWriter.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

/** Without links, as far as it exists. */
Files::path Resolve(const Files::path& Path)
{
	std::error_code Error;
	const Files::path Resolved = Files::weakly_canonical(Files::absolute(Path, Error), Error);
	return Error ? Files::path() : Resolved;
}

bool IsBelow(const Files::path& Path, const Files::path& Folder)
{
	const auto [InFolder, InPath] = std::mismatch(Folder.begin(), Folder.end(), Path.begin(), Path.end());
	return InFolder == Folder.end() && !Folder.empty();
}

FError MakePlaceError(const std::string& Message, const std::string& Path)
{
	return FError({.Code = ErrorSavePlace, .Message = Message, .File = Path}, ExitUsage);
}

/** The relative paths of files in a config, as they lead there from another folder. */
void FindMovedPaths(
	const FJsonValue& Value, const Files::path& From, const Files::path& To, std::vector<FConfigEdit>& Moved)
{
	std::error_code Error;
	const Files::path Path = Value.String;
	const bool bText = Value.Type == EJsonType::String && !Value.String.empty() && Path.is_relative();
	if (bText && (Value.Pointer == "/scene/file" || Files::exists(From / Path, Error)))
	{
		const Files::path There = (From / Path).lexically_normal().lexically_relative(To);
		Moved.push_back({Value.Pointer, FJsonWriter::Quote(There.generic_string())});
	}
	for (const FJsonValue& Element : Value.Elements)
	{
		FindMovedPaths(Element, From, To, Moved);
	}
	for (const FJsonMember& Member : Value.Members)
	{
		FindMovedPaths(Member.Value, From, To, Moved);
	}
}

std::string MoveConfig(const FLiveSession& Session, const Files::path& From, const Files::path& To)
{
	const FEditHistory& History = Session.GetHistory();
	std::vector<FConfigEdit> Moved;
	if (From != To)
	{
		FindMovedPaths(ParseConfigDocument(History.GetText(), History.GetFile()).Root, From, To, Moved);
	}
	return ApplyEdits(History.GetText(), Moved);
}

/** The volumes as actors of the editor, and what the camera overrides as one more. */
std::string MakeEngineText(const FConfig& Config)
{
	std::vector<FDiagnostic> Ignored; // shapes that are left out; those who export by the verb are told
	std::vector<FVolumeText> Volumes;
	for (const FConfigVolume& Volume : Config.Volumes)
	{
		Volumes.push_back(MakeVolumeText(Volume, Config.File, Ignored));
	}
	FVolumeText Camera;
	Camera.Name = "Camera";
	Camera.bUnbound = true;
	Camera.Settings.Settings = Config.Camera.Settings.Settings;
	if (std::ranges::any_of(GetSettingFields(),
			[&](const FSettingField& Field) { return Field.IsOverridden(Camera.Settings.Settings); }))
	{
		for (const FVolumeText& Volume : Volumes)
		{
			Camera.Priority = std::max(Camera.Priority, Volume.Priority + 1.0);
		}
		Volumes.push_back(Camera);
	}
	return WriteVolumesText(Volumes, ESettingsTextForm::Delta, Ignored);
}

} // namespace

std::string SaveConfig(FLiveSession& Session, const FJsonValue& Request)
{
	const std::string Path = Request.GetString("path");
	const FJsonValue* const Again = Request.Find("again");
	const Files::path Home = Resolve(Session.GetHistory().GetFile()).parent_path();
	const Files::path File = Resolve(Home / Path);
	if (Path.find('\0') != std::string::npos || File.extension() != ".json")
	{
		throw MakePlaceError("a config is saved as a file that ends in .json", Path);
	}
	const std::string& Out = Session.GetOptions().OutputFolder;
	if (File.parent_path() != Home && (Out.empty() || !IsBelow(File, Resolve(Out))))
	{
		throw MakePlaceError("a config is saved beside the one that was opened" +
								 (Out.empty() ? std::string() : ", or in " + Out) + ", and nowhere else",
			Path);
	}
	std::error_code Error;
	const Files::file_status Status = Files::symlink_status(File, Error);
	if (Files::exists(Status) && !Files::is_regular_file(Status))
	{
		throw MakePlaceError("this is not a file", Path);
	}
	if (Files::exists(Status) && (Again == nullptr || !Again->Bool))
	{
		throw FError(
			{.Code = ErrorFileExists, .Message = "the file exists: ask again to replace it", .File = Path}, ExitUsage);
	}
	WriteTextFile(File.string(), MoveConfig(Session, Home, File.parent_path()));
	return "{\"saved\": " + FJsonWriter::Quote(Path) + "}\n";
}

std::string MakeLiveText(FLiveSession& Session, const FJsonValue& Asked)
{
	const std::string As = Asked.GetString("as");
	if (As == "config")
	{
		return Session.GetHistory().GetText();
	}
	const FConfig& Config = Session.BeginRun();
	std::string Text;
	if (As == "engine")
	{
		return MakeEngineText(Config);
	}
	if (As == "variables")
	{
		for (const FConfigVariable& Variable : Config.Variables)
		{
			Text += Variable.Name + "=" + Variable.Value + "\n";
		}
		return Text;
	}
	if (As != "lines")
	{
		throw FError(
			{.Code = ErrorBadEdit, .Message = "expected config, engine, lines or variables", .Where = "as"}, ExitUsage);
	}
	for (const FConfigEdit& Change : FindChanges(Session.GetHistory().GetStart(), Session.GetHistory().GetText()))
	{
		Text += WriteEdit(Change) + "\n";
	}
	return Text;
}

} // namespace Drydock
