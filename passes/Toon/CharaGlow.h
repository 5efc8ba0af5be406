// CharaGlow: a glow around characters, made by widening their mask. Source: article "RED post process" (CharaGlow,
// CharaGlowComp); drydock's decisions where it is silent.
//
//   CharaGlow      mask = GBufferD.b (outline id); mean of a box of (2R + 1)^2 texels,
//                  R = the whole part of CharaGlowArea
//   CharaGlowComp  c + saturate(blurredMask - mask) * CharaGlowColor.rgb * CharaGlowColor.a
//
// Corrected: the box is separable (rows, then columns) and its outer ring weighs by the fraction of the area, so that
// the glow does not pop when volumes blend the area. As printed (r.RED.AsPrinted 1): the double loop, whole areas only.
//
// Contract. Taps stay inside the rect: the mask's edge texels are repeated. The result is within 0..1 for masks within
// 0..1; a constant mask gives no glow. Area 0 and below, or NaN: no pass. Area is used up to 128. A pixel without
// glow keeps its bits. A native kernel with running sums stands in for the corrected passes; it differs from the .usf
// by less than 2e-6 before the store. The mask has 8 bits and holds no NaN; colour passes at its own pixel, whatever it
// is. Any size from 1x1.
#pragma once

#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

#include <optional>

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FCharaGlowInputs
{
	FScreenPassTexture SceneColor;
	/** GBufferD.b is the mask. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	FScreenPassRenderTarget OverrideOutput;
	/** Radius of the box in texels of the scene. */
	float Area = 0.0f;
	FLinearColor Color = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	bool bAsPrinted = false;
	/** Outside of these bounds the mask is 0, from the corner of SceneColor's rect; not set: it may be anything
	 * anywhere. Then only what the glow can reach is drawn, and the rest of the picture is copied. */
	std::optional<FIntRect> MaskBounds;

	/** Makes the inputs from the settings and r.RED.AsPrinted. */
	DRYDOCK_API static FCharaGlowInputs FromSettings(
		const FFinalPostProcessSettings& Settings, const FScreenPassTexture& SceneColor);
};

/** The widened mask, PF_R16F, over SceneColor's rect, or over what MaskBounds can reach of it; invalid where there is
 * no area. */
DRYDOCK_API FScreenPassTexture AddCharaGlowPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs);

/** The glow added to the picture. */
DRYDOCK_API FScreenPassTexture AddCharaGlowCompPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FCharaGlowInputs& Inputs, const FScreenPassTexture& BlurredMask);

/** Both; SceneColor itself where there is no area (then OverrideOutput is not written). */
DRYDOCK_API FScreenPassTexture AddCharaGlow(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FCharaGlowInputs& Inputs);

/** One direction of the corrected box: texels within Radius weigh 1, the one beyond Fraction, all times Scale. */
struct FCharaGlowBox
{
	int32 Radius = 0;
	float Fraction = 0.0f;
	float Scale = 1.0f; // 1 / (2 Radius + 1 + 2 Fraction)
};

DRYDOCK_API FCharaGlowBox GetCharaGlowBox(float Area, bool bAsPrinted);

/** Areas above this are used as this. */
constexpr float MaxCharaGlowArea = 128.0f;

} // namespace Drydock
