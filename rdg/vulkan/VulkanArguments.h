// Copies the resources that a kernel reads and writes to a device and back.
#pragma once

#include "VulkanShader.h"
#include "VulkanTexels.h"

namespace Drydock
{

/** An image beside the picture that it is a copy of. */
struct FVulkanImage
{
	VkImage Image = VK_NULL_HANDLE;
	VkImageView View = VK_NULL_HANDLE;
	FVulkanBuffer Staging; // all mips and slices, one after the other
	std::vector<VkBufferImageCopy> Copies;
};

class FVulkanArguments : private FNoncopyable
{
public:
	/** Copies everything that the bindings name into memory of the arena. Throws FVulkanError. */
	FVulkanArguments(const FVulkanDevice& InDevice, FVulkanArena& InArena, const FSpirvModule& InModule,
		const std::vector<FVulkanBinding>& Bindings, const FKernelArgs& InArgs, const FShaderReflection& Kernel);
	~FVulkanArguments();

	/** A descriptor set that names it all. */
	VkDescriptorSet MakeSet(VkDescriptorSetLayout Layout);

	/** Commands before and after the shader. */
	void Upload(VkCommandBuffer Commands) const;
	void Download(VkCommandBuffer Commands) const;

	/** Copies the device's results into the textures and buffers that the shader writes. */
	void WriteBack() const;

private:
	struct FResource
	{
		FVulkanBinding Binding;
		FVulkanImage Image;
		FVulkanBuffer Buffer;
		VkBufferView BufferView = VK_NULL_HANDLE;
		VkSampler Sampler = VK_NULL_HANDLE;
		FVulkanTexels Texels;
	};

	void CopyIn(FResource& Resource, const FShaderReflection& Kernel);
	void CopyTexture(FResource& Resource, const FKernelTexture& Texture);
	void CopyTypedBuffer(FResource& Resource, const FKernelBuffer& Buffer);
	bool IsWritten(const FResource& Resource) const;
	const FSpirvType& TypeOf(const FResource& Resource) const
	{
		return Module.GetType(Resource.Binding.Variable->Type);
	}

	const FVulkanDevice& Device;
	FVulkanArena& Arena;
	const FSpirvModule& Module;
	const FKernelArgs& Args;
	bool bFilters = false; // a sampler interpolates
	std::vector<FResource> Resources;
	VkDescriptorPool Pool = VK_NULL_HANDLE;
};

/** Everything that was written before is seen by everything after. */
void WaitForAll(const FVulkanDevice& Device, VkCommandBuffer Commands);

/** A new image becomes one that all commands take. */
void BeginImage(const FVulkanDevice& Device, VkCommandBuffer Commands, VkImage Image);

} // namespace Drydock
