// Copies the templates of overlays, and runs `diff` on what became of them.
#include "Overlay/OverlayFiles.h"

#include "ChildProcess.h"
#include "Config/ConfigReader.h"
#include "Overlay/CppText.h"
#include "Overlay/OverlayErrors.h"
#include "Patch/PatchErrors.h"
#include "RangeTools.h"
#include "ShaderCore.h"
#include "ShaderDirectories.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

const std::string PrivateShaders = "Engine/Shaders/Private/";

/** "BloomSetup" of AddBloomSetupPass, "DiaphragmDOF" of DiaphragmDOF::AddPasses. */
std::string GetShortName(std::string_view Function)
{
	const size_t Scope = Function.find("::");
	if (Scope != Function.npos && !Function.starts_with("Drydock::"))
	{
		return std::string(Function.substr(0, Scope));
	}
	Function.remove_prefix(Scope == Function.npos ? 0 : Scope + 2);
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

/** The line that opens the function or the struct that a line of the file is in; empty: none does. */
std::string FindFunction(const std::vector<std::string>& Lines, size_t Line)
{
	for (size_t Index = std::min(Line, Lines.size()); Index-- > 0;)
	{
		const std::string& Text = Lines[Index];
		const bool bOutermost = !Text.empty() && (IsWordCharacter(Text[0]) || Text[0] == '}');
		if (bOutermost && Text[0] == '}')
		{
			return Index + 1 == Line ? FindFunction(Lines, Index) : "";
		}
		const bool bHead = Text.starts_with("struct ") || Text.starts_with("class ") || Text.find('(') != Text.npos;
		const auto At = Lines.begin() + static_cast<std::ptrdiff_t>(Index);
		const bool bBody = Text.starts_with("BEGIN_") ||
						   std::any_of(At, At + static_cast<std::ptrdiff_t>(std::min(Line, Lines.size()) - Index),
							   [](const std::string& Next) { return Next.starts_with('{'); });
		if (bOutermost && bHead && bBody && !Text.ends_with(';'))
		{
			return Trim(Text.substr(0, Text.find('(')));
		}
	}
	return "";
}

/** Reads what `diff` prints: two lines of names, then hunks "@@ -a,b +c,d @@". Those of one function are joined. */
void TakeHunks(
	const std::string& File, const std::string& Edited, const std::string& Output, std::vector<FOverlayHunk>& Hunks)
{
	const std::vector<std::string> Lines = SplitText(Edited);
	bool bInHunk = false;
	for (const std::string& Line : SplitText(Output))
	{
		if (Line.starts_with("@@ "))
		{
			const size_t Plus = Line.find('+');
			const std::string Function =
				FindFunction(Lines, Plus == Line.npos ? 0 : std::strtoul(Line.c_str() + Plus + 1, nullptr, 10));
			if (Hunks.empty() || Hunks.back().File != File || Hunks.back().Function != Function)
			{
				Hunks.push_back({File, Function, "", false});
			}
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
	return ToVector<std::string>(GetPassFunctions(), [](const FPassFunction& Pass) { return GetShortName(Pass.Name); });
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
		throw FError(
			{.Code = ErrorOverlayFolder,
				.Message = Pass +
						   ": drydock has no file of it in the engine's form; put the engine's own files in a folder " +
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
			RunChild({"diff", "-U0", "--ignore-all-space", "--ignore-blank-lines", "--", Original, Path}, TimeLimit);
		if (!Result.bStarted)
		{
			throw FError(
				{.Code = ErrorOverlayFolder, .Message = "diff cannot be started: install diffutils"}, ExitFiles);
		}
		TakeHunks(File, TryReadTextFile(Path).value_or(""), Result.Output, Difference.Hunks);
	}
	return Difference;
}

std::string FormatHunks(const std::vector<FOverlayHunk>& Hunks)
{
	std::string Text;
	std::string File;
	for (const FOverlayHunk& Hunk : Hunks)
	{
		Text += Hunk.File != File ? "--- " + Hunk.File + "\n+++ " + Hunk.File + "\n" : "";
		File = Hunk.File;
		Text += "@@ " + (Hunk.Function.empty() ? "outside of functions" : Hunk.Function) + " @@" +
				(Hunk.bOwn ? " # touches something of drydock's own, which the engine does not have" : "") + "\n" +
				Hunk.Lines;
	}
	return Text;
}

} // namespace Drydock
