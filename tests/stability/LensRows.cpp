// Rows of the stability table for depth of field and motion blur: data only.
#include "Runs.h"
#include "Table.h"

namespace Stability
{

namespace LensRows
{

constexpr FCell RectOnly = SameAsCropped("nothing outside the rect is read");
constexpr FCell ByDepth = DoesNotApply("depth and lens decide, not light");
constexpr FCell ByMovement = DoesNotApply("movement decides, not light");

constexpr FPassRow Rows[] = {
	{
		.Name = "Depth of field",
		.Header = "Lens/DiaphragmDOF.h",
		.Factories = "",
		.Run = RunDiaphragmDOF,
		.Reach = 12.0,
		.Cells =
			{
				.NaN = Spreads("to what it reaches and what is behind; what is in focus keeps its bits"),
				.PlusInf = Spreads("likewise"),
				.MinusInf = Spreads("likewise"),
				.LargestHalf = Kept("a mean of equal values, in float", 1e-3),
				.BeyondHalf = RoundedBefore,
				.Huge = Contained("layers are stored as the picture is"),
				.Denormals = AsBlack("flushed to 0 or averaged"),
				.NegativeZero = AsBlack("means of zeros"),
				.NegativeColors = Mirrored("depth decides, not colour"),
				.HotPixel = Energy("away from the edge of depth a disc of even weights", 0.02),
				.MovingHotPixel = Steady("away from the edge of depth a mean keeps the sum", 0.03),
				.Black = Zero("means of zeros"),
				.Constant = Kept("a mean of equal values", 1e-3),
				.OneByOne = Kept("a mean of equal values", 1e-3),
				.OneByN = Kept("a mean of equal values", 1e-3),
				.NByOne = Kept("a mean of equal values", 1e-3),
				.Odd = Centred("layers map 2:1 in texels from the corner"),
				.Prime = Centred("likewise"),
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = NoLevels,
				.SigmaZero = Identity("no radius reaches half a pixel"),
				.SigmaHuge = Bounded("the radius ends at its maximum", 1e-3),
				.ThresholdZero = ByDepth,
				.ThresholdNegative = ByDepth,
				.ThresholdHuge = ByDepth,
				.IntensityZero = ByDepth,
				.IntensityNegative = ByDepth,
				.IntensityHuge = ByDepth,
				.PowOfZero = NoPower,
				.PowOfNegative = NoPower,
				.LuminanceZero = NoLuminance,
				.HalfAccumulation = Accurate("layers in half", 4e-3),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = NoHistory,
			},
	},
	{
		.Name = "Motion blur",
		.Header = "Lens/PostProcessMotionBlur.h",
		.Factories = "",
		.Run = RunMotionBlur,
		.Reach = 4.0,
		.Cells =
			{
				.NaN = Spreads("to the samples along the movement that hold it"),
				.PlusInf = Spreads("likewise"),
				.MinusInf = Spreads("likewise"),
				.LargestHalf = Kept("a mix of equal values", 1e-3),
				.BeyondHalf = RoundedBefore,
				.Huge = Bounded("a mix of input colours", 1e-5),
				.Denormals = AsBlack("flushed to 0 or averaged"),
				.NegativeZero = AsBlack("means of zeros"),
				.NegativeColors = Mirrored("movement decides, not colour"),
				.HotPixel =
					Energy("what moves over a background neither gains nor loses light, but for the sampling", 0.05),
				.MovingHotPixel = Steady("likewise", 0.05),
				.Black = Zero("means of zeros"),
				.Constant = Kept("a mix of equal values", 1e-3),
				.OneByOne = Kept("a mean of equal values", 1e-3),
				.OneByN = Kept("a mean of equal values", 1e-3),
				.NByOne = Kept("a mean of equal values", 1e-3),
				.Odd = Centred("the exposure is centred on the frame"),
				.Prime = Centred("likewise"),
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = NoLevels,
				.SigmaZero = Identity("no movement, no pass"),
				.SigmaHuge = Bounded("movement ends at the longest blur", 1e-3),
				.ThresholdZero = ByMovement,
				.ThresholdNegative = ByMovement,
				.ThresholdHuge = ByMovement,
				.IntensityZero = ByMovement,
				.IntensityNegative = ByMovement,
				.IntensityHuge = ByMovement,
				.PowOfZero = NoPower,
				.PowOfNegative = NoPower,
				.LuminanceZero = NoLuminance,
				.HalfAccumulation = Accurate("summed in float, stored once", 2e-3),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = NoHistory,
			},
	},
};

} // namespace LensRows

std::span<const FPassRow> GetLensRows()
{
	return LensRows::Rows;
}

} // namespace Stability
