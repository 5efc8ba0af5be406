// Writes the project of a plugin, runs cmake on it, and reports the files left out or the compiler's errors.
#include "Patch/PluginBuild.h"

#include "ChildProcess.h"
#include "Diagnostics.h"
#include "InstallPaths.h"
#include "Patch/BuildLog.h"
#include "Patch/EngineApi.h"
#include "Patch/PatchErrors.h"
#include "Patch/PatchName.h"
#include "Patch/PluginBuildErrors.h"
#include "Patch/PluginErrors.h"
#include "Text/OutputFolder.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr int DefaultEngineMinor = 4;
const std::string ProjectMark = "# Made by drydock build.";
const std::string LogMark = "Written by drydock build.\n";

[[noreturn]] void Fail(EPluginBuildError Code, const std::string& File, const std::string& Message)
{
	throw FError({.Code = Code, .Message = Message, .File = File}, ExitUsage);
}

/** The first file of Folder with that extension; empty: none. */
Files::path FindByExtension(const Files::path& Folder, const char* Extension)
{
	std::vector<Files::path> Found;
	std::error_code Error;
	for (Files::directory_iterator Entry(Folder, Error), End; !Error && Entry != End; Entry.increment(Error))
	{
		if (Entry->path().extension() == Extension)
		{
			Found.push_back(Entry->path());
		}
	}
	std::sort(Found.begin(), Found.end());
	return Found.empty() ? Files::path() : Found.front();
}

/** The position after blanks and Wanted; npos if the text has something else there. */
size_t SkipPast(const std::string& Text, size_t At, std::string_view Wanted)
{
	At = Text.find_first_not_of(" \t\r\n", At);
	return At != std::string::npos && Text.compare(At, Wanted.size(), Wanted) == 0 ? At + Wanted.size()
																				   : std::string::npos;
}

/** The x of the first version that one of the keys has in a file and that begins with Major, a quote and "5."; none:
 * there is no such version. */
std::optional<int> FindVersion(const Files::path& File, std::string_view Major)
{
	const std::string Text = File.empty() ? std::string() : TryReadTextFile(File.string()).value_or("");
	for (size_t Key = Text.find("\"Engine"); Key != std::string::npos; Key = Text.find("\"Engine", Key + 1))
	{
		for (const std::string_view Name : {"\"EngineVersion\"", "\"EngineAssociation\""})
		{
			size_t At = SkipPast(Text, Key, Name);
			At = At != std::string::npos ? SkipPast(Text, At, ":") : At;
			At = At != std::string::npos ? SkipPast(Text, At, Major) : At;
			const std::string Digits = At != std::string::npos ? Text.substr(At, 2) : "";
			if (!Digits.empty() && std::isdigit(static_cast<unsigned char>(Digits[0])) != 0)
			{
				return std::atoi(Digits.c_str());
			}
		}
	}
	return std::nullopt;
}

/** FindVersion in the .uplugin of a folder, or else in a .uproject above it. */
std::optional<int> FindVersionOf(const std::string& Folder, std::string_view Major)
{
	const Files::path Plugin = Files::absolute(Folder).lexically_normal();
	std::optional<int> Found = FindVersion(FindByExtension(Plugin, ".uplugin"), Major);
	Files::path Above = Plugin;
	for (int Level = 0; !Found && Level < 4 && Above.has_relative_path(); ++Level, Above = Above.parent_path())
	{
		Found = FindVersion(FindByExtension(Above, ".uproject"), Major);
	}
	return Found;
}

/** "it is for engine 4.26, and drydock knows 5.1 to 5.8; " where the plugin names such a version; else empty. */
std::string DescribeOldEngine(const std::string& Folder)
{
	std::optional<int> Minor = FindVersionOf(Folder, "\"5.");
	const char* const Major = Minor ? "5." : "4.";
	Minor = Minor ? Minor : FindVersionOf(Folder, "\"4.");
	const bool bOld = Minor && (*Major == '4' || *Minor == 0);
	return bOld ? "it is for engine " + (Major + std::to_string(*Minor)) + ", and drydock knows 5.1 to 5.8; " : "";
}

