// A graph as plain data: what was declared (descriptions) and what the compile phases found. Nothing here points into a
// builder, so a compiled graph can be kept, compared and printed without one. Behaviour is the engine's.
#pragma once

#include "Diagnostics.h"
#include "RenderGraphDefinitions.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

enum class ERDGResourceKind : uint8_t
{
	Texture,
	Buffer,
};

/** A box of subresources of one resource. Buffers have one subresource. */
struct FRDGSubresources
{
	int32_t FirstMip = 0;
	int32_t NumMips = 1;
	int32_t Slice = 0;
	int32_t NumSlices = 1;
	int32_t Plane = 0; // 0 colour or depth, 1 stencil
	int32_t NumPlanes = 1;

	bool operator==(const FRDGSubresources&) const = default;
	DRYDOCK_API bool Overlaps(const FRDGSubresources& Other) const;
};

/** One parameter of a pass that touches a resource. */
struct FRDGUse : FRDGSubresources
{
	int32_t Resource = -1; // position in Resources
	ERHIAccess Access = ERHIAccess::Unknown;
	std::string Parameter;        // C++ name, "Input.Texture", "RenderTargets[0]"
	bool bLoads = false;          // a target with ELoad: contents from before matter
	int32_t SkipBarrierView = -1; // identifies a view made with SkipBarrier

	bool IsWrite() const { return IsWritableAccess(Access); }
	/** Declared as a read. An unordered access is declared as a write, though a shader may read through it too. */
	bool IsRead() const { return IsReadableAccess(Access & ~ERHIAccess::UAVMask) || bLoads; }
};

/** One bound colour target. */
struct FRDGTarget
{
	int32_t Resource = -1;
	int32_t ResolveResource = -1;
	int32_t Mip = 0;
	int32_t Slice = -1;
	ERenderTargetLoadAction Load = ERenderTargetLoadAction::ENoAction;
};

/** Render targets of a raster pass. */
struct FRDGTargets
{
	std::vector<FRDGTarget> Colors;
	int32_t DepthStencil = -1;
	ERenderTargetLoadAction DepthLoad = ERenderTargetLoadAction::ENoAction;
	ERenderTargetLoadAction StencilLoad = ERenderTargetLoadAction::ENoAction;
	uint8_t DepthStencilAccess = 0; // FExclusiveDepthStencil::Type
	int32_t ShadingRate = -1;
	int32_t NumOcclusionQueries = 0;
	FIntRect ResolveRect = FIntRect(0, 0, 0, 0);

	bool IsEmpty() const { return Colors.empty() && DepthStencil < 0; }
};

/** A pass as declared. */
struct FRDGPassDescription
{
	int32_t Index = -1; // position in Passes: 0 the prologue, 1 the first pass, last the epilogue
	std::string Name;
	std::string Scope;                // open event scopes, outermost first, joined by '/'
	std::string Effect;               // whose pass it is, by the innermost FRDGEffectScope; empty: nobody's
	std::string Owner;                // the plugin whose code added it, and from where; empty: none
	FIntPoint Area = FIntPoint(0, 0); // pixels that it draws or dispatches; 0: not known
	ERDGPassFlags Flags = ERDGPassFlags::None;
	std::string File; // of the AddPass call
	int32_t Line = 0;
	std::string Shader; // class name; empty: a lambda of its own
	std::string Entry;
	std::string
		RunsAs; // how the shader is going to run (DescribeShaderRun), of a graph that is compiled to be looked at
	std::vector<std::string> UnsetOutputs; // parameters through which it could write and that are null
	std::vector<FRDGUse> Uses;
	std::vector<int32_t> DeclaredProducers; // AddPassDependency
	FRDGTargets Targets;
	bool bHasParameters = false;
	bool bHasTargetSlots = false;
	bool bHasExternalOutputs = false; // writes through a view outside the graph
	bool bIsSentinel = false;         // prologue or epilogue
	bool bAsync = false;              // runs on the async pipeline (flags and r.RDG.AsyncCompute)
	uint32_t Workload = 1;

	ERHIPipeline GetPipeline() const { return bAsync ? ERHIPipeline::AsyncCompute : ERHIPipeline::Graphics; }
};

