// Converts texels for a driver and back: as 32-bit channels, so that only the shader's arithmetic is compared. Reading
// and rounding a format stays drydock's own.
#pragma once

#include "SpirvModule.h"
#include "VulkanDevice.h"
#include "ShaderKernel.h"

namespace Drydock
{

/** Texels of 1, 2 or 4 channels of 32 bits; or of half floats, which hold some formats exactly. */
struct FVulkanTexels
{
	VkFormat Format = VK_FORMAT_UNDEFINED;
	int32_t Channels = 4;
	bool bUint = false;
	bool bHalf = false;

	size_t GetBytes() const { return size_t(Channels) * (bHalf ? 2 : 4); }
};

/** Chooses texels for a texture or typed buffer that is read. bFiltered: a sampler interpolates it, for which not every
 * driver takes 32-bit floats. Throws FVulkanError where the device lacks the format. */
FVulkanTexels ChooseSampledTexels(
	const FVulkanDevice& Device, ETexelStorage Storage, ESpirvType Scalar, bool bFiltered);

/** The texels of a texture or typed buffer that is written too: as the shader declares it (Format of the image type).
 * Throws FVulkanError where the shader declares another format than one of 32-bit channels, or the storage is of
 * another kind. */
FVulkanTexels GetStorageTexels(uint32_t SpirvFormat, ETexelStorage Storage);

/** Count texels side by side, Out of Texels.GetBytes() each. */
void ReadTexels(ETexelStorage Storage, const uint8_t* From, int32_t Count, const FVulkanTexels& Texels, uint8_t* Out);

/** Back; channels that the texels do not have stay as they are. */
void WriteTexels(ETexelStorage Storage, const uint8_t* Values, int32_t Count, const FVulkanTexels& Texels,
	bool bSaturate, uint8_t* To);

} // namespace Drydock
