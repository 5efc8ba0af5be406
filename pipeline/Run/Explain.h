// Why a frame does what it does and leaves out what it leaves out: effects, passes, channels, memory and time, beside
// the same frame with nothing skipped.
#pragma once

#include "Run/CostModel.h"
#include "Run/Run.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

struct FExplainedPass
{
	int Index = 0;
	std::string Name;
	std::string Effect; // whose pass it is; empty: nobody's, as a pass of a view extension
	bool bExecutes = false;
	std::string Reason; // of one that does not: why
	std::string Shader;
	double Milliseconds = 0.0;
	std::vector<std::string> Reads;   // resources
	std::vector<std::string> Writes;  // likewise
	std::vector<std::string> Readers; // surviving passes that read what it writes
};

struct FExplainedEffect
{
	FEffectDecision Decision;
	int NumPasses = 0; // that execute
	int NumCulled = 0;
	double Milliseconds = 0.0;
	double Megabytes = 0.0; // of what its passes write
};

/** What a frame comes to. */
struct FExplainedCost
{
	int NumPasses = 0;   // that execute
	int NumChannels = 0; // that are decoded
	uint64_t TransientBytes = 0;
	uint64_t SceneBytes = 0;   // of scene textures that are loaded
	double Milliseconds = 0.0; // of all passes
};

struct FExplainReport
{
	std::string Config;
	std::vector<FExplainedEffect> Effects;
	std::vector<FExplainedPass> Passes;
	std::vector<FSceneChannel> Channels;
	FExplainedCost Cost;
	FExplainedCost WithoutSkipping;
	bool bMeasured = false; // Milliseconds are medians of executed runs; else the cost model's
	int NumUnknown = 0;     // passes that never ran on this machine, so that their cost is a guess
};

/** Milliseconds of passes by index, of executed runs: medians. */
using FMeasuredPasses = std::vector<std::pair<int, double>>;

/** Frame, and the same frame with nothing skipped: compiled at least, with what they would load. Measured: of both;
 * without it the model's estimates. */
DRYDOCK_API FExplainReport MakeExplainReport(const FRunResult& Frame, const FRunResult& NoSkip, const FCostModel& Model,
	const FMeasuredPasses* MeasuredFrame = nullptr, const FMeasuredPasses* MeasuredNoSkip = nullptr);

/** Effects, then totals and what is saved. */
DRYDOCK_API std::string MakeExplainText(const FExplainReport& Report, bool bColorful);

/** One pass: what it reads, writes, who reads that; every pass of that name. Throws FError (exit code 2) where there is
 * none. */
DRYDOCK_API std::string MakePassText(const FExplainReport& Report, const std::string& Pass);

/** One effect with its passes. Throws FError (exit code 2) where there is none. */
DRYDOCK_API std::string MakeEffectText(const FExplainReport& Report, const std::string& Effect);

DRYDOCK_API std::string MakeExplainJson(const FExplainReport& Report);

} // namespace Drydock
