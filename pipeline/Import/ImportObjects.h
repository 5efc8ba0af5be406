// Objects chosen by name: Cryptomatte's layers and the lists of names in a file's header. Source: the Cryptomatte
// specification 1.2 (Psyop): rank layers of id and coverage, metadata, ids as the bits of 32-bit floats.
#pragma once

#include "Diagnostics.h"
#include "Import/ImportEncoding.h"
#include "Import/ImportLayers.h"
#include "Import/ImportPlanes.h"

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Drydock
{

/** One Cryptomatte of a file. */
struct FImportMatte
{
	std::string Name;                        // "ActorHitProxyMask", "ViewLayer.CryptoObject"
	FImportSource Ids;                       // the id that covers most of each pixel
	std::map<std::string, uint32_t> Objects; // by name
};

/** Those whose first layer and list of names are there. A list that cannot be read is a warning. */
DRYDOCK_API std::vector<FImportMatte> FindImportMattes(
	const FImportLayers& Layers, std::vector<FDiagnostic>& Diagnostics);

/** Objects of one matte, and what --stencil gives them. */
struct FImportChoice
{
	std::vector<std::pair<FImportSource, std::set<uint32_t>>> Objects;
	std::set<int> StencilValues; // --toon with a number: where the stencil has it
	int Value = 0;               // of the stencil
	size_t NumObjects = 0;
	std::string Text; // as it was asked
};

struct FImportChoices
{
	std::vector<FImportChoice> Toon;
	std::vector<FImportChoice> Stencil;

	/** The planes that they look at. */
	DRYDOCK_API std::vector<FImportSource> GetSources() const;
};

/** Reads --toon and --stencil. Mistakes are appended to Errors: a pattern that fits no object, with the nearest name.
 */
DRYDOCK_API FImportChoices ChooseImportObjects(
	const FImportAsked& Asked, const std::vector<FImportMatte>& Mattes, std::vector<FDiagnostic>& Errors);

/** Whether a pixel is of one of the objects; StencilValue: of the pixel. */
DRYDOCK_API bool IsChosen(const FImportChoice& Choice, const FImportPlanes& Planes, size_t Pixel, int StencilValue);

} // namespace Drydock
