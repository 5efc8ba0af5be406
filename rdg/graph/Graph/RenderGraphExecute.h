// Runs passes: gives resources memory before their first pass, opens and closes render passes, lets the running pass
// touch what it declares, measures. Internal to this folder.
#pragma once

#include "RenderGraphObserver.h"
#include "RenderGraphState.h"

namespace Drydock
{

class FRDGExecutor
{
public:
	FRDGExecutor(FRDGBuilderState& InState, FRHICommandListImmediate& InRHICmdList)
		: State(InState)
		, RHICmdList(InRHICmdList)
	{
	}

	/** All surviving passes, then the extractions. */
	void RunGraph(const FRDGCompiledGraph& Compiled);

	/** One pass, now: immediate mode. */
	void RunPassImmediately(FRDGPass& Pass);

	/** Immediate mode: what is left when all passes have run. */
	void FinishImmediate(const FRDGCompiledGraph& Compiled);

	/** The textures that RunGraph would announce for loading. */
	std::vector<FRDGExternalLoad> PlanExternals(const FRDGCompiledGraph& Compiled);

	/** Gives a texture or buffer memory from a pool, whoever uses it first. */
	static void AllocatePooled(FRDGViewableResource& Resource);

	/** The action of the pass of UseExternalAccessMode. */
	static void SetExternalAccess(FRDGViewableResource& Resource, bool bExternal);

private:
	void TakeOver(const FRDGCompiledGraph& Compiled);
	void CompileShaders();
	void LoadExternals(const std::vector<FRDGExternalLoad>& Loads);
	std::vector<FRDGExternalLoad> FindExternals(int32 PassIndex);
	void MakeReady(FRDGViewableResource& Resource);
	void MakeReady(const FRDGPassResources& Resources);
	void Allocate(FRDGViewableResource& Resource);
	void Upload(FRDGBuffer& Buffer);
	void AllowAccess(const FRDGPassResources& Resources, bool bAllow);
	void RunPass(FRDGPass& Pass);
	void RunLambda(FRDGPass& Pass, const FRDGPassResources& Resources);
	FRHIRenderPassInfo MakeRenderPassInfo(const FRenderTargetBindingSlots& Slots) const;
	const FRDGPassDescription& Describe(const FRDGPass& Pass) const;
	std::vector<FRDGTexture*> FindWritten(const FRDGPass& Pass) const;
	void WarnAboutUnused(const FRDGPass& Pass, const FRDGPassResources& Resources) const;
	void WriteExtractions();
	void LogTransitions(const FRDGCompiledGraph& Compiled) const;

	FRDGBuilderState& State;
	FRHICommandListImmediate& RHICmdList;
	const FRDGCompiledGraph* Compiled = nullptr; // null in immediate mode
	uint8* Heap = nullptr;
};

} // namespace Drydock
