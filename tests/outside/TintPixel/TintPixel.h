// A full-screen pixel pass as a plugin writes it: out = in * Tint, through a screen transform.
#pragma once

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

FScreenPassTexture AddTintPass(FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, const FLinearColor& Tint);
