// Rows of the stability table for metering, adaptation and local exposure: data only.
#include "Runs.h"
#include "Table.h"

namespace Stability
{

namespace
{

constexpr FCell Counted = Formula("counted texel by texel, in double", 1e-5);
constexpr FCell RectOnly = SameAsCropped("nothing outside the rect is read");
constexpr FCell Guarded = Finite("divisors and logarithms are guarded");
constexpr FCell Floats = DoesNotApply("metering takes 32-bit values here; what a half rounds is rounded before");
constexpr FCell FlatFactor = Formula("the factor of a flat area, from the formula", 0.02);

constexpr FPassRow Rows[] = {
	{
		.Name = "Histogram",
		.Header = "Exposure/PostProcessHistogram.h",
		.Factories = "",
		.Run = RunHistogram,
		.Formula = HistogramFormula,
		.Cells =
			{
				.NaN = Formula("left out of the count", 1e-5),
				.PlusInf = Formula("counts as 65536", 1e-5),
				.MinusInf = Formula("counts as black", 1e-5),
				.LargestHalf = Counted,
				.BeyondHalf = Floats,
				.Huge = Formula("counts as 65536", 1e-5),
				.Denormals = Counted,
				.NegativeZero = Counted,
				.NegativeColors = Formula("counts as black", 1e-5),
				.HotPixel = Counted,
				.MovingHotPixel = Counted,
				.Black = Counted,
				.Constant = Counted,
				.OneByOne = Counted,
				.OneByN = Counted,
				.NByOne = Counted,
				.Odd = Counted,
				.Prime = Counted,
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = NoLevels,
				.SigmaZero = NoKernel,
				.SigmaHuge = NoKernel,
				.ThresholdZero = NoThreshold,
				.ThresholdNegative = NoThreshold,
				.ThresholdHuge = NoThreshold,
				.IntensityZero = NoIntensity,
				.IntensityNegative = NoIntensity,
				.IntensityHuge = NoIntensity,
				.PowOfZero = NoPower,
				.PowOfNegative = NoPower,
				.LuminanceZero = Formula("the logarithm's argument has a lower limit", 1e-5),
				.HalfAccumulation = DoesNotApply("sums are doubles whatever the storage"),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = Formula("170,000 texels: shares still sum to 1", 1e-5),
			},
	},
	{
		.Name = "Eye adaptation: histogram, basic",
		.Header = "Exposure/PostProcessEyeAdaptation.h",
		.Factories = "",
		.Run = RunEyeAdaptation,
		.Formula = EyeAdaptationFormula,
		.NumVariants = 2,
		.Cells =
			{
				.NaN = Finite("left out of the histogram; black in basic metering"),
				.PlusInf = Finite("counts as 65536"),
				.MinusInf = Guarded,
				.LargestHalf = Guarded,
				.BeyondHalf = Floats,
				.Huge = Guarded,
				.Denormals = Guarded,
				.NegativeZero = Guarded,
				.NegativeColors = Guarded,
				.HotPixel = Guarded,
				.MovingHotPixel = Guarded,
				.Black = Finite("the average has a lower limit, and a scale is at most 10^4"),
				.Constant = Guarded,
				.OneByOne = Guarded,
				.OneByN = Guarded,
				.NByOne = Guarded,
				.Odd = Guarded,
				.Prime = Guarded,
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = NoLevels,
				.SigmaZero = NoKernel,
				.SigmaHuge = NoKernel,
				.ThresholdZero = NoThreshold,
				.ThresholdNegative = NoThreshold,
				.ThresholdHuge = NoThreshold,
				.IntensityZero = NoIntensity,
				.IntensityNegative = NoIntensity,
				.IntensityHuge = NoIntensity,
				.PowOfZero = NoPower,
				.PowOfNegative = NoPower,
				.LuminanceZero = Guarded,
				.HalfAccumulation = DoesNotApply("the buffer holds 32-bit floats"),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = Settles("adaptation ends at its target and does not go beyond", 1e-3),
			},
	},
	{
		.Name = "Local exposure",
		.Header = "Exposure/PostProcessLocalExposure.h",
		.Factories = "",
		.Run = RunLocalExposure,
		.Formula = LocalExposureFormula,
		.Cells =
			{
				.NaN = Overflows("it counts as black in the factor; the setup then makes it 65536"),
				.PlusInf = Overflows("it counts as 65536 in the factor; the setup then makes it 65536"),
				.MinusInf = SpreadsAnywhere("it stays what it is"),
				.LargestHalf = Finite("factors are at most 2^64 and here below 1"),
				.BeyondHalf = RoundedBefore,
				.Huge = Finite("it counts as 65536 in the factor"),
				.Denormals = AsBlack("its factor is finite", 1e-3),
				.NegativeZero = AsBlack("0 times a finite factor"),
				.NegativeColors = Finite("negatives count as black in the factor"),
				.HotPixel = Bounded("highlights are brought down", 1e-3),
				.MovingHotPixel = Bounded("highlights are brought down", 1e-3),
				.Black = Zero("0 times a finite factor"),
				.Constant = FlatFactor,
				.OneByOne = FlatFactor,
				.OneByN = FlatFactor,
				.NByOne = FlatFactor,
				.Odd = Finite("cells of 64 texels; no centroid is stated"),
				.Prime = Finite("likewise"),
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = NoLevels,
				.SigmaZero = Finite("a blur of no width is the luminance itself"),
				.SigmaHuge = Finite("the radius ends at the most taps a kernel may have"),
				.ThresholdZero = Finite("the factor is continuous in the threshold"),
				.ThresholdNegative = Finite("likewise"),
				.ThresholdHuge = Finite("nothing is as far from middle grey"),
				.IntensityZero = Finite("a contrast of 0: all highlights as bright as middle grey"),
				.IntensityNegative = Finite("the exponent ends at 64 EV"),
				.IntensityHuge = Finite("the exponent ends at 64 EV"),
				.PowOfZero = NoPower,
				.PowOfNegative = NoPower,
				.LuminanceZero = Finite("the logarithm's argument has a lower limit"),
				.HalfAccumulation = Accurate("log2 luminance blurred in half", 0.02),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = NoHistory,
			},
	},
};

} // namespace

std::span<const FPassRow> GetExposureRows()
{
	return Rows;
}

} // namespace Stability
