// Measures the difference of two images: figures of error, and a map of the error. All in double, summed in one order:
// equal images give equal bits. Source of SSIM: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error
// Visibility to Structural Similarity", IEEE Transactions on Image Processing 13(4), 2004.
#pragma once

#include "Picture/ImageEncoding.h"
#include "Picture/ImageFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

struct FImageErrorOptions
{
	EImageEncoding Encoding = EImageEncoding::Linear;
	int NumChannels = 0;    // the first ones only; 0: all
	bool bPerceived = true; // SSIM and FLIP, the figures that take long; else 1 and 0
};

struct FImageError
{
	/** Largest |a - b| of all values, where it is, and the two values there. */
	double Max = 0.0;
	int MaxX = 0;
	int MaxY = 0;
	int MaxChannel = 0;
	double MaxA = 0.0;
	double MaxB = 0.0;
	/** Square root of the mean of (a - b)^2 over all values. */
	double Rms = 0.0;
	/** Square root of (sum of (a - b)^2 / sum of b^2): 0.01 is an error of one percent of the reference. 0 where both
	 * are 0, infinite where only the reference is. */
	double Relative = 0.0;
	/** Decibels, 20 log10(Peak / Rms); infinite where nothing differs. */
	double Psnr = 0.0;
	/** 1 at most, 1 where nothing differs: see ComputeSsim. */
	double Ssim = 1.0;
	/** 0 to 1, 0 where nothing differs: the mean of ComputeFlip (ImageFlip.h). */
	double Flip = 0.0;
	/** The peak of PSNR: the reference's largest value, at least 1. */
	double Peak = 1.0;
	/** Values that are NaN or infinite in one image and something else in the other. Then Max, Rms and Relative are
	 *  infinite; those alike in both images do not count as an error. */
	uint64_t NumNonFinite = 0;
};

/** A against the reference B, which have the same size and number of channels (checked). */
DRYDOCK_API FImageError CompareImages(const FImage& A, const FImage& B, const FImageErrorOptions& Options = {});

/** One figure of an error by name: max, rms, relative, psnr, ssim, flip. An unknown name: NaN. */
DRYDOCK_API double GetMetric(const FImageError& Error, const std::string& Metric);
DRYDOCK_API const std::vector<std::string>& GetMetricNames();
/** psnr and ssim grow as images come closer. */
DRYDOCK_API bool IsHigherBetter(const std::string& Metric);

/** Mean structural similarity as its authors compute it: Gaussian window of 11 x 11 with sigma 1.5, K1 = 0.01, K2 =
 * 0.03, L = 1, over all windows that lie inside; an image less than 11 wide or high has one window across that side. It
 * is computed on the luminance (Rec.709) of the display-encoded colours: linear images are clamped to 0..1 and
 * sRGB-encoded first. An image of one or two channels uses the first. NaN counts as 0. */
DRYDOCK_API double ComputeSsim(const FImage& A, const FImage& B, EImageEncoding Encoding);

/** sRGB curve, of a value clamped to 0..1; NaN gives 0. */
DRYDOCK_API double EncodeDisplay(double Linear);

/** The error of every pixel (the largest of its channels) as colour, display-encoded RGB: from black over violet, red
 * and orange to pale yellow in even steps of the logarithm. Full is the error that is pale yellow, Full / 10^4 and
 * below is black; what is not finite in one image only is cyan. */
DRYDOCK_API FImage MakeHeatMap(const FImage& A, const FImage& B, double Full, int NumChannels = 0);

/** The map of ComputeFlip (ImageFlip.h) in the colours of the heat map: black 0, pale yellow 1. */
DRYDOCK_API FImage MakeFlipMap(const FImage& A, const FImage& B, EImageEncoding Encoding);

/** The colours of the heat map, 0..1 to RGB. */
DRYDOCK_API void GetHeatColor(double Heat, double OutColor[3]);

/** Reads an image file for comparison, all channels: those of PNG and of drydock's own final.exr as they are displayed.
 * Throws FError (exit code 3). */
struct FComparedImage
{
	FImage Image;
	FImageWindow Window; // where it lies in what the file stands for
	std::vector<std::string> Channels;
	EImageEncoding Encoding = EImageEncoding::Linear;
};
DRYDOCK_API FComparedImage ReadComparedImage(const std::string& Path);

} // namespace Drydock
