// Lists the hazards: numbers, sizes and parameters that break other programs. Columns of docs/stability.md, and what
// `drydock hazards` runs a pass with.
#pragma once

#include <cstddef>

namespace Drydock
{

/** X(member of a row, group, title, what the case is). HazardPictures.cpp makes the picture of each case. */
#define STABILITY_HAZARDS(X) \
	X(NaN, Values, "NaN", "one pixel of a noise picture is NaN in red, green and blue") \
	X(PlusInf, Values, "+Inf", "one pixel of a noise picture is +Inf in red, green and blue") \
	X(MinusInf, Values, "-Inf", "one pixel of a noise picture is -Inf in red, green and blue") \
	X(LargestHalf, Values, "65504", "every pixel is 65504, the largest half") \
	X(BeyondHalf, Values, "65520", \
		"one pixel is 65520, the first value that a half does not hold; then 65519, which it does") \
	X(Huge, Values, "1e30", "one pixel is 1e30, in 32-bit storage") \
	X(Denormals, Values, "denormals", "noise of 1e-40 in 32-bit storage; then noise of denormal halves") \
	X(NegativeZero, Values, "-0", "every pixel is -0") \
	X(NegativeColors, Values, "negative", "noise of both signs") \
	X(HotPixel, Values, "hot pixel", "one pixel of 60000 on black") \
	X(MovingHotPixel, Values, "moving 0.1 px", "a pixel's light of 16 moves to the next one in steps of 0.1 pixel") \
	X(Black, Values, "black", "all 0") \
	X(Constant, Values, "constant", "every pixel (0.75, 0.5, 0.25)") \
	X(OneByOne, Sizes, "1x1", "a constant of 1 x 1 pixel") \
	X(OneByN, Sizes, "1xN", "a constant of 1 x 37") \
	X(NByOne, Sizes, "Nx1", "a constant of 37 x 1") \
	X(Odd, Sizes, "odd", "a soft spot in 55 x 45 pixels") \
	X(Prime, Sizes, "prime", "a soft spot in 53 x 47 pixels") \
	X(RectOffset, Sizes, "rect offset", "the picture lies at (128, 64) of a texture that is NaN elsewhere") \
	X(PaddedExtent, Sizes, "padding", "the picture lies in the corner of a larger texture that is NaN elsewhere") \
	X(TooManyLevels, Sizes, "too many levels", "a constant of 5 x 3 pixels and more levels than it has") \
	X(SigmaZero, Parameters, "width 0", "the width of the kernel is 0") \
	X(SigmaHuge, Parameters, "width huge", "the width of the kernel is far beyond the picture") \
	X(ThresholdZero, Parameters, "threshold 0", "a threshold of 0, one pixel black") \
	X(ThresholdNegative, Parameters, "threshold < 0", "a threshold of -1, one pixel black") \
	X(ThresholdHuge, Parameters, "threshold huge", "a threshold of 1e30") \
	X(IntensityZero, Parameters, "intensity 0", "an intensity of 0") \
	X(IntensityNegative, Parameters, "intensity < 0", "an intensity of -1") \
	X(IntensityHuge, Parameters, "intensity huge", "an intensity of 1e6, in 32-bit storage") \
	X(PowOfZero, Parameters, "pow of 0", "a black picture, exponents 0 and 2.5") \
	X(PowOfNegative, Parameters, "pow of < 0", "noise of both signs, exponents 0.5 and 2.5") \
	X(LuminanceZero, Parameters, "luminance 0", "colours that are not black and whose luminance is 0 or nearly so") \
	X(HalfAccumulation, Sums, "16-bit sums", "the stored formats against 64 bits throughout") \
	X(WeightOutside, Sums, "weight outside 0..1", "blend weights of -1, 2 and NaN") \
	X(EqualPriorities, Sums, "equal priorities", "two volumes of one priority") \
	X(TenThousand, Sums, "10,000 times", "10,000 frames, blends or texels of a row, one upon the other")

enum class EHazard
{
#define X(Name, Group, Title, Case) Name,
	STABILITY_HAZARDS(X)
#undef X
		MAX
};

constexpr std::size_t NumHazards = static_cast<std::size_t>(EHazard::MAX);

enum class EHazardGroup
{
	Values,
	Sizes,
	Parameters,
	Sums,
	MAX
};

struct FHazard
{
	EHazardGroup Group;
	const char* Name;
	const char* Title;
	const char* Case;
};

inline constexpr FHazard Hazards[NumHazards] = {
#define X(Name, Group, Title, Case) {EHazardGroup::Group, #Name, Title, Case},
	STABILITY_HAZARDS(X)
#undef X
};

} // namespace Drydock
