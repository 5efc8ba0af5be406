// Runs a config under every promised equivalence: `drydock prove`.
#pragma once

#include "Prove/PassRecord.h"

#include <functional>
#include <string>
#include <vector>

namespace Drydock
{

/** The result of one equivalence. */
struct FProven
{
	const FEquivalence* Equivalence = nullptr;
	std::string NotRun;                    // why it says nothing of this config; empty: both frames ran
	std::string Unwritten;                 // of SecondRun: messages of what passes read that nothing wrote
	std::string Error;                     // the other frame does not run: its messages
	std::string OtherSize;                 // of the final pictures, where they are of two sizes: "16 x 8, and 15 x 8"
	std::optional<FPixelDifference> Final; // of the final picture, in its own pixels
	std::optional<FFirstDifference> FirstPass; // none where only the final picture tells
	uint64_t NumRounded = 0;                   // values of the final picture that differ within what the promise allows

	bool Holds() const { return Error.empty() && OtherSize.empty() && !Final && Unwritten.empty(); }
	/** A transform that a pass does not follow: an effect may mean it. */
	bool MayBeMeant() const { return Holds() && FirstPass; }
};

struct FProveOptions
{
	FRunOptions Run;
	std::string Only = "*"; // names of equivalences
	/** Called before each. */
	std::function<void(int Done, int Total, const std::string& Name)> Progress;
};

struct FRunResult;

/** The rect of all views in the picture, without padding. */
DRYDOCK_API FViewRect FindPictureView(const FRunResult& Result);

/** Runs the frame of an equivalence; with bReuse those before it, too. */
DRYDOCK_API FRunResult RunEquivalent(const FRunOptions& Options, const FEquivalenceRun& Run, const FViewRect& View);

/** Compares final pictures, and where they differ runs both frames again to find the first pass. Throws FError where
 * the config itself does not run, or (exit code 2) where Only fits no equivalence. */
DRYDOCK_API std::vector<FProven> ProveConfig(const FProveOptions& Options);

/** Lines about the two frames of an equivalence that does not hold: the first pass, the final picture, the likely
 * reason.
 */
DRYDOCK_API std::string DescribeDifference(const FProven& Proven);

/** A line for each, and what is known of those that do not hold. */
DRYDOCK_API std::string MakeProveText(const std::string& Config, const std::vector<FProven>& Proven, int Width = 0);
DRYDOCK_API std::string MakeProveJson(const std::string& Config, const std::vector<FProven>& Proven);

} // namespace Drydock
