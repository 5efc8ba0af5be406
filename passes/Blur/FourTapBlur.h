// Kawase's blur and a Gaussian pyramid: both are passes of four bilinear taps on a diagonal cross. Source: Kawase,
// "Frame Buffer Postprocessing Effects in DOUBLE-S.T.E.A.L", GDC 2003; Burt and Adelson, "The Laplacian Pyramid as a
// Compact Image Code", 1983.
//
// Kawase: passes at full size, the taps of pass i at i + 1/2 texels, where one bilinear tap averages four texels. The
// last pass's taps are moved so that the variances add up to the wanted one: a tap at d texels spreads by d^2 + frac(d)
// (1 - frac(d)) along each axis, which is linear between whole d.
//
// Pyramid: halve with the binomial kernel [1 3 3 1] / 8 (four taps at 3/4 texel), blur the small picture by a separable
// Gaussian, double with the same kernel (one bilinear tap). A level's two passes spread by 3/2 of its finer texels^2;
// the Gaussian makes up what is left.
//
// Contract of both. Extent, rect and format are the input's, and so are the formats of what lies between. Levels map
// two texels to one from the rect's corner, and reach two texels beyond it: further out all is the input's edge texel.
// Every tap is clamped to half a texel inside the rect. Weights sum to 1: a
// constant stays constant to the edge. NaN and infinities spread over the support and no further; negatives pass on
// until an unsigned store clips them. Any size from 1x1 up.
#pragma once

#include "CoreMinimal.h"
#include "ScreenPass.h"

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

constexpr int32 GKawaseMaxPasses = 64;
constexpr int32 GPyramidMaxLevels = 10;

/** Distances of the taps in texels, pass by pass, for this standard deviation in pixels; on the sampler's grid of 1/256
 *  texel. None for 0 and below; at most GKawaseMaxPasses, which reach a standard deviation of 296. */
DRYDOCK_API TArray<double> GetKawaseDistances(double StandardDeviation);

/** Variance along one axis of passes with these distances, pixels^2. */
DRYDOCK_API double GetKawaseVariance(TConstArrayView<double> Distances);

struct FPyramidSetting
{
	int32 Levels = 0;
	double LowStandardDeviation = 0.0; // of the Gaussian, in texels of the coarsest level
};

/** The setting with as many levels as leave the Gaussian 3.5 texels of the coarsest one, one at least where it leaves
 * 0.75. */
DRYDOCK_API FPyramidSetting GetPyramidSetting(double StandardDeviation);

/** The same for a given number of levels: fewer where they would be wider than wanted. */
DRYDOCK_API FPyramidSetting GetPyramidSetting(double StandardDeviation, int32 Levels);

/** StandardDeviation in pixels. The input itself where there is nothing to do. */
DRYDOCK_API FScreenPassTexture AddKawaseBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double StandardDeviation);

/** A blur of this standard deviation in texels of the picture it is given; same rect size out. */
using FAddLowResolutionBlur =
	TFunctionRef<FScreenPassTexture(const FScreenPassTexture& Input, double StandardDeviation)>;

/** Levels down, Blur on the coarsest, and up again. The input itself where there is nothing to do. */
DRYDOCK_API FScreenPassTexture AddPyramidBlurPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& Input, const FPyramidSetting& Setting, FAddLowResolutionBlur Blur);

/** The same with a separable Gaussian of 4 deviations. The reference is an infinite Gaussian, which reads the edge
 * texel beyond the rect. For pictures between 0 and 1, borders included, the result differs from it by at most 0.001
 * from a StandardDeviation of 7.2 on (3.5 texels of the coarsest level), 0.004 from 4 on, and 0.035 below; storage's
 * rounding is added. Per axis these are half the sums of |differences| of the two responses, 3.6e-4, 1.7e-3 and 1.7e-2.
 */
DRYDOCK_API FScreenPassTexture AddPyramidBlurPasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, double StandardDeviation);

/** Stretches Input's rect over a rect of this size by one bilinear tap, as readers of a coarse level do. */
DRYDOCK_API FScreenPassTexture AddBilinearStretchPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Input, const FScreenPassTexture& Like);

} // namespace Drydock
