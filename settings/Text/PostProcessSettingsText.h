// Post-process settings as the engine's paste text, both ways:
// `(bOverride_BloomIntensity=True,BloomIntensity=1.200000,...)`. Reading sets only what is named; what the table does
// not have is kept as text and written again in its place.
//
// The engine writes six decimals. They hold every float that was typed with up to six decimals, and every float from 16
// up; another one (1e-7, one third) comes back rounded, and WriteSettingsText reports it. Doubles (vectors) hold what
// was typed with up to six decimals. Source: engine text of pasted properties.
#pragma once

#include "PostProcessSettingsTextTree.h"
#include "PostProcessSettings.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A field of the text that the table does not have. */
struct FUnknownSetting
{
	std::string Key;   // "LumenFoo", "Foo[2]", "bOverride_LumenFoo"
	std::string Text;  // of the value, as written
	std::string After; // key of the known field before it, as the table spells it; empty: it comes first

	bool operator==(const FUnknownSetting&) const = default;
};

struct FSettingsText
{
	FPostProcessSettings Settings;
	std::vector<FUnknownSetting> Unknown; // in the order of the text
};

/** The settings of a struct's tree, over the defaults. Everything wrong is reported, with the text Where before the
 * names of fields ("PostProcessVolume_0."). A value whose override bit is off is kept and reported once for all of
 * them, unless it is the default, as in full exports. */
DRYDOCK_API FSettingsText ReadSettingsStruct(
	const FEngineTextValue& Struct, const std::string& Where, FSettingsTextMessages& Messages);

/** Reads `(...)`. File names the text in messages. The result is incomplete if one of Diagnostics is an error. */
DRYDOCK_API FSettingsText ReadSettingsText(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** The fields that are written. */
enum class ESettingsTextForm
{
	Delta, // override bits that are on, with their values, and values that are not the defaults
	Full,  // all of them
};

/** `(...)`: override bits in the order of the table, then values, as the engine declares them. Values that six decimals
 * do not hold are one warning. */
DRYDOCK_API std::string WriteSettingsText(
	const FSettingsText& Settings, ESettingsTextForm Form, std::vector<FDiagnostic>& Diagnostics);

/** Upgrades settings saved before convolution bloom had an intensity of its own, as the engine does: with BM_FFT and an
 * intensity above 0, the intensities that are given become 1. Returns their names. Source: engine Scene.cpp
 * (PostSerialize), the toon-bloom article. */
DRYDOCK_API std::vector<std::string> UpgradeSettings(FPostProcessSettings& Settings);

} // namespace Drydock
