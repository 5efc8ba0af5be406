// The functions of Vulkan that drydock calls, found at run time: no program of it is linked with the loader. Source:
// Khronos, Vulkan specification.
#pragma once

#define VK_NO_PROTOTYPES
#include <vulkan/vulkan_core.h>

#include <stdexcept>
#include <string>

namespace Drydock
{

// clang-format off
#define DRYDOCK_VULKAN_INSTANCE_FUNCTIONS(X) \
	X(vkDestroyInstance) X(vkEnumeratePhysicalDevices) X(vkGetPhysicalDeviceProperties2) \
	X(vkGetPhysicalDeviceFeatures2) X(vkGetPhysicalDeviceMemoryProperties) X(vkGetPhysicalDeviceFormatProperties) \
	X(vkGetPhysicalDeviceQueueFamilyProperties) X(vkCreateDevice) X(vkGetDeviceProcAddr)

#define DRYDOCK_VULKAN_DEVICE_FUNCTIONS(X) \
	X(vkDestroyDevice) X(vkDeviceWaitIdle) X(vkGetDeviceQueue) X(vkQueueSubmit) \
	X(vkCreateFence) X(vkDestroyFence) X(vkWaitForFences) \
	X(vkAllocateMemory) X(vkFreeMemory) X(vkMapMemory) \
	X(vkCreateBuffer) X(vkDestroyBuffer) X(vkGetBufferMemoryRequirements) X(vkBindBufferMemory) \
	X(vkCreateBufferView) X(vkDestroyBufferView) \
	X(vkCreateImage) X(vkDestroyImage) X(vkGetImageMemoryRequirements) X(vkBindImageMemory) \
	X(vkCreateImageView) X(vkDestroyImageView) X(vkCreateSampler) X(vkDestroySampler) \
	X(vkCreateShaderModule) X(vkDestroyShaderModule) X(vkCreatePipelineLayout) X(vkDestroyPipelineLayout) \
	X(vkCreateComputePipelines) X(vkCreateGraphicsPipelines) X(vkDestroyPipeline) \
	X(vkCreateRenderPass) X(vkDestroyRenderPass) X(vkCreateFramebuffer) X(vkDestroyFramebuffer) \
	X(vkCreateDescriptorSetLayout) X(vkDestroyDescriptorSetLayout) X(vkCreateDescriptorPool) \
	X(vkDestroyDescriptorPool) X(vkAllocateDescriptorSets) X(vkUpdateDescriptorSets) \
	X(vkCreateCommandPool) X(vkDestroyCommandPool) X(vkAllocateCommandBuffers) X(vkFreeCommandBuffers) \
	X(vkBeginCommandBuffer) X(vkEndCommandBuffer) X(vkCmdPipelineBarrier) X(vkCmdCopyBufferToImage) \
	X(vkCmdCopyImageToBuffer) X(vkCmdBindPipeline) X(vkCmdBindDescriptorSets) X(vkCmdDispatch) \
	X(vkCmdBeginRenderPass) X(vkCmdEndRenderPass) X(vkCmdSetViewport) X(vkCmdSetScissor) \
	X(vkCmdBindVertexBuffers) X(vkCmdDraw)
// clang-format on

struct FVulkanFunctions
{
#define DRYDOCK_VULKAN_DECLARE(Name) PFN_##Name Name = nullptr;
	DRYDOCK_VULKAN_INSTANCE_FUNCTIONS(DRYDOCK_VULKAN_DECLARE)
	DRYDOCK_VULKAN_DEVICE_FUNCTIONS(DRYDOCK_VULKAN_DECLARE)
#undef DRYDOCK_VULKAN_DECLARE
};

/** The driver lacks a feature: a sentence's rest, "it has no ...". */
class FVulkanError : public std::runtime_error
{
public:
	using std::runtime_error::runtime_error;
};

/** One of Vulkan's structs, all else zero. */
template<typename T>
T MakeInfo(VkStructureType Type)
{
	T Info = {};
	Info.sType = Type;
	return Info;
}

/** Throws FVulkanError unless the call succeeded. */
inline void CheckVulkan(VkResult Result, const char* Call)
{
	if (Result != VK_SUCCESS)
	{
		throw FVulkanError(std::string(Call) + " of the driver failed, code " + std::to_string(int(Result)));
	}
}

} // namespace Drydock
