// Command lists. They run at once: when a call returns, its work is done. A draw runs the bound pixel shader over the
// viewport, or over the rectangles that a vertex shader of a plugin makes of its vertices. Source: engine
// RHICommandList.h.
#pragma once

#include <map>
#include <vector>

#include "BoundShader.h"
#include "PassCounters.h"
#include "RHIResources.h"
#include "RHITransition.h"
#include "RHIViewDesc.h"
#include "VertexDraw.h"

/** Creation, locks, uploads and clears; counters. */
class DRYDOCK_API FRHICommandListBase
{
public:
	FRHICommandListBase() = default;
	virtual ~FRHICommandListBase();
	FRHICommandListBase(const FRHICommandListBase&) = delete;
	FRHICommandListBase& operator=(const FRHICommandListBase&) = delete;

	FTextureRHIRef CreateTexture(const FRHITextureCreateDesc& Desc);
	FBufferRHIRef CreateBuffer(
		uint32 Size, EBufferUsageFlags Usage, uint32 Stride, ERHIAccess State, const FRHIResourceCreateInfo& Info);
	FBufferRHIRef CreateBuffer(const FRHIBufferDesc& Desc, ERHIAccess State, const FRHIResourceCreateInfo& Info);
	FBufferRHIRef CreateVertexBuffer(uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info);
	/** Stride: bytes of an index, 2 or 4. */
	FBufferRHIRef CreateIndexBuffer(
		uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
	{
		return CreateBuffer(
			Size, Usage | EBufferUsageFlags::IndexBuffer, Stride, ERHIAccess::VertexOrIndexBuffer, Info);
	}
	FBufferRHIRef CreateStructuredBuffer(
		uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info);
	FShaderResourceViewRHIRef CreateShaderResourceView(FRHITexture* Texture, const FRHITextureSRVCreateInfo& Info);
	FShaderResourceViewRHIRef CreateShaderResourceView(FRHITexture* Texture, uint8 MipLevel);
	FShaderResourceViewRHIRef CreateShaderResourceView(FRHIBuffer* Buffer);
	FShaderResourceViewRHIRef CreateShaderResourceView(FRHIBuffer* Buffer, uint32 Stride, EPixelFormat Format);
	FShaderResourceViewRHIRef CreateShaderResourceView(
		FRHITexture* Texture, const FRHIViewDesc::FTextureSRV::FInitializer& Desc)
	{
		return new FRHIShaderResourceView(Texture, Desc.Info);
	}
	FShaderResourceViewRHIRef CreateShaderResourceView(
		FRHIBuffer* Buffer, const FRHIViewDesc::FBufferSRV::FInitializer& Desc)
	{
		return new FRHIShaderResourceView(Buffer, Desc.Info);
	}
	FUnorderedAccessViewRHIRef CreateUnorderedAccessView(
		FRHITexture* Texture, const FRHIViewDesc::FTextureUAV::FInitializer& Desc)
	{
		return new FRHIUnorderedAccessView(Texture, Desc.Info);
	}
	FUnorderedAccessViewRHIRef CreateUnorderedAccessView(
		FRHIBuffer* Buffer, const FRHIViewDesc::FBufferUAV::FInitializer& Desc)
	{
		return new FRHIUnorderedAccessView(Buffer, Desc.Info);
	}
	FUnorderedAccessViewRHIRef CreateUnorderedAccessView(FRHITexture* Texture, uint32 MipLevel = 0);
	FUnorderedAccessViewRHIRef CreateUnorderedAccessView(FRHIBuffer* Buffer, EPixelFormat Format = PF_Unknown);
	FUnorderedAccessViewRHIRef CreateUnorderedAccessView(FRHIBuffer* Buffer, bool bUseUAVCounter, bool bAppendBuffer);

	/** Address of a buffer's bytes; what is written there is in the buffer at once. */
	void* LockBuffer(FRHIBuffer* Buffer, uint32 Offset, uint32 Size, EResourceLockMode Mode);
	void UnlockBuffer(FRHIBuffer* Buffer);

	/** Address of a mip's rows, OutStride bytes apart, in the texture's own format. A widened texture receives what was
	 *  written when it is unlocked. One lock per texture at a time (checked). */
	void* LockTexture2D(FRHITexture* Texture, uint32 MipIndex, EResourceLockMode Mode, uint32& OutStride,
		bool bLockWithinMiptail = false);
	void UnlockTexture2D(FRHITexture* Texture, uint32 MipIndex, bool bLockWithinMiptail = false);

	/** SourceData: the region's first texel, in the texture's own format. */
	void UpdateTexture2D(FRHITexture* Texture, uint32 MipIndex, const FUpdateTextureRegion2D& Region,
		uint32 SourcePitch, const uint8* SourceData);

	/** Transitions describe what a GPU would do; nothing happens. */
	void Transition(const FRHITransitionInfo&) {}
	void Transition(TArrayView<const FRHITransitionInfo>) {}
	void Transition(std::initializer_list<FRHITransitionInfo>) {}

	/** Event scopes for GPU captures. The graph keeps its own. */
	void PushEvent(const TCHAR*, FColor) {}
	void PopEvent() {}

	bool IsImmediate() const { return bImmediate; }
	FRHICommandListBase& GetAsImmediate() { return *this; }

	/** Sums since ResetCounters, which keeps the remarks that nobody has taken: those of work outside passes. */
	const Drydock::FPassCounters& GetCounters() const { return Counters; }
	void ResetCounters()
	{
		std::vector<Drydock::FDiagnostic> Remarks = TakeRemarks();
		Counters = Drydock::FPassCounters();
		Counters.Remarks = std::move(Remarks);
	}
	std::vector<Drydock::FDiagnostic> TakeRemarks() { return std::exchange(Counters.Remarks, {}); }
	/** Counts what was written to Drawn as written to Target. */
	void CountAs(const FRHITexture* Drawn, const FRHITexture* Target) { Counters.Rename(Drawn, Target); }

protected:
	Drydock::FPassCounters Counters;
	bool bImmediate = false;

private:
	struct FLockedTexture
	{
		uint32 MipIndex = 0;
		EResourceLockMode Mode = RLM_ReadOnly;
		uint32 Pitch = 0;
		std::vector<uint8> Staging; // empty: locked in place
	};

	std::map<FRHITexture*, FLockedTexture> LockedTextures;
};

/** The parameters that SetShaderParameters has bound for one shader, for SetBatchedShaderParameters to set. */
class FRHIBatchedShaderParameters
{
public:
	FRHIBatchedShaderParameters() = default;
	FRHIBatchedShaderParameters(FRHIBatchedShaderParameters&&) = default;
	FRHIBatchedShaderParameters& operator=(FRHIBatchedShaderParameters&&) = default;
	/** Copies only what holds no parameters yet (checked), as plugins copy the scratch parameters of a list. */
	FRHIBatchedShaderParameters(const FRHIBatchedShaderParameters& Other)
	{
		checkf(!Other.HasParameters(), TEXT("a copy of batched parameters that are set already"));
	}

