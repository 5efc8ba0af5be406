// Opens one Vulkan device, found through the loader, whose drivers VK_DRIVER_FILES may name.
#pragma once

#include "Templates/UnrealTemplate.h"
#include "VulkanFunctions.h"

#include <functional>
#include <memory>

namespace Drydock
{

class FVulkanDevice : private FNoncopyable
{
public:
	/** The first graphics card, else the first device of any kind. Null: there is none; OutFault is the reason. */
	static std::shared_ptr<FVulkanDevice> Open(std::string& OutFault);

	~FVulkanDevice();

	/** Name and version as the driver gives them. */
	std::string GetName() const { return Properties.deviceName; }

	/** Memory of one of these types that has all Flags. Throws FVulkanError where there is none. */
	uint32_t FindMemory(uint32_t TypeBits, VkMemoryPropertyFlags Flags) const;

	VkFormatProperties GetFormat(VkFormat Format) const;

	/** Records commands, runs them and waits for their end. Wall milliseconds of running and waiting. */
	double Submit(const std::function<void(VkCommandBuffer)>& Record) const;

	FVulkanFunctions Vk;
	VkPhysicalDeviceProperties Properties = {};
	VkPhysicalDeviceFeatures Features = {};
	uint32_t SubgroupSize = 1;
	VkSubgroupFeatureFlags SubgroupOperations = 0; // of compute shaders
	bool bFloat16 = false;
	bool bInt64Atomics = false; // on buffers and groupshared variables
	VkDevice Device = VK_NULL_HANDLE;

private:
	std::string MakeInstance(void* Loader);
	std::string MakeDevice();
	void ReadProperties();

	VkInstance Instance = VK_NULL_HANDLE;
	VkPhysicalDevice Physical = VK_NULL_HANDLE;
	VkPhysicalDeviceMemoryProperties Memory = {};
	VkQueue Queue = VK_NULL_HANDLE;
	VkCommandPool Commands = VK_NULL_HANDLE;
};

} // namespace Drydock
