// FPostProcessUtils under its engine header. Source: engine Engine/PostProcessUtils.h.
#pragma once

// By its folder: a plain name would be this file.
#include "../PostProcessUtils.h"