/** A name for CMake's target and the library's file. */
std::string MakeTargetName(const std::string& Text)
{
	std::string Name;
	for (const char Letter : Text)
	{
		const bool bPlain = std::isalnum(static_cast<unsigned char>(Letter)) != 0 || Letter == '_';
		Name += bPlain ? Letter : '_';
	}
	return Name.empty() || std::isdigit(static_cast<unsigned char>(Name[0])) != 0 ? "Plugin" + Name : Name;
}

/** Text between quotes of CMake. */
std::string Quote(const std::string& Text)
{
	std::string Quoted = "\"";
	for (const char Letter : Text)
	{
		if (Letter == '"' || Letter == '\\' || Letter == '$' || Letter == ';')
		{
			Quoted += '\\';
		}
		Quoted += Letter;
	}
	return Quoted + "\"";
}

/** A keyword and its values, each with a space before it; nothing where there are none. */
std::string QuoteList(const char* Keyword, const std::vector<std::string>& Values)
{
	std::string Text = Values.empty() ? "" : Keyword;
	for (const std::string& Value : Values)
	{
		Text += " " + Quote(Value);
	}
	return Text;
}

/** Folder of drydockConfig.cmake: of the installation, else of the build that this program belongs to. */
std::string FindPackage()
{
	std::string Installed = FindInstalled(DRYDOCK_PACKAGE_DIR);
	if (!Installed.empty())
	{
		return Installed;
	}
	std::error_code Error;
	if (Files::is_regular_file(Files::path(DRYDOCK_BINARY_DIR) / "drydockConfig.cmake", Error))
	{
		return DRYDOCK_BINARY_DIR;
	}
	Fail(ErrorBuildTools, "", "drydock's CMake package is missing: is drydock installed completely?");
}

std::string RunTool(const std::vector<std::string>& Arguments, int TimeLimitSeconds, bool& bOutSucceeded)
{
	const FChildResult Result = RunChild(Arguments, TimeLimitSeconds);
	if (!Result.bStarted)
	{
		Fail(ErrorBuildTools, "", Arguments[0] + " cannot be started: a plugin is built by cmake 3.25 or newer");
	}
	bOutSucceeded = Result.Succeeded();
	return Result.Output + (Result.bTimedOut ? Result.Describe(TimeLimitSeconds) + "\n" : std::string());
}

/** CMake's own message, without its decoration. */
std::string TakeRefusal(const std::string& Output, const std::string& LogFile)
{
	std::string Text;
	bool bError = false;
	for (const std::string& Line : SplitText(Output))
	{
		if (Line.starts_with("CMake Error"))
		{
			bError = true;
			continue;
		}
		if (bError && Line.starts_with("Call Stack"))
		{
			break;
		}
		const size_t Start = Line.find_first_not_of(' ');
		if (bError && Start != std::string::npos)
		{
			Text += (Text.empty() ? "" : " ") + Line.substr(Start);
		}
	}
	return (Text.empty() ? "cmake failed" : Text) + "\n  full log: " + LogFile;
}

/** Log: of the sources one by one, JoinedLog: as one file, where a name does not lack that another source includes;
 * empty: not tried. */
[[noreturn]] void FailToCompile(const FPluginBuild& Build, const std::vector<std::string>& Notes,
	const std::string& Log, const std::string& JoinedLog)
{
	const std::string LogFile = Build.BuildFolder + "/build.log";
	WriteTextFile(LogFile, Log);
	Fail(ErrorPluginNotCompiled, Build.Folder,
		DescribeOldEngine(Build.Folder) + DescribePluginErrors(Build.Folder, Notes, Log, JoinedLog) +
			"  full log: " + LogFile);
}

struct FAttempt
{
	bool bCompiled = false;
	std::string Log; // of cmake and the compiler
};

/** The file's text; nothing where the file does not exist. Throws FError where the text lacks drydock's mark. */
std::optional<std::string> ReadOwn(const std::string& Path, const std::string& Mark)
{
	std::error_code Ignored;
	std::optional<std::string> Text = TryReadTextFile(Path, MaxBinaryBytes);
	if (Files::exists(Files::symlink_status(Path, Ignored)) && !(Text && Text->starts_with(Mark)))
	{
		throw MakeForeignError(Path, "drydock did not write this");
	}
	return Text;
}

