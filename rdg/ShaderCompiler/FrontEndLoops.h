// Loops that have no effect stay in SPIR-V through the front end's optimiser, which drops them even where they never
// end.
#pragma once

#include <vector>

namespace Drydock
{

/** Marks each loop of a whole module, with its header, before it is optimised: its turns have an effect that the
 * optimiser knows nothing of. */
void MarkLoops(std::vector<unsigned int>& Words);

/** After it: takes the marks away. */
void UnmarkLoops(std::vector<unsigned int>& Words);

} // namespace Drydock
