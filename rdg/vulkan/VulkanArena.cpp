// Makes Vulkan's resources and destroys them. Source: Khronos, Vulkan specification, chapters 11, 12 and 13.
#include "VulkanArena.h"

#include <algorithm>

namespace Drydock
{

namespace
{

VkSamplerAddressMode ToVulkan(EKernelAddress Address)
{
	return Address == EKernelAddress::Wrap     ? VK_SAMPLER_ADDRESS_MODE_REPEAT
		   : Address == EKernelAddress::Mirror ? VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT
		   : Address == EKernelAddress::Border ? VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_BORDER
											   : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

VkBorderColor ToVulkan(const float (&Border)[4])
{
	const bool bGrey = Border[0] == Border[1] && Border[1] == Border[2];
	if (bGrey && Border[0] == 0 && Border[3] == 0)
	{
		return VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;
	}
	if (bGrey && Border[3] == 1 && (Border[0] == 0 || Border[0] == 1))
	{
		return Border[0] == 0 ? VK_BORDER_COLOR_FLOAT_OPAQUE_BLACK : VK_BORDER_COLOR_FLOAT_OPAQUE_WHITE;
	}
	throw FVulkanError("Vulkan has no border colour other than black and white");
}

} // namespace

FVulkanArena::~FVulkanArena()
{
	const auto DestroyAll = [this](const auto& Handles, const auto& Destroy)
	{
		for (const auto Handle : Handles)
		{
			Destroy(Owner.Device, Handle, nullptr);
		}
	};
	const FVulkanFunctions& Vk = Owner.Vk;
	DestroyAll(Samplers, Vk.vkDestroySampler);
	DestroyAll(ImageViews, Vk.vkDestroyImageView);
	DestroyAll(BufferViews, Vk.vkDestroyBufferView);
	DestroyAll(Images, Vk.vkDestroyImage);
	DestroyAll(Buffers, Vk.vkDestroyBuffer);
	DestroyAll(Memories, Vk.vkFreeMemory);
}

void* FVulkanArena::Allocate(const VkMemoryRequirements& Needs, VkMemoryPropertyFlags Flags, VkDeviceMemory& OutMemory)
{
	auto Info = MakeInfo<VkMemoryAllocateInfo>(VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO);
	Info.allocationSize = Needs.size;
	Info.memoryTypeIndex = Owner.FindMemory(Needs.memoryTypeBits, Flags);
	CheckVulkan(Owner.Vk.vkAllocateMemory(Owner.Device, &Info, nullptr, &OutMemory), "vkAllocateMemory");
	Memories.push_back(OutMemory);
	void* Address = nullptr;
	if (Flags & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
	{
		CheckVulkan(Owner.Vk.vkMapMemory(Owner.Device, OutMemory, 0, VK_WHOLE_SIZE, 0, &Address), "vkMapMemory");
	}
	return Address;
}

FVulkanBuffer FVulkanArena::MakeBuffer(VkDeviceSize Size, VkBufferUsageFlags Usage)
{
	FVulkanBuffer Result;
	Result.Size = std::max<VkDeviceSize>(Size, 4); // no buffer is empty
	auto Info = MakeInfo<VkBufferCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO);
	Info.size = Result.Size;
	Info.usage = Usage;
	CheckVulkan(Owner.Vk.vkCreateBuffer(Owner.Device, &Info, nullptr, &Result.Buffer), "vkCreateBuffer");
	Buffers.push_back(Result.Buffer);
	VkMemoryRequirements Needs = {};
	Owner.Vk.vkGetBufferMemoryRequirements(Owner.Device, Result.Buffer, &Needs);
	VkDeviceMemory Memory = VK_NULL_HANDLE;
	Result.Bytes = static_cast<uint8_t*>(
		Allocate(Needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, Memory));
	CheckVulkan(Owner.Vk.vkBindBufferMemory(Owner.Device, Result.Buffer, Memory, 0), "vkBindBufferMemory");
	return Result;
}

VkBufferView FVulkanArena::MakeBufferView(const FVulkanBuffer& Buffer, VkFormat Format)
{
	auto Info = MakeInfo<VkBufferViewCreateInfo>(VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO);
	Info.buffer = Buffer.Buffer;
	Info.format = Format;
	Info.range = VK_WHOLE_SIZE;
	VkBufferView View = VK_NULL_HANDLE;
	CheckVulkan(Owner.Vk.vkCreateBufferView(Owner.Device, &Info, nullptr, &View), "vkCreateBufferView");
	BufferViews.push_back(View);
	return View;
}

VkImage FVulkanArena::MakeImage(const VkImageCreateInfo& Info)
{
	VkImage Image = VK_NULL_HANDLE;
	CheckVulkan(Owner.Vk.vkCreateImage(Owner.Device, &Info, nullptr, &Image), "vkCreateImage");
	Images.push_back(Image);
	VkMemoryRequirements Needs = {};
	Owner.Vk.vkGetImageMemoryRequirements(Owner.Device, Image, &Needs);
	VkDeviceMemory Memory = VK_NULL_HANDLE;
	Allocate(Needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, Memory);
	CheckVulkan(Owner.Vk.vkBindImageMemory(Owner.Device, Image, Memory, 0), "vkBindImageMemory");
	return Image;
}

VkImageView FVulkanArena::MakeImageView(VkImage Image, VkImageViewType Type, VkFormat Format)
{
	auto Info = MakeInfo<VkImageViewCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO);
	Info.image = Image;
	Info.viewType = Type;
	Info.format = Format;
	Info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
	VkImageView View = VK_NULL_HANDLE;
	CheckVulkan(Owner.Vk.vkCreateImageView(Owner.Device, &Info, nullptr, &View), "vkCreateImageView");
	ImageViews.push_back(View);
	return View;
}

VkSampler FVulkanArena::MakeSampler(const FKernelSampler& Sampler)
{
	const bool bPoint = Sampler.Filter == EKernelFilter::Point;
	auto Info = MakeInfo<VkSamplerCreateInfo>(VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO);
	Info.magFilter = Info.minFilter = bPoint ? VK_FILTER_NEAREST : VK_FILTER_LINEAR;
	Info.mipmapMode =
		Sampler.Filter == EKernelFilter::Trilinear ? VK_SAMPLER_MIPMAP_MODE_LINEAR : VK_SAMPLER_MIPMAP_MODE_NEAREST;
	Info.addressModeU = ToVulkan(Sampler.AddressU);
	Info.addressModeV = ToVulkan(Sampler.AddressV);
	Info.addressModeW = ToVulkan(Sampler.AddressW);
	Info.mipLodBias = Sampler.MipBias;
	Info.minLod = Sampler.MinLevel;
	Info.maxLod = Sampler.MaxLevel;
	const bool bBorder = Sampler.AddressU == EKernelAddress::Border || Sampler.AddressV == EKernelAddress::Border ||
						 Sampler.AddressW == EKernelAddress::Border;
	Info.borderColor = bBorder ? ToVulkan(Sampler.Border) : VK_BORDER_COLOR_FLOAT_TRANSPARENT_BLACK;
	VkSampler Made = VK_NULL_HANDLE;
	CheckVulkan(Owner.Vk.vkCreateSampler(Owner.Device, &Info, nullptr, &Made), "vkCreateSampler");
	Samplers.push_back(Made);
	return Made;
}

} // namespace Drydock
