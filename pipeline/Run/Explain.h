// Explains why a frame runs or leaves out effects, passes and channels, with memory and time, beside the same frame
// with nothing skipped.
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
	std::string Effect; // whose pass it is, "plugin libTint.so" for a plugin's; empty: nobody's
	bool bExecutes = false;
	std::string Reason; // of one that does not: why
	std::string Shader;
	std::string RunsAs; // DescribeShaderRun; empty: not known before the pass runs
	double Milliseconds = 0.0;
	std::vector<FPassValue> Values;   // of its parameters
	std::string MergeReason;          // why it begins a render pass; empty: it does not
	std::string MergedInto;           // the pass whose render pass it is part of; empty: none, or its own
	std::string Silent;               // of a measured one: that it wrote again what it read, and why; empty: it did not
	std::vector<std::string> Reads;   // resources
	std::vector<std::string> Writes;  // resources
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

/** A plugin's passes, whatever effect of the chain they stand in. */
struct FExplainedPlugin
{
	std::string Name; // "plugin libTint.so"
	int NumPasses = 0;
	int NumCulled = 0;
	double Milliseconds = 0.0;
	double Megabytes = 0.0;
};

/** The cost of a frame. */
struct FExplainedCost
{
	int NumPasses = 0;                // that execute
	int NumChannels = 0;              // that are decoded
	uint64_t Texels = 0;              // that its passes write, by what they are asked for
	std::optional<uint64_t> Taps = 0; // texture reads of an executed frame; none: not known of one of its passes
	uint64_t BytesMoved = 0;          // that its passes read and write, of an executed frame
	uint64_t TransientBytes = 0;
	uint64_t SceneBytes = 0;   // of scene textures that are loaded
	double Milliseconds = 0.0; // of all passes
};

/** The difference between two frames, run in turn: milliseconds. */
struct FMeasuredSaving
{
	double Least = 0.0;
	double Median = 0.0;
	double Most = 0.0;
	int NumPairs = 0;
};

struct FExplainReport
{
	std::string Config;
	std::vector<FExplainedEffect> Effects;
	std::vector<FExplainedPlugin> Plugins; // in the order of their first passes
	std::vector<FExplainedPass> Passes;
	std::vector<FSceneChannel> Channels;
	FExplainedCost Cost;
	FExplainedCost WithoutSkipping;
	std::optional<FMeasuredSaving> Saved; // where it was measured
	bool bMeasured = false;               // Milliseconds are medians of executed runs; else the cost model's
	int NumUnknown = 0;                   // passes that never ran on this machine, so that their cost is a guess
};

/** Milliseconds of passes by index, of executed runs: medians. */
using FMeasuredPasses = std::vector<std::pair<int, double>>;

/** Samples: of the time that each pair of runs differs by; one at least. */
DRYDOCK_API FMeasuredSaving MakeMeasuredSaving(std::vector<double> Samples);

/** Frame, and the same frame with nothing skipped: compiled at least, with what they would load. Measured: of both;
 * without it the model's estimates. */
DRYDOCK_API FExplainReport MakeExplainReport(const FRunResult& Frame, const FRunResult& NoSkip, const FCostModel& Model,
	const FMeasuredPasses* MeasuredFrame = nullptr, const FMeasuredPasses* MeasuredNoSkip = nullptr);

/** Effects, then totals and what is saved. */
DRYDOCK_API std::string MakeExplainText(const FExplainReport& Report, bool bColorful, int Width = 0);

/** Describes every pass of that name: what it reads, what it writes, and the passes that read this. Throws FError (exit
 * code 2) if there is none. */
DRYDOCK_API std::string MakePassText(const FExplainReport& Report, const std::string& Pass);

/** One effect with its passes. Throws FError (exit code 2) where there is none. */
DRYDOCK_API std::string MakeEffectText(const FExplainReport& Report, const std::string& Effect, int Width = 0);

DRYDOCK_API std::string MakeExplainJson(const FExplainReport& Report);

} // namespace Drydock
