// A compute pass as a plugin writes it: out = 1 - in, alpha kept.
#pragma once

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

FScreenPassTexture AddInvertPass(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input);
