// Measures the result of an import, so that a wrong unit is seen at once, and warns of values that are unlikely in a
// frame.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportConvert.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Over the pixels that count: finite ones, and in depths those with a surface. */
struct FImportFigures
{
	double Least = 0.0;
	double Mean = 0.0;
	double Greatest = 0.0;
	size_t Count = 0;
};

DRYDOCK_API FImportFigures MeasureImport(const std::vector<float>& Values, double Least, double Greatest);

/** One sentence about a group: "0.0033 to 2478, mean 2.39", "1.98 m to 11.3 m, no surface in 0 %", ... */
DRYDOCK_API std::string DescribeFigures(const FImportScene& Scene, const FImportTarget& Target);

/** Appends a warning for what a frame hardly has in these units: depths of millimetres or kilometres, vectors that are
 * not of length 1, movements larger than the picture, colours without a highlight, numbers that are not whole. */
DRYDOCK_API void CheckFigures(const FImportScene& Scene, const FImportPlan& Plan, const FImportPlanes& Planes,
	std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
