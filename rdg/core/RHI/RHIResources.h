// Everything the RHI makes. Source: engine RHIResources.h.
#pragma once

#include "RHIBuffer.h"
#include "RHIDefinitions.h"
#include "RHIFwd.h"
#include "RHIRenderPass.h"
#include "RHIStates.h"
#include "RHITexture.h"
#include "RHIViews.h"
