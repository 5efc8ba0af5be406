// The stability table: a row is a pass, a frame or a rule of blending, a column a hazard, and a cell what is expected
// and why. The table is data: NamedCells.txt, PassRows.txt and BlendRows.txt, which Table.cpp reads and CheckPass.cpp
// and CheckBlend.cpp carry out. Lines of these files:
//
//   [Row] path/of/its/Header.h Word Word: [Other row] Name Name
//   <tab>Hazard Hazard Expectation Bound, Hazard..Hazard Expectation: the reason
//   Name = Hazard Expectation Bound: the reason
//   Name = Name Name
//
// A row takes the cells of the other row first, then those of the names, then its own. Own cells replace the cells of
// names, and these replace the cells of the other row. First..Last names both columns and all between them. A line of
// a name adds cells to it. A line that begins with two tabs continues the line before it, and # begins a comment.
#pragma once

#include "Hazards.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace Stability
{

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

struct FCell
{
	/** MAX: none is given. */
	EExpect Expect = EExpect::MAX;
	/** The number that the expectation needs. */
	double Bound = 0.0;
	/** A sentence without its full stop. */
	std::string Reason;
	/** File and line in the table. */
	std::string Place;
};

/** One cell to a hazard. */
struct FCells : std::array<FCell, NumHazards>
{
	const FCell& operator[](EHazard Hazard) const { return at(static_cast<size_t>(Hazard)); }
};

struct FRow
{
	std::string Name;
	std::string Header;
	/** Passes: the factories (config types) whose passes these are. Rules: how it is tried (CheckBlend.cpp), and the
	 *  setting it is tried on. */
	std::vector<std::string> Words;
	FCells Cells = {};
	std::string Place;
};

/** A file of the table. */
struct FTableText
{
	std::string File;
	std::string Text;
};

/** Throws std::runtime_error, which begins with file and line: a line is not as it should be, a row gives a cell twice
 * or lacks one. */
std::vector<FRow> ReadTable(const std::vector<FTableText>& Texts);

/** Rows whose header is in a folder ("passes/"), in the order of the table. Frames are in pipeline/, rules in
 * settings/. */
std::vector<const FRow*> GetRows(std::string_view Folder);

} // namespace Stability
