// Pictures of a study beside one another, each over the map of its error. Pure, from PNGs to SVG; equal data give equal
// bytes.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FStudyInset
{
	std::string Title;     // "DualKawase"
	std::string Subtitle;  // "rms 0.0012"
	std::string Png;       // bytes of the file
	std::string HeatPng;   // of the map below, as large; empty: none
	std::string HeatTitle; // "its error, at most 0.03"
	int Width = 0;         // pixels
	int Height = 0;
};

struct FStudyInsetRow
{
	std::string Title; // of the job
	std::vector<FStudyInset> Insets;
};

/** Pictures within the drawing; below all of them the colours of the heat maps. */
DRYDOCK_API std::string DrawStudyInsets(const std::string& Title, const std::vector<FStudyInsetRow>& Rows);

} // namespace Drydock
