// Finds the texels of a sample and their weights.
#pragma once

#include "DrydockAPI.h"
#include "ShaderKernel.h"

#include <cstdint>
#include <vector>

namespace Drydock
{

struct FFootprintTexel
{
	int32_t Mip = 0;
	int32_t X = 0; // -1: the sampler's border
	int32_t Y = 0;
	int32_t Z = 0; // depth of a volume, or slice
	double Weight = 0;
	double Value[4] = {};
};

/** The place where a sample or gather falls. */
struct FFootprintPlace
{
	double At[3] = {}; // U, V, W of a volume; of a cube the direction
	double Layer = 0;  // of an array; which cube of several
	double Level = 0;
	int32_t Offset[3] = {}; // texels
	bool bCube = false;
};

/** The footprint of a sample: texels whose weight is not 0, by mip, then Z, Y, X. Source: D3D11 functional
 * specification 7.18, written a second time beside the samplers but for the faces of cubes. */
DRYDOCK_API std::vector<FFootprintTexel> FindFootprint(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FFootprintPlace& Place);

/** The footprint of a gather: the texels that it takes a component of, on level 0, each with the number of components
 * out of four. */
DRYDOCK_API std::vector<FFootprintTexel> FindGathered(
	const FKernelTexture& Texture, const FKernelSampler& Sampler, const FFootprintPlace& Place);

} // namespace Drydock
