// Writes the report of `drydock blend`: the settings at a place and the story of each, as text and as JSON.
#pragma once

#include "BlendSettings.h"
#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FBlendReport
{
	std::string Config;
	FVector Location = FVector(0.0, 0.0, 0.0); // cm
	std::string LocationFrom;                  // "--at", "view.location", "the scene's camera", ...
	std::vector<std::string> VolumeNames;      // by index; those of the ledger
	std::vector<FPostProcessVolumeProperties> VolumeProperties;
	std::vector<FVolumeAtPlace> Volumes; // in the order of blending
	FBlendedSettings Blended;
	FBlendLedger Ledger;
	std::vector<FDiagnostic> Diagnostics;
};

/** Indices of fields: those of the patterns (with * and ?), in the order of the table. Throws FError (exit code 2)
 * where a pattern matches none. */
DRYDOCK_API std::vector<size_t> FindSettings(const std::vector<std::string>& Patterns);

/** Fields that something beyond defaults and untouched console variables acted on. */
DRYDOCK_API std::vector<size_t> FindChangedSettings(const FBlendReport& Report);

/** The volumes, the story of each of these settings, and where bRest is true a count of the others. */
DRYDOCK_API std::string MakeBlendText(
	const FBlendReport& Report, const std::vector<size_t>& Settings, bool bRest, bool bColorful);

/** {location, settings: {Name: value}, ledger: {Name: [...]}, ...}: of these settings. */
DRYDOCK_API std::string MakeBlendJson(const FBlendReport& Report, const std::vector<size_t>& Settings);

} // namespace Drydock
