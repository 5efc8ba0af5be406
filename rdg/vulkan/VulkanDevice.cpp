// Finds the loader, an instance, a device and its queue. Source: Khronos, Vulkan specification, chapters 4 and 5.
#include "VulkanDevice.h"

#include <dlfcn.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace Drydock
{

namespace
{

constexpr const char* GLoader = "libvulkan.so.1";

/** The lower, the better. */
int GetRank(VkPhysicalDeviceType Type)
{
	return Type == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU     ? 0
		   : Type == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU ? 1
		   : Type == VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU    ? 2
															: 3;
}

} // namespace

std::shared_ptr<FVulkanDevice> FVulkanDevice::Open(std::string& OutFault)
{
	// It stays loaded: drivers leave threads and handlers behind.
	void* const Loader = dlopen(GLoader, RTLD_NOW | RTLD_LOCAL);
	if (!Loader)
	{
		OutFault = std::string("there is no ") + GLoader + " (Debian package libvulkan1)";
		return nullptr;
	}
	const auto Opened = std::make_shared<FVulkanDevice>();
	OutFault = Opened->MakeInstance(Loader);
	if (OutFault.empty())
	{
		OutFault = Opened->MakeDevice();
	}
	return OutFault.empty() ? Opened : nullptr;
}

std::string FVulkanDevice::MakeInstance(void* Loader)
{
	const auto GetInstanceProc = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(Loader, "vkGetInstanceProcAddr"));
	const auto CreateInstance =
		GetInstanceProc ? reinterpret_cast<PFN_vkCreateInstance>(GetInstanceProc(nullptr, "vkCreateInstance"))
						: nullptr;
	if (!CreateInstance)
	{
		return std::string(GLoader) + " has no vkCreateInstance";
	}
	auto Application = MakeInfo<VkApplicationInfo>(VK_STRUCTURE_TYPE_APPLICATION_INFO);
	Application.pApplicationName = "drydock";
	Application.apiVersion = VK_API_VERSION_1_3; // the most that is used
	auto Info = MakeInfo<VkInstanceCreateInfo>(VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO);
	Info.pApplicationInfo = &Application;
	if (CreateInstance(&Info, nullptr, &Instance) != VK_SUCCESS)
	{
		Instance = VK_NULL_HANDLE;
		return "there is no Vulkan driver (mesa-vulkan-drivers is Debian's package of one for the CPU)";
	}
#define DRYDOCK_VULKAN_FIND(Name) Vk.Name = reinterpret_cast<PFN_##Name>(GetInstanceProc(Instance, #Name));
	DRYDOCK_VULKAN_INSTANCE_FUNCTIONS(DRYDOCK_VULKAN_FIND)
#undef DRYDOCK_VULKAN_FIND

	uint32_t Count = 0;
	Vk.vkEnumeratePhysicalDevices(Instance, &Count, nullptr);
	std::vector<VkPhysicalDevice> Devices(Count);
	Vk.vkEnumeratePhysicalDevices(Instance, &Count, Devices.data());
	std::optional<int> Best;
	for (const VkPhysicalDevice Candidate : Devices)
	{
		auto Read = MakeInfo<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
		Vk.vkGetPhysicalDeviceProperties2(Candidate, &Read);
		const int Rank = GetRank(Read.properties.deviceType);
		if (Read.properties.apiVersion >= VK_API_VERSION_1_1 && (!Best || Rank < *Best))
		{
			Best = Rank;
			Physical = Candidate;
		}
	}
	return Best ? std::string() : "no Vulkan driver has a device of version 1.1";
}

void FVulkanDevice::ReadProperties()
{
	auto Subgroups =
		MakeInfo<VkPhysicalDeviceSubgroupProperties>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES);
	auto Read = MakeInfo<VkPhysicalDeviceProperties2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2);
	Read.pNext = &Subgroups;
	Vk.vkGetPhysicalDeviceProperties2(Physical, &Read);
	Properties = Read.properties;
	SubgroupSize = Subgroups.subgroupSize;
	SubgroupOperations = Subgroups.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT ? Subgroups.supportedOperations : 0;
	Vk.vkGetPhysicalDeviceMemoryProperties(Physical, &Memory);
}

