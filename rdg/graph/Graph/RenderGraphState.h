// Holds a builder's state between its calls. Internal to this folder.
#pragma once

#include "RenderGraphAllocator.h"
#include "RenderGraphCompiled.h"
#include "RenderGraphConsoleVariables.h"
#include "RenderGraphKnownObjects.h"
#include "RenderGraphParameter.h"
#include "RenderGraphPass.h"
#include "RenderGraphResources.h"

#include <map>
#include <memory>

namespace Drydock
{

struct FRDGUpload
{
	const void* Data = nullptr;
	uint64 Size = 0;
};

template<typename ResourceType, typename PooledType>
struct TRDGExtraction
{
	ResourceType* Resource;
	TRefCountPtr<PooledType>* Out;
};

struct FRDGDestroy
{
	template<typename T>
	void operator()(T* Object) const
	{
		Object->~T();
	}
};

/** An object in the graph's own memory. */
template<typename T>
using TRDGPlaced = std::unique_ptr<T, FRDGDestroy>;

struct FRDGScope
{
	std::string Path;   // with those around it
	std::string Effect; // whose passes it holds; of the one around it where it does not say
	bool bFinal = false;
	bool bRecorded = true;
};

struct FRDGBuilderState
{
	FRDGSettings Settings;
	IRDGObserver* Observer = nullptr;
	FRDGGraphDescription Graph; // grows with each call; Passes[0] is the prologue, the epilogue comes with compiling
	/** Takes the description over when it is executed. Kept until the builder goes: freeing what ten thousand passes
	 * have left all over memory is not part of running them. */
	std::unique_ptr<FRDGCompiledGraph> Compiled;

	// Declared in this order because destruction runs backwards: passes and their captures go first.
	FRDGAllocator Allocator;
	std::vector<TRDGPlaced<FRDGViewableResource>> Resources;
	std::vector<TRDGPlaced<FRDGView>> Views;
	std::vector<std::unique_ptr<FRDGUniformBuffer>> UniformBuffers;
	std::vector<TRDGPlaced<FRDGPass>> Passes;     // Passes[i] has index i + 1
	std::vector<FRDGPassResources> PassResources; // by position in Passes
	FRDGKnownObjects Known;                       // all of the above, by address

	std::map<FRHITexture*, FRDGTexture*> ExternalTextures;
	std::map<FRHIBuffer*, FRDGBuffer*> ExternalBuffers;
	std::map<FRDGBuffer*, FRDGUpload> Uploads;
	std::vector<TRDGExtraction<FRDGTexture, IPooledRenderTarget>> TextureExtractions;
	std::vector<TRDGExtraction<FRDGBuffer, FRDGPooledBuffer>> BufferExtractions;
	std::vector<FRDGScope> Scopes;

	std::vector<FDiagnostic> Errors; // collected so far
	std::vector<FDiagnostic> Ensures;
	std::vector<FDiagnostic> Remarks;             // of the draws of passes that ran
	std::map<FRDGTexture*, bool> LoadedExternals; // and whether they were said to be read
	bool bEnsuresReported = false;
	bool bFinished = false; // executed or discarded
	bool bFailed = false;   // an error was thrown: whoever caught it need not execute
	int UncaughtExceptions = 0;

	FRDGPassDescription& GetDescription(const FRDGPass& Pass) { return Graph.Passes[size_t(Pass.GetIndex())]; }
	FRDGResourceDescription& GetDescription(const FRDGViewableResource& Resource)
	{
		return Graph.Resources[size_t(Resource.GetIndex())];
	}
};

} // namespace Drydock