/** Writes the project, configures and builds it. */
FAttempt Attempt(const FPluginBuild& Build, const std::string& Package, std::vector<std::string>& OutNotes)
{
	const std::string Project = Build.BuildFolder + "/CMakeLists.txt";
	const std::string Text = MakePluginProject(Build, Package);
	const std::string LogFile = Build.BuildFolder + "/build.log";
	const std::optional<std::string> Before = ReadOwn(Project, ProjectMark);
	ReadOwn(LogFile, LogMark);
	if (!Before)
	{
		ReadOwn(Build.BuildFolder + "/cmake", ProjectMark); // a folder, whose maker the project would name
	}
	// As it stands where nothing changed: cmake does not start over then.
	if (Before != Text)
	{
		WriteTextFile(Project, Text);
	}
	std::vector<std::string> Configure = {"cmake", "-S", Build.BuildFolder, "-B", Build.BuildFolder + "/cmake"};
	if (!FindProgram("ninja").empty())
	{
		Configure.insert(Configure.end(), {"-G", "Ninja"});
	}
	if (!Build.Compiler.empty())
	{
		Configure.push_back("-DCMAKE_CXX_COMPILER=" + Build.Compiler);
	}
	bool bSucceeded = false;
	const std::string Configured = RunTool(Configure, Build.TimeLimitSeconds, bSucceeded);
	WriteTextFile(LogFile, LogMark + Configured);
	if (!bSucceeded)
	{
		const std::string Refusal = TakeRefusal(Configured, LogFile);
		const bool bNoPlugin = Refusal.find("no sources found") != std::string::npos ||
							   Refusal.find("that CMake takes for its own") != std::string::npos;
		Fail(bNoPlugin ? ErrorNoPlugin : ErrorPluginNotConfigured, Build.Folder, Refusal);
	}
	const std::string Prefix = "-- " + Build.Name + ": ";
	for (const std::string& Line : SplitText(Configured))
	{
		if (Line.starts_with(Prefix))
		{
			OutNotes.push_back(Line.substr(Prefix.size()));
		}
	}
	std::vector<std::string> Compile = {"cmake", "--build", Build.BuildFolder + "/cmake", "--parallel"};
	if (Build.NumJobs > 0)
	{
		Compile.push_back(std::to_string(Build.NumJobs));
	}
	// All sources are compiled, although one of them does not: one message tells all that is wrong.
	Compile.insert(Compile.end(), {"--", "-k"});
	if (Files::exists(Build.BuildFolder + "/cmake/build.ninja"))
	{
		Compile.push_back("0");
	}
	const std::string Compiled = RunTool(Compile, Build.TimeLimitSeconds, bSucceeded);
	const std::string Log = LogMark + Configured + Compiled;
	WriteTextFile(LogFile, Log);
	const std::vector<std::string> Versions = FindVersionMessages(Compiled);
	OutNotes.insert(OutNotes.end(), Versions.begin(), Versions.end());
	return {bSucceeded, Log};
}

} // namespace

int FindEngineMinor(const std::string& Folder)
{
	return FindVersionOf(Folder, "\"5.").value_or(0);
}

std::string FindPluginName(const std::string& Folder)
{
	const Files::path Plugin = Files::absolute(Files::path(Folder) / ".").lexically_normal().parent_path();
	const Files::path Description = FindByExtension(Plugin, ".uplugin");
	return MakeTargetName((Description.empty() ? Plugin : Description).stem().string());
}

std::string MakePluginProject(const FPluginBuild& Build, const std::string& Package)
{
	std::string Rest = QuoteList("\n\tEXCLUDE", Build.Excludes) + QuoteList("\n\tSOURCES", Build.Sources) +
					   (Build.bUnity ? "\n\tUNITY" : "");
	const std::string Includes = QuoteList("", Build.IncludeFolders);
	const std::string Definitions = QuoteList("", Build.Definitions);
	return ProjectMark +
		   " Everything is built beside this file, nothing in the plugin's folder.\n"
		   "cmake_minimum_required(VERSION 3.25)\n"
		   "project(" +
		   Build.Name +
		   " LANGUAGES CXX)\n"
		   "if(NOT CMAKE_BUILD_TYPE)\n\tset(CMAKE_BUILD_TYPE Debug)\nendif()\n"
		   "find_package(drydock CONFIG REQUIRED PATHS " +
		   Quote(Package) +
		   " NO_DEFAULT_PATH)\n"
		   "drydock_add_plugin(" +
		   Build.Name + "\n\tFOLDER " + Quote(Build.Folder) + Rest +
		   ")\n"
		   "target_compile_definitions(" +
		   Build.Name + " PUBLIC ENGINE_MINOR_VERSION=" + std::to_string(Build.EngineMinor) +
		   " DRYDOCK_ENGINE_NAMES=" + std::to_string(Build.EngineNames) + Definitions + ")\n" +
		   (Includes.empty() ? std::string()
							 : "target_include_directories(" + Build.Name + " BEFORE PRIVATE" + Includes + ")\n");
}

