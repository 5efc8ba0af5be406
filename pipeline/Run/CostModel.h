// Predicts what a pass will cost on this machine: nanoseconds for each texel it writes, learned from earlier runs. Kept
// as costs.json beside the shader cache.
#pragma once

#include "RenderGraphCompiled.h"
#include "Run/RunResult.h"

#include <cstdint>
#include <map>
#include <string>

namespace Drydock
{

class DRYDOCK_API FCostModel
{
public:
	/** The assumed cost of a pass that never ran here, ns for each texel: about that of a filter of a few taps. */
	static constexpr double UnknownCost = 2.0;

	/** The model as the cache has it; empty where there is none or it cannot be read. */
	static FCostModel Load();

	/** Takes over what the passes of an executed run cost: the mean of old and new. */
	void Learn(const FRunResult& Result);

	/** Writes it aside and renames it. A cache that cannot be written is not an error: the model is a convenience. */
	void Save() const;

	/** Conditions: those of MakeCostConditions. */
	double EstimateMilliseconds(
		const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass, const std::string& Conditions) const;

	bool IsKnown(const FRDGCompiledPass& Pass, const std::string& Conditions) const;

	std::string ToJson() const;
	static FCostModel FromJson(const std::string& Text);

private:
	std::map<std::string, double> NanosecondsPerTexel; // by shader or pass and conditions; also with what is read
};

/** "float native 2": arithmetic, storage and threads, which costs depend on. */
DRYDOCK_API std::string MakeCostConditions(const FRunResult& Result);

/** Texels and elements that a pass writes: those of the size that its event name states, as names do in the engine
 * ("BloomSetup 480x270 (PS)"), and at most the whole of what it declares to write. */
DRYDOCK_API uint64_t CountWrittenTexels(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass);

} // namespace Drydock
