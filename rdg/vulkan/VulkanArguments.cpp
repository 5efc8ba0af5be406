// Copies textures and buffers, mip by mip and slice by slice. Source: Khronos, Vulkan specification, chapters 7 and 19.
#include "VulkanArguments.h"

#include "PixelFormatConversion.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** f(mip, z, y) for the rows of a texture, in the order of staging memory. */
template<typename FFunction>
void ForEachRow(const FKernelTexture& Texture, FFunction f)
{
	for (int32_t m = 0; m < Texture.NumMips; ++m)
	{
		const FKernelMip& Mip = Texture.Mips[m];
		for (int32_t z = 0; z < Mip.SizeZ; ++z)
		{
			for (int32_t y = 0; y < Mip.SizeY; ++y)
			{
				f(Mip, z, y);
			}
		}
	}
}

uint8_t* GetRow(const FKernelMip& Mip, int32_t Z, int32_t Y)
{
	return Mip.Data + int64_t(Z) * Mip.SlicePitch + int64_t(Y) * Mip.RowPitch;
}

VkImageViewType GetViewType(const FSpirvType& Type)
{
	switch (Type.Dim)
	{
	case Dim3D:
		return VK_IMAGE_VIEW_TYPE_3D;
	case DimCube:
		return Type.bArrayed ? VK_IMAGE_VIEW_TYPE_CUBE_ARRAY : VK_IMAGE_VIEW_TYPE_CUBE;
	case Dim2D:
		return Type.bArrayed ? VK_IMAGE_VIEW_TYPE_2D_ARRAY : VK_IMAGE_VIEW_TYPE_2D;
	default:
		throw FVulkanError("it is not asked for textures of one dimension");
	}
}

} // namespace

void WaitForAll(const FVulkanDevice& Device, VkCommandBuffer Commands)
{
	auto Barrier = MakeInfo<VkMemoryBarrier>(VK_STRUCTURE_TYPE_MEMORY_BARRIER);
	Barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
	Barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT | VK_ACCESS_HOST_READ_BIT;
	Device.Vk.vkCmdPipelineBarrier(Commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
		VK_PIPELINE_STAGE_ALL_COMMANDS_BIT | VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &Barrier, 0, nullptr, 0, nullptr);
}

void BeginImage(const FVulkanDevice& Device, VkCommandBuffer Commands, VkImage Image)
{
	auto Barrier = MakeInfo<VkImageMemoryBarrier>(VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER);
	Barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
	Barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
	Barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
	Barrier.srcQueueFamilyIndex = Barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
	Barrier.image = Image;
	Barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, VK_REMAINING_MIP_LEVELS, 0, VK_REMAINING_ARRAY_LAYERS};
	Device.Vk.vkCmdPipelineBarrier(Commands, VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0,
		0, nullptr, 0, nullptr, 1, &Barrier);
}

FVulkanArguments::FVulkanArguments(const FVulkanDevice& InDevice, FVulkanArena& InArena, const FSpirvModule& InModule,
	const std::vector<FVulkanBinding>& Bindings, const FKernelArgs& InArgs, const FShaderReflection& Kernel)
	: Device(InDevice)
	, Arena(InArena)
	, Module(InModule)
	, Args(InArgs)
{
	for (size_t Sampler = 0; Sampler < Kernel.Samplers.size(); ++Sampler)
	{
		bFilters = bFilters || Args.Samplers[Sampler].Filter != EKernelFilter::Point;
	}
	for (const FVulkanBinding& Binding : Bindings)
	{
		FResource& Resource = Resources.emplace_back();
		Resource.Binding = Binding;
		CopyIn(Resource, Kernel);
	}
}

FVulkanArguments::~FVulkanArguments()
{
	Device.Vk.vkDestroyDescriptorPool(Device.Device, Pool, nullptr);
}

