// Options that several verbs share, and what limits an option's values.
#pragma once

#include "Budget/RunOptions.h"

#include <array>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

namespace Drydock
{

/** An option that repeats and takes one value each time, so that a config may follow it. Type: as --help shows it. */
CLI::Option* AddRepeated(
	CLI::App& Verb, const char* Name, const char* Type, std::vector<std::string>& Values, const char* Doc);

/** --set and --exec, in the order in which they were given. */
void AddVariables(CLI::App& Verb, FRunOptions& Options);

/** What a config from a stranger is run with: --no-plugins and --read-only-cache. */
void AddTrust(CLI::App& Verb, FRunOptions& Options);

/** The config that the verb is about, with the options that change it (--set, --exec, --pp, --frame, --engine and
 * --plugin) and those of AddTrust. */
void AddConfig(CLI::App& Verb, FRunOptions& Options);

/** --threads. Doc: its line in --help. */
void AddThreads(CLI::App& Verb, FRunOptions& Options, const char* Doc);

/** --precision, --storage and --threads. */
void AddArithmetic(CLI::App& Verb, FRunOptions& Options);

/** Whole numbers from Least to Most are taken, all else is a usage error. Returns the option. */
CLI::Option* RequireRange(CLI::Option* Option, int Least, int Most);

/** Numbers from 0 on are taken, all else is a usage error. Returns the option. */
CLI::Option* RequireNonNegative(CLI::Option* Option);

/** One of these words is taken, all else is a usage error; they become the option's type, "a|b", which --help shows and
 * completion offers. Returns the option. */
CLI::Option* RequireOneOf(CLI::Option* Option, const std::vector<std::string>& Words);

/** "X,Y,Z" of --at, in cm. Throws FError (exit code 2) where it is anything else. */
std::array<double, 3> ParseLocation(const std::string& Text);

/** Folder, or where that is empty the default one of the config. */
std::string ChooseOutputFolder(const std::string& Folder, const FRunOptions& Options);

} // namespace Drydock
