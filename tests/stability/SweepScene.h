// A frame with every effect on, in a picture so small that thousands of runs take minutes.
#pragma once

#include "Run/Run.h"
#include "SceneFolder.h"

#include <string>
#include <vector>

namespace Stability
{

/** What the frame is made with. */
enum class ESweepFrame
{
	Corrected, // bloom as a sum of Gaussians, the histogram, articles' effects corrected
	Printed,   // convolution bloom, basic metering, articles' effects but RED as printed
	Manual,    // as Corrected, without automatic exposure
	MAX
};

const char* ToString(ESweepFrame Frame);

/** A finite scene of 32 x 18 pixels with every channel, in a folder of its own. */
class FSweepScene
{
public:
	FSweepScene();

	/** Settings: "Name=Value"; Variables: "r.Name=Value". Throws FError as RunConfig does. */
	Drydock::FRunResult Run(ESweepFrame Frame, const std::vector<std::string>& Settings,
		const std::vector<std::string>& Variables = {}) const;

private:
	const FSceneFolder Folder;
};

} // namespace Stability
