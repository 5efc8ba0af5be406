// Writes the data of a matrix's page as one JSON: the table as matrix.json has it, and the pictures that differ.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

struct FMatrixPageInputs
{
	std::string Name;       // of the plugin
	std::string MatrixJson; // MakeMatrixJson
	/** Engine version ("5.4") and final.png of those that ran and whose picture is not that of the version before. */
	std::vector<std::pair<std::string, std::string>> Pictures;
};

/** JSON by report/matrix.schema.json, for MakeReportPage. When: UTC, as FormatReportTime has it. Throws FError (exit
 * code 3) where a picture cannot be read. */
DRYDOCK_API std::string MakeMatrixPageData(const FMatrixPageInputs& Inputs, const std::string& When);

} // namespace Drydock
