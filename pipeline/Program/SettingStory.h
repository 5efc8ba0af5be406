// Writes the report of `drydock blend` for the verbs that print it too: the settings of a config at a place or along a
// path.
#pragma once

#include "Budget/RunOptions.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FBlendOptions
{
	FRunOptions Run;
	std::string At;                 // "X,Y,Z", cm; empty: the view's location
	std::string Path;               // a file of points, or "scene"; empty: one place only
	std::optional<int> Steps;       // between two points of the path
	std::string OutputFolder;       // for what a path gives; empty: GetDefaultOutputFolder
	std::vector<std::string> Names; // settings, with * and ?; empty: those that changed
	bool bJson = false;
};

/** Prints the settings at a place, and the story of each: text or JSON. Returns the exit code; throws FError. */
int PrintSettingStory(const FBlendOptions& Options);

/** Walks Options.Path and writes walk.csv and walk.svg; prints the weights at its points, text or JSON. Returns the
 * exit code; throws FError. */
int WalkAlongPath(const FBlendOptions& Options);

} // namespace Drydock
