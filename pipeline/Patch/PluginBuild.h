// A plugin's folder as the engine has it, built into a shared object by one call: a small CMake project is written
// beside the outputs, cmake and the compiler run; nothing is written to the plugin's folder.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FPluginBuild
{
	std::string Folder;                // of the .uplugin
	std::string Name;                  // of the library; empty: the .uplugin's, else the folder's
	std::string BuildFolder;           // empty: build/NAME, below the working folder
	int EngineMinor = 0;               // 5.x that it is compiled for; 0: what the .uplugin or .uproject names, else 4
	int EngineNames = 0;               // what names of other versions are: DRYDOCK_ENGINE_NAMES (Misc/EngineApi.h)
	std::vector<std::string> Excludes; // EXCLUDE of drydock_add_plugin
	// The code of an overlay. Sources: what is compiled, absolute; empty: what a plugin's folder has.
	std::vector<std::string> Sources;
	std::vector<std::string> IncludeFolders; // before all others
	std::vector<std::string> Definitions;
	bool bUnity = false;         // all sources as one file; else only where they do not compile one by one
	std::string Compiler;        // empty: CMake's choice
	int NumJobs = 0;             // compilers at a time; 0: CMake's choice
	int TimeLimitSeconds = 1800; // for cmake, and for the compilers once more
};

struct FBuiltPlugin
{
	std::string Name;
	std::string Library; // path of the shared object
	int EngineMinor = 0;
	std::vector<std::string> Notes; // what was left out and why, a line each
};

/** The 5.x that the engine version in a plugin's .uplugin, or in a .uproject above it, means; 0 if neither has a
 * version. */
DRYDOCK_API int FindEngineMinor(const std::string& Folder);

/** Name of the library that is built from a plugin's folder: the .uplugin's name, else the folder's. */
DRYDOCK_API std::string FindPluginName(const std::string& Folder);

/** The CMakeLists.txt that builds it. Package: folder of drydockConfig.cmake. */
DRYDOCK_API std::string MakePluginProject(const FPluginBuild& Build, const std::string& Package);

/** Builds it. Throws FError: exit code 2 where the folder holds no plugin, a tool is missing or the plugin does not
 * compile (with the first errors), 3 where nothing can be written. */
DRYDOCK_API FBuiltPlugin BuildPlugin(FPluginBuild Build);

/** The compiler's messages on all sources, including those that were up to date: those of build.log, and for sources
 * that it did not compile those of the builds before, which steps.log keeps. */
DRYDOCK_API std::string RememberBuildSteps(const std::filesystem::path& BuildFolder);

} // namespace Drydock
