// Cells and rows of the stability table. A cell says what is expected and why, or why the hazard does not apply. Cells
// have no default, and a reason is tested when it is compiled: a row that leaves one out does not build. Data only; the
// checkers are CheckPass.cpp and CheckBlend.cpp.
#pragma once

#include "Hazards.h"

#include <span>
#include <string_view>

namespace PassReference
{
struct FImage;
}

namespace Stability
{

using PassReference::FImage;
struct FCase;

/** X(expectation, symbol in docs/stability.md, what it says of a result). Those of blend rules come last. */
#define STABILITY_EXPECTATIONS(X) \
	X(DoesNotApply, "&middot;", "does not apply") \
	X(Spreads, "s", "what is not finite reaches its footprint, and every pixel outside keeps its bits") \
	X(SpreadsAnywhere, "S", "what is not finite spreads; no bound is stated") \
	X(Cleaned, "c", "every value is finite, and every pixel outside the footprint keeps its bits") \
	X(Contained, "n", "every pixel outside the footprint keeps its bits") \
	X(Floods, "%", "finite, and the stated share of the picture's pixels, to a hundredth, is changed") \
	X(ReadsAs, "r", "the bits of a picture with a finite number in its place") \
	X(Ignored, "=", "the bits of the result without the hazard") \
	X(AsInfinity, "i", "65520 gives the bits of infinity, 65519 those of 65504") \
	X(AsBlack, "b", "as a black picture") \
	X(Mirrored, "M", "the negated picture gives the negated result, bit for bit") \
	X(CutOff, "0", "nothing below 0, all finite") \
	X(Bounded, "B", "finite, and within the range of the input") \
	X(Fades, "d", "finite, not negative, and never above the input") \
	X(UnitRange, "1", "finite, and within 0..1") \
	X(Finite, "f", "every value is finite") \
	X(Overflows, "o", "infinity, never NaN") \
	X(Energy, "E", "the sum of the light is kept") \
	X(Steady, "T", "the sum of the light does not vary as it moves") \
	X(Smooth, "~", "the result changes by no more than a stated multiple of the input's change") \
	X(Kept, "K", "the same value everywhere, to the edge") \
	X(KeptInside, "k", "the same value in the middle, never more anywhere") \
	X(Flat, "l", "a flat picture stays flat, to the edge") \
	X(Centred, "C", "the centroid stays where it is, within 0.02 pixel") \
	X(SameAsCropped, "R", "the bits of the picture in a texture of its own") \
	X(Identity, "I", "the bits of the input") \
	X(Zero, "Z", "adds nothing: all 0") \
	X(Affine, "L", "the part that is added scales by the parameter") \
	X(Formula, "F", "the value of a formula, computed apart") \
	X(Accurate, "A", "within a stated bound of 64-bit arithmetic and storage") \
	X(LeftOut, "x", "the source is left out: nothing changes") \
	X(Assigned, "a", "the value of the source, bit for bit") \
	X(BetweenEnds, "m", "between both values, monotone in the weight, exact at its ends") \
	X(Clamped, "w", "as the nearest weight of 0..1; NaN as 0") \
	X(ByDeclaration, "p", "by order of declaration, and the tie is reported") \
	X(Settles, "t", "10,000 steps end at the value of the closed form")

enum class EExpect
{
#define X(Name, Symbol, Meaning) Name,
	STABILITY_EXPECTATIONS(X)
#undef X
		MAX
};

struct FExpectation
{
	const char* Name;
	const char* Symbol;
	const char* Meaning;
};

inline constexpr FExpectation Expectations[] = {
#define X(Name, Symbol, Meaning) {#Name, Symbol, Meaning},
	STABILITY_EXPECTATIONS(X)
#undef X
};

class FCell
{
public:
	/** Reason: a sentence without its full stop. Bound: what the expectation needs a number for. */
	consteval FCell(EExpect InExpect, const char* InReason, double InBound = 0.0)
		: Expect(InExpect)
		, Reason(InReason)
		, Bound(InBound)
	{
		if (Reason.size() < 6 || Reason.back() == '.')
		{
			throw "a cell of the stability table needs a reason";
		}
	}

