// Makes pipelines. Source: Khronos, Vulkan specification, chapters 9, 10 and 14.
#include "VulkanShader.h"

#include "InspectedShader.h"
#include "ShaderFrontEnd.h"
#include "ShaderSource.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

/** Whether the device runs modules that declare a capability (SPIR-V specification, 3.31). */
bool IsThere(uint32_t Capability, const FVulkanDevice& Device)
{
	const VkPhysicalDeviceFeatures& Features = Device.Features;
	const auto HasWaves = [&Device](VkSubgroupFeatureFlags Operations)
	{
		return (Device.SubgroupOperations & Operations) == Operations;
	};
	const std::pair<uint32_t, bool> Known[] = {
		{0, true},                                                // Matrix
		{1, true},                                                // Shader
		{43, true},                                               // Sampled1D
		{44, true},                                               // Image1D
		{46, true},                                               // SampledBuffer
		{47, true},                                               // ImageBuffer
		{50, true},                                               // ImageQuery
		{51, true},                                               // DerivativeControl
		{9, Device.bFloat16},                                     // Float16
		{10, Features.shaderFloat64},                             // Float64
		{11, Features.shaderInt64},                               // Int64
		{12, Device.bInt64Atomics},                               // Int64Atomics
		{22, Features.shaderInt16},                               // Int16
		{25, Features.shaderImageGatherExtended},                 // ImageGatherExtended
		{34, Features.imageCubeArray},                            // ImageCubeArray
		{45, Features.imageCubeArray},                            // SampledCubeArray
		{42, Features.shaderResourceMinLod},                      // MinLod
		{49, Features.shaderStorageImageExtendedFormats},         // StorageImageExtendedFormats
		{55, Features.shaderStorageImageReadWithoutFormat},       // StorageImageReadWithoutFormat
		{56, Features.shaderStorageImageWriteWithoutFormat},      // StorageImageWriteWithoutFormat
		{61, HasWaves(VK_SUBGROUP_FEATURE_BASIC_BIT)},            // GroupNonUniform
		{62, HasWaves(VK_SUBGROUP_FEATURE_VOTE_BIT)},             // GroupNonUniformVote
		{63, HasWaves(VK_SUBGROUP_FEATURE_ARITHMETIC_BIT)},       // GroupNonUniformArithmetic
		{64, HasWaves(VK_SUBGROUP_FEATURE_BALLOT_BIT)},           // GroupNonUniformBallot
		{65, HasWaves(VK_SUBGROUP_FEATURE_SHUFFLE_BIT)},          // GroupNonUniformShuffle
		{66, HasWaves(VK_SUBGROUP_FEATURE_SHUFFLE_RELATIVE_BIT)}, // GroupNonUniformShuffleRelative
		{68, HasWaves(VK_SUBGROUP_FEATURE_QUAD_BIT)},             // GroupNonUniformQuad
	};
	return std::ranges::find(Known, std::pair(Capability, true)) != std::end(Known);
}

bool HasWaves(const FVulkanModule& Module)
{
	return std::any_of(Module.Capabilities.begin(), Module.Capabilities.end(),
		[](uint32_t Capability) { return Capability >= 61 && Capability <= 68; });
}

VkDescriptorType GetDescriptorType(const FSpirvType& Type)
{
	switch (Type.Kind)
	{
	case ESpirvType::Sampler:
		return VK_DESCRIPTOR_TYPE_SAMPLER;
	case ESpirvType::Image:
		if (Type.Dim == DimBuffer)
		{
			return Type.bStorageImage ? VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER
									  : VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
		}
		return Type.bStorageImage ? VK_DESCRIPTOR_TYPE_STORAGE_IMAGE : VK_DESCRIPTOR_TYPE_SAMPLED_IMAGE;
	default:
		return Type.bBufferBlock ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
	}
}

} // namespace

