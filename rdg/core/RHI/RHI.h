// The umbrella of the RHI. Source: engine RHI.h.
#pragma once

#include "RHICommandList.h"
#include "RHIDefinitions.h"
#include "RHIGPUReadback.h"
#include "RHIResources.h"
#include "RHIStaticStates.h"
