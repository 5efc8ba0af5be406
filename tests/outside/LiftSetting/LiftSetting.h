// A post-process setting of a plugin's own, known to volumes and the command line while the plugin is loaded, and a
// pass that it drives.
#pragma once

#include "PostProcessSettings.h"
#include "RenderGraphBuilder.h"
#include "ScreenPass.h"

/** Gives "OutsideLift", the light that is added: 0 unless somebody gives it. */
void SetOutsideLift(FPostProcessSettings& Settings, float Lift);

/** Adds what Settings say to every pixel's colour. */
FScreenPassTexture AddLiftPass(
	FRDGBuilder& GraphBuilder, const FScreenPassTexture& Input, const FPostProcessSettings& Settings);
