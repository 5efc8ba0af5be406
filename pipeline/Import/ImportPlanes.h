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

/** Reads what the plan's rows name, and More as it stands in the file, each part of each file once. Data windows are
 * laid into the picture: what reaches over its edges is cut, what is missing is infinitely far in depths and 0 in all
 * else, and both are said in Diagnostics. Throws FError (exit code 3) where a file is broken. */
DRYDOCK_API FImportPlanes ReadImportPlanes(const FImportLayers& Layers, const FImportPlan& Plan,
	const std::vector<FImportSource>& More, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
