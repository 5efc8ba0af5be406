// Computes the width of a dual Kawase blur, and the number of levels and the offset for a wanted width: pure functions
// in double, no graph and no shader. Docs: docs/dual-kawase.md. The filter is Bjorge's, "Bandwidth-Efficient
// Rendering", SIGGRAPH 2015.
//
// Width is the standard deviation of the impulse response along one axis, in pixels of the blurred image, as the mean
// over all positions of the impulse relative to the coarsest level's grid. It has a closed form. Read the filter
// backwards from an output pixel: each pass picks a tap by its weight, then one of the tap's two texels per axis by its
// bilinear weight. Every step's mean is zero (taps are symmetric, linear interpolation keeps linear functions), so
// steps do not correlate and their variances add:
//
//     sigma^2 = sum over levels k = 1..N of 4^(k-1) D(Offset) + 4^k U(Offset) = (4^N - 1) / 3 * (D + 4 U)
//     D = (d^2 + f(1/2) + f(1/2 + d)) / 2                    d the diagonal taps' distance, in finer texels
//     U = a^2/6 + h(a)/6 + h(0)/6 + (e^2 + h(e)) 2/3         a axis, e diagonal, in coarser texels
//     f(x) = frac(x) (1 - frac(x)),  h(x) = (f(x + 1/4) + f(x - 1/4)) / 2
//
// Exact away from the borders, for the offset's taps as they are sampled (GetDualKawaseTaps).
#pragma once

#include "CoreMinimal.h"

namespace Drydock
{

constexpr int32 GDualKawaseMaxPasses = 8;
/** Beyond it the taps leave gaps that show as a grid of blocks. */
constexpr double GDualKawaseBlockyOffset = 2.0;
/** Largest offset that matching a width uses, where no more levels are to be had. */
constexpr double GDualKawaseMaxOffset = 4.0;
/** Steps of a texel that a bilinear sampler distinguishes. */
constexpr double GSubtexelSteps = 256.0;

// Sizes -------------------------------------------------------------------------------------------------------------

/** Sizes of the levels, [0] the image: ceiling division by two, at most PassNum times, and no further than the shorter
 * side stays at least 2. So Num() - 1 levels run, none on an image less than 3 pixels wide or high. */
DRYDOCK_API TArray<FIntPoint> GetDualKawaseLevelSizes(FIntPoint Size, int32 PassNum);

/** The sizes that the article's code renders, pass by pass: PassNum times down, the first at full size, halving
 * (truncating) after each pass; then PassNum times up, doubling before each. There are fewer passes if a side would
 * become 0. */
DRYDOCK_API TArray<FIntPoint> GetDualKawasePrintedSizes(FIntPoint Size, int32 PassNum);

/** Columns and rows that the article's result lacks: 22 at 1366 pixels and 5 passes. */
DRYDOCK_API FIntPoint GetDualKawasePrintedLoss(FIntPoint Size, int32 PassNum);

// Width -------------------------------------------------------------------------------------------------------------

/** Distances of the taps from a pass's sample point, in texels of the texture it reads, rounded to the sampler's grid
 * of 1/256 texel: so taps never fall between two grid points, where the last bit of a coordinate would decide. */
struct FDualKawaseTaps
{
	double DownDiagonal = 0.0; // Offset: half a texel of the coarser level is one of the finer
	double UpAxis = 0.0;       // Offset: two half texels of the coarser level
	double UpDiagonal = 0.0;   // Offset / 2
};

/** The sign of Offset does not matter. */
DRYDOCK_API FDualKawaseTaps GetDualKawaseTaps(double Offset);

/** Square of the standard deviation, pixels^2. 0 levels: 0. */
DRYDOCK_API double GetDualKawaseVariance(int32 PassNum, double Offset);
DRYDOCK_API double GetDualKawaseStandardDeviation(int32 PassNum, double Offset);

/** No pixel reads another that is further away than this, in pixels along either axis; at most the largest int32. */
DRYDOCK_API int32 GetDualKawaseReach(int32 PassNum, double Offset);

struct FDualKawaseSetting
{
	int32 PassNum = 0;
	double Offset = 0.0;
};

/** The public fit from a Gaussian's radius in pixels: passes = max(1, round(4/3 ln r)), offset = 0.4538^passes r. Its
 * offset belongs to another filter convention; only its number of passes is used here. Source: servo/webrender#2821. */
DRYDOCK_API FDualKawaseSetting FitDualKawase(double Radius);

struct FDualKawaseMatch
{
	FDualKawaseSetting Setting;
	double StandardDeviation = 0.0; // of the setting
	bool bReached = true; // false: the wanted width is below 1 pixel, or above what MaxPasses and offset 4 give
};

/** Passes and offset whose blur has this standard deviation in pixels: within 0.25 % where bReached, within 0.16 %
 * from 1.5 pixels on; that is half a step of the sampler's grid. Starts with the fit's number of passes, takes fewer
 * while offset 0 is too wide and more while offset 2 is too narrow, then bisects the closed form and takes the nearest
 * grid step. */
DRYDOCK_API FDualKawaseMatch MatchDualKawaseWidth(double StandardDeviation, int32 MaxPasses = GDualKawaseMaxPasses);

/** Farther than any picture is wide. */
constexpr int32 GMatchedGaussianMaxReach = 32768;

/** Weights of a Gaussian's texels at distance 0, 1, ... R = max(1, ceil(ReachInDeviations StandardDeviation)), which
 * together with their mirror sum to 1 and have exactly this variance although the tails are cut. At least 0.5 pixels. R
 * is at most GMatchedGaussianMaxReach; beyond that reach the variance is smaller than wanted. */
DRYDOCK_API TArray<double> ComputeMatchedGaussian(double StandardDeviation, double ReachInDeviations = 3.0);

} // namespace Drydock
