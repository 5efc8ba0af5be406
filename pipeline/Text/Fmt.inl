// fmt for source files that are compiled together, in any order: the engine's macro check would break it. Headers do
// not include it, because their readers may be plugins.
#pragma push_macro("check")
#undef check
#include <fmt/format.h>
#pragma pop_macro("check")
