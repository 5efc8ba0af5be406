// How each row's pass is built and run, and the formula that it is held to: the files *Runs.cpp register their runs
// under the names of rows.
#pragma once

#include <map>
#include <string>

namespace PassReference
{
struct FImage;
}

namespace Stability
{

using PassReference::FImage;
struct FCase;

struct FRun
{
	/** Builds and runs the pass. The comment of each function says how it fills in what a case leaves open. */
	FImage (*Run)(const FCase& Case);
	/** The formula, computed apart; null where no cell asks for it. */
	FImage (*Formula)(const FCase& Case) = nullptr;
	/** Forms that all cells hold for; FCase::Variant counts them. */
	int NumVariants = 1;
	/** Size of the input over that of the result. */
	double Shrink = 1.0;
	/** How far beyond the pixels under it a result looks, pixels of the input. */
	double Reach = 0.0;
	/** The factor for a constant and for the sum of the light. */
	double Gain = 1.0;
};

/** All, by row. */
inline std::map<std::string, FRun>& GetRuns()
{
	static std::map<std::string, FRun> Runs;
	return Runs;
}

struct FRunRegistration
{
	explicit FRunRegistration(std::map<std::string, FRun> Runs) { GetRuns().merge(Runs); }
};

} // namespace Stability
