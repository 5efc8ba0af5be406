// Rapidcheck tries the same cases on every run of this program, unless RC_PARAMS says otherwise.
#include <cstdlib>

namespace
{

[[maybe_unused]] const int GSeeded = setenv("RC_PARAMS", "seed=20240405", 0);

} // namespace
