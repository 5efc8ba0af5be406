// Guesses which layer becomes which channel, by the layers' names and the user's options. No pixel is read.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportEncoding.h"
#include "Import/ImportLayers.h"
#include "Import/ImportTargets.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** A group of channels and what they come from. */
struct FImportRow
{
	const FImportTarget* Target = nullptr;
	std::vector<std::optional<FImportSource>> Sources; // one to each channel; none: a default
	EImportOrigin Origin = EImportOrigin::Plain;
	FImportEncoding Encoding;
	std::string Remark;
};

struct FImportLeftOut
{
	size_t Layer = 0;
	std::string Why;
};

struct FImportPlan
{
	std::vector<FImportRow> Rows; // in the order of the targets; colour is the first
	std::vector<FImportLeftOut> LeftOut;
	int Width = 0; // of the picture that all layers stand for
	int Height = 0;

	/** Null where no layer becomes it. */
	DRYDOCK_API const FImportRow* Find(const std::string& Group) const;
};

/** Finds the origin of a file's layers, by its header and their names. */
DRYDOCK_API EImportOrigin FindImportOrigin(const FImportLayers& Layers, size_t File);

/** Doubts are appended to Diagnostics. Throws FError (exit code 2): no layer is colour, layers of pictures of different
 * sizes, options that name layers or channels that do not exist; all of these together. */
DRYDOCK_API FImportPlan GuessImport(
	const FImportLayers& Layers, const FImportAsked& Asked, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
