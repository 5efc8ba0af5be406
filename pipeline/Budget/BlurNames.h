// The blurs that a study can compare, by name: plain data, so that a config is checked without them.
#pragma once

#include "DrydockAPI.h"

#include <string>
#include <vector>

namespace Drydock
{

struct FBlurAlgorithm
{
	std::string Name;           // "DualKawase"
	std::string Doc;            // one sentence
	bool bGraph = true;         // shaders in the render graph; else plain code
	double SmallestSigma = 0.5; // pixels; what it can be matched to
	double LargestSigma = 1000.0;
};

/** Exact, Direct, Separable, GaussianSum, Kawase, DualKawase, Pyramid, FFT. */
DRYDOCK_API const std::vector<FBlurAlgorithm>& GetBlurAlgorithms();

/** Null when there is none of that name. */
DRYDOCK_API const FBlurAlgorithm* FindBlurAlgorithm(const std::string& Name);

DRYDOCK_API const std::vector<std::string>& GetBlurStorages();

} // namespace Drydock
