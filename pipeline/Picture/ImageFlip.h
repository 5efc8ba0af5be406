// FLIP: the difference that a person sees who alternates between two pictures. Source: Andersson, Nilsson,
// Akenine-Moller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", Proceedings of
// the ACM on Computer Graphics and Interactive Techniques 3(2), 2020, with its erratum (luminance is divided by 116).
#pragma once

#include "Picture/ImageEncoding.h"
#include "Picture/ImageFile.h"

#include <vector>

namespace Drydock
{

/** Pixels for a degree of the view: a display 0.7 m wide with 3840 pixels, seen from 0.7 m, as in the paper. */
constexpr double FlipPixelsPerDegree = 0.7 * 3840.0 / 0.7 * 3.14159265358979323846 / 180.0;

/** FLIP of each pixel, 0 to 1, row by row. Colours are those of the display: linear images are clamped to 0..1 first,
 * as for SSIM. An image of one or two channels is grey. NaN counts as 0. Images of one size (checked). */
DRYDOCK_API std::vector<double> ComputeFlip(const FImage& A, const FImage& B, EImageEncoding Encoding);

/** The mean of it: 0 where nothing differs. */
DRYDOCK_API double GetMeanFlip(const std::vector<double>& Flip);

} // namespace Drydock
