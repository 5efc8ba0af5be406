// Gives a plugin's own objects their values: those of the ini files in its folder Config, then those of the config's
// "objects". They reach a class's default object and its subsystem before the plugin's modules start, and every object
// of the class that is made later. Source of the rules of ini files: Epic's page "Configuration Files".
#pragma once

#include "Config/Config.h"
#include "Objects/IniValues.h"

#include <set>
#include <string>
#include <vector>

namespace Drydock
{

/** The values of one run. */
class DRYDOCK_API FObjectValues
{
public:
	/** Takes back what an earlier run gave. Both arguments must outlive this. */
	FObjectValues(const FConfig& InConfig, std::vector<FDiagnostic>& InDiagnostics);

	/** Gives the classes of a loaded plugin theirs. Library: its file name. A mistake of the config is an error, one of
	 * an ini file a warning. */
	void GiveTo(const std::string& Library);

	/** Places in the world, with their values, those of the plugin's classes that "objects" names and that are actors;
	 * then makes the calls of "objects". Called once the plugin's modules have started. A class that the plugin has
	 * spawned itself is not placed. */
	void PlaceActors(const std::string& Library) const;

	/** Called once all plugins are loaded: names of "objects" that none of them has are errors. bAllLoaded: no plugin
	 * is missing. */
	void ReportUnknownClasses(bool bAllLoaded);

	/** The variables that ini files of all plugins set, in their order. */
	const std::vector<FIniVariable>& GetVariables() const { return Variables; }

private:
	void GiveObjects(const std::string& Library);

	const FConfig& Config;
	std::vector<FDiagnostic>& Diagnostics;
	std::vector<FIniVariable> Variables;
	std::set<std::string> Taken; // keys of "objects" that some plugin has
	std::vector<std::string> ClassNames;
};

} // namespace Drydock
