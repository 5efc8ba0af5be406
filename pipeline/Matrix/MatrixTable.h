// Writes a matrix for its reader: a table with a row for each version, the messages, and the summary. Pure: data in,
// text out.
#pragma once

#include "DrydockAPI.h"
#include "Matrix/MatrixResult.h"
#include "Text/JUnit.h"

#include <string>

namespace Drydock
{

/** "yes", "deprecated: NAME", "uncertain: NAME" or "no: NAME", of the first name; what lacks goes before the others.
 * "-": the plugin does not build, and lacks nothing. */
std::string FormatInEngine(const FMatrixBuild& Build);

DRYDOCK_API std::string FormatMatrix(const FVersionMatrix& Matrix, int Width = 0);

/** {plugin, folder, config, versions: [{engine, builds, firstError, compilerWarnings, inEngine: {answer, messages},
 * notes, library, log, run: {exitCode, end, firstError, warnings, extensions, folder}, picture: {fingerprint, before,
 * same, max, pixels, first, sameAs}, firstDifference: {pass, what}}], summary, advice, passed}. A message: {code, file,
 * line, where, text}. A missing value is null. */
DRYDOCK_API std::string MakeMatrixJson(const FVersionMatrix& Matrix);

/** Makes the cases for JUnit: "5.3 builds", "5.3 runs" and "5.3 picture" of every version. A version that does not
 * compile or run fails. A picture that differs from the one before does not fail, but its case reports the difference.
 */
DRYDOCK_API std::vector<FJUnitCase> MakeMatrixCases(const FVersionMatrix& Matrix);

} // namespace Drydock
