// A path through a level: the places whose settings `drydock blend --path` follows.
#pragma once

#include "Config/Config.h"
#include "CoreMinimal.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FPathPoint
{
	FVector Location;  // cm
	std::string Label; // the frame, else the time, else the number of the point from 1
};

/** A JSON array of `{"location": [x, y, z], "frame": 3, "t": 0.125}`, at least two; frame and t may be left out. File
 * names the text in messages. Faults are appended to Diagnostics, each with line and column. */
DRYDOCK_API std::vector<FPathPoint> ReadPath(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** Reads a file. Throws FError: with all mistakes (exit code 2), or that it cannot be opened (3). */
DRYDOCK_API std::vector<FPathPoint> LoadPath(const std::string& File);

/** The camera's location in each frame of the config's scene, by the frames' headers. Throws FError: the scene is not a
 * sequence of two frames or more, or a frame has no camera (exit code 2); a file cannot be read (3). */
DRYDOCK_API std::vector<FPathPoint> ReadScenePath(const FConfig& Config);

} // namespace Drydock