std::string FVulkanDevice::MakeDevice()
{
	ReadProperties();
	uint32_t Count = 0;
	Vk.vkGetPhysicalDeviceQueueFamilyProperties(Physical, &Count, nullptr);
	std::vector<VkQueueFamilyProperties> Families(Count);
	Vk.vkGetPhysicalDeviceQueueFamilyProperties(Physical, &Count, Families.data());
	constexpr VkQueueFlags Both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
	const auto Family = std::find_if(Families.begin(), Families.end(),
		[](const VkQueueFamilyProperties& Candidate) { return (Candidate.queueFlags & Both) == Both; });
	if (Family == Families.end())
	{
		return GetName() + " has no queue that both draws and dispatches";
	}

	// Asked for is what shaders may need; bounds are checked, as in Direct3D.
	auto Has13 = MakeInfo<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
	auto Has12 = MakeInfo<VkPhysicalDeviceVulkan12Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
	const bool bHas12 = Properties.apiVersion >= VK_API_VERSION_1_2;
	const bool bHas13 = Properties.apiVersion >= VK_API_VERSION_1_3;
	Has12.pNext = bHas13 ? &Has13 : nullptr;
	auto Has = MakeInfo<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
	Has.pNext = bHas12 ? &Has12 : nullptr;
	Vk.vkGetPhysicalDeviceFeatures2(Physical, &Has);
	Features = Has.features;
	bFloat16 = Has12.shaderFloat16 != 0;
	bInt64Atomics = Has12.shaderBufferInt64Atomics && Has12.shaderSharedInt64Atomics;

	auto Use13 = MakeInfo<VkPhysicalDeviceVulkan13Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
	Use13.robustImageAccess = Has13.robustImageAccess;
	auto Use12 = MakeInfo<VkPhysicalDeviceVulkan12Features>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES);
	Use12.pNext = bHas13 ? &Use13 : nullptr;
	Use12.shaderFloat16 = Has12.shaderFloat16;
	Use12.shaderBufferInt64Atomics = Has12.shaderBufferInt64Atomics;
	Use12.shaderSharedInt64Atomics = Has12.shaderSharedInt64Atomics;
	Use12.scalarBlockLayout = Has12.scalarBlockLayout; // constants lie as in Direct3D
	auto Use = MakeInfo<VkPhysicalDeviceFeatures2>(VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2);
	Use.pNext = bHas12 ? &Use12 : nullptr;
	Use.features = Features;

	const uint32_t FamilyIndex = uint32_t(Family - Families.begin());
	constexpr float Priority = 1;
	auto QueueInfo = MakeInfo<VkDeviceQueueCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO);
	QueueInfo.queueFamilyIndex = FamilyIndex;
	QueueInfo.queueCount = 1;
	QueueInfo.pQueuePriorities = &Priority;
	auto Info = MakeInfo<VkDeviceCreateInfo>(VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO);
	Info.pNext = &Use;
	Info.queueCreateInfoCount = 1;
	Info.pQueueCreateInfos = &QueueInfo;
	if (Vk.vkCreateDevice(Physical, &Info, nullptr, &Device) != VK_SUCCESS)
	{
		Device = VK_NULL_HANDLE;
		return GetName() + " cannot be opened";
	}
#define DRYDOCK_VULKAN_FIND(Name) Vk.Name = reinterpret_cast<PFN_##Name>(Vk.vkGetDeviceProcAddr(Device, #Name));
	DRYDOCK_VULKAN_DEVICE_FUNCTIONS(DRYDOCK_VULKAN_FIND)
#undef DRYDOCK_VULKAN_FIND
	Vk.vkGetDeviceQueue(Device, FamilyIndex, 0, &Queue);
	auto PoolInfo = MakeInfo<VkCommandPoolCreateInfo>(VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO);
	PoolInfo.queueFamilyIndex = FamilyIndex;
	return Vk.vkCreateCommandPool(Device, &PoolInfo, nullptr, &Commands) == VK_SUCCESS
			   ? std::string()
			   : GetName() + " gives no memory for commands";
}

FVulkanDevice::~FVulkanDevice()
{
	if (Device)
	{
		Vk.vkDeviceWaitIdle(Device);
		Vk.vkDestroyCommandPool(Device, Commands, nullptr);
		Vk.vkDestroyDevice(Device, nullptr);
	}
	if (Instance)
	{
		Vk.vkDestroyInstance(Instance, nullptr);
	}
}

uint32_t FVulkanDevice::FindMemory(uint32_t TypeBits, VkMemoryPropertyFlags Flags) const
{
	for (uint32_t Type = 0; Type < Memory.memoryTypeCount; ++Type)
	{
		if ((TypeBits >> Type & 1) && (Memory.memoryTypes[Type].propertyFlags & Flags) == Flags)
		{
			return Type;
		}
	}
	throw FVulkanError("it has no memory of the kind that is needed");
}

VkFormatProperties FVulkanDevice::GetFormat(VkFormat Format) const
{
	VkFormatProperties Result = {};
	Vk.vkGetPhysicalDeviceFormatProperties(Physical, Format, &Result);
	return Result;
}

double FVulkanDevice::Submit(const std::function<void(VkCommandBuffer)>& Record) const
{
	auto BufferInfo = MakeInfo<VkCommandBufferAllocateInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO);
	BufferInfo.commandPool = Commands;
	BufferInfo.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
	BufferInfo.commandBufferCount = 1;
	VkCommandBuffer List = VK_NULL_HANDLE;
	CheckVulkan(Vk.vkAllocateCommandBuffers(Device, &BufferInfo, &List), "vkAllocateCommandBuffers");
	auto Begin = MakeInfo<VkCommandBufferBeginInfo>(VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO);
	Begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
	auto FenceInfo = MakeInfo<VkFenceCreateInfo>(VK_STRUCTURE_TYPE_FENCE_CREATE_INFO);
	VkFence Fence = VK_NULL_HANDLE;
	VkResult Result = Vk.vkBeginCommandBuffer(List, &Begin);
	std::chrono::duration<double, std::milli> Taken{};
	if (Result == VK_SUCCESS)
	{
		Record(List);
		Result = Vk.vkEndCommandBuffer(List);
	}
	if (Result == VK_SUCCESS)
	{
		Result = Vk.vkCreateFence(Device, &FenceInfo, nullptr, &Fence);
	}
	if (Result == VK_SUCCESS)
	{
		auto Info = MakeInfo<VkSubmitInfo>(VK_STRUCTURE_TYPE_SUBMIT_INFO);
		Info.commandBufferCount = 1;
		Info.pCommandBuffers = &List;
		const auto Start = std::chrono::steady_clock::now();
		Result = Vk.vkQueueSubmit(Queue, 1, &Info, Fence);
		if (Result == VK_SUCCESS)
		{
			Result = Vk.vkWaitForFences(Device, 1, &Fence, VK_TRUE, UINT64_MAX); // FKernelWatch looks at the clock
		}
		Taken = std::chrono::steady_clock::now() - Start;
	}
	Vk.vkDestroyFence(Device, Fence, nullptr);
	Vk.vkFreeCommandBuffers(Device, Commands, 1, &List);
	CheckVulkan(Result, "vkQueueSubmit");
	return Taken.count();
}

} // namespace Drydock
