// The text of an ini file (Config/DefaultGame.ini) as data: sections with their keys and values, after what +, -, . and
// ! do. Source: Epic's page "Configuration Files" (dev.epicgames.com/documentation, "configuration-files-in-unreal-
// engine"), of its forms those that docs/plugins.md names: + adds a value that the array does not have yet, ! empties
// it whatever stands behind the =. The page's older form, "Special Characters", as quoted in
// answers.unrealengine.com/questions/471435: - removes a value that matches exactly, . adds one all the same, ! needs
// the name alone.
#pragma once

#include "Diagnostics.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FIniValue
{
	std::string Text; // without quotes and escapes where it was in quotes
	bool bQuoted = false;
	int Line = 0;
};

/** A key with its values, one but for those of arrays. */
struct FIniKey
{
	std::string Name;
	std::vector<FIniValue> Values;
};

struct FIniSection
{
	std::string Name; // "/Script/MyPlugin.MySettings"
	std::vector<FIniKey> Keys;
};

/** Sections in the order of their first lines; those of one name are one. Names ignore case and keep the spelling of
 * the first. A line that is not understood is a warning (DD2124) with file and line, and left out. */
DRYDOCK_API std::vector<FIniSection> ReadIniText(
	const std::string& Text, const std::string& File, std::vector<FDiagnostic>& Diagnostics);

/** Whether two names are equal in any case of letters. */
bool IsSameName(const std::string& A, const std::string& B);

} // namespace Drydock
