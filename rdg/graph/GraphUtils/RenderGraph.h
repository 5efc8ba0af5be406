// Everything of the render graph. Source: engine RenderGraph.h.
#pragma once

#include "RenderGraphBlackboard.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphDefinitions.h"
#include "RenderGraphEvent.h"
#include "RenderGraphPass.h"
#include "RenderGraphResources.h"
#include "RenderGraphUtils.h"
