// Copies the template of a patch under another name, whole or not at all.
#include "Patch/PatchTemplate.h"

#include "Diagnostics.h"
#include "Extensions/PublishedSchema.h"
#include "InstallPaths.h"
#include "Patch/PatchErrors.h"
#include "Text/AsideFile.h"
#include "Text/ConfigErrors.h"
#include "Text/TextFile.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string TemplateName = "MyPatch";

[[noreturn]] void Fail(int Code, EExitCode ExitCode, const Files::path& File, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = File.string()}, ExitCode);
}

} // namespace

std::string FindTemplates()
{
	const std::string Installed = FindInstalled("share/drydock/templates");
	return Installed.empty() ? DRYDOCK_SOURCE_DIR "/templates" : Installed;
}

std::string ReadOwnFile(const Files::path& Path)
{
	return ReadTextFile(Path, "drydock's own file cannot be opened: is drydock installed completely?", MaxBinaryBytes);
}

std::vector<FPatchFile> ReadTemplate(const Files::path& Folder)
{
	std::vector<FPatchFile> Found;
	std::error_code Error;
	for (Files::recursive_directory_iterator Entry(Folder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (Entry->is_regular_file(Error))
		{
			Found.push_back({Entry->path().lexically_relative(Folder).generic_string(), ReadOwnFile(Entry->path())});
		}
	}
	return Found;
}

std::string RenamePatch(const std::string& Text, const std::string& Name)
{
	std::string Renamed;
	size_t From = 0;
	for (size_t At; (At = Text.find(TemplateName, From)) != std::string::npos; From = At + TemplateName.size())
	{
		Renamed.append(Text, From, At - From).append(Name);
	}
	return Renamed.append(Text, From);
}

std::vector<FPatchFile> MakePatchFiles(const std::string& Name)
{
	const Files::path Root = Files::path(FindTemplates()).parent_path();
	const Files::path Template = Root / "templates" / TemplateName;
	std::vector<FPatchFile> Project;
	for (const FPatchFile& File : ReadTemplate(Template))
	{
		Project.push_back({RenamePatch(File.Path, Name), RenamePatch(File.Text, Name)});
	}
	if (Project.empty())
	{
		Fail(ErrorFileMissing, ExitFiles, Template,
			"drydock's own templates are missing: is drydock installed completely?");
	}
	Project.push_back({"configs/scenes/room.exr", ReadOwnFile(Root / "configs/scenes/moving_camera.0001.exr")});
	Project.push_back({"configs/schema/drydock.schema.json", MakePublishedSchema()});
	std::sort(Project.begin(), Project.end(), [](const FPatchFile& A, const FPatchFile& B) { return A.Path < B.Path; });
	return Project;
}

void WritePatch(const std::string& Folder, const std::vector<FPatchFile>& Project)
{
	const Files::path Target = Files::absolute(Folder).lexically_normal();
	const auto RefuseExisting = [&]
	{
		std::error_code Ignored;
		if (Files::exists(Files::symlink_status(Target, Ignored)))
		{
			Fail(ErrorPatchExists, ExitUsage, Folder,
				"exists already, and nothing is overwritten: choose another name or --dir");
		}
	};
	RefuseExisting();
	try
	{
		FAsideFile Aside(Target);
		for (const FPatchFile& File : Project)
		{
			WriteTextFile((Aside.GetPath() / File.Path).string(), File.Text);
		}
		Aside.PutInPlace();
	}
	catch (const FError& Unwritten)
	{
		RefuseExisting(); // somebody made it meanwhile
		Fail(ErrorFileNotWritten, ExitFiles, Folder, Unwritten.GetDiagnostics().front().Message);
	}
}

} // namespace Drydock
