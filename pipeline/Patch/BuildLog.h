// Extracts the messages of compiler and linker from the text that cmake's build prints. Pure: texts in, data out.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** One thing that a build did. */
struct FBuildStep
{
	std::string Name;   // "Building CXX object CMakeFiles/MyTint.dir/MyTint.cpp.o"
	std::string Output; // what was printed of it, lines

	bool operator==(const FBuildStep&) const = default;
};

/** The steps of a log of ninja or make: each begins with a line "[2/5] NAME" or "[ 40%] NAME". Text before the first
 * step is left out. */
DRYDOCK_API std::vector<FBuildStep> ReadBuildSteps(const std::string& Log);

/** A text that ReadBuildSteps reads as Steps. */
DRYDOCK_API std::string WriteBuildSteps(const std::vector<FBuildStep>& Steps);

/** Merges the steps of two builds, because a build repeats and prints only steps that are out of date: the steps of
 * Before that Now does not have, then those of Now. */
DRYDOCK_API std::vector<FBuildStep> MergeBuildSteps(
	const std::vector<FBuildStep>& Before, const std::vector<FBuildStep>& Now);

enum class ECompilerMessage
{
	Error, // the linker's too
	Warning,
};

/** A message of compiler or linker. */
struct FCompilerMessage
{
	std::string File = {}; // of the plugin: relative to its folder; empty: none
	int Line = 0;          // 1-based, 0: unknown
	std::string Text = {};

	bool operator==(const FCompilerMessage&) const = default;
};

/** Messages of that kind, each once, by file and line; those in the plugin's files are first. Folder: of the plugin,
 * absolute; files in it are given from there on. */
DRYDOCK_API std::vector<FCompilerMessage> ReadCompilerMessages(
	const std::string& Text, ECompilerMessage Kind, const std::string& Folder);

} // namespace Drydock
