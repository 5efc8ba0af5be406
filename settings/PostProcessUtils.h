// FPostProcessUtils by its plain name. Source: engine Engine/PostProcessUtils.h.
#pragma once

#include "Engine/PostProcessUtils.h"
