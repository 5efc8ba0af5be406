// Who includes whom: read from the house's sources, for the tests that keep storeys, rooms and units in order.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace Drydock::Test
{

/** One line `#include "Name"`. Paths are relative to the root, with slashes. */
struct FInclude
{
	std::string From;
	std::string Name;
	std::vector<std::string> To; // files that it can mean; empty: none of those that were read
};

/** Path to contents. */
using FSourceTexts = std::map<std::string, std::string>;

/** The .h, .cpp and .inl files below some folders of Root, hidden folders left out. */
FSourceTexts ReadSources(const std::filesystem::path& Root, const std::vector<std::string>& Folders);

/** All quoted includes, in the order of the files. A file beside the including one wins, as for the compiler; else
 * those whose path ends with the name, and of these the ones that lie in the fewest folders: forwarding headers under
 * the engine's long paths lie deeper. */
std::vector<FInclude> FindIncludes(const FSourceTexts& Sources);

/** A header and its source are one unit: the path without its extension. */
std::string GetUnit(const std::string& File);

/** Each unit, and the other units that it includes. */
using FUnitGraph = std::map<std::string, std::set<std::string>>;

FUnitGraph MakeUnitGraph(const std::vector<FInclude>& Includes);

/** Units that reach each other: every circle once, with all units of it. */
std::set<std::set<std::string>> FindCircles(const FUnitGraph& Graph);

} // namespace Drydock::Test
