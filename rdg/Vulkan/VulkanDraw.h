// One dispatch or one draw over a rectangle: arguments up, the shader, results down.
#pragma once

#include "VulkanArguments.h"

namespace Drydock
{

class FVulkanDispatch
{
public:
	FVulkanDispatch(FVulkanShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole);

	/** Milliseconds of the shader itself. */
	double Run();

private:
	FVulkanShader& Shader;
	const FVulkanDevice& Device;
	FKernelTile Whole;
	FVulkanArena Arena;
	FVulkanArguments Arguments;
};

/** Targets are 32-bit floats; what comes back is blended and stored by drydock. */
class FVulkanDraw
{
public:
	static constexpr VkFormat TargetFormat = VK_FORMAT_R32G32B32A32_SFLOAT;

	FVulkanDraw(FVulkanShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole);
	~FVulkanDraw();
	FVulkanDraw(const FVulkanDraw&) = delete;
	FVulkanDraw& operator=(const FVulkanDraw&) = delete;

	double Run();

private:
	void MakeTargets();
	void MakeVertices();
	void StoreTargets() const;

	FVulkanShader& Shader;
	const FVulkanDevice& Device;
	FKernelArgs Args;
	FKernelTile Whole;
	FVulkanArena Arena;
	FVulkanArguments Arguments;
	std::vector<FVulkanImage> Targets;
	VkFramebuffer Framebuffer = VK_NULL_HANDLE;
	FVulkanBuffer Vertices;
};

} // namespace Drydock
