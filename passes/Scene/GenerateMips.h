// What code takes from it without making mips. FGenerateMips is not there. Source: engine file GenerateMips.h.
#pragma once

#include "RenderGraphUtils.h"
