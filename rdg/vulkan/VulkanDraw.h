// One dispatch or one draw over a rectangle: arguments up, the shader, results down.
#pragma once

#include "VulkanArguments.h"
#include "VulkanShader.h"

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

class FVulkanDraw : private FNoncopyable
{
public:
	FVulkanDraw(FVulkanShader& InShader, const FKernelArgs& InArgs, const FKernelTile& InWhole);
	~FVulkanDraw();

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

/** Runs all of Whole over what a kernel would be given; blending, write masks and the rounding of formats are
 * drydock's. Returns the milliseconds that the driver took without the transfers. Throws FVulkanError, with nothing
 * written. */
double RunVulkanShader(FVulkanShader& Shader, const FKernelArgs& Args, const FKernelTile& Whole);

} // namespace Drydock
