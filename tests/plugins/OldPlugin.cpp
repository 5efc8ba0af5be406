// A plugin that was built with other headers: it must not come to run any code.
#include <cstdlib>

extern "C" const char DrydockHeaders_of_another;

namespace
{

[[gnu::used]] const char* const Headers = &DrydockHeaders_of_another;
[[gnu::used]] const bool bStarted = (std::abort(), true);

} // namespace
