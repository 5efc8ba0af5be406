// Rows of the stability table for the rules of blending: data only.
#include "Table.h"

namespace Stability
{

namespace BlendRows
{

/** The hazards that a value can be. The others are a picture's. */
struct FSettingCells
{
	FCell NaN;
	FCell PlusInf;
	FCell MinusInf;
	FCell LargestHalf;
	FCell BeyondHalf;
	FCell Huge;
	FCell Denormals;
	FCell NegativeZero;
	FCell NegativeColors;
	FCell Black;
	FCell Constant;
	FCell WeightOutside;
	FCell EqualPriorities;
	FCell TenThousand;
};

constexpr FCell NoPicture = DoesNotApply("a setting is no picture");
constexpr FCell Floats32 = DoesNotApply("settings are 32-bit floats");
constexpr FCell NotFinite = LeftOut("a value that is not finite does not enter the blend; a warning names it");
constexpr FCell AtFull = Assigned("weight 1 assigns: no a + (b - a) is left over");
constexpr FCell InUnit = Clamped("weights end at 0 and 1, and NaN does nothing");
constexpr FCell Order = ByDeclaration("volumes of one priority keep the order of their declaration");
constexpr FCell NoVolumes = DoesNotApply("two settings objects, no volumes");
constexpr FCell Discrete = DoesNotApply("the type has no such value");

consteval FCells OfSettings(const FSettingCells& Cells)
{
	return {
		.NaN = Cells.NaN,
		.PlusInf = Cells.PlusInf,
		.MinusInf = Cells.MinusInf,
		.LargestHalf = Cells.LargestHalf,
		.BeyondHalf = Cells.BeyondHalf,
		.Huge = Cells.Huge,
		.Denormals = Cells.Denormals,
		.NegativeZero = Cells.NegativeZero,
		.NegativeColors = Cells.NegativeColors,
		.HotPixel = NoPicture,
		.MovingHotPixel = NoPicture,
		.Black = Cells.Black,
		.Constant = Cells.Constant,
		.OneByOne = NoPicture,
		.OneByN = NoPicture,
		.NByOne = NoPicture,
		.Odd = NoPicture,
		.Prime = NoPicture,
		.RectOffset = NoPicture,
		.PaddedExtent = NoPicture,
		.TooManyLevels = NoPicture,
		.SigmaZero = NoPicture,
		.SigmaHuge = NoPicture,
		.ThresholdZero = NoPicture,
		.ThresholdNegative = NoPicture,
		.ThresholdHuge = NoPicture,
		.IntensityZero = NoPicture,
		.IntensityNegative = NoPicture,
		.IntensityHuge = NoPicture,
		.PowOfZero = NoPicture,
		.PowOfNegative = NoPicture,
		.LuminanceZero = NoPicture,
		.HalfAccumulation = Floats32,
		.WeightOutside = Cells.WeightOutside,
		.EqualPriorities = Cells.EqualPriorities,
		.TenThousand = Cells.TenThousand,
	};
}

/** Whatever is blended linearly, component by component. */
constexpr FCells LinearCells = OfSettings({
	.NaN = NotFinite,
	.PlusInf = NotFinite,
	.MinusInf = NotFinite,
	.LargestHalf = AtFull,
	.BeyondHalf = AtFull,
	.Huge = BetweenEnds("the difference does not overflow: the ends are weighed instead"),
	.Denormals = BetweenEnds("settings blend with denormals as they are"),
	.NegativeZero = AtFull,
	.NegativeColors = BetweenEnds("signs do not matter to a linear blend"),
	.Black = BetweenEnds("0 is a value like others"),
	.Constant = Kept("a + w (a - a) is a"),
	.WeightOutside = InUnit,
	.EqualPriorities = Order,
	.TenThousand = Settles("1 - 0.75^n of the way, to rounding", 1e-6),
});

/** Likewise, of two settings objects. */
constexpr FCells LinearPartCells = []
{
	FCells Cells = LinearCells;
	Cells.EqualPriorities = NoVolumes;
	return Cells;
}();

constexpr FBlendRow Rows[] = {
	{
		.Name = "Number, linear",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "BloomSizeScale",
		.Cells = LinearCells,
	},
	{
		.Name = "Colour, linear",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "SceneColorTint",
		.Cells = LinearCells,
	},
	{
		.Name = "Vector of 2, linear",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "BloomConvolutionCenterUV",
		.Cells = LinearCells,
	},
	{
		.Name = "Vector of 4, linear",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "ColorSaturation",
		.Cells = LinearCells,
	},
	{
		.Name = "Colours of an array, linear",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "LensFlareTints",
		.Cells = LinearCells,
	},
	{
		.Name = "Flag, set",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "DepthOfFieldUseHairDepth",
		.Cells = OfSettings({
			.NaN = Discrete,
			.PlusInf = Discrete,
			.MinusInf = Discrete,
			.LargestHalf = Discrete,
			.BeyondHalf = Discrete,
			.Huge = Discrete,
			.Denormals = Discrete,
			.NegativeZero = Discrete,
			.NegativeColors = Discrete,
			.Black = Assigned("at any weight above 0", 1e-3),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("the value, from the first time on"),
		}),
	},
	{
		.Name = "Whole number, set",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "MotionBlurTargetFPS",
		.Cells = OfSettings({
			.NaN = Discrete,
			.PlusInf = Discrete,
			.MinusInf = Discrete,
			.LargestHalf = Assigned("at any weight above 0", 1e-3),
			.BeyondHalf = Assigned("at any weight above 0", 1e-3),
			.Huge = Discrete,
			.Denormals = Discrete,
			.NegativeZero = Discrete,
			.NegativeColors = Assigned("at any weight above 0", 1e-3),
			.Black = Assigned("at any weight above 0", 1e-3),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("the value, from the first time on"),
		}),
	},
	{
		.Name = "Enum, set",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "BloomMethod",
		.Cells = OfSettings({
			.NaN = Discrete,
			.PlusInf = Discrete,
			.MinusInf = Discrete,
			.LargestHalf = Discrete,
			.BeyondHalf = Discrete,
			.Huge = Discrete,
			.Denormals = Discrete,
			.NegativeZero = Discrete,
			.NegativeColors = Discrete,
			.Black = Assigned("at any weight above 0", 1e-3),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("the value, from the first time on"),
		}),
	},
	{
		.Name = "Number, set unless 0",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "BloomConvolutionBufferScale",
		.Cells = OfSettings({
			.NaN = NotFinite,
			.PlusInf = NotFinite,
			.MinusInf = NotFinite,
			.LargestHalf = Assigned("at any weight above 0", 1e-3),
			.BeyondHalf = Assigned("at any weight above 0", 1e-3),
			.Huge = Assigned("at any weight above 0", 1e-3),
			.Denormals = Assigned("at any weight above 0", 1e-3),
			.NegativeZero = LeftOut("0 replaces nothing, whatever its sign"),
			.NegativeColors = Assigned("at any weight above 0", 1e-3),
			.Black = LeftOut("0 replaces nothing"),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("the value, from the first time on"),
		}),
	},
	{
		.Name = "Object, set unless null",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "BloomDirtMask",
		.Cells = OfSettings({
			.NaN = Discrete,
			.PlusInf = Discrete,
			.MinusInf = Discrete,
			.LargestHalf = Discrete,
			.BeyondHalf = Discrete,
			.Huge = Discrete,
			.Denormals = Discrete,
			.NegativeZero = Discrete,
			.NegativeColors = Discrete,
			.Black = LeftOut("null replaces nothing"),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("the value, from the first time on"),
		}),
	},
	{
		.Name = "Focal distance",
		.Header = "PostProcessSettingsBlending.h",
		.Form = EBlendForm::Volumes,
		.Setting = "DepthOfFieldFocalDistance",
		.Cells = OfSettings({
			.NaN = NotFinite,
			.PlusInf = NotFinite,
			.MinusInf = NotFinite,
			.LargestHalf = AtFull,
			.BeyondHalf = AtFull,
			.Huge = BetweenEnds("the difference does not overflow: the ends are weighed instead"),
			.Denormals = BetweenEnds("settings blend with denormals as they are"),
			.NegativeZero = Assigned("0 of either sign is off", 1e-3),
			.NegativeColors = BetweenEnds("signs do not matter to a linear blend"),
			.Black = Assigned("0 is focus switched off, and nothing lies between off and a distance", 1e-3),
			.Constant = Kept("a + w (a - a) is a"),
			.WeightOutside = InUnit,
			.EqualPriorities = Order,
			.TenThousand = Settles("1 - 0.75^n of the way, to rounding", 1e-6),
		}),
	},
	{
		.Name = "Colour grading tables",
		.Header = "BlendContributions.h",
		.Form = EBlendForm::Table,
		.Setting = "",
		.Cells = OfSettings({
			.NaN = Clamped("an intensity that is not a number counts as 0"),
			.PlusInf = Clamped("intensities end at 1"),
			.MinusInf = Clamped("intensities begin at 0"),
			.LargestHalf = Clamped("intensities end at 1"),
			.BeyondHalf = Clamped("intensities end at 1"),
			.Huge = Clamped("intensities end at 1"),
			.Denormals = Finite("a weight like others"),
			.NegativeZero = LeftOut("a weight of 0 does nothing"),
			.NegativeColors = Clamped("intensities begin at 0"),
			.Black = LeftOut("a weight of 0 does nothing"),
			.Constant = Finite("weights sum to 1"),
			.WeightOutside = InUnit,
			.EqualPriorities = DoesNotApply("a list of weights: ties are those of the setting ColorGradingLUT"),
			.TenThousand = Settles("weights still sum to 1", 1e-5),
		}),
	},
	{
		.Name = "Ambient cubemaps",
		.Header = "BlendContributions.h",
		.Form = EBlendForm::Cubemap,
		.Setting = "",
		.Cells = OfSettings({
			.NaN = LeftOut("a colour that is not finite is not added"),
			.PlusInf = LeftOut("a colour that is not finite is not added"),
			.MinusInf = LeftOut("a colour that is not finite is not added"),
			.LargestHalf = Finite("added in float"),
			.BeyondHalf = Finite("added in float"),
			.Huge = Finite("the sum ends at the largest float"),
			.Denormals = Finite("added in float"),
			.NegativeZero = LeftOut("adds 0"),
			.NegativeColors = Finite("takes light away, as the engine's sum does"),
			.Black = LeftOut("adds 0"),
			.Constant = Finite("colours of one cubemap add up"),
			.WeightOutside = InUnit,
			.EqualPriorities = DoesNotApply("a sum: the order does not matter"),
			.TenThousand = Settles("10,000 quarters are 2500", 1e-4),
		}),
	},
	{
		.Name = "Blendables",
		.Header = "BlendContributions.h",
		.Form = EBlendForm::Blendable,
		.Setting = "",
		.Cells = OfSettings({
			.NaN = LeftOut("not above 0"),
			.PlusInf = Clamped("weights end at 1"),
			.MinusInf = LeftOut("not above 0"),
			.LargestHalf = Clamped("weights end at 1"),
			.BeyondHalf = Clamped("weights end at 1"),
			.Huge = Clamped("weights end at 1"),
			.Denormals = Finite("a weight like others"),
			.NegativeZero = LeftOut("not above 0"),
			.NegativeColors = LeftOut("not above 0"),
			.Black = LeftOut("not above 0"),
			.Constant = Finite("one entry to each time"),
			.WeightOutside = InUnit,
			.EqualPriorities = DoesNotApply("a list: all are kept, in order"),
			.TenThousand = DoesNotApply("a list of entries: nothing accumulates in a number"),
		}),
	},
	{
		.Name = "Weight by distance",
		.Header = "PostProcessVolumeWeight.h",
		.Form = EBlendForm::Distance,
		.Setting = "",
		.Cells = OfSettings({
			.NaN = Zero("a distance that is not a number: the volume does nothing"),
			.PlusInf = Zero("out of every radius"),
			.MinusInf = DoesNotApply("distances are not negative"),
			.LargestHalf = Zero("out of the radius"),
			.BeyondHalf = Zero("out of the radius"),
			.Huge = Zero("out of the radius"),
			.Denormals = Finite("inside"),
			.NegativeZero = Finite("inside"),
			.NegativeColors = DoesNotApply("distances are not negative"),
			.Black = Finite("inside"),
			.Constant = Finite("1 less the distance over the radius"),
			.WeightOutside = InUnit,
			.EqualPriorities = DoesNotApply("a weight does not look at priorities"),
			.TenThousand = DoesNotApply("computed anew for every place"),
		}),
	},
	{
		.Name = "Parts: numbers",
		.Header = "Engine/PostProcessUtils.h",
		.Form = EBlendForm::Parts,
		.Setting = "VignetteIntensity",
		.Cells = LinearPartCells,
	},
	{
		.Name = "Parts: over one half",
		.Header = "Engine/PostProcessUtils.h",
		.Form = EBlendForm::Parts,
		.Setting = "BloomMethod",
		.Cells = OfSettings({
			.NaN = Discrete,
			.PlusInf = Discrete,
			.MinusInf = Discrete,
			.LargestHalf = Discrete,
			.BeyondHalf = Discrete,
			.Huge = Discrete,
			.Denormals = Discrete,
			.NegativeZero = Discrete,
			.NegativeColors = Discrete,
			.Black = Assigned("above one half"),
			.Constant = Kept("either way the value"),
			.WeightOutside = InUnit,
			.EqualPriorities = NoVolumes,
			.TenThousand = DoesNotApply("a quarter is not above one half: nothing accumulates"),
		}),
	},
};

} // namespace BlendRows

std::span<const FBlendRow> GetBlendRows()
{
	return BlendRows::Rows;
}

} // namespace Stability
