// Walks a parameter struct by its metadata and finds what a pass touches and how: textures, views, uniform buffers with
// everything in them, bare accesses, render targets. Null members are skipped. Source: engine RenderGraphParameter.h.
#pragma once

#include "RenderGraphCompiled.h"
#include "RenderGraphFwd.h"
#include "RenderGraphObjects.h"

class FRenderTargetBindingSlots;
class FShaderParametersMetadata;

namespace Drydock
{

/** A texture or buffer that a pass reaches only through a uniform buffer, and the name a shader reads it under. */
struct FRDGUniformBufferResource
{
	FRDGViewableResource* Resource;
	std::string HlslName; // "SceneTexturesStruct_GBufferBTexture"
};

/** The resources that a pass's parameters refer to. */
struct FRDGPassResources
{
	std::vector<FRDGViewableResource*> Viewables; // textures and buffers, each once, in the order of the parameters
	std::vector<FRDGView*> Views;
	std::vector<FRDGUniformBuffer*> UniformBuffers;
	std::vector<FRDGUniformBufferResource> InUniformBuffers; // of Viewables; one entry per name
	const FRenderTargetBindingSlots* TargetSlots = nullptr;
};

/** Fills the uses, targets and outputs of Pass, whose flags and pipeline are set. IsKnown distinguishes pointers to
 * this graph's objects of these kinds from others; the first unknown pointer is thrown as FError before it is
 * dereferenced. */
DRYDOCK_API FRDGPassResources CollectPassResources(const FShaderParametersMetadata& Metadata, const void* Parameters,
	TFunctionRef<bool(const void*, ERDGObject)> IsKnown, FRDGPassDescription& Pass);

} // namespace Drydock
