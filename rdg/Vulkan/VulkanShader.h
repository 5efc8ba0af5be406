// A shader as a Vulkan pipeline, run over what its kernel would be given.
#pragma once

#include "ShaderCompileRequest.h"
#include "VulkanArena.h"
#include "VulkanModule.h"

#include <map>

namespace Drydock
{

/** A resource of the module: its place in the descriptor set, and among a kernel's arguments. */
struct FVulkanBinding
{
	const FSpirvVariable* Variable = nullptr;
	uint32_t Binding = 0;
	int32_t Slot = 0;
	VkDescriptorType Type = VK_DESCRIPTOR_TYPE_SAMPLER;
};

class FVulkanShader
{
public:
	/** Kernel: the reflection whose slots the arguments have. Throws FVulkanError for what the device cannot run,
	 * FError with the front end's messages. */
	FVulkanShader(std::shared_ptr<const FVulkanDevice> InDevice, const FShaderCompileRequest& Request,
		const FShaderReflection& InKernel);
	~FVulkanShader();
	FVulkanShader(const FVulkanShader&) = delete;
	FVulkanShader& operator=(const FVulkanShader&) = delete;

	/** Runs all of Whole; blending, write masks and the rounding of formats are drydock's. Throws FVulkanError, with
	 * nothing written. */
	void Run(const FKernelArgs& Args, const FKernelTile& Whole);

	/** Wall time that the driver took for the last run without the transfers. */
	double GetRunMilliseconds() const { return RunMilliseconds; }

private:
	void CheckDevice(const FShaderCompileRequest& Request) const;
	void FindBindings();
	void MakeLayouts();
	void MakeComputePipeline();
	void MakeGraphicsPipeline();
	void MakeRenderPass();
	void Destroy();
	VkShaderModule MakeModule(const std::vector<uint32_t>& Words);

	std::shared_ptr<const FVulkanDevice> Owner;
	FShaderReflection Kernel;
	FSpirvModule Module;
	FVulkanModule Ready;
	std::vector<FVulkanBinding> Bindings;
	std::vector<uint32_t> TexCoords;        // components, by number
	std::vector<uint32_t> OutputComponents; // by SV_Target
	VkDescriptorSetLayout SetLayout = VK_NULL_HANDLE;
	VkPipelineLayout Layout = VK_NULL_HANDLE;
	VkRenderPass RenderPass = VK_NULL_HANDLE;
	VkPipeline Pipeline = VK_NULL_HANDLE;
	std::vector<VkShaderModule> Modules;
	double RunMilliseconds = 0;

	friend class FVulkanDispatch;
	friend class FVulkanDraw;
};

} // namespace Drydock
