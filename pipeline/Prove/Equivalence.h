// Lists the equivalences that drydock promises: other ways of computing a frame that give the same picture.
#pragma once

#include "Budget/RunOptions.h"

#include <string>
#include <vector>

namespace Drydock
{

/** The likeness that is promised for two frames. */
enum class EAlike
{
	SameBits,
	/** Texture coordinates over another extent round otherwise, and one on the border of two steps of 1/256 texel takes
	 * the other: final values differ by at most one step of 8 bits, and fewer than one in 1000 differ at all. */
	SameButForRounding,
};

/** The part of the picture that is a view. */
enum class EViewLayout
{
	AsConfigured,
	Left,         // the left half alone
	LeftAndRight, // both halves as views of their own
	Right,        // the right half alone
	RightAndLeft, // both, the right one first
};

/** A change to the inputs of each pass of a plugin, which runs once more beside the frame. */
enum class EPassTransform
{
	None,
	Mirrored, // left and right
	Shifted,  // by whole texels to the right
};

/** The options of a frame's run, beside those that its user asked for. */
struct FEquivalenceRun
{
	std::vector<std::string> Variables = {}; // "r.Name=Value"
	bool bNoSkip = false;
	std::optional<std::array<int, 4>> Padding = {}; // left, top, right, bottom
	std::optional<double> ScreenPercentage = {};
	EViewLayout Layout = EViewLayout::AsConfigured;
	/** The third of three frames in a row that share a cache of passes. The first has another pre-exposure. */
	bool bReuse = false;

	bool operator==(const FEquivalenceRun&) const = default;
};

/** Two runs that give the same picture. */
struct FEquivalence
{
	std::string Name; // "OneThread"
	std::string What; // "on one thread"
	FEquivalenceRun Base;
	FEquivalenceRun Other;
	EAlike Alike = EAlike::SameBits;
	std::string Likely; // what is likely wrong where they differ: a sentence
	/** Textures between may hold this multiple in the other run. */
	double Scale = 1.0;
	/** Not None: both runs are one, in which passes are judged. Effects may break it on purpose. */
	EPassTransform Transform = EPassTransform::None;
};

/** All of them. Those of layouts come last. */
DRYDOCK_API const std::vector<FEquivalence>& GetEquivalences();

/** Left, top, right, bottom, pixels of the picture. */
using FViewRect = std::array<int, 4>;

/** The options with what an equivalence's run adds. View: the one whose halves the layouts are cut from. */
DRYDOCK_API FRunOptions MakeEquivalentRun(
	const FRunOptions& Options, const FEquivalenceRun& Run, const FViewRect& View);

/** The first view of the run, which both show, counted from the corner of its final picture. */
DRYDOCK_API FViewRect FindSharedView(const FEquivalenceRun& Run, const FViewRect& View);

} // namespace Drydock
