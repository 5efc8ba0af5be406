// Imports a frame of the user's as a scene: reads layers, guesses their meaning, converts numbers, and writes scene and
// config.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportEncoding.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FImportOptions
{
	std::vector<std::string> Inputs; // files; "shot.####.exr" is a sequence
	std::string OutputFile;          // .exr; of a sequence with #### too; may be empty where nothing is written
	FImportAsked Asked;
	bool bDryRun = false; // nothing is written
	bool bForce = false;  // also over what import did not write
	bool bJson = false;
	int Width = 0; // of the terminal that the table is for; 0: of any
};

struct FImportResult
{
	std::string Report; // the table, or the same as JSON
	std::vector<FDiagnostic> Diagnostics;
	std::vector<std::string> Scenes; // written
	std::string Config;              // written; empty: there was one
};

/** The plan of a sequence is guessed from its first frame; the others follow it. Throws FError: the user's mistakes
 * (exit code 2), files that cannot be read or written (3). */
DRYDOCK_API FImportResult ImportFrame(const FImportOptions& Options);

} // namespace Drydock
