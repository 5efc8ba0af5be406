// A raw pass as a plugin writes it: no shader, a lambda that talks to the command list.
#pragma once

#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

/** Copies Input, then overwrites the columns [0, Width) with Color. */
FScreenPassTexture AddStripePass(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, int32 Width, const FLinearColor& Color);
