// Counts what a pass cost, in units that do not depend on the machine.
#pragma once

#include <cstdint>
#include <string>

namespace Drydock
{

/** Sums over the dispatches and draws of a pass. */
struct FPassCounters
{
	std::string Shader;     // class of the last shader that ran: "FBloomSetupPS"; empty: none did
	std::string Entry;      // its entry point
	uint64_t Pixels = 0;    // pixels drawn, threads dispatched, texels copied or cleared
	uint64_t Taps = 0;      // texture samples and loads; 0 where the count varies per pixel and is not measured
	uint64_t BytesRead = 0; // of every view bound for reading, each texel once
	/** Of every texel written; views bound for writing by compute shaders: at most all of them. */
	uint64_t BytesWritten = 0;
};

} // namespace Drydock
