// Records dispatches and draws. Source: Khronos, Vulkan specification, chapters 8, 21 and 29.
#include "VulkanDraw.h"

#include "LanesResources.h"
#include "TexelRows.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

/** A NaN that no shader makes, in all channels: the pixel was discarded. */
constexpr uint32_t Untouched = 0x7fdeadad;

} // namespace

FVulkanDispatch::FVulkanDispatch(FVulkanShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole)
	: Shader(InShader)
	, Device(*InShader.Owner)
	, Whole(InWhole)
	, Arena(Device)
	, Arguments(Device, Arena, Shader.Module, Shader.Bindings, InArgs, Shader.Kernel)
{
}

double FVulkanDispatch::Run()
{
	const VkDescriptorSet Set = Arguments.MakeSet(Shader.SetLayout);
	Device.Submit([this](VkCommandBuffer Commands) { Arguments.Upload(Commands); });
	const double Milliseconds = Device.Submit(
		[&](VkCommandBuffer Commands)
		{
			const uint32_t* const Size = Shader.Module.LocalSize;
			const FVulkanFunctions& Vk = Device.Vk;
			Vk.vkCmdBindPipeline(Commands, VK_PIPELINE_BIND_POINT_COMPUTE, Shader.Pipeline);
			Vk.vkCmdBindDescriptorSets(Commands, VK_PIPELINE_BIND_POINT_COMPUTE, Shader.Layout, 0, 1, &Set, 0, nullptr);
			Vk.vkCmdDispatch(Commands, uint32_t(Whole.MaxX) / Size[0], uint32_t(Whole.MaxY) / Size[1],
				uint32_t(Whole.MaxZ) / Size[2]);
		});
	Device.Submit([this](VkCommandBuffer Commands) { Arguments.Download(Commands); });
	Arguments.WriteBack();
	return Milliseconds;
}

FVulkanDraw::FVulkanDraw(FVulkanShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole)
	: Shader(InShader)
	, Device(*InShader.Owner)
	, Args(InArgs)
	, Whole(InWhole)
	, Arena(Device)
	, Arguments(Device, Arena, Shader.Module, Shader.Bindings, Args, Shader.Kernel)
{
	MakeTargets();
	MakeVertices();
}

FVulkanDraw::~FVulkanDraw()
{
	Device.Vk.vkDestroyFramebuffer(Device.Device, Framebuffer, nullptr);
}

void FVulkanDraw::MakeTargets()
{
	const VkPhysicalDeviceLimits& Limits = Device.Properties.limits;
	const uint32_t Width = uint32_t(Whole.MaxX);
	const uint32_t Height = uint32_t(Whole.MaxY);
	if (Width > Limits.maxFramebufferWidth || Height > Limits.maxFramebufferHeight)
	{
		throw FVulkanError("its render targets have at most " + std::to_string(Limits.maxFramebufferWidth) + " x " +
						   std::to_string(Limits.maxFramebufferHeight) + " pixels");
	}
	std::vector<VkImageView> Views;
	for (int32_t Target = 0; Target < Shader.Kernel.NumTargets; ++Target)
	{
		auto Info = MakeInfo<VkImageCreateInfo>(VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO);
		Info.imageType = VK_IMAGE_TYPE_2D;
		Info.format = FVulkanShader::TargetFormat;
		Info.extent = {Width, Height, 1};
		Info.mipLevels = Info.arrayLayers = 1;
		Info.samples = VK_SAMPLE_COUNT_1_BIT;
		Info.usage =
			VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
		FVulkanImage& Image = Targets.emplace_back();
		Image.Image = Arena.MakeImage(Info);
		Image.View = Arena.MakeImageView(Image.Image, VK_IMAGE_VIEW_TYPE_2D, FVulkanShader::TargetFormat);
		Views.push_back(Image.View);
		VkBufferImageCopy Copy = {};
		Copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
		Copy.imageOffset = {Whole.MinX, Whole.MinY, 0};
		Copy.imageExtent = {uint32_t(Whole.MaxX - Whole.MinX), uint32_t(Whole.MaxY - Whole.MinY), 1};
		Image.Copies.push_back(Copy);
		Image.Staging = Arena.MakeBuffer(VkDeviceSize(Copy.imageExtent.width) * Copy.imageExtent.height * 16,
			VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT);
		for (VkDeviceSize At = 0; At < Image.Staging.Size; At += sizeof(Untouched))
		{
			std::memcpy(Image.Staging.Bytes + At, &Untouched, sizeof(Untouched));
		}
	}
	auto Info = MakeInfo<VkFramebufferCreateInfo>(VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO);
	Info.renderPass = Shader.RenderPass;
	Info.attachmentCount = uint32_t(Views.size());
	Info.pAttachments = Views.data();
	Info.width = Width;
	Info.height = Height;
	Info.layers = 1;
	CheckVulkan(Device.Vk.vkCreateFramebuffer(Device.Device, &Info, nullptr, &Framebuffer), "vkCreateFramebuffer");
}

