// Engine versions on the command line and in sentences: "5.3-5.6,5.8" to numbers, and numbers to "5.3 to 5.6 and 5.8".
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The x of every 5.x that the text names, ascending, each once; all that drydock knows where it is empty. Throws
 * FError (DD1110, exit code 2): no such list, or a version that drydock does not know. */
DRYDOCK_API std::vector<int> ParseMatrixVersions(const std::string& Text);

/** "5.1 and 5.2", "5.1, 5.3 to 5.6 and 5.8": three and more in a row are a range. Minors: ascending. */
DRYDOCK_API std::string DescribeVersions(const std::vector<int>& Minors);

/** "5.4". */
DRYDOCK_API std::string DescribeVersion(int Minor);

} // namespace Drydock
