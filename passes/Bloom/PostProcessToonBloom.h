// Toon bloom: pixels shaded as cloth (the toon mark) bloom with a strength of their own. Switches, and the passes that
// the corrected form adds in front of the bloom setup. Source: the article's engine patch, and its correction
// (drydock).
//
// As printed, the setup at half resolution takes one point-sampled shading model id for each of its pixels: edges are
// jagged, and only the pixel shader has it. Corrected, full-resolution colour times the factor is downsampled as the
// unmasked colour is, so that an edge weighs what it covers.
// Contract. Same rect as the input; alpha passes on. Pixels of other shading models keep their bits. Hazards: a factor
// of 0 makes toon pixels 0 whatever they hold; otherwise NaN and infinities stay what they are.
#pragma once

#include "CoreMinimal.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

#include <optional>

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** r.ToonBloom: -1 where the settings call for it, 0 never, 1 always. */
DRYDOCK_API int32 GetToonBloomMode();

/** r.ToonBloom.AsPrinted. */
DRYDOCK_API bool IsToonBloomAsPrinted();

/** r.ToonBloom.VisualizeMask. */
DRYDOCK_API bool IsToonBloomMaskVisualized();

struct FToonBloomInputs
{
	/** [Required] The view's picture at the resolution of the scene textures. */
	FScreenPassTexture SceneColor;
	/** [Required] */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	/** Factor of toon pixels. */
	float ToonIntensity = 1.0f;
	/** Bounds of the pixels that can be toon, from the corner of SceneColor's rect; not set: anywhere. Read by the
	 * bloom setup. */
	std::optional<FIntRect> ToonBounds = std::nullopt;
};

/** The input with toon pixels times the factor, in the same format. DrawRect: drawn by a pixel shader, in Output's
 * texels; the rest of the output holds nothing. Not set: all. */
DRYDOCK_API FScreenPassTexture AddToonBloomMaskPass(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FToonBloomInputs& Inputs, const std::optional<FIntRect>& DrawRect = {});

/** The input dimmed to grey, toon pixels in magenta over it: linear, to be tonemapped. */
DRYDOCK_API FScreenPassTexture AddToonBloomVisualizePass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FToonBloomInputs& Inputs);

} // namespace Drydock