/** One triangle twice as wide and high as the rectangle, which the viewport spans. */
void FVulkanDraw::MakeVertices()
{
	const size_t PerVertex = (Shader.TexCoords.size() + 1) * 4;
	std::vector<float> Values(3 * PerVertex);
	for (size_t Vertex = 0; Vertex < 3; ++Vertex)
	{
		float* const Out = Values.data() + Vertex * PerVertex;
		const double X = Vertex == 1 ? 2 : 0; // in widths
		const double Y = Vertex == 2 ? 2 : 0;
		const double Position[4] = {X * 2 - 1, Y * 2 - 1, 0, 1};
		std::copy_n(Position, 4, Out);
		const double PixelX = Whole.MinX + X * (Whole.MaxX - Whole.MinX);
		const double PixelY = Whole.MinY + Y * (Whole.MaxY - Whole.MinY);
		for (size_t n = 0; n < Shader.TexCoords.size(); ++n)
		{
			const FKernelInterpolant& Input = Args.Interpolants[n];
			for (size_t c = 0; c < 4; ++c)
			{
				Out[(n + 1) * 4 + c] = float(Input.Base[c] + Input.DX[c] * PixelX + Input.DY[c] * PixelY);
			}
		}
	}
	Vertices = Arena.MakeBuffer(Values.size() * sizeof(float), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
	std::memcpy(Vertices.Bytes, Values.data(), Values.size() * sizeof(float));
}

double FVulkanDraw::Run()
{
	const FVulkanFunctions& Vk = Device.Vk;
	const VkDescriptorSet Set = Arguments.MakeSet(Shader.SetLayout);
	Device.Submit(
		[&](VkCommandBuffer Commands)
		{
			for (const FVulkanImage& Target : Targets)
			{
				BeginImage(Device, Commands, Target.Image);
				Vk.vkCmdCopyBufferToImage(
					Commands, Target.Staging.Buffer, Target.Image, VK_IMAGE_LAYOUT_GENERAL, 1, Target.Copies.data());
			}
			Arguments.Upload(Commands);
		});
	const double Milliseconds = Device.Submit(
		[&](VkCommandBuffer Commands)
		{
			const VkRect2D Rect = {
				{Whole.MinX, Whole.MinY}, {uint32_t(Whole.MaxX - Whole.MinX), uint32_t(Whole.MaxY - Whole.MinY)}};
			auto Begin = MakeInfo<VkRenderPassBeginInfo>(VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO);
			Begin.renderPass = Shader.RenderPass;
			Begin.framebuffer = Framebuffer;
			Begin.renderArea = Rect;
			const VkViewport Viewport = {
				float(Whole.MinX), float(Whole.MinY), float(Rect.extent.width), float(Rect.extent.height), 0, 1};
			constexpr VkDeviceSize NoOffset = 0;
			Vk.vkCmdBeginRenderPass(Commands, &Begin, VK_SUBPASS_CONTENTS_INLINE);
			Vk.vkCmdBindPipeline(Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, Shader.Pipeline);
			Vk.vkCmdBindDescriptorSets(
				Commands, VK_PIPELINE_BIND_POINT_GRAPHICS, Shader.Layout, 0, 1, &Set, 0, nullptr);
			Vk.vkCmdSetViewport(Commands, 0, 1, &Viewport);
			Vk.vkCmdSetScissor(Commands, 0, 1, &Rect);
			Vk.vkCmdBindVertexBuffers(Commands, 0, 1, &Vertices.Buffer, &NoOffset);
			Vk.vkCmdDraw(Commands, 3, 1, 0, 0);
			Vk.vkCmdEndRenderPass(Commands);
		});
	Device.Submit(
		[&](VkCommandBuffer Commands)
		{
			Arguments.Download(Commands);
			for (const FVulkanImage& Target : Targets)
			{
				Vk.vkCmdCopyImageToBuffer(
					Commands, Target.Image, VK_IMAGE_LAYOUT_GENERAL, Target.Staging.Buffer, 1, Target.Copies.data());
			}
			WaitForAll(Device, Commands);
		});
	Arguments.WriteBack();
	StoreTargets();
	return Milliseconds;
}

void FVulkanDraw::StoreTargets() const
{
	const int32_t Width = Whole.MaxX - Whole.MinX;
	for (size_t i = 0; i < Targets.size() && i < size_t(Args.NumTargets); ++i)
	{
		const FKernelTarget& Target = Args.Targets[i];
		const uint32_t Components = Shader.OutputComponents[i];
		const auto* const Values = reinterpret_cast<const float*>(Targets[i].Staging.Bytes);
		for (int32_t y = Whole.MinY; y < Whole.MaxY; ++y)
		{
			for (int32_t x = 0; x < Width; ++x)
			{
				const float* const Value = Values + (size_t(y - Whole.MinY) * size_t(Width) + size_t(x)) * 4;
				uint32_t Bits[4];
				std::memcpy(Bits, Value, sizeof(Bits));
				const bool bDiscarded = Shader.Kernel.bUsesDiscard &&
										std::all_of(Bits, Bits + 4, [](uint32_t Word) { return Word == Untouched; });
				const int32_t Mask = bDiscarded ? 0 : -1;
				float Color[4] = {}; // components that the shader does not write are 0, as a kernel stores them
				std::copy_n(Value, Components, Color);
				Lanes::TSampling<float, 1>::StoreTarget(Target, &Mask, Whole.MinX + x, y, Color);
			}
		}
	}
}

double RunVulkanShader(FVulkanShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole)
{
	return Shader.Kernel.Stage == EShaderStage::Compute ? FVulkanDispatch(Shader, Args, Whole).Run()
														: FVulkanDraw(Shader, Args, Whole).Run();
}

} // namespace Drydock
