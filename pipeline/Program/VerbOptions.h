// Options that several verbs share.
#pragma once

#include "Budget/RunOptions.h"
#include "Program/ArgumentParser.h"

#include <array>
#include <string>

namespace Drydock
{

/** --set and --exec, in the order in which they were given. */
void AddVariables(FVerbOptions& Verb, FRunOptions& Options);

/** Adds --plugin. */
void AddPlugins(FVerbOptions& Verb, FRunOptions& Options);

/** Adds the options for a config from a stranger: --no-plugins and --read-only-cache. */
void AddTrust(FVerbOptions& Verb, FRunOptions& Options);

/** The config that the verb is about, with the options that change it (--set, --exec, --pp, --frame, --engine and
 * --plugin) and those of AddTrust. */
void AddConfig(FVerbOptions& Verb, FRunOptions& Options, bool bRequired = true);

/** --threads. Doc: its line in --help. */
void AddThreads(FVerbOptions& Verb, FRunOptions& Options, const char* Doc);

/** --precision, --storage and --threads. */
void AddArithmetic(FVerbOptions& Verb, FRunOptions& Options);

/** "X,Y,Z" of --at, in cm. Throws FError (exit code 2) where it is anything else. */
std::array<double, 3> ParseLocation(const std::string& Text);

/** Folder, or where that is empty the default one of the config. */
std::string ChooseOutputFolder(const std::string& Folder, const FRunOptions& Options);

} // namespace Drydock
