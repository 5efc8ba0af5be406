// Pictures that need no file: kernels of convolution bloom, by the names that settings use for them. Grey, square, with
// the source of light in the middle texel. Airy's pattern is that of a round aperture.
#pragma once

#include "CoreMinimal.h"

#include <string>
#include <vector>

namespace Drydock
{

/** "Builtin/Airy": rings around a disc, as a round aperture diffracts light. "Builtin/Disc": an even disc that touches
 * the picture's edges. "Builtin/Star": six spikes and a halo, as a six-bladed iris makes them. */
DRYDOCK_API const std::vector<std::string>& GetBuiltinTextureNames();

/** Side of a built-in kernel in texels: odd, so that its middle is a texel. */
constexpr int32 BuiltinKernelSize = 513;

/** The part of a kernel's energy that lies outside its middle texel: about what the sum of Gaussians adds to a picture
 * at its defaults, divided by the default BloomIntensity. */
constexpr double BuiltinKernelScatter = 2.0 / 15.0;

/** Row-major, BuiltinKernelSize squared; sums to 1. Empty for any other name. */
DRYDOCK_API std::vector<float> MakeBuiltinKernel(const std::string& Name);

} // namespace Drydock
