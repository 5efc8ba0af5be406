// Reads the post-process settings that an overlay's Scene.h adds, with defaults from Scene.cpp and the rule of blending
// from SceneView.cpp.
#pragma once

#include "Diagnostics.h"
#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A setting as it is written into C++. */
struct FOverlaySetting
{
	std::string Name;
	std::string Type;    // float, bool, int32, FLinearColor, FVector2D, FVector4 or an enum's name
	std::string Default; // an expression of C++
	std::string Min;     // a number; empty: no bound
	std::string Max;
	std::string Category;
	std::string Doc;
	std::string Blend; // Lerp, Set, SetIfNonZero; empty: the type's own
	std::vector<std::string> EnumNames;
};

/** The default of a setting that drydock has, as the overlay's Scene.cpp gives it. */
struct FOverlayDefault
{
	std::string Name;
	std::string Value; // an expression of C++
	std::string File;
	int Line = 0;

	/** The name under which FPassReplacement knows it. */
	std::string GetPlace() const { return "the default of " + Name; }
};

/** A file of the overlay and its text. */
struct FOverlayText
{
	std::string File;
	std::string Text; // empty where there is no such file
};

struct FOverlaySettings
{
	std::vector<FOverlaySetting> Settings;
	std::vector<std::string> EnumTexts;
};

/** Every UPROPERTY of Header that has a bOverride_ bit there and is not in drydock's table. Defaults are those
 * of Source or Header, else zero. Mistakes are appended to Diagnostics, and a note on each UPROPERTY of
 * FPostProcessSettings without such a bit. */
DRYDOCK_API FOverlaySettings ReadOverlaySettings(const FOverlayText& Header, const FOverlayText& Source,
	const FOverlayText& View, std::vector<FDiagnostic>& Diagnostics);

/** Every `Name = VALUE;` of Scene.cpp for a setting of drydock's table; a plain number or word that is drydock's
 * default is left out. */
DRYDOCK_API std::vector<FOverlayDefault> ReadOverlayDefaults(const FOverlayText& Source);

} // namespace Drydock