void FVulkanArguments::CopyIn(FResource& Resource, const FShaderReflection& Kernel)
{
	const int32_t Slot = Resource.Binding.Slot;
	const auto CopyBytes = [&](const void* Bytes, size_t Size, VkBufferUsageFlags Usage)
	{
		Resource.Buffer = Arena.MakeBuffer(Size, Usage);
		std::memcpy(Resource.Buffer.Bytes, Bytes, Size);
	};
	switch (Resource.Binding.Type)
	{
	case VK_DESCRIPTOR_TYPE_SAMPLER:
		if (Kernel.Samplers[size_t(Slot)].bCompares)
		{
			throw FVulkanError("comparison samplers want textures of depth, and it is given colours");
		}
		Resource.Sampler = Arena.MakeSampler(Args.Samplers[Slot]);
		return;
	case VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE:
		CopyTexture(Resource, Args.Textures[Slot]);
		return;
	case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE:
		CopyTexture(Resource, Args.RWTextures[Slot]);
		return;
	case VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER:
		CopyTypedBuffer(Resource, Args.Buffers[Slot]);
		return;
	case VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER:
		CopyTypedBuffer(Resource, Args.RWBuffers[Slot]);
		return;
	case VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER:
		CopyBytes(
			Args.ConstantBuffers[Slot], Kernel.ConstantBuffers[size_t(Slot)].Size, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
		return;
	default:
	{
		const FKernelBuffer& Buffer = IsWritten(Resource) ? Args.RWBuffers[Slot] : Args.Buffers[Slot];
		CopyBytes(Buffer.Data, Buffer.SizeInBytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
	}
	}
}

bool FVulkanArguments::IsWritten(const FResource& Resource) const
{
	switch (Resource.Binding.Type)
	{
	case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE:
	case VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER:
		return true;
	case VK_DESCRIPTOR_TYPE_STORAGE_BUFFER:
		return TypeOf(Resource).Members.empty() || !TypeOf(Resource).Members[0].bNonWritable;
	default:
		return false;
	}
}

void FVulkanArguments::CopyTexture(FResource& Resource, const FKernelTexture& Texture)
{
	const FSpirvType& Type = TypeOf(Resource);
	const bool bStorage = Resource.Binding.Type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
	FVulkanTexels& Texels = Resource.Texels;
	Texels = bStorage ? GetStorageTexels(Type.Format, Texture.Storage)
					  : ChooseSampledTexels(Device, Texture.Storage, Module.GetType(Type.Element).Kind, bFilters);
	const FKernelMip& First = Texture.Mips[0];
	const uint32_t NumMips = bStorage ? 1 : uint32_t(Texture.NumMips); // mip 0 is what is written
	auto Info = MakeInfo<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
	Info.flags = Type.Dim == DimCube ? VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT : 0;
	Info.imageType = Texture.bIs3D ? VK_IMAGE_TYPE_3D : VK_IMAGE_TYPE_2D;
	Info.format = Texels.Format;
	Info.extent = {uint32_t(First.SizeX), uint32_t(First.SizeY), Texture.bIs3D ? uint32_t(First.SizeZ) : 1};
	Info.mipLevels = NumMips;
	Info.arrayLayers = Texture.bIs3D ? 1 : uint32_t(First.SizeZ);
	Info.samples = VK_SAMPLE_COUNT_1_BIT;
	Info.usage = VK_IMAGE_USAGE_TRANSFER_DST_BIT |
				 (bStorage ? VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT : VK_IMAGE_USAGE_SAMPLED_BIT);
	const uint32_t Most =
		Texture.bIs3D ? Device.Properties.limits.maxImageDimension3D : Device.Properties.limits.maxImageDimension2D;
	if (std::max({Info.extent.width, Info.extent.height, Info.extent.depth}) > Most)
	{
		throw FVulkanError("its textures have at most " + std::to_string(Most) + " texels a side");
	}
	FVulkanImage& Image = Resource.Image;
	Image.Image = Arena.MakeImage(Info);
	Image.View = Arena.MakeImageView(Image.Image, GetViewType(Type), Texels.Format);

	VkDeviceSize Size = 0;
	for (uint32_t m = 0; m < NumMips; ++m)
	{
		const FKernelMip& Mip = Texture.Mips[m];
		VkBufferImageCopy Copy = {};
		Copy.bufferOffset = Size;
		Copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, m, 0, Info.arrayLayers};
		Copy.imageExtent = {uint32_t(Mip.SizeX), uint32_t(Mip.SizeY), Texture.bIs3D ? uint32_t(Mip.SizeZ) : 1};
		Image.Copies.push_back(Copy);
		Size += VkDeviceSize(Mip.SizeX) * VkDeviceSize(Mip.SizeY) * VkDeviceSize(Mip.SizeZ) * Texels.GetBytes();
		Size = (Size + 15) / 16 * 16; // copies begin at a multiple of a texel's size
	}
	Image.Staging = Arena.MakeBuffer(Size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
	const FKernelTexture Copied = {Texture.Mips, int32_t(NumMips), Texture.Storage, Texture.bIs3D, 0};
	uint8_t* To = Image.Staging.Bytes;
	ForEachRow(Copied,
		[&](const FKernelMip& Mip, int32_t Z, int32_t Y)
		{
			if (Y == 0 && Z == 0)
			{
				To = Image.Staging.Bytes + Image.Copies[size_t(&Mip - Texture.Mips)].bufferOffset;
			}
			ReadTexels(Texture.Storage, GetRow(Mip, Z, Y), Mip.SizeX, Texels, To);
			To += size_t(Mip.SizeX) * Texels.GetBytes();
		});
}

void FVulkanArguments::CopyTypedBuffer(FResource& Resource, const FKernelBuffer& Buffer)
{
	const FSpirvType& Type = TypeOf(Resource);
	const bool bStorage = Resource.Binding.Type == VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
	Resource.Texels = bStorage ? GetStorageTexels(Type.Format, Buffer.Storage)
							   : ChooseSampledTexels(Device, Buffer.Storage, Module.GetType(Type.Element).Kind, false);
	const int32_t Count = int32_t(Buffer.SizeInBytes / GetTexelStorageInfo(Buffer.Storage).BytesPerTexel);
	if (uint32_t(Count) > Device.Properties.limits.maxTexelBufferElements)
	{
		throw FVulkanError("its typed buffers have at most " +
						   std::to_string(Device.Properties.limits.maxTexelBufferElements) + " elements");
	}
	Resource.Buffer = Arena.MakeBuffer(size_t(Count) * Resource.Texels.GetBytes(),
		bStorage ? VK_BUFFER_USAGE_STORAGE_TEXEL_BUFFER_BIT : VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT);
	Resource.BufferView = Arena.MakeBufferView(Resource.Buffer, Resource.Texels.Format);
	ReadTexels(Buffer.Storage, Buffer.Data, Count, Resource.Texels, Resource.Buffer.Bytes);
}

VkDescriptorSet FVulkanArguments::MakeSet(VkDescriptorSetLayout Layout)
{
	std::vector<VkDescriptorPoolSize> Sizes = {{VK_DESCRIPTOR_TYPE_SAMPLER, 1}}; // an empty pool is none
	for (const FResource& Resource : Resources)
	{
		Sizes.push_back({Resource.Binding.Type, 1});
	}
	auto PoolInfo = MakeInfo<VkDescriptorPoolCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO);
	PoolInfo.maxSets = 1;
	PoolInfo.poolSizeCount = uint32_t(Sizes.size());
	PoolInfo.pPoolSizes = Sizes.data();
	CheckVulkan(Device.Vk.vkCreateDescriptorPool(Device.Device, &PoolInfo, nullptr, &Pool), "vkCreateDescriptorPool");
	auto SetInfo = MakeInfo<VkDescriptorSetAllocateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO);
	SetInfo.descriptorPool = Pool;
	SetInfo.descriptorSetCount = 1;
	SetInfo.pSetLayouts = &Layout;
	VkDescriptorSet Set = VK_NULL_HANDLE;
	CheckVulkan(Device.Vk.vkAllocateDescriptorSets(Device.Device, &SetInfo, &Set), "vkAllocateDescriptorSets");
	for (const FResource& Resource : Resources)
	{
		const VkDescriptorImageInfo Image = {Resource.Sampler, Resource.Image.View, VK_IMAGE_LAYOUT_GENERAL};
		const VkDescriptorBufferInfo Buffer = {Resource.Buffer.Buffer, 0, VK_WHOLE_SIZE};
		auto Write = MakeInfo<VkWriteDescriptorSet>(VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET);
		Write.dstSet = Set;
		Write.dstBinding = Resource.Binding.Binding;
		Write.descriptorCount = 1;
		Write.descriptorType = Resource.Binding.Type;
		Write.pImageInfo = &Image;
		Write.pBufferInfo = &Buffer;
		Write.pTexelBufferView = &Resource.BufferView;
		Device.Vk.vkUpdateDescriptorSets(Device.Device, 1, &Write, 0, nullptr);
	}
	return Set;
}