	EExpect Expect;
	std::string_view Reason;
	double Bound;
};

/** One cell to a hazard, by name. */
struct FCells
{
#define X(Name, Group, Title, Case) FCell Name;
	STABILITY_HAZARDS(X)
#undef X

	constexpr const FCell& operator[](EHazard Hazard) const
	{
		constexpr FCell FCells::*Members[] = {
#define X(Name, Group, Title, Case) &FCells::Name,
			STABILITY_HAZARDS(X)
#undef X
		};
		return this->*Members[static_cast<std::size_t>(Hazard)];
	}
};

/** A pass, or several that make one effect. */
struct FPassRow
{
	const char* Name;
	const char* Header;
	/** Names of factories (config types) whose passes these are, separated by spaces. */
	const char* Factories;
	/** Builds and runs it. */
	FImage (*Run)(const FCase& Case);
	/** The formula, computed apart; null where no cell asks for it. */
	FImage (*Formula)(const FCase& Case) = nullptr;
	/** Forms that all cells hold for; FCase::Variant counts them. */
	int NumVariants = 1;
	/** Size of the input over that of the result. */
	double Shrink = 1.0;
	/** How far beyond the pixels under it a result looks, pixels of the input. */
	double Reach = 0.0;
	/** What a constant and the sum of the light are multiplied by. */
	double Gain = 1.0;
	FCells Cells;
};

/** How a rule is tried: CheckBlend.cpp. */
enum class EBlendForm
{
	Volumes,   // the setting, in two unbound volumes
	Table,     // weight of a colour grading table, by ColorGradingIntensity
	Cubemap,   // colour of a cubemap, by AmbientCubemapIntensity
	Blendable, // weight of a blendable
	Distance,  // weight of a volume of radius 100, by the distance
	Parts,     // FPostProcessUtils::BlendPostProcessSettings
};

/** A rule of blending settings. */
struct FBlendRow
{
	const char* Name;
	const char* Header;
	EBlendForm Form;
	/** The setting it is tried on, where the form has one. */
	const char* Setting;
	FCells Cells;
};

// Words for cells ---------------------------------------------------------------------------------------------------

#define X(Name, Symbol, Meaning) \
	consteval FCell Name(const char* Reason, double Bound = 0.0) \
	{ \
		return FCell(EExpect::Name, Reason, Bound); \
	}
STABILITY_EXPECTATIONS(X)
#undef X

// Reasons that many rows share --------------------------------------------------------------------------------------

inline constexpr FCell NoWeight = DoesNotApply("settings are blended before a pass sees them");
inline constexpr FCell NoPriority = DoesNotApply("volumes are sorted before a pass sees the settings");
inline constexpr FCell NoHistory = DoesNotApply("it keeps nothing from frame to frame");
inline constexpr FCell NoKernel = DoesNotApply("it has no kernel whose width could be set");
inline constexpr FCell NoThreshold = DoesNotApply("it has no threshold");
inline constexpr FCell NoIntensity = DoesNotApply("it has no intensity");
inline constexpr FCell NoPower = DoesNotApply("it computes no power");
inline constexpr FCell NoLuminance = DoesNotApply("it does not look at luminance");
inline constexpr FCell NoLevels = DoesNotApply("it works at one resolution");
inline constexpr FCell NoSum = DoesNotApply("a pixel depends on no other, so nothing is summed");
inline constexpr FCell RoundedBefore =
	AsInfinity("a half texture rounds when it is written, as IEEE 754 says, before the pass sees it");

// The rows ----------------------------------------------------------------------------------------------------------

std::span<const FPassRow> GetSamplingRows();
std::span<const FPassRow> GetBloomRows();
std::span<const FPassRow> GetBlurRows();
std::span<const FPassRow> GetToonRows();
std::span<const FPassRow> GetREDRows();
std::span<const FPassRow> GetLensRows();
std::span<const FPassRow> GetExposureRows();
std::span<const FPassRow> GetDisplayRows();
/** Frames, not passes: each Header is one of pipeline/. */
std::span<const FPassRow> GetFrameRows();
std::span<const FBlendRow> GetBlendRows();

} // namespace Stability
