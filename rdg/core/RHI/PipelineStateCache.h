// Setting pipeline states, as code outside the engine's helpers does it. Source: engine PipelineStateCache.h.
#pragma once

#include "RHICommandList.h"

inline void SetComputePipelineState(FRHIComputeCommandList& RHICmdList, FRHIComputeShader* ComputeShader)
{
	RHICmdList.SetComputePipelineState(ComputeShader);
}

inline void SetGraphicsPipelineState(FRHICommandList& RHICmdList, const FGraphicsPipelineStateInitializer& Initializer,
	uint32 StencilRef = 0, EApplyRendertargetOption = EApplyRendertargetOption::CheckApply)
{
	RHICmdList.SetGraphicsPipelineState(Initializer, StencilRef);
}

namespace PipelineStateCache
{

/** Kept for the process: equal declarations made twice are two objects, which nothing notices. */
DRYDOCK_API FRHIVertexDeclaration* GetOrCreateVertexDeclaration(const FVertexDeclarationElementList& Elements);

} // namespace PipelineStateCache
