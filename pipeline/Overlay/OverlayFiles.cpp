// Copies the templates of overlays, and runs `diff` on what became of them.
#include "Overlay/OverlayFiles.h"

#include "ChildProcess.h"
#include "Config/ConfigReader.h"
#include "Overlay/CppText.h"
#include "Overlay/OverlayErrors.h"
#include "Patch/PatchErrors.h"
#include "ShaderCore.h"
#include "ShaderDirectories.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string PrivateShaders = "Engine/Shaders/Private/";

/** "BloomSetup" of AddBloomSetupPass, "DiaphragmDOF" of DiaphragmDOF::AddPasses. */
std::string GetShortName(std::string_view Function)
{
	if (const size_t Scope = Function.find("::"); Scope != Function.npos)
	{
		return std::string(Function.substr(0, Scope));
	}
	Function.remove_prefix(std::string_view("Add").size());
	for (const std::string_view End : {"Passes", "Pass"})
	{
		if (Function.ends_with(End))
		{
			Function.remove_suffix(End.size());
			break;
		}
	}
	return std::string(Function);
}

Files::path GetTemplates()
{
	return Files::path(FindTemplates()) / "overlay";
}

std::string ReadOwnFile(const Files::path& Path)
{
	return ReadTextFile(
		Path.string(), "drydock's own file cannot be opened: is drydock installed completely?", MaxBinaryBytes);
}

/** Files below a folder of templates, from it on. */
std::vector<std::string> ListTemplate(const Files::path& Template)
{
	std::vector<std::string> Found;
	std::error_code Error;
	for (Files::recursive_directory_iterator Entry(Template, Error), End; !Error && Entry != End;
		 Entry.increment(Error))
	{
		if (Entry->is_regular_file(Error))
		{
			Found.push_back(Entry->path().lexically_relative(Template).generic_string());
		}
	}
	return Found;
}

/** drydock's own file of a shader; empty: it has none. No overlay is active here. */
std::string FindOwnShader(const std::string& VirtualPath)
{
	MapShippedShaders();
	return FindShaderFile(VirtualPath);
}

/** drydock's text of a file of the engine's tree; empty: it has none. */
std::string FindOriginal(const std::string& File)
{
	constexpr std::string_view Shaders = "Engine/Shaders/";
	if (File.starts_with(Shaders))
	{
		return FindOwnShader("/Engine/" + File.substr(Shaders.size()));
	}
	for (const std::string& Pass : ListOverlayPasses())
	{
		const Files::path Template = GetTemplates() / Pass / File;
		std::error_code Error;
		if (Files::is_regular_file(Template, Error))
		{
			return Template.string();
		}
	}
	return "";
}

/** Reads what `diff` prints: two lines of names, then hunks. */
void TakeHunks(const std::string& File, const std::string& Output, std::vector<FOverlayHunk>& Hunks)
{
	std::istringstream Lines(Output);
	bool bInHunk = false;
	for (std::string Line; std::getline(Lines, Line);)
	{
		if (Line.starts_with("@@ "))
		{
			const size_t End = Line.find(" @@", 3);
			Hunks.push_back({File, Trim(End == Line.npos ? "" : Line.substr(End + 3)), "", false});
			bInHunk = true;
		}
		else if (bInHunk && (Line.starts_with('+') || Line.starts_with('-')))
		{
			FOverlayHunk& Hunk = Hunks.back();
			Hunk.Lines += Line + "\n";
			Hunk.bOwn |= ToLowerCase(Line).find("drydock") != Line.npos;
		}
	}
}

} // namespace

std::vector<std::string> ListOverlayPasses()
{
	std::vector<std::string> Names;
	for (const FPassFunction& Pass : GetPassFunctions())
	{
		Names.push_back(GetShortName(Pass.Name));
	}
	return Names;
}

std::vector<FPatchFile> MakeOverlayFiles(const std::string& Name, const std::string& Pass)
{
	const std::vector<FPassFunction>& Functions = GetPassFunctions();
	const auto Found = std::find_if(Functions.begin(), Functions.end(),
		[&](const FPassFunction& Function) { return GetShortName(Function.Name) == Pass; });
	if (Found == Functions.end())
	{
		throw FError({.Code = ErrorOverlayFolder,
						 .Message = "there is no pass \"" + Pass + "\"" + Suggest(Pass, ListOverlayPasses()) +
									"; the passes are " + JoinText(ListOverlayPasses())},
			ExitUsage);
	}
	std::vector<FPatchFile> Made;
	for (const std::string& File : ListTemplate(GetTemplates() / Pass))
	{
		Made.push_back({File, ReadOwnFile(GetTemplates() / Pass / File)});
	}
	if (*Found->Shader != '\0')
	{
		Made.push_back({PrivateShaders + Found->Shader,
			ReadOwnFile(FindOwnShader(std::string("/Engine/Private/") + Found->Shader))});
	}
	if (Made.empty())
	{
		throw FError({.Code = ErrorOverlayFolder,
						 .Message = Pass +
									" runs on the CPU and has no shader, and drydock has no C++ of the engine's "
									"form for it; put the engine's own files in a folder " +
									Name + "/Engine/Source/Runtime/Renderer/Private/PostProcess"},
			ExitUsage);
	}
	Made.push_back({Name + ".json", RenamePatch(ReadOwnFile(GetTemplates() / "MyPatch.json"), Name)});
	Made.push_back({"scenes/room.exr",
		ReadOwnFile(Files::path(FindTemplates()).parent_path() / "configs/scenes/moving_camera.0001.exr")});
	std::sort(Made.begin(), Made.end(), [](const FPatchFile& A, const FPatchFile& B) { return A.Path < B.Path; });
	return Made;
}

FOverlayDifference CompareOverlay(const FOverlayFolder& Folder)
{
	constexpr int TimeLimit = 60;
	std::vector<std::string> Edited = Folder.Read;
	std::transform(Folder.Shaders.begin(), Folder.Shaders.end(), std::back_inserter(Edited),
		[&](const std::string& Shader) { return Folder.GetShaderFile(Shader); });
	std::sort(Edited.begin(), Edited.end());
	FOverlayDifference Difference;
	for (const std::string& Path : Edited)
	{
		const std::string File = Path.substr(Folder.Path.size() + 1);
		const std::string Original = FindOriginal(File);
		if (Original.empty())
		{
			Difference.NewFiles.push_back(File);
			continue;
		}
		const FChildResult Result =
			RunChild({"diff", "-U0", "--show-function-line=^[[:alpha:]_][^;]*(", "--", Original, Path}, TimeLimit);
		if (!Result.bStarted)
		{
			throw FError(
				{.Code = ErrorOverlayFolder, .Message = "diff cannot be started: install diffutils"}, ExitFiles);
		}
		TakeHunks(File, Result.Output, Difference.Hunks);
	}
	return Difference;
}

} // namespace Drydock