void FVulkanArguments::Upload(VkCommandBuffer Commands) const
{
	for (const FResource& Resource : Resources)
	{
		const FVulkanImage& Image = Resource.Image;
		if (Image.Image)
		{
			BeginImage(Device, Commands, Image.Image);
			Device.Vk.vkCmdCopyBufferToImage(Commands, Image.Staging.Buffer, Image.Image, VK_IMAGE_LAYOUT_GENERAL,
				uint32_t(Image.Copies.size()), Image.Copies.data());
		}
	}
	WaitForAll(Device, Commands);
}

void FVulkanArguments::Download(VkCommandBuffer Commands) const
{
	WaitForAll(Device, Commands);
	for (const FResource& Resource : Resources)
	{
		const FVulkanImage& Image = Resource.Image;
		if (Image.Image && IsWritten(Resource))
		{
			Device.Vk.vkCmdCopyImageToBuffer(Commands, Image.Image, VK_IMAGE_LAYOUT_GENERAL, Image.Staging.Buffer,
				uint32_t(Image.Copies.size()), Image.Copies.data());
		}
	}
	WaitForAll(Device, Commands);
}

void FVulkanArguments::WriteBack() const
{
	for (const FResource& Resource : Resources)
	{
		const int32_t Slot = Resource.Binding.Slot;
		switch (IsWritten(Resource) ? Resource.Binding.Type : VK_DESCRIPTOR_TYPE_SAMPLER)
		{
		case VK_DESCRIPTOR_TYPE_STORAGE_IMAGE:
		{
			const FKernelTexture& Texture = Args.RWTextures[Slot];
			const uint8_t* From = Resource.Image.Staging.Bytes;
			ForEachRow({Texture.Mips, 1, Texture.Storage, Texture.bIs3D, 0},
				[&](const FKernelMip& Mip, int32_t Z, int32_t Y)
				{
					WriteTexels(Texture.Storage, From, Mip.SizeX, Resource.Texels, Texture.bSaturateStore != 0,
						GetRow(Mip, Z, Y));
					From += size_t(Mip.SizeX) * Resource.Texels.GetBytes();
				});
			break;
		}
		case VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER:
		{
			const FKernelBuffer& Buffer = Args.RWBuffers[Slot];
			const int32_t Count = int32_t(Buffer.SizeInBytes / GetTexelStorageInfo(Buffer.Storage).BytesPerTexel);
			WriteTexels(Buffer.Storage, Resource.Buffer.Bytes, Count, Resource.Texels, false, Buffer.Data);
			break;
		}
		case VK_DESCRIPTOR_TYPE_STORAGE_BUFFER:
			std::memcpy(Args.RWBuffers[Slot].Data, Resource.Buffer.Bytes, Args.RWBuffers[Slot].SizeInBytes);
			break;
		default:
			break;
		}
	}
}

} // namespace Drydock
