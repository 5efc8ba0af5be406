// Blurs the shadow of the main light on toon characters.
#pragma once

#include "ScreenPass.h"

/** The blurred shadow's root in the alpha of eight bits; SceneShadow has the shadow in red. */
FScreenPassTexture AddToonMainLightShadowBlurPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture SceneShadow);

/** The shadow of that texture as a picture. */
FScreenPassTexture AddShowShadowPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, FScreenPassTexture Shadow, FScreenPassRenderTarget Output);
