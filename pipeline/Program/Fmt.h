// fmt, also where the engine's macro check is known: fmt has a function of that name.
#pragma once

#pragma push_macro("check")
#undef check
#include <fmt/format.h>
#pragma pop_macro("check")
