// Two versions beside each other: their pictures, and their passes one by one. Pure: data in, data out.
#pragma once

#include "DrydockAPI.h"
#include "Matrix/MatrixResult.h"
#include "Picture/ImageFile.h"

#include <optional>
#include <string>
#include <vector>

namespace Drydock
{

/** None: every value has the same bits, NaN of any kind counting as one. */
DRYDOCK_API std::optional<FPictureDifference> ComparePictures(const FImage& Before, const FImage& Now);

/** Fingerprint of size and values. */
DRYDOCK_API std::string FingerprintPicture(const FImage& Picture);

/** The first pass, in the order of the graph, that is new, gone, another, culled or run otherwise, has another shader
 * or wrote something else. None: all passes are the same. */
DRYDOCK_API std::optional<FPassDifference> FindFirstDifference(
	const std::vector<FMatrixPass>& Before, const std::vector<FMatrixPass>& Now);

} // namespace Drydock
