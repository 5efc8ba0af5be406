// Post-process volumes as the engine's text of copied actors, both ways. Source: engine text of copied actors
// (APostProcessVolume and its brush).
#pragma once

#include "PostProcessSettingsText.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** The volume's brush where it is a box: cm, and pitch, yaw, roll in degrees. */
struct FVolumeTextBox
{
	double Center[3] = {0.0, 0.0, 0.0};
	double Extent[3] = {100.0, 100.0, 100.0}; // half sizes
	double Rotation[3] = {0.0, 0.0, 0.0};

	bool operator==(const FVolumeTextBox&) const = default;
};

/** Defaults: the engine's. */
struct FVolumeText
{
	std::string Name; // the actor's label, else its name
	bool bEnabled = true;
	bool bUnbound = false;
	double Priority = 0.0;
	double BlendRadius = 100.0; // cm
	double BlendWeight = 1.0;
	std::optional<FVolumeTextBox> Box; // empty where the text has no shape, or none that is a box
	FSettingsText Settings;
};

/** All volumes of a text: whole copied actors (Begin Map..), lines such as Settings=(..), or one struct (..), which is
 * an unbound volume of no name. Every error is reported; no settings at all is one. */
DRYDOCK_API std::vector<FVolumeText> ReadVolumesText(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** Actors to paste into the editor: Begin Map to End Map. */
DRYDOCK_API std::string WriteVolumesText(
	const std::vector<FVolumeText>& Volumes, ESettingsTextForm Form, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
