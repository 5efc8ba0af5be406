// Enumerations and descriptions of the render graph, with the engine's names and values. Source: engine
// RenderGraphDefinitions.h, RenderGraphResources.h.
#pragma once

#include "CoreMinimal.h"
#include "RHIDefinitions.h"
#include "RHITextureDesc.h"
#include "RHIViews.h"
#include "RenderGraphFwd.h"
#include "RenderGraphResourcePool.h"

// Validation is always compiled in; r.RDG.Validation 0 turns it off.
#define RDG_ENABLE_DEBUG 1
#define RDG_ENABLE_TRACE 0
#define RDG_EVENTS 1

/** The work of a pass on the GPU. With parameters at least one of Raster, Compute, AsyncCompute and Copy. */
enum class ERDGPassFlags : uint16
{
	None = 0,
	Raster = 1 << 0, // the graph begins and ends the render pass
	Compute = 1 << 1,
	AsyncCompute = 1 << 2,
	Copy = 1 << 3,
	NeverCull = 1 << 4,
	SkipRenderPass = 1 << 5, // with Raster: the lambda begins and ends the render pass itself
	NeverMerge = 1 << 6,
	NeverParallel = 1 << 7,
	ParallelTranslate = 1 << 8,
	Readback = Copy | NeverCull,
};
ENUM_CLASS_FLAGS(ERDGPassFlags)

enum class ERDGBuilderFlags
{
	None = 0,
	AllowParallelExecute = 1 << 0,
	ParallelSetup = AllowParallelExecute,
	ParallelCompile = AllowParallelExecute,
	ParallelExecute = AllowParallelExecute,
	Parallel = AllowParallelExecute,
};
ENUM_CLASS_FLAGS(ERDGBuilderFlags)

enum class ERDGTextureFlags : uint8
{
	None = 0,
	MultiFrame = 1 << 0,
	SkipTracking = 1 << 1, // registered textures only: read-only for the whole graph
	ForceImmediateFirstBarrier = 1 << 2,
	MaintainCompression = 1 << 3,
};
ENUM_CLASS_FLAGS(ERDGTextureFlags)

enum class ERDGBufferFlags : uint8
{
	None = 0,
	MultiFrame = 1 << 0,
	SkipTracking = 1 << 1,
	ForceImmediateFirstBarrier = 1 << 2,
};
ENUM_CLASS_FLAGS(ERDGBufferFlags)

enum class ERDGUnorderedAccessViewFlags : uint8
{
	None = 0,
	SkipBarrier = 1 << 0, // consecutive uses of this one view need no barrier in between
};
ENUM_CLASS_FLAGS(ERDGUnorderedAccessViewFlags)

enum class ERDGInitialDataFlags : uint8
{
	None = 0,        // the data is copied at once
	NoCopy = 1 << 0, // the pointer is kept and must live until Execute returns
};
ENUM_CLASS_FLAGS(ERDGInitialDataFlags)

/** The planes of a texture that a view may be of. */
enum class ERDGTextureMetaDataAccess : uint8
{
	None = 0,
	CompressedSurface,
	Depth,
	Stencil,
	HTile,
	FMask,
	CMask,
	PrimitiveShadingRate,
};

enum class ERDGResourceExtractionFlags : uint8
{
	None = 0,
	AllowTransient = 1 << 0,
};
ENUM_CLASS_FLAGS(ERDGResourceExtractionFlags)

enum class ERDGViewType : uint8
{
	TextureUAV,
	TextureSRV,
	BufferUAV,
	BufferSRV,
	MAX,
};

enum class ERDGViewableResourceType : uint8
{
	Texture,
	Buffer,
	MAX,
};

/** The access that a registered or extracted resource is left ready for. */
constexpr ERHIAccess kDefaultAccessInitial = ERHIAccess::Unknown;
constexpr ERHIAccess kDefaultAccessFinal = ERHIAccess::SRVMask;

inline ERHIPipeline GetPassPipeline(ERDGPassFlags Flags)
{
	return EnumHasAnyFlags(Flags, ERDGPassFlags::AsyncCompute) ? ERHIPipeline::AsyncCompute : ERHIPipeline::Graphics;
}

/** The graph's texture description is the RHI's; buffers are described by FRDGBufferDesc (RenderGraphResourcePool.h).
 */
using FRDGTextureDesc = FRHITextureDesc;

/** Gives a buffer's element count when the graph is executed. */
using FRDGBufferNumElementsCallback = TFunction<uint32()>;
