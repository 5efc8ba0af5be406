// Runs the compile phases one after the other.
#include "RenderGraphCompile.h"

#include "RangeTools.h"
#include "RenderGraphAlias.h"
#include "RenderGraphAsyncCompute.h"
#include "RenderGraphConsoleVariables.h"
#include "RenderGraphCull.h"
#include "RenderGraphDependencies.h"
#include "RenderGraphLifetimes.h"
#include "RenderGraphMerge.h"
#include "RenderGraphTransitions.h"

namespace Drydock
{

bool FRDGSubresources::Overlaps(const FRDGSubresources& Other) const
{
	const auto Intersect = [](int32_t A, int32_t NumA, int32_t B, int32_t NumB)
	{
		return A < B + NumB && B < A + NumA;
	};
	return Intersect(FirstMip, NumMips, Other.FirstMip, Other.NumMips) &&
		   Intersect(Slice, NumSlices, Other.Slice, Other.NumSlices) &&
		   Intersect(Plane, NumPlanes, Other.Plane, Other.NumPlanes);
}

const FRDGCompiledPass* FRDGCompiledGraph::FindPass(const std::string& PassName) const
{
	return FindItem(Passes, PassName, &FRDGCompiledPass::Name);
}

const FRDGCompiledResource* FRDGCompiledGraph::FindResource(const std::string& ResourceName) const
{
	return FindItem(Resources, ResourceName, &FRDGCompiledResource::Name);
}

FRDGCompileOptions FRDGCompileOptions::FromConsoleVariables()
{
	const FRDGSettings Settings = GetRDGSettings();
	FRDGCompileOptions Options;
	Options.bCullPasses = Settings.bCullPasses && !Settings.bImmediateMode;
	Options.bMergeRenderPasses = Settings.bMergeRenderPasses && !Settings.bImmediateMode;
	Options.bTransientHeap =
		Settings.TransientAllocator != 0 && !Settings.bDisableTransientResources && !Settings.bImmediateMode;
	Options.bExtendLifetimes = Settings.bExtendResourceLifetimes;
	Options.bOverlapUAVs = Settings.bOverlapUAVs;
	return Options;
}

namespace
{

FRDGMemory SumMemory(const std::vector<FRDGCompiledResource>& Resources, const FRDGHeapLayout& Heap)
{
	FRDGMemory Memory;
	Memory.TransientPeakBytes = Heap.PeakBytes;
	Memory.WithoutAliasingBytes = Heap.WithoutAliasingBytes;
	for (const FRDGCompiledResource& Resource : Resources)
	{
		if (Resource.FirstPass >= 0 && Resource.bExternal)
		{
			Memory.ExternalBytes += Resource.Bytes;
		}
		else if (Resource.FirstPass >= 0 && !Resource.bTransient)
		{
			Memory.PooledBytes += Resource.Bytes;
		}
	}
	return Memory;
}

} // namespace

FRDGCompiledGraph CompileGraph(FRDGGraphDescription Graph, const FRDGCompileOptions& Options)
{
	FRDGDependencies Dependencies = FindDependencies(Graph);
	const FRDGCullResult Cull = CullPasses(Graph, Dependencies, Options.bCullPasses);
	std::vector<FRDGRenderPass> RenderPasses = MergeRenderPasses(Graph, Cull.bCulled, Options.bMergeRenderPasses);
	const std::vector<FRDGAsyncWindow> AsyncWindows = FindAsyncWindows(Graph, Dependencies, Cull.bCulled);
	std::vector<FRDGLifetime> Lifetimes = FindLifetimes(Graph, Cull.bCulled, AsyncWindows, Options.bExtendLifetimes);

	std::vector<FRDGHeapRequest> Requests;
	Requests.reserve(Graph.Resources.size());
	FRDGTransitionOptions TransitionOptions;
	TransitionOptions.bOverlapUAVs = Options.bOverlapUAVs;
	TransitionOptions.bTransient.reserve(Graph.Resources.size());
	for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
	{
		const FRDGResourceDescription& Resource = Graph.Resources[Index];
		const bool bTransient = Options.bTransientHeap && Resource.bMayBeTransient && Lifetimes[Index].First >= 0;
		TransitionOptions.bTransient.push_back(bTransient);
		Requests.push_back({Resource.Bytes, bTransient ? Lifetimes[Index].First : -1, Lifetimes[Index].Last});
	}
	const FRDGHeapLayout Heap = PlaceInHeap(Requests);

	FRDGCompiledGraph Compiled;
	Compiled.Transitions = FindTransitions(Graph, Cull.bCulled, TransitionOptions);
	Compiled.Name = std::move(Graph.Name);
	Compiled.Passes.reserve(Graph.Passes.size());
	for (FRDGPassDescription& Pass : Graph.Passes)
	{
		const size_t Index = size_t(Pass.Index);
		FRDGCompiledPass& Out = Compiled.Passes.emplace_back();
		static_cast<FRDGPassDescription&>(Out) = std::move(Pass);
		Out.Producers = std::move(Dependencies.Producers[Index]);
		Out.bCulled = Cull.bCulled[Index];
		Out.Readers = Cull.Chains[Index];
		Out.RenderPassBegin = RenderPasses[Index].Begin;
		Out.RenderPassEnd = RenderPasses[Index].End;
		Out.MergeReason = std::move(RenderPasses[Index].Reason);
		Out.ForkPass = AsyncWindows[Index].Fork;
		Out.JoinPass = AsyncWindows[Index].Join;
	}
	Compiled.Resources.reserve(Graph.Resources.size());
	for (size_t Index = 0; Index < Graph.Resources.size(); ++Index)
	{
		FRDGCompiledResource& Out = Compiled.Resources.emplace_back();
		static_cast<FRDGResourceDescription&>(Out) = std::move(Graph.Resources[Index]);
		Out.FirstPass = Lifetimes[Index].First;
		Out.LastPass = Lifetimes[Index].Last;
		Out.NumUses = Lifetimes[Index].NumUses;
		Out.CulledUsers = std::move(Lifetimes[Index].CulledUsers);
		Out.bTransient = TransitionOptions.bTransient[Index];
		Out.HeapOffset = Heap.Offsets[Index];
	}
	Compiled.Memory = SumMemory(Compiled.Resources, Heap);
	return Compiled;
}

} // namespace Drydock