	bool HasParameters() const { return Bound.IsValid(); }
	void Reset() { Bound = Drydock::FBoundShader(); }

	Drydock::FBoundShader Bound; // ours
};

class DRYDOCK_API FRHIComputeCommandList : public FRHICommandListBase
{
public:
	/** Names the shader of the following dispatches; forgets the parameters of the one before. */
	void SetComputePipelineState(FRHIComputeShader* ComputeShader);

	/** The spelling before 5.1. */
	void SetComputeShader(FRHIComputeShader* InComputeShader) { SetComputePipelineState(InComputeShader); }
	FRHIComputeShader* GetBoundComputeShader() const { return ComputeShader; }

	/** The parameters' binder hands over what DispatchComputeShader runs. Stays until the next pipeline state. */
	void SetBoundComputeShader(Drydock::FBoundShader&& Shader);

	/** Runs that many thread groups. A zero count runs nothing. */
	void DispatchComputeShader(uint32 ThreadGroupCountX, uint32 ThreadGroupCountY, uint32 ThreadGroupCountZ);

	/** Group counts: three uint32 at ArgumentOffset. */
	void DispatchIndirectComputeShader(FRHIBuffer* ArgumentBuffer, uint32 ArgumentOffset);

	/** Values are stored as the view's format stores them. Buffers without a format: 32-bit elements, from Value.X. */
	void ClearUAVFloat(FRHIUnorderedAccessView* View, const FVector4f& Value);
	void ClearUAVUint(FRHIUnorderedAccessView* View, const FUintVector4& Value);

