// Reads and writes .cube files: tables from colour to colour. Source: Adobe, Cube LUT Specification 1.0 (2013).
#pragma once

#include "Picture/ImageFile.h"

#include <array>
#include <string>
#include <vector>

namespace Drydock
{

struct FColorCube
{
	int Size = 0;                                      // entries to a side, 2 to 256
	std::array<double, 3> DomainMin = {0.0, 0.0, 0.0}; // input of the first entry
	std::array<double, 3> DomainMax = {1.0, 1.0, 1.0}; // input of the last entry
	std::vector<std::array<double, 3>> Colors;         // Size^3, red fastest

	/** Between the entries by three linear steps. A colour outside of the domain takes the value at its border. */
	DRYDOCK_API std::array<double, 3> Sample(const std::array<double, 3>& Color) const;
};

/** Whether the name ends as that of a .cube file does. */
DRYDOCK_API bool IsColorCubePath(const std::string& Path);

/** Throws FError (exit code 3): DD5001 for a file that cannot be read, DD5035 with the line that is wrong. */
DRYDOCK_API FColorCube ReadColorCube(const std::string& Path);

/** The picture that ColorGradingLUT is in the engine: 256 x 16, slices of blue side by side, codes as in the table. A
 * table of another size than 16 is sampled. */
DRYDOCK_API FImage MakeLegacyTable(const FColorCube& Cube);

/** The text of a file. Comments: lines, which go in front. */
DRYDOCK_API std::string MakeColorCubeText(
	const FColorCube& Cube, const std::string& Title, const std::vector<std::string>& Comments);

} // namespace Drydock