FVulkanShader::FVulkanShader(std::shared_ptr<const FVulkanDevice> InDevice, const FShaderCompileRequest& Request,
	const FShaderReflection& InKernel)
	: Owner(std::move(InDevice))
	, Kernel(InKernel)
{
	FShaderCompileRequest Asked = Request;
	Asked.bKeepFunctions = false;
	const std::vector<uint32_t> Words = CompileToSpirv(FlattenShader(Asked), Asked);
	try
	{
		Module = ReadSpirv(Words);
	}
	catch (const FSpirvError& Error)
	{
		throw FVulkanError(Error.what());
	}
	Ready = MakeVulkanModule(Words, Module);
	CheckDevice(Request);
	FindBindings();
	try
	{
		MakeLayouts();
		Kernel.Stage == EShaderStage::Compute ? MakeComputePipeline() : MakeGraphicsPipeline();
	}
	catch (...)
	{
		Destroy();
		throw;
	}
}

FVulkanShader::~FVulkanShader()
{
	Destroy();
}

void FVulkanShader::Destroy()
{
	const FVulkanFunctions& Vk = Owner->Vk;
	Vk.vkDestroyPipeline(Owner->Device, Pipeline, nullptr);
	Vk.vkDestroyRenderPass(Owner->Device, RenderPass, nullptr);
	Vk.vkDestroyPipelineLayout(Owner->Device, Layout, nullptr);
	Vk.vkDestroyDescriptorSetLayout(Owner->Device, SetLayout, nullptr);
	for (const VkShaderModule Made : Modules)
	{
		Vk.vkDestroyShaderModule(Owner->Device, Made, nullptr);
	}
}

void FVulkanShader::CheckDevice(const FShaderCompileRequest& Request) const
{
	for (const uint32_t Capability : Ready.Capabilities)
	{
		if (!IsThere(Capability, *Owner))
		{
			throw FVulkanError("it lacks what the shader needs, SPIR-V's capability " + std::to_string(Capability));
		}
	}
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		const bool bViewed = std::any_of(Module.Variables.begin(), Module.Variables.end(),
			[&](const FSpirvVariable& Other) { return Other.Id != Variable.Id && Other.Name == Variable.Name; });
		if (bViewed && !Variable.Name.empty() && Module.GetType(Variable.Type).bBufferBlock)
		{
			throw FVulkanError("a buffer of bytes that is changed as numbers of 16 or 64 bits ('" + Variable.Name +
							   "') does not run on a driver; use a RWStructuredBuffer");
		}
	}
	if (HasWaves(Ready) && Owner->SubgroupSize != uint32_t(Request.Lanes.WaveSize))
	{
		throw FVulkanError("its waves have " + std::to_string(Owner->SubgroupSize) + " threads and drydock's " +
						   std::to_string(Request.Lanes.WaveSize) + "; set r.Drydock.WaveSize to " +
						   std::to_string(Owner->SubgroupSize));
	}
	const VkPhysicalDeviceLimits& Limits = Owner->Properties.limits;
	const uint32_t* const Size = Module.LocalSize;
	if (Kernel.Stage == EShaderStage::Compute && Size[0] * Size[1] * Size[2] > Limits.maxComputeWorkGroupInvocations)
	{
		throw FVulkanError("its thread groups have at most " + std::to_string(Limits.maxComputeWorkGroupInvocations) +
						   " threads, and the shader's have " + std::to_string(Size[0] * Size[1] * Size[2]));
	}
	if (Kernel.IntegerTargets)
	{
		throw FVulkanError("render targets of integers are not given to it");
	}
	if (Kernel.IntegerInterpolants || Kernel.bWritesDepth)
	{
		throw FVulkanError("integers between the stages, and depth that a pixel shader writes, are not given to it");
	}
	if (uint32_t(Kernel.NumTargets) > Limits.maxColorAttachments)
	{
		throw FVulkanError("it has " + std::to_string(Limits.maxColorAttachments) + " render targets");
	}
}

