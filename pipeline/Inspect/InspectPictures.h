// Makes pictures of the values found inside shaders: masks, values stretched to their range, cost.
#pragma once

#include "Inspect/CheckCapture.h"
#include "Inspect/LineCapture.h"
#include "Picture/ImageFile.h"

namespace Drydock
{

/** White where a finding was made, black elsewhere; one channel. */
DRYDOCK_API FImage MakeMask(const FPassFinding& Finding);

/** The values, NaN where the line did not run. */
DRYDOCK_API FImage MakeValueImage(const FLineValues& Values);

/** The range of a value picture, for its description and its display. */
struct FValueRange
{
	double Least = 0; // of all channels, what is finite
	double Most = 0;
	uint64_t Reached = 0;   // pixels whose line ran
	uint64_t NotFinite = 0; // of them
};
DRYDOCK_API FValueRange FindRange(const FLineValues& Values);

/** Red, green, blue and alpha to look at: the range goes to 0..1, of one channel in grey; magenta what is not finite,
 * clear where the line did not run. */
DRYDOCK_API FImage MakeStretched(const FLineValues& Values, const FValueRange& Range);

/** Taps and operations of each pixel, two channels. */
DRYDOCK_API FImage MakeCostImage(const FCostMap& Map);

/** Makes a picture of the cost to look at: black means none, pale yellow the most expensive pixel by operations. */
DRYDOCK_API FImage MakeCostPreview(const FCostMap& Map);

} // namespace Drydock
