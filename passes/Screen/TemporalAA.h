// Temporal antialiasing: the jittered pictures of a sequence, averaged along the movement of what they show. Source: B.
// Karis, "High Quality Temporal Supersampling" (SIGGRAPH 2014); engine file TemporalAA.h (variables, place in the
// chain); the filter is drydock's own.
//
// For a pixel, with C the colours of the 3x3 pixels around it, without pre-exposure, in YCoCg:
//   F = sum k_i h(C_i) C_i / sum k_i h(C_i)     this frame: k is a Gaussian about the pixel's centre without jitter
//   B = the range of the 3x3, averaged with that of the middle cross
//   H = the history at the place where the surface in front of the 3x3's diagonal was (Catmull-Rom), moved into B
//   result = ((1 - a) h(H) H + a h(F) F) / ((1 - a) h(H) + a h(F)),  a = max(1 / (n + 1), CurrentFrameWeight)
// h(C) = 1 / (1 + max(luma, 0) ExposureScale), so that a bright pixel weighs as on a display; n is the number of
// frames in the history. A view that stands still gets the mean of its frames, weighed by h, until n reaches
// 1 / CurrentFrameWeight.
//
// Contract. Without history (first frame, camera cut, uncovered from outside of the view) the result is F. A history
// that is not finite counts as none. A colour that is not finite is shown as it is in its own pixel, is left out of the
// neighbours, and is not remembered: it leaves the picture with the frame that brought it. Negative light passes. A
// velocity of infinity counts as "from outside", NaN as not stored, and less than 1/1024 pixel as none. The
// pre-exposure of a frame does not reach the history. Nothing outside the rect is read. Any size from 1x1; a history of
// another size is scaled. Alpha is this frame's.
#pragma once

#include "CoreMinimal.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** Name of the history in the view's state: PF_A32B32G32R32F, colour without pre-exposure, alpha the frames in it. */
constexpr const char* TemporalAAHistoryName = "TemporalAA.History";

struct FTemporalAAInputs
{
	/** [Required] The picture of the scene textures' view rect, linear. */
	FScreenPassTexture SceneColor;
	/** [Required] Depth and velocity, read in the view's rect. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	/** [Optional] What the frame before returned as History; not valid: there is none, or it is of no use. */
	FScreenPassTexture History;
	/** The least share of this frame: 0 to 1; 0 averages all frames. r.TemporalAACurrentFrameWeight. */
	float CurrentFrameWeight = 0.04f;
	/** Width of the Gaussian: 1 is 0.47 pixels of standard deviation; 0 takes the middle pixel alone.
	 * r.TemporalAAFilterSize. */
	float FilterSize = 1.0f;
	/** A Catmull-Rom filter in place of the Gaussian: sharper, and not weighed by luma. r.TemporalAACatmullRom. */
	bool bCatmullRom = false;
	/** The factor from scene light to the display: 1 where that is not known yet. Above 0 and finite. */
	float ExposureScale = 1.0f;

	/** Makes the inputs from the console variables; values outside of their range count as its end. */
	DRYDOCK_API static FTemporalAAInputs FromVariables();
};

struct FTemporalAAOutputs
{
	FScreenPassTexture SceneColor; // of the input's format, pre-exposed as it is
	FScreenPassTexture History;    // for the next frame
};

/** SceneColor lies right and down of the picture without jitter, by the view's TemporalJitterPixels. */
DRYDOCK_API FTemporalAAOutputs AddTemporalAAPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FTemporalAAInputs& Inputs);

/** Weights of the 3x3 pixels, row by row, of a frame with this jitter in pixels; their sum is 1. */
DRYDOCK_API TStaticArray<float, 9> MakeTemporalAAWeights(FVector2D Jitter, float FilterSize, bool bCatmullRom);

} // namespace Drydock
