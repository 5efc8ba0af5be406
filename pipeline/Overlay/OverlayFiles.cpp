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

/** The text that a pass's config has in place of BloomSetup's, so that the chain calls the pass. */
struct FPassCall
{
	std::string_view Pass;
	const char* Text;
	std::string_view Old = R"("camera": { "Settings": { "BloomIntensity": 1.0, "BloomThreshold": 0.5 } })";
};

constexpr FPassCall PassCalls[] = {
	{"FFTBloom", R"("camera": { "Settings": { "BloomIntensity": 1.0, "BloomMethod": "BM_FFT" } })"},
	{"FXAA", R"("cvars": { "r.AntiAliasingMethod": 1 })"},
	{"Upscale", R"("scenes/room.exr", "screenPercentage": 50)", R"("scenes/room.exr")"},
	{"MotionBlur", R"("camera": { "Settings": { "MotionBlurAmount": 1.0 } })"},
	{"HistogramEyeAdaptation", R"("view": { "exposure": "auto" })"},
	{"BasicEyeAdaptationSetup",
		R"("view": { "exposure": "auto" }, "camera": { "Settings": { "AutoExposureMethod": "AEM_Basic" } })"},
	{"BasicEyeAdaptation",
		R"("view": { "exposure": "auto" }, "camera": { "Settings": { "AutoExposureMethod": "AEM_Basic" } })"},
	{"LocalExposureBlurredLogLuminance", R"("camera": { "Settings": { "LocalExposureHighlightContrastScale": 0.6 } })"},
};

Files::path GetTemplates()
{
	return Files::path(FindTemplates()) / "overlay";
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
		const bool bBody = std::any_of(At, At + static_cast<std::ptrdiff_t>(std::min(Line, Lines.size()) - Index),
			[](const std::string& Next) { return Next.starts_with('{'); });
		if (bOutermost && Text.starts_with("BEGIN_"))
		{
			const size_t Open = Text.find('(') + 1;
			return "struct " + Trim(Text.substr(Open, Text.find_first_of(",)", Open) - Open));
		}
		if (bOutermost && bHead && bBody && !Text.ends_with(';'))
		{
			return Trim(Text.substr(0, Text.find('(')));
		}
	}
	return "";
}

/** Without the byte-order mark and the carriage return of another editor. */
std::string NormalizeLine(std::string Line)
{
	constexpr std::string_view Mark = "\xef\xbb\xbf";
	if (const size_t At = Line.find(Mark); At <= 1) // behind + or -
	{
		Line.erase(At, Mark.size());
	}
	return Line.ends_with('\r') ? Line.substr(0, Line.size() - 1) : Line;
}

/** Whether the line's code names something of drydock's own; comments may. */
bool NamesOwn(const std::string& Line)
{
	const std::string Code = Trim(Line.substr(1, Line.find("//") - 1));
	return !Code.starts_with('*') && !Code.starts_with("/*") && ToLowerCase(Code).find("drydock") != Code.npos;
}

/** Reads what `diff` prints: two lines of names, then hunks "@@ -a,b +c,d @@". Those of one function are joined. */
void TakeHunks(
	const std::string& File, const std::string& Edited, const std::string& Output, std::vector<FOverlayHunk>& Hunks)
{
	const std::vector<std::string> Lines = SplitText(Edited);
	std::vector<std::string> Changed = SplitText(Output);
	std::transform(Changed.begin(), Changed.end(), Changed.begin(), NormalizeLine);
	for (size_t Index = 0; Index + 1 < Changed.size(); ++Index)
	{
		const bool bPair = Index > 2 && Changed[Index - 1].starts_with("@@ ") && Changed[Index].starts_with('-');
		if (bPair && "+" + Changed[Index].substr(1) == Changed[Index + 1])
		{
			Changed.erase(Changed.begin() + static_cast<std::ptrdiff_t>(Index) - 1, // with its head
				Changed.begin() + static_cast<std::ptrdiff_t>(Index) + 2);
		}
	}
	bool bInHunk = false;
	for (const std::string& Line : Changed)
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
			Hunk.bOwn |= NamesOwn(Line);
		}
	}
}

} // namespace

std::vector<std::string> ListOverlayPasses()
{
	std::vector<std::string> Passes;
	for (const FPassFunction& Function : GetPassFunctions())
	{
		const std::string Pass = GetShortName(Function.Name);
		std::error_code Error;
		if (*Function.Shader != '\0' || Files::is_directory(GetTemplates() / Pass, Error))
		{
			Passes.push_back(Pass);
		}
	}
	return Passes;
}

std::vector<FPatchFile> MakeOverlayFiles(const std::string& Name, const std::string& Pass)
{
	const std::vector<FPassFunction>& Functions = GetPassFunctions();
	const FPassFunction* const Found =
		FindItem(Functions, Pass, [](const FPassFunction& Function) { return GetShortName(Function.Name); });
	if (Found == nullptr)
	{
		const bool bFunction = Contains(Functions, Pass, &FPassFunction::Name);
		throw FError({.Code = ErrorOverlayFolder,
						 .Message = "there is no pass \"" + Pass + "\"" +
									Suggest(bFunction ? GetShortName(Pass) : Pass, ListOverlayPasses()) +
									"; the passes are " + JoinText(ListOverlayPasses())},
			ExitUsage);
	}
	std::vector<FPatchFile> Made = ReadTemplate(GetTemplates() / Pass);
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
	std::string Config = RenamePatch(ReadOwnFile(GetTemplates() / "MyPatch.json"), Name);
	for (const FPassCall& Call : PassCalls)
	{
		if (Call.Pass == Pass)
		{
			Config.replace(Config.find(Call.Old), Call.Old.size(), Call.Text);
		}
	}
	Made.push_back({Name + ".json", Config});
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
			FOverlayHunk New{File, "new to drydock", "", false};
			for (const std::string& Line : SplitText(TryReadTextFile(Path).value_or("")))
			{
				New.Lines += NormalizeLine("+" + Line) + "\n";
				New.bOwn |= NamesOwn("+" + Line);
			}
			Difference.Hunks.push_back(std::move(New));
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