/** A texture or buffer as declared. */
struct FRDGResourceDescription
{
	std::string Name;
	ERDGResourceKind Kind = ERDGResourceKind::Texture;
	EPixelFormat Format = PF_Unknown;        // textures
	FIntVector Extent = FIntVector(0, 0, 0); // textures: texels; buffers: X elements of Y bytes
	int32_t NumMips = 1;
	int32_t NumSlices = 1;
	int32_t NumPlanes = 1;
	int32_t NumSamples = 1;
	ETextureCreateFlags TextureFlags = ETextureCreateFlags::None;
	EBufferUsageFlags BufferUsage = EBufferUsageFlags::None;
	uint64_t Bytes = 0; // of memory, alignment and margins included
	bool bExternal = false;
	bool bExtracted = false;
	bool bUploaded = false;
	bool bSkipTracking = false;
	bool bSkipUnusedWarning = false; // RemoveUnusedTextureWarning
	bool bMayBeTransient = false;    // settings and flags let it live in the heap
	ERHIAccess AccessFinal = ERHIAccess::Unknown;

	int32_t GetNumSubresources() const { return NumMips * NumSlices * NumPlanes; }
	/** Everything of it. */
	FRDGSubresources GetWhole() const { return {0, NumMips, 0, NumSlices, 0, NumPlanes}; }
};

/** The input of the phases. Passes include the prologue and the epilogue. */
struct FRDGGraphDescription
{
	std::string Name;
	std::vector<FRDGPassDescription> Passes;
	std::vector<FRDGResourceDescription> Resources;

	int32_t GetEpilogue() const { return int32_t(Passes.size()) - 1; }
};

/** The chain of a culled pass's readers: from one first reader to the next, all of them culled. */
struct FRDGCulledChain
{
	int32_t Next = -1;  // the first pass that depends on it; -1: none does
	int32_t End = -1;   // the last pass of the chain, which nobody reads; itself where there is no chain
	int32_t Length = 0; // passes after it
};

struct FRDGCompiledPass : FRDGPassDescription
{
	std::vector<int32_t> Producers; // passes it depends on, ascending
	bool bCulled = false;
	FRDGCulledChain Readers;      // of a culled pass: what DescribeCulled explains
	int32_t RenderPassBegin = -1; // raster: first and last pass of the render pass it is merged into
	int32_t RenderPassEnd = -1;
	std::string MergeReason; // raster: why it was not merged into the pass before
	int32_t ForkPass = -1;   // async: the graphics pass after which it may start
	int32_t JoinPass = -1;   // async: the graphics pass before which it has to be done
};

struct FRDGCompiledResource : FRDGResourceDescription
{
	int32_t FirstPass = -1; // surviving passes that hold it in memory; -1: unused, never allocated
	int32_t LastPass = -1;
	int32_t NumUses = 0; // surviving passes that touch it
	bool bTransient = false;
	int64_t HeapOffset = -1;          // transient: bytes from the start of the heap
	std::vector<int32_t> CulledUsers; // of an unused resource: what DescribeUnused explains
};

/** A change of state that a GPU would need a barrier for. */
struct FRDGTransition : FRDGSubresources
{
	int32_t Resource = -1;
	ERHIAccess Before = ERHIAccess::Unknown;
	ERHIAccess After = ERHIAccess::Unknown;
	int32_t BeginPass = -1; // begins in this pass's epilogue
	int32_t EndPass = -1;   // ends in this pass's prologue; equal to BeginPass: at once, in its prologue
	bool bUAVBarrier = false;

	bool operator==(const FRDGTransition&) const = default;
};

struct FRDGMemory
{
	uint64_t TransientPeakBytes = 0;   // size of the heap
	uint64_t WithoutAliasingBytes = 0; // the same resources side by side
	uint64_t PooledBytes = 0;          // created, but not in the heap
	uint64_t ExternalBytes = 0;        // registered and used
};

/** The result of the compile phases. */
struct FRDGCompiledGraph
{
	std::string Name;
	std::vector<FRDGCompiledPass> Passes;
	std::vector<FRDGCompiledResource> Resources; // in the order of creation and registration
	std::vector<FRDGTransition> Transitions;     // by EndPass, then resource
	FRDGMemory Memory;
	std::vector<FDiagnostic> Warnings;

	/** Null when there is none of that name; the first one otherwise. */
	DRYDOCK_API const FRDGCompiledPass* FindPass(const std::string& PassName) const;
	DRYDOCK_API const FRDGCompiledResource* FindResource(const std::string& ResourceName) const;

	/** Why a pass is culled; empty for one that runs. Made when asked: of a long chain of readers the first ones, how
	 * many more there are, and the last. */
	DRYDOCK_API std::string DescribeCulled(const FRDGCompiledPass& Pass) const;
	/** Why a resource is never allocated; empty for one that is. */
	DRYDOCK_API std::string DescribeUnused(const FRDGCompiledResource& Resource) const;
};

} // namespace Drydock
