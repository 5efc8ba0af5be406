// Row of the stability table for a whole frame, scene colour to final picture, at default settings: data only.
#include "Runs.h"
#include "Table.h"

namespace Stability
{

namespace FrameRows
{

constexpr FCell InRange = UnitRange("the tonemapper's curve ends at 1, and the picture has 8 bits");
constexpr FCell SmallPicture = UnitRange("likewise; bloom's levels stop at 1 x 1");
constexpr FCell NoBloom = Formula("as with the show flag of bloom off, bit for bit");
constexpr FCell RectOnly = SameAsCropped("no pass reads outside of the view");

constexpr FPassRow Rows[] = {
	{
		.Name = "Whole frame",
		.Header = "Frame/Frame.h",
		.Factories = "",
		.Run = RunFrame,
		.Formula = FrameWithoutBloom,
		.Cells =
			{
				.NaN = Floods(
					"the finest of bloom's levels spreads it, coarser ones and the tonemapper make 0 of it", 0.15),
				.PlusInf =
					Floods("bloom carries it over the reach of its kernels, and the tonemapper makes white of it", 1.0),
				.MinusInf =
					Floods("bloom and tonemapper make 0 of it: what changes is where that light is missing", 0.02),
				.LargestHalf = InRange,
				.BeyondHalf = AsInfinity("scene colour is a texture of half floats"),
				.Huge = Floods("scene colour is a texture of half floats, which makes infinity of it", 1.0),
				.Denormals = AsBlack("far below the first of 255 steps", 1e-9),
				.NegativeZero = AsBlack("a channel of 0", 1e-9),
				.NegativeColors = InRange,
				.HotPixel = InRange,
				.MovingHotPixel = InRange,
				.Black = Zero("bloom adds nothing, and the curve begins at 0"),
				.Constant = InRange,
				.OneByOne = SmallPicture,
				.OneByN = SmallPicture,
				.NByOne = SmallPicture,
				.Odd = InRange,
				.Prime = InRange,
				.RectOffset = RectOnly,
				.PaddedExtent = RectOnly,
				.TooManyLevels = SmallPicture,
				.SigmaZero = InRange,
				.SigmaHuge = InRange,
				.ThresholdZero = InRange,
				.ThresholdNegative = InRange,
				.ThresholdHuge = NoBloom,
				.IntensityZero = NoBloom,
				.IntensityNegative = NoBloom,
				.IntensityHuge = InRange,
				.PowOfZero = InRange,
				.PowOfNegative = InRange,
				.LuminanceZero = InRange,
				.HalfAccumulation = Accurate("the picture has 8 bits, the table and bloom fewer than float", 0.02),
				.WeightOutside = NoWeight,
				.EqualPriorities = NoPriority,
				.TenThousand = NoHistory,
			},
	},
};

} // namespace FrameRows

std::span<const FPassRow> GetFrameRows()
{
	return FrameRows::Rows;
}

} // namespace Stability
