// Questions about shader platforms; the answers lie in RHIShaderPlatform.h. Source: engine
// DataDrivenShaderPlatformInfo.h.
#pragma once

#include "RHIDefinitions.h"
