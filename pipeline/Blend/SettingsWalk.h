// Computes the settings along a path: a view's settings at every step of a walk, and the weight of each volume there.
#pragma once

#include "Blend/WalkPath.h"
#include "BlendSettings.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FWalkSample
{
	double Distance = 0.0; // from the beginning, along the path, cm
	FVector Location;
	int Point = -1;                    // index of the path's point; -1: between two
	std::vector<float> Weights;        // by volume
	std::vector<FSettingValue> Values; // by setting of the walk
};

struct FSettingsWalk
{
	std::vector<std::string> Volumes; // in the order of declaration
	std::vector<bool> Unbound;        // by volume
	std::vector<size_t> Settings;     // indices in GetSettingFields()
	std::vector<FPathPoint> Points;
	std::vector<FWalkSample> Samples; // every point, and NumSteps places between neighbours
};

/** A number of steps that draws a smooth line: some 240 samples in all, however many points there are. */
DRYDOCK_API int GetDefaultNumSteps(size_t NumPoints);

/** Walks straight from point to point. Settings: indices in GetSettingFields(); empty: those that change on the way. */
DRYDOCK_API FSettingsWalk WalkSettings(const FSettingsBlender& Blender, const std::vector<FPathPoint>& Points,
	int NumSteps, const std::vector<size_t>& Settings);

/** Comma-separated, one line a sample: distance_cm, x, y, z, point (its label; empty between two), the weight of each
 * volume ("weight:NAME"), the settings; colours and vectors with a column for each component (".R", ".X"). Numbers are
 * the shortest that read back exactly. */
DRYDOCK_API std::string MakeWalkCsv(const FSettingsWalk& Walk);

/** Suffixes of a setting's components: "" for one number, ".R", ... */
DRYDOCK_API std::vector<std::string> GetComponentNames(const FSettingField& Field);

} // namespace Drydock
