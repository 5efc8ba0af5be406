// Holds the values of --map: which layer or channel becomes which group or channel of the scene.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportLayers.h"
#include "Import/ImportTargets.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace Drydock
{

struct FImportMaps
{
	std::map<std::string, size_t> Groups;          // a whole layer, by group
	std::map<std::string, FImportSource> Channels; // one channel, by the scene's name
	std::set<size_t> None;                         // layers to leave out

	/** Whether guesses have nothing to say about a layer. */
	bool IsSpokenFor(size_t Layer) const;

	/** Fills the sources of a target; false where nothing is asked for it. A component that the layer lacks is an
	 * error. */
	bool Apply(const FImportTarget& Target, const FImportLayers& Layers,
		std::vector<std::optional<FImportSource>>& Sources, std::vector<FDiagnostic>& Errors) const;
};

/** Reads texts "LAYER=CHANNEL": left a layer's or a channel's name or a file's, right a group, a channel or "none". All
 * mistakes are appended to Errors, each with the nearest name. */
DRYDOCK_API FImportMaps ReadImportMaps(
	const std::vector<std::string>& Texts, const FImportLayers& Layers, std::vector<FDiagnostic>& Errors);

} // namespace Drydock
