// The values that the ini files in a plugin's folder Config give: to fields of its classes and to console variables.
// Source of the rules: Epic's page "Configuration Files".
#pragma once

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FReflectedStruct;

/** "MySettings" and "UMySettings" mean UMySettings. */
bool IsNameOf(const std::string& Name, const FReflectedStruct& Class);

/** A console variable that an ini file sets. */
struct FIniVariable
{
	std::string Name;
	std::string Value;
	EConsoleVariableFlags SetBy = ECVF_SetBySystemSettingsIni;
	std::string File;
	int Line = 0;
};

/** Config/Default*.ini of a plugin that is loaded, by folder and name; of another none. Library: its file name. */
std::vector<std::string> FindIniFiles(const std::string& Library);

/** Gives the classes of a plugin what one of its ini files says, and collects the variables that it sets. A file that
 * cannot be read, and a value that is not taken, is a warning. Library: the plugin's file name. */
void GiveIniFile(const std::string& Library, const std::string& Path, std::vector<FIniVariable>& OutVariables,
	std::vector<FDiagnostic>& Diagnostics);

/** Sets the variables; those that cannot be set are reported. */
DRYDOCK_API void ApplyIniVariables(const std::vector<FIniVariable>& Variables, std::vector<FDiagnostic>& Diagnostics);

} // namespace Drydock