	/** Empty; the list's own, for one shader at a time. */
	FRHIBatchedShaderParameters& GetScratchShaderParameters();
	/** Takes them over, for the dispatches and draws that follow. */
	void SetBatchedShaderParameters(FRHIComputeShader* Shader, FRHIBatchedShaderParameters& Parameters);

	void BeginUAVOverlap() {}
	void EndUAVOverlap() {}
	void SubmitCommandsHint() {}

	/** Ours: the shader that is bound to the stage. */
	Drydock::FBoundShader& GetBound(FRHIComputeShader*) { return BoundCompute; }

protected:
	/** Runs tiles of a bound shader under its arithmetic's denormal mode and counts. Targets: the textures of
	 * Args.Targets. */
	void RunTiles(const Drydock::FBoundShader& Shader, Drydock::FKernelArgs Args, const Drydock::FKernelTile& Whole,
		FIntVector TileSize, const std::vector<FRHITexture*>& Targets = {});

private:
	void NoteCleared(const FRHIUnorderedAccessView* View);

	Drydock::FBoundShader BoundCompute;
	FRHIBatchedShaderParameters ScratchShaderParameters;
	FRHIComputeShader* ComputeShader = nullptr;
};

class DRYDOCK_API FRHICommandList : public FRHIComputeCommandList
{
public:
	/** Clears what is to be cleared, to the textures' clear values. The viewport becomes the whole of the first target.
	 */
	void BeginRenderPass(const FRHIRenderPassInfo& Info, const TCHAR* Name);
	void EndRenderPass();
	bool IsInsideRenderPass() const { return bInsideRenderPass; }
	bool IsOutsideRenderPass() const { return !bInsideRenderPass; }

	/** Fills the initializer's formats from the render pass. */
	void ApplyCachedRenderTargets(FGraphicsPipelineStateInitializer& Initializer) const;

	/** Names the states of the following draws; forgets parameters and interpolants. */
	void SetGraphicsPipelineState(const FGraphicsPipelineStateInitializer& Initializer, uint32 StencilRef = 0);

	/** The parameters' binder hands over what draws run. Stays until the next pipeline state. */
	void SetBoundPixelShader(Drydock::FBoundShader&& Shader);

	/** The same of the pipeline state's vertex shader. */
	void SetBoundVertexShader(Drydock::FBoundShader&& Shader) { Vertices.Bound = std::move(Shader); }

	using FRHIComputeCommandList::GetBound;
	Drydock::FBoundShader& GetBound(FRHIPixelShader*) { return BoundPixel; }
	Drydock::FBoundShader& GetBound(FRHIVertexShader*) { return Vertices.Bound; }

	using FRHIComputeCommandList::SetBatchedShaderParameters;
	void SetBatchedShaderParameters(FRHIGraphicsShader* Shader, FRHIBatchedShaderParameters& Parameters);
	/** The vertex shader of the pipeline state. */
	FRHIVertexShader* GetBoundVertexShader() const { return Vertices.Shader; }
	FRHIPixelShader* GetBoundPixelShader() const { return PixelShader; }

