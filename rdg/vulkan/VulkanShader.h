// A shader as a Vulkan pipeline.
#pragma once

#include "ShaderCompileRequest.h"
#include "VulkanArena.h"
#include "VulkanModule.h"

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

/** RunVulkanShader runs it. */
class FVulkanShader : private FNoncopyable
{
public:
	/** Format of the shader's render targets, whatever those of the pass are: drydock blends and stores the results. */
	static constexpr VkFormat TargetFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

	/** Kernel: the reflection whose slots the arguments have. Throws FVulkanError for what the device cannot run,
	 * FError with the front end's messages. */
	FVulkanShader(std::shared_ptr<const FVulkanDevice> InDevice, const FShaderCompileRequest& Request,
		const FShaderReflection& InKernel);
	~FVulkanShader();

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

	friend class FVulkanDispatch;
	friend class FVulkanDraw;
	friend double RunVulkanShader(FVulkanShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole);
};

} // namespace Drydock