namespace
{

/** Throws where a path holds what ends a text of CMake's, parts a list, is replaced or stands for other names. */
void RequirePlainPath(const std::string& Path)
{
	for (const std::string_view Text : {"\\", ";", "\"", "[", "]", "*", "?", "|", "\n", "${", "$<"})
	{
		if (Path.find(Text) != std::string::npos)
		{
			Fail(ErrorNoPlugin, Path,
				"the path holds " + (Text == "\n" ? "a line break" : std::string(Text)) +
					", which CMake takes for its own: move the folder, or name another one");
		}
	}
}

void RequireName(const std::string& Name)
{
	const std::string Why = ExplainBadPatchName(Name, {});
	if (!Why.empty())
	{
		throw FError(
			{.Code = ErrorPatchName, .Message = "\"" + Name + "\" cannot be a library's name: " + Why}, ExitUsage);
	}
}

} // namespace

FBuiltPlugin BuildPlugin(FPluginBuild Build)
{
	const Files::path Folder = Files::absolute(Build.Folder).lexically_normal();
	std::error_code Error;
	if (!Files::is_directory(Folder, Error))
	{
		Fail(ErrorNoPlugin, Build.Folder, "is not a folder; expected the folder of a plugin, with its .uplugin");
	}
	Build.Folder = (Folder.has_filename() ? Folder : Folder.parent_path()).string();
	RequirePlainPath(Build.Folder);
	if (Build.Name.empty())
	{
		Build.Name = FindPluginName(Build.Folder);
	}
	else
	{
		RequireName(Build.Name);
	}
	if (Build.EngineMinor == 0)
	{
		const int Named = FindEngineMinor(Build.Folder);
		Build.EngineMinor = Named != 0 ? Named : DefaultEngineMinor;
	}
	if (Build.BuildFolder.empty())
	{
		Build.BuildFolder = "build/" + Build.Name;
	}
	RequirePlainPath(Files::absolute(Build.BuildFolder).string());
	const std::string Package = FindPackage();
	FBuiltPlugin Built;
	Built.Name = Build.Name;
	Built.EngineMinor = Build.EngineMinor;
	const FAttempt First = Attempt(Build, Package, Built.Notes);
	FAttempt Joined;
	if (!First.bCompiled && !Build.bUnity)
	{
		// The engine's build puts a module's sources into one file, and published ones are used to it.
		Build.bUnity = true;
		std::vector<std::string> Notes;
		Joined = Attempt(Build, Package, Notes);
	}
	if (!First.bCompiled && !Joined.bCompiled)
	{
		FailToCompile(Build, Built.Notes, First.Log, Joined.Log);
	}
	if (!First.bCompiled)
	{
		Built.Notes.push_back("built as one file, as the engine does: one by one its sources do not compile");
	}
	Built.Library = Build.BuildFolder + "/cmake/lib" + Build.Name + ".so";
	return Built;
}

std::string RememberBuildSteps(const Files::path& BuildFolder)
{
	const std::string Kept = (BuildFolder / "steps.log").string();
	std::vector<FBuildStep> Before = ReadBuildSteps(TryReadTextFile(Kept).value_or(""));
	std::erase_if(Before,
		[&BuildFolder](const FBuildStep& Step)
		{
			std::error_code Error; // the source of a step without output no longer exists
			const std::string Made = Step.Name.substr(Step.Name.find_last_of(' ') + 1);
			return !Files::exists(BuildFolder / "cmake" / Made, Error);
		});
	const std::vector<FBuildStep> Now =
		ReadBuildSteps(TryReadTextFile((BuildFolder / "build.log").string()).value_or(""));
	const std::string All = WriteBuildSteps(MergeBuildSteps(Before, Now));
	WriteTextFile(Kept, All);
	return All;
}

} // namespace Drydock
