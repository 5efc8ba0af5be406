// Toon-shadow blur: the shadow of toon characters is blurred and used in lighting, so that dark areas get a soft
// coloured fringe. Source: article "Toon-shadow blur" (formulas); drydock's decisions where it is silent.
//
//   ToonShadow: 8-bit RGBA. R projected shadow of the main light, G self shadow, 1 = lit; A receives the blurred one.
//
//   Setup       darker of R and G, into a single-channel temporary
//
//   Blur        the bloom's sum of Gaussians, tints normalised per channel (GaussianSum.h)
//
//   Combine     the result, stretched bilinearly to full size, into A
//
//   Lighting    Screen: lit' = 1 - (1 - lit)(1 - b), b = Intensity * blurred * LightColor * BaseColor
//
//               Add: lit' = lit + b
//
//               Max: the shadow term s becomes max(s, blurred); what that lights more is added to the frame, which is
//               lit already: lit' = lit + Intensity * (R(max(s, blurred)) - R(s)) * LightColor * BaseColor. R is the
//               ramp of the toon shading, a colour for each shadow term; without one R(x) = x
//
// Stores (ToonShadowBlurStore), the article's three pictures: EightBit keeps temporaries and A in 8 bit (mosaic);
// SixteenBit has half-float temporaries and A linear (bands); SqrtEightBit keeps A as a square root (smooth).
//
// Contract. Nothing outside the rects is read or written. Corrected: clamp addressing, a constant shadow stays constant
// to the edge; the screen is taken of what lies in 0..1 and light above 1 is kept, so the result is never negative and
// never darker than lit. As printed (r.ToonShadowBlur.AsPrinted 1): border addressing, the edge of the picture darkens;
// the raw screen, which goes below lit where lit is above 1. Add and Max have one form: a sum is right for any light,
// negative light is added to. Max keeps the bits of what the blur does not brighten; a ramp that falls takes no more
// light than there is, and its NaN takes all. Pixels that are not toon are copied bit for bit. NaN in the scene colour
// of a toon pixel: NaN with Add and Max, corrected Screen gives light from b alone; shadows are 8 bit and hold none.
#pragma once

#include "Blur/GaussianSum.h"
#include "CoreMinimal.h"
#include "PostProcessSettings.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

struct FToonShadowBlurInputs
{
	/** The shadow buffer, PF_R8G8B8A8 or PF_B8G8R8A8. */
	FScreenPassTexture ToonShadow;
	/** Sizes, tints, scale and quality of the blur. */
	FGaussianSumInputs Blur;
	EToonShadowBlurStore Store = EToonShadowBlurStore::SqrtEightBit;
	bool bAsPrinted = false;

	/** Makes the inputs from the settings and r.ToonShadowBlur.AsPrinted. */
	DRYDOCK_API static FToonShadowBlurInputs FromSettings(
		const FFinalPostProcessSettings& Settings, const FScreenPassTexture& ToonShadow);
};

/** The darker of R and G, in a single-channel temporary of the store's format. */
DRYDOCK_API FScreenPassTexture AddToonShadowSetupPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& ToonShadow, EToonShadowBlurStore Store);

/** ToonShadow with Blurred in A, as Store encodes it, in a texture of its own. Blurred: of any size, its red counts;
 * invalid: A is 1. */
DRYDOCK_API FScreenPassTexture AddToonShadowCombinePass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& ToonShadow, const FScreenPassTexture& Blurred, EToonShadowBlurStore Store);

/** Setup, blur and combine. Gives the shadow buffer with A filled, in a texture of its own; A is 1 where no stage of
 * the blur runs. */
DRYDOCK_API FScreenPassTexture AddToonShadowBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonShadowBlurInputs& Inputs);

struct FToonShadowLightingInputs
{
	FScreenPassTexture SceneColor;
	/** The toon shadow with A filled. */
	FScreenPassTexture ToonShadow;
	/** Base colour and shading model: only pixels of the toon model (SHADINGMODELID_CLOTH) change. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	FScreenPassRenderTarget OverrideOutput;
	/** Colour of the main light, relative: 1 is white. */
	FLinearColor LightColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
	float Intensity = 1.0f;
	EToonShadowBlurBlend Blend = EToonShadowBlurBlend::Screen;
	/** With Max: linear colours of shadow terms, 0 at the centre of the first texel, 1 at that of the last, bilinear in
	 * between, from the middle row; of any range. Null: each term is its own light. */
	FTextureRHIRef Ramp;
	EToonShadowBlurStore Store = EToonShadowBlurStore::SqrtEightBit;
	bool bAsPrinted = false;
};

/** Uses the blurred shadow in the lighting of an already lit frame. The result is like SceneColor. */
DRYDOCK_API FScreenPassTexture AddToonShadowLightingPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonShadowLightingInputs& Inputs);

/** The value of A for a blurred shadow of 0..1, before rounding to 8 bit, and back. */
DRYDOCK_API float EncodeToonShadowBlur(float Blurred, EToonShadowBlurStore Store);
DRYDOCK_API float DecodeToonShadowBlur(float Stored, EToonShadowBlurStore Store);

/** PF_G8 or PF_R16F. */
DRYDOCK_API EPixelFormat GetToonShadowBlurFormat(EToonShadowBlurStore Store);

} // namespace Drydock
