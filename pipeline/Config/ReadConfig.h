// Reads a config: its text once into a document, from that the plugins it names, and with these loaded all the rest.
#pragma once

#include "Config/Config.h"
#include "Text/Json.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A config as JSON, before anything in it is understood. */
struct FConfigDocument
{
	std::string File;
	FJsonValue Root;
	bool bSyntaxError = false;
	std::vector<FDiagnostic> Diagnostics; // of the syntax
};

DRYDOCK_API FConfigDocument ParseConfigDocument(const std::string& Text, const std::string& File);

/** Throws FError (exit code 3) when the file cannot be opened. */
DRYDOCK_API FConfigDocument LoadConfigDocument(const std::string& File);

/** File, Plugins, Objects and Assets alone: plugins bring console variables and settings, which the rest of the config
 * names. Mistakes are reported when all of it is read. */
DRYDOCK_API FConfig ReadConfigPlugins(const FConfigDocument& Document);

/** All of it. Every mistake that can be found is appended to Diagnostics, in the order of the file; where one is an
 * error the result is not to be run. */
DRYDOCK_API FConfig ReadConfig(const FConfigDocument& Document, std::vector<FDiagnostic>& Diagnostics);

/** Reads Text; File names it in messages and is what relative paths are relative to. Every mistake that can be found is
 *  appended to Diagnostics, in the order of the file; where one is an error the result is not to be run. */
DRYDOCK_API FConfig ReadConfig(const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** Reads a file. Throws FError (exit code 3) when it cannot be opened. */
DRYDOCK_API FConfig LoadConfig(const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** `--engine`: Version in place of the config's. */
DRYDOCK_API void SetEngineArgument(FConfig& Config, const std::string& Version, std::vector<FDiagnostic>& Diagnostics);

/** `--plugin`: a file, relative to the working folder, in place of the config's plugin of its file name, else beside
 * them. */
DRYDOCK_API void AddPluginArgument(FConfig& Config, const std::string& File);

/** `--overlay`: a folder, relative to the working folder, beside the config's overlays. */
DRYDOCK_API void AddOverlayArgument(FConfig& Config, const std::string& Folder);

/** Adds `Setting=Value` of the command line. */
DRYDOCK_API void AddSettingArgument(
	FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics);

/** Adds `r.Name=Value` of the command line, which beats the config's. */
DRYDOCK_API void AddVariableArgument(
	FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics);

/** Adds console commands: "r.A 1, r.B=2, r.C, SomeCommand x", separated by commas; it beats --set. */
DRYDOCK_API void AddExecArgument(FConfig& Config, const std::string& Argument, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