void FVulkanShader::FindBindings()
{
	const FSpirvSlotTable Slots = FindKernelSlots(Module, Kernel);
	for (size_t i = 0; i < Module.Variables.size(); ++i)
	{
		const FSpirvVariable& Variable = Module.Variables[i];
		const bool bResource = Variable.Storage == StorageUniformConstant || Variable.Storage == StorageUniform ||
							   Variable.Storage == StorageStorageBuffer;
		if (bResource && Slots.Slots[i] >= 0)
		{
			Bindings.push_back(
				{&Variable, uint32_t(i), Slots.Slots[i], GetDescriptorType(Module.GetType(Variable.Type))});
		}
	}
	OutputComponents.resize(size_t(Kernel.NumTargets));
	for (const FSpirvVariable& Variable : Module.Variables)
	{
		if (Variable.Storage == StorageOutput && Variable.Location < OutputComponents.size())
		{
			OutputComponents[Variable.Location] = Module.GetType(Variable.Type).NumScalars;
		}
	}
	TexCoords = GetTexCoordComponents(Module);
	if (TexCoords.size() + 1 > Owner->Properties.limits.maxVertexInputAttributes)
	{
		throw FVulkanError("the shader reads more TEXCOORDs than it passes on");
	}
}

void FVulkanShader::MakeLayouts()
{
	const VkShaderStageFlags Stage =
		Kernel.Stage == EShaderStage::Compute ? VK_SHADER_STAGE_COMPUTE_BIT : VK_SHADER_STAGE_FRAGMENT_BIT;
	std::vector<VkDescriptorSetLayoutBinding> Places;
	for (const FVulkanBinding& Binding : Bindings)
	{
		Places.push_back({Binding.Binding, Binding.Type, 1, Stage, nullptr});
	}
	auto SetInfo = MakeInfo<VkDescriptorSetLayoutCreateInfo>(VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO);
	SetInfo.bindingCount = uint32_t(Places.size());
	SetInfo.pBindings = Places.data();
	CheckVulkan(Owner->Vk.vkCreateDescriptorSetLayout(Owner->Device, &SetInfo, nullptr, &SetLayout),
		"vkCreateDescriptorSetLayout");
	auto Info = MakeInfo<VkPipelineLayoutCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO);
	Info.setLayoutCount = 1;
	Info.pSetLayouts = &SetLayout;
	CheckVulkan(Owner->Vk.vkCreatePipelineLayout(Owner->Device, &Info, nullptr, &Layout), "vkCreatePipelineLayout");
}

VkShaderModule FVulkanShader::MakeModule(const std::vector<uint32_t>& Words)
{
	auto Info = MakeInfo<VkShaderModuleCreateInfo>(VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO);
	Info.codeSize = Words.size() * sizeof(uint32_t);
	Info.pCode = Words.data();
	VkShaderModule Made = VK_NULL_HANDLE;
	CheckVulkan(Owner->Vk.vkCreateShaderModule(Owner->Device, &Info, nullptr, &Made), "vkCreateShaderModule");
	Modules.push_back(Made);
	return Made;
}

void FVulkanShader::MakeComputePipeline()
{
	auto Info = MakeInfo<VkComputePipelineCreateInfo>(VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO);
	Info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
	Info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
	Info.stage.module = MakeModule(Ready.Words);
	Info.stage.pName = Ready.EntryPoint.c_str();
	Info.layout = Layout;
	CheckVulkan(Owner->Vk.vkCreateComputePipelines(Owner->Device, VK_NULL_HANDLE, 1, &Info, nullptr, &Pipeline),
		"vkCreateComputePipelines");
}

void FVulkanShader::MakeRenderPass()
{
	// Discarded pixels keep what was there before.
	std::vector<VkAttachmentDescription> Attachments;
	std::vector<VkAttachmentReference> References;
	for (int32_t Target = 0; Target < Kernel.NumTargets; ++Target)
	{
		References.push_back({uint32_t(Target), VK_IMAGE_LAYOUT_GENERAL});
		Attachments.push_back({0, TargetFormat, VK_SAMPLE_COUNT_1_BIT, VK_ATTACHMENT_LOAD_OP_LOAD,
			VK_ATTACHMENT_STORE_OP_STORE, VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_DONT_CARE,
			VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL});
	}
	VkSubpassDescription Subpass = {};
	Subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
	Subpass.colorAttachmentCount = uint32_t(References.size());
	Subpass.pColorAttachments = References.data();
	auto Info = MakeInfo<VkRenderPassCreateInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO);
	Info.attachmentCount = uint32_t(Attachments.size());
	Info.pAttachments = Attachments.data();
	Info.subpassCount = 1;
	Info.pSubpasses = &Subpass;
	CheckVulkan(Owner->Vk.vkCreateRenderPass(Owner->Device, &Info, nullptr, &RenderPass), "vkCreateRenderPass");
}

