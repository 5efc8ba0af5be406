// Reads an engine overlay: a folder in the engine's own layout, whose shaders, pass functions, places of the chain and
// settings stand in place of drydock's. Nothing is compiled here.
#pragma once

#include "Diagnostics.h"
#include "Overlay/ChainPlaces.h"
#include "Overlay/OverlaySettings.h"
#include "PassFunctions.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A block of the overlay's PostProcessing.cpp. */
struct FOverlayPlace
{
	const FChainPlaceOfOverlay* Place = nullptr;
	std::string File; // absolute
	int Line = 0;     // of the block
	std::string Text;
	std::string
		Condition; // the definition of the condition's variable, up to its semicolon; empty: drydock's own value
	int ConditionLine = 0;
};

/** A function of a source that bears the name of one of the chain's. */
struct FOverlayPass
{
	const FPassFunction* Function = nullptr;
	std::string File; // absolute
	int Line = 0;
};

struct FOverlayFolder
{
	std::string Name;                        // the folder's
	std::string Path;                        // absolute, without a slash at the end
	std::vector<std::string> Shaders;        // virtual paths: "/Engine/Private/PostProcessBloom.usf"
	std::vector<std::string> Sources;        // .cpp files that are compiled, absolute
	std::vector<std::string> IncludeFolders; // absolute
	std::string Library;                     // of the code, once it is built
	std::vector<FOverlayPass> Passes;        // that the sources define
	std::vector<FOverlayPlace> Places;
	std::vector<FOverlaySetting> Settings;
	std::vector<FOverlayDefault> Defaults;
	std::vector<std::string> EnumTexts; // definitions of the settings' enums
	std::vector<std::string> Read;      // every file that was read, absolute
	std::vector<std::string> Unused;    // files that nothing here reads, from the folder on

	/** Whether it has anything to compile. */
	bool HasCode() const { return !Passes.empty() || !Places.empty() || !Settings.empty() || !Defaults.empty(); }

	/** The file of one of its shaders. */
	std::string GetShaderFile(const std::string& Shader) const;

	/** Names of all that it stands in for: shaders, functions, places and settings. */
	std::vector<std::string> ListReplaced() const;
};

/** Reads the folder. Mistakes are appended to Diagnostics, with file and line. */
DRYDOCK_API FOverlayFolder ReadOverlayFolder(const std::string& Path, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
