// Writes the C++ that connects an overlay's files with drydock: its pass functions and places with the table, its
// settings with the settings' struct.
#pragma once

#include "Overlay/OverlayFolder.h"

#include <string>

namespace Drydock
{

/** The texts of an overlay's made files. */
struct FOverlaySource
{
	std::string Connections; // a .cpp file
	std::string Members;     // included in FPostProcessSettings; empty: the overlay adds no setting
	std::string Types;       // included before it
};

DRYDOCK_API FOverlaySource WriteOverlaySource(const FOverlayFolder& Folder);

} // namespace Drydock
