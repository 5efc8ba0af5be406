// The pixels of the layers that become channels, each plane as large as the picture that the files stand for.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportGuess.h"

#include <map>
#include <utility>
#include <vector>

namespace Drydock
{

/** Row-major planes; whole numbers are whole numbers, encoded colour is linear. */
struct FImportPlanes
{
	int Width = 0;
	int Height = 0;
	std::map<std::pair<size_t, int>, std::vector<float>> Planes; // by layer and slot

	const std::vector<float>& Get(const FImportSource& Source) const { return Planes.at({Source.Layer, Source.Slot}); }
};

/** Reads the channels that the plan's rows name, and those of More as they stand in the file, each part of each file
 * once. Data windows are laid into the picture: pixels beyond its edges are cut, missing ones are infinitely far in
 * depths and 0 in all else. Diagnostics reports both. Throws FError (exit code 3) where a file is broken. */
DRYDOCK_API FImportPlanes ReadImportPlanes(const FImportLayers& Layers, const FImportPlan& Plan,
	const std::vector<FImportSource>& More, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
