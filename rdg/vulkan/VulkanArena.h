// Buffers, images and what belongs to them, made for one draw or dispatch and destroyed together.
#pragma once

#include "ShaderKernel.h"
#include "Templates/UnrealTemplate.h"
#include "VulkanDevice.h"

#include <vector>

namespace Drydock
{

/** Memory that both sides see. */
struct FVulkanBuffer
{
	VkBuffer Buffer = VK_NULL_HANDLE;
	uint8_t* Bytes = nullptr;
	VkDeviceSize Size = 0;
};

class FVulkanArena : private FNoncopyable
{
public:
	explicit FVulkanArena(const FVulkanDevice& InDevice)
		: Owner(InDevice)
	{
	}
	~FVulkanArena();

	/** All of these throw FVulkanError where the device has no more. Contents are not defined. */
	FVulkanBuffer MakeBuffer(VkDeviceSize Size, VkBufferUsageFlags Usage);
	VkBufferView MakeBufferView(const FVulkanBuffer& Buffer, VkFormat Format);
	VkImage MakeImage(const VkImageCreateInfo& Info);
	VkImageView MakeImageView(VkImage Image, VkImageViewType Type, VkFormat Format);
	VkSampler MakeSampler(const FKernelSampler& Sampler);

private:
	void* Allocate(const VkMemoryRequirements& Needs, VkMemoryPropertyFlags Flags, VkDeviceMemory& OutMemory);

	const FVulkanDevice& Owner;
	std::vector<VkBuffer> Buffers;
	std::vector<VkBufferView> BufferViews;
	std::vector<VkImage> Images;
	std::vector<VkImageView> ImageViews;
	std::vector<VkSampler> Samplers;
	std::vector<VkDeviceMemory> Memories;
};

} // namespace Drydock