void FVulkanShader::MakeGraphicsPipeline()
{
	MakeRenderPass();
	VkPipelineShaderStageCreateInfo Stages[2] = {};
	for (VkPipelineShaderStageCreateInfo& Stage : Stages)
	{
		Stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
	}
	Stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
	Stages[0].module = MakeModule(MakePassingVertexShader(TexCoords));
	Stages[0].pName = "main";
	Stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
	Stages[1].module = MakeModule(Ready.Words);
	Stages[1].pName = Ready.EntryPoint.c_str();

	std::vector<VkVertexInputAttributeDescription> Attributes;
	const uint32_t NumAttributes = uint32_t(TexCoords.size()) + 1;
	for (uint32_t Location = 0; Location < NumAttributes; ++Location)
	{
		if (Location == 0 || TexCoords[Location - 1] > 0)
		{
			Attributes.push_back({Location, 0, VK_FORMAT_R32G32B32A32_SFLOAT, Location * 16});
		}
	}
	const VkVertexInputBindingDescription Stream = {0, NumAttributes * 16, VK_VERTEX_INPUT_RATE_VERTEX};
	auto Input =
		MakeInfo<VkPipelineVertexInputStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO);
	Input.vertexBindingDescriptionCount = 1;
	Input.pVertexBindingDescriptions = &Stream;
	Input.vertexAttributeDescriptionCount = uint32_t(Attributes.size());
	Input.pVertexAttributeDescriptions = Attributes.data();
	auto Assembly =
		MakeInfo<VkPipelineInputAssemblyStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO);
	Assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
	auto Viewport = MakeInfo<VkPipelineViewportStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO);
	Viewport.viewportCount = Viewport.scissorCount = 1;
	auto Raster =
		MakeInfo<VkPipelineRasterizationStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO);
	Raster.frontFace = VK_FRONT_FACE_CLOCKWISE; // of the triangle that is drawn: SV_IsFrontFace is true
	Raster.lineWidth = 1;
	auto Samples =
		MakeInfo<VkPipelineMultisampleStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO);
	Samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
	VkPipelineColorBlendAttachmentState Plain = {};
	Plain.colorWriteMask = 15;
	const std::vector<VkPipelineColorBlendAttachmentState> Blends(size_t(Kernel.NumTargets), Plain);
	auto Blend =
		MakeInfo<VkPipelineColorBlendStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO);
	Blend.attachmentCount = uint32_t(Blends.size());
	Blend.pAttachments = Blends.data();
	const VkDynamicState DynamicStates[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
	auto Dynamic = MakeInfo<VkPipelineDynamicStateCreateInfo>(VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO);
	Dynamic.dynamicStateCount = 2;
	Dynamic.pDynamicStates = DynamicStates;

	auto Info = MakeInfo<VkGraphicsPipelineCreateInfo>(VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO);
	Info.stageCount = 2;
	Info.pStages = Stages;
	Info.pVertexInputState = &Input;
	Info.pInputAssemblyState = &Assembly;
	Info.pViewportState = &Viewport;
	Info.pRasterizationState = &Raster;
	Info.pMultisampleState = &Samples;
	Info.pColorBlendState = &Blend;
	Info.pDynamicState = &Dynamic;
	Info.layout = Layout;
	Info.renderPass = RenderPass;
	CheckVulkan(Owner->Vk.vkCreateGraphicsPipelines(Owner->Device, VK_NULL_HANDLE, 1, &Info, nullptr, &Pipeline),
		"vkCreateGraphicsPipelines");
}

} // namespace Drydock