	/** The pipeline state has a vertex shader that draws run: one other than the engine's of screen passes. */
	bool HasVertexShader() const { return Vertices.Shader && Vertices.Shader->GetShaderToRun(); }

	/** Draws two triangles of GScreenRectangleVertexBuffer by the vertex shader, the engine's where the state has none.
	 * Parameters: contents of the uniform buffer DrawRectangleParameters, FDrawRectangleParameters. */
	void DrawScreenRectangle(const void* Parameters, uint32 NumBytes);

	/** Sets the outputs of the engine's vertex shader of screen passes, by location. Without it, location 0 is
	 *  (u, v, screen x, screen y): 0..1 over the viewport with v down, and -1..1 with y up. Stays until the next
	 * pipeline state. */
	void SetInterpolants(TConstArrayView<Drydock::FKernelInterpolant> InInterpolants);

	void SetViewport(float MinX, float MinY, float MinZ, float MaxX, float MaxY, float MaxZ);
	void SetScissorRect(bool bEnable, uint32 MinX, uint32 MinY, uint32 MaxX, uint32 MaxY);
	void SetStencilRef(uint32) {}
	/** Sets where the vertex declaration's elements of that stream lie: Offset bytes into Buffer. */
	void SetStreamSource(uint32 StreamIndex, FRHIBuffer* Buffer, uint32 Offset);

	/** Only white, the default, is simulated (checked). */
	void SetBlendFactor(const FLinearColor& BlendFactor);

	/** Each instance covers the viewport once, within scissor and targets; or what the vertex shader makes of it, which
	 * have to be triangles of the screen (VertexRectangles.h): others are not drawn, which is a warning (DD2130). */
	void DrawPrimitive(uint32 BaseVertexIndex, uint32 NumPrimitives, uint32 NumInstances);
	void DrawIndexedPrimitive(FRHIBuffer* IndexBuffer, int32 BaseVertexIndex, uint32 FirstInstance, uint32 NumVertices,
		uint32 StartIndex, uint32 NumPrimitives, uint32 NumInstances);

	/** Formats must agree (checked). */
	void CopyTexture(FRHITexture* Source, FRHITexture* Dest, const FRHICopyTextureInfo& Info);
	void CopyBufferRegion(
		FRHIBuffer* Dest, uint64 DestOffset, FRHIBuffer* Source, uint64 SourceOffset, uint64 NumBytes);

private:
	void ClearTarget(FRHITexture* Texture, int32 Mip, int32 Slice);
	void DrawViewport(uint32 NumInstances);
	void DrawRect(const FIntRect& Rect, const std::vector<Drydock::FKernelInterpolant>& Inputs, uint32 NumInstances);
	void DrawVertices(const Drydock::FVertexDraw& Draw, uint32 NumInstances);
	void CheckDraw();
	std::vector<Drydock::FKernelTarget> MakeTargets() const;
	std::vector<FRHITexture*> GetTargetTextures() const;
	std::vector<Drydock::FKernelInterpolant> MakeInterpolants(int32 NumRead) const;
	FIntRect GetDrawRect() const;

	FRHIRenderPassInfo RenderPass;
	Drydock::FBoundShader BoundPixel;
	FRHIPixelShader* PixelShader = nullptr;
	TRefCountPtr<FRHIBlendState> BlendState;
	TRefCountPtr<FRHIDepthStencilState> DepthStencilState;
	Drydock::FVertexState Vertices;
	std::vector<Drydock::FKernelInterpolant> Interpolants;
	FIntRect Viewport;
	FIntRect Scissor;
	bool bScissor = false;
	bool bInsideRenderPass = false;
};

/** How far the engine flushes: there is nothing to wait for here. */
namespace EImmediateFlushType
{
enum Type
{
	WaitForOutstandingTasksOnly,
	DispatchToRHIThread,
	FlushRHIThread,
	FlushRHIThreadFlushResources,
};
} // namespace EImmediateFlushType

class DRYDOCK_API FRHICommandListImmediate : public FRHICommandList
{
public:
	FRHICommandListImmediate() { bImmediate = true; }

