// All ways to blur an image by a standard deviation of s pixels, behind one interface, each with what it costs.
// Algorithms of shaders run through the render graph, as in a frame; the exact one is plain code and is marked so.
// Widths are matched by measurement: the second moment of the impulse response. Each algorithm names its source where
// it is defined.
#pragma once

#include "Budget/BlurNames.h"
#include "Picture/ImageFile.h"

#include <string>

namespace Drydock
{

/** The arithmetic and storage of the graph's algorithms; Exact runs in double. */
struct FBlurArithmetic
{
	/** float32, float16, R11G11B10 or 8bit: format of all textures, the input's too. */
	std::string Storage = "float32";
	bool bDouble = false;     // 64-bit arithmetic and storage, coordinates not snapped
	int ResolutionLevels = 0; // halvings before the blur: [1 3 3 1] down and up around it
};

struct FBlurRun
{
	FImage Image;               // RGBA
	double Milliseconds = 0.0;  // of the passes, or of the exact blur
	double TapsPerPixel = 0.0;  // texture samples and loads of all passes' pixels, per pixel of the image
	double BytesPerPixel = 0.0; // read and written, each texel once per pass
	int NumPasses = 0;
};

/** One algorithm, ready to blur. Not for two threads at once. */
class DRYDOCK_API FBlur
{
public:
	/** Sigma: what is wanted, pixels. The name must exist. Matches the width: one to four measurements. */
	FBlur(const std::string& Algorithm, double InSigma, const FBlurArithmetic& InArithmetic = {});

	/** Image: RGBA. */
	FBlurRun Run(const FImage& Image) const { return RunAs(Image, Arithmetic); }

	/** Standard deviation of the impulse response, pixels: the root of the mean of both axes' variances, over all
	 * positions of the impulse. Measured with 32-bit storage. */
	double GetMeasuredSigma() const { return MeasuredSigma; }
	/** Within one percent of what is wanted. */
	bool IsMatched() const;

private:
	FBlurRun RunAs(const FImage& Image, const FBlurArithmetic& As) const;
	double MeasureVariance(bool bVertical) const;
	double Measure() const;
	void Match();

	const FBlurAlgorithm& Algorithm;
	double Sigma = 0.0;
	double Requested = 0.0; // what the algorithm is asked for, so that its width is Sigma
	double MeasuredSigma = 0.0;
	FBlurArithmetic Arithmetic;
};

/** Taps per pixel of the direct two-dimensional Gaussian: (2 ceil(3 s) + 1)^2. */
DRYDOCK_API double GetDirectTaps(double Sigma);

} // namespace Drydock
