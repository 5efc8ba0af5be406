// The message about a plugin that does not compile: one for all of its sources.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** A sentence about the first class of UE4's composition graph that a text names, with what to write in its place;
 * empty: the text names none. It begins with the class. */
DRYDOCK_API std::string AdviseOnCompositionGraph(const std::string& Text);

/** Tells the compiler's log: missing names as a table, other errors, and the modules and files left out, lines that
 * end in a break. Folder: of the plugin, absolute. Notes: the lines of drydock_add_plugin. Log: of the sources one by
 * one. JoinedLog: of them as one file, where a name does not lack that another source includes; empty: not tried. */
DRYDOCK_API std::string DescribePluginErrors(const std::string& Folder, const std::vector<std::string>& Notes,
	const std::string& Log, const std::string& JoinedLog);

} // namespace Drydock