	/** Row-major texels of Rect. RCM_MinMax: values as stored. */
	void ReadSurfaceData(
		FRHITexture* Texture, FIntRect Rect, TArray<FLinearColor>& OutData, FReadSurfaceDataFlags Flags);

	/** Eight bits per channel: the bytes of 8-bit formats; others clamped to 0..1, and encoded as sRGB when they are
	 * floats and the flags say LinearToGamma. */
	void ReadSurfaceData(FRHITexture* Texture, FIntRect Rect, TArray<FColor>& OutData, FReadSurfaceDataFlags Flags);

	void ImmediateFlush(EImmediateFlushType::Type = EImmediateFlushType::FlushRHIThread) {}
	void BlockUntilGPUIdle() {}
	void FlushResources() {}
	void SubmitAndBlockUntilGPUIdle() {}
};

class FRHICommandListExecutor
{
public:
	/** The one list there is need of; made on first use. Not for two threads at once. */
	static DRYDOCK_API FRHICommandListImmediate& GetImmediateCommandList();
};

inline FRHICommandListExecutor GRHICommandList;

inline FRHICommandListImmediate& GetImmediateCommandList_ForRenderCommand()
{
	return FRHICommandListExecutor::GetImmediateCommandList();
}

DRYDOCK_API_RHICreateTexture DRYDOCK_API FTextureRHIRef RHICreateTexture(const FRHITextureCreateDesc& Desc);
DRYDOCK_API FBufferRHIRef RHICreateBuffer(
	uint32 Size, EBufferUsageFlags Usage, uint32 Stride, ERHIAccess State, const FRHIResourceCreateInfo& Info);
DRYDOCK_API FBufferRHIRef RHICreateVertexBuffer(
	uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info);
inline FBufferRHIRef RHICreateIndexBuffer(
	uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info)
{
	return FRHICommandListExecutor::GetImmediateCommandList().CreateIndexBuffer(Stride, Size, Usage, Info);
}
DRYDOCK_API FBufferRHIRef RHICreateStructuredBuffer(
	uint32 Stride, uint32 Size, EBufferUsageFlags Usage, const FRHIResourceCreateInfo& Info);
DRYDOCK_API FShaderResourceViewRHIRef RHICreateShaderResourceView(FRHITexture* Texture, uint8 MipLevel);
DRYDOCK_API FShaderResourceViewRHIRef RHICreateShaderResourceView(
	FRHITexture* Texture, const FRHITextureSRVCreateInfo& Info);
DRYDOCK_API FShaderResourceViewRHIRef RHICreateShaderResourceView(FRHIBuffer* Buffer);
DRYDOCK_API FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(FRHITexture* Texture, uint32 MipLevel = 0);
DRYDOCK_API FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(
	FRHIBuffer* Buffer, EPixelFormat Format = PF_Unknown);
DRYDOCK_API FUnorderedAccessViewRHIRef RHICreateUnorderedAccessView(
	FRHIBuffer* Buffer, bool bUseUAVCounter, bool bAppendBuffer);
DRYDOCK_API void* RHILockBuffer(FRHIBuffer* Buffer, uint32 Offset, uint32 Size, EResourceLockMode Mode);
DRYDOCK_API void RHIUnlockBuffer(FRHIBuffer* Buffer);
DRYDOCK_API void* RHILockTexture2D(FRHITexture* Texture, uint32 MipIndex, EResourceLockMode Mode, uint32& OutStride,
	bool bLockWithinMiptail, bool bFlush = true);
DRYDOCK_API void RHIUnlockTexture2D(FRHITexture* Texture, uint32 MipIndex, bool bLockWithinMiptail, bool bFlush = true);
DRYDOCK_API void RHIUpdateTexture2D(FRHITexture* Texture, uint32 MipIndex, const FUpdateTextureRegion2D& Region,
	uint32 SourcePitch, const uint8* SourceData);
