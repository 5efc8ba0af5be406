// Writes and checks the record of a baseline.
#include "Program/Baseline.h"

#include "Diagnostics.h"
#include "Text/ConfigErrors.h"
#include "Text/Fingerprint.h"
#include "Text/Json.h"
#include "Text/JsonWriter.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "Text/Version.h"

#include <filesystem>
#include <set>

namespace Drydock
{

namespace
{

namespace fs = std::filesystem;

constexpr const char* RecordName = "baseline.json";

[[noreturn]] void Refuse(const fs::path& File, const std::string& Message)
{
	throw FError(
		{.Code = ErrorNotBlessed,
			.Message = Message + "; a person accepts pictures with drydock bless RUN --to FOLDER --because REASON",
			.File = File.string()},
		ExitUsage);
}

/** All EXR files of a folder, relative to it. */
std::set<std::string> ListPictures(const fs::path& Folder)
{
	std::set<std::string> Names;
	std::error_code Error;
	for (fs::recursive_directory_iterator Entry(Folder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (Entry->path().extension() == ".exr")
		{
			Names.insert(Entry->path().lexically_relative(Folder).generic_string());
		}
	}
	return Names;
}

} // namespace

bool IsBaseline(const std::string& Folder)
{
	std::error_code Error;
	return fs::is_regular_file(fs::path(Folder) / RecordName, Error);
}

void WriteBaseline(const std::string& Run, const std::string& Folder, const std::vector<std::string>& Files,
	const std::string& Because)
{
	static const FOutputNames Names = {.Name = "baseline",
		.Files = {RecordName, "final.exr", "final.png", "scene_linear.exr"},
		.Last = RecordName,
		.Folders = {"passes"},
		.Unsteady = {}};
	FOutputFolder Output(Folder, Names);
	FJsonWriter Writer('{');
	Writer.Members({{"drydock", GetVersion()}, {"commit", GetCommit()}, {"because", Because}});
	Writer.Key("files").BeginObject();
	for (const std::string& Name : Files)
	{
		const fs::path To = Output.GetAside() / Name;
		std::error_code Error;
		fs::create_directories(To.parent_path(), Error);
		fs::copy_file(fs::path(Run) / Name, To, Error);
		if (Error)
		{
			throw FError(
				{.Code = ErrorFileNotWritten, .Message = "cannot be copied: " + Error.message(), .File = To.string()},
				ExitFiles);
		}
		Writer.Member(Name, FingerprintFile(To.string()));
	}
	WriteWholeFile((Output.GetAside() / RecordName).string(), Writer.GetText());
	Output.PutInPlace();
}

void CheckBaseline(const std::string& Folder)
{
	const fs::path Record = fs::path(Folder) / RecordName;
	if (!IsBaseline(Folder))
	{
		Refuse(Folder, "nobody blessed these pictures: there is no baseline.json");
	}
	std::vector<FDiagnostic> Diagnostics;
	bool bSyntaxError = false;
	const FJsonValue Root =
		ParseJson(ReadTextFile(Record.string(), "cannot be read"), Record.string(), Diagnostics, bSyntaxError);
	const FJsonValue* const Blessed = Root.Find("files");
	if (bSyntaxError || Blessed == nullptr)
	{
		Refuse(Record, "the record of the baseline is damaged");
	}
	std::set<std::string> Pictures = ListPictures(Folder);
	for (const FJsonMember& File : Blessed->Members)
	{
		const fs::path Path = fs::path(Folder) / File.Key;
		std::error_code Error;
		if (!fs::is_regular_file(Path, Error) || FingerprintFile(Path.string()) != File.Value.String)
		{
			Refuse(Path, "this is not the file that was blessed");
		}
		Pictures.erase(File.Key);
	}
	if (!Pictures.empty())
	{
		Refuse(fs::path(Folder) / *Pictures.begin(), "nobody blessed this file");
	}
}

} // namespace Drydock
