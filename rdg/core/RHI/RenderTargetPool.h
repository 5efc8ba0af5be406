// The pool of textures that outlive graphs: a free one of exactly the wanted description is used again.
// Source: engine RenderTargetPool.h.
#pragma once

#include "RHICommandList.h"
#include "RendererInterface.h"

class FRenderTargetPool;

/** One texture and its holders. */
class DRYDOCK_API FPooledRenderTarget final : public IPooledRenderTarget
{
public:
	/** Pool null: untracked, deleted with its last reference. */
	FPooledRenderTarget(FRHITexture* InTexture, const FPooledRenderTargetDesc& InDesc, FRenderTargetPool* InPool);

	uint32 AddRef() const override { return NumRefs.fetch_add(1, std::memory_order_relaxed) + 1; }
	uint32 Release() override;
	uint32 GetRefCount() const override { return NumRefs.load(std::memory_order_relaxed); }
	bool IsFree() const override { return Pool && GetRefCount() == 1; }
	bool IsTracked() const override { return Pool != nullptr; }
	const FPooledRenderTargetDesc& GetDesc() const override { return Desc; }
	FRHITexture* GetRHI() const override { return Texture; }
	void SetDebugName(const TCHAR* Name) override;
	uint32 ComputeMemorySize() const override { return uint32(Texture->GetSizeInBytes()); }

private:
	friend FRenderTargetPool;

	FTextureRHIRef Texture;
	FPooledRenderTargetDesc Desc;
	FRenderTargetPool* Pool;
	mutable std::atomic<uint32> NumRefs{0};
	uint32 NumUnusedFrames = 0;
};

class DRYDOCK_API FRenderTargetPool
{
public:
	/** A free element of exactly that description (and of the storage r.Drydock.Storage asks for), or a new one.
	 * Contents are whatever the last user left. */
	TRefCountPtr<IPooledRenderTarget> FindFreeElement(const FRHITextureDesc& Desc, const TCHAR* Name);

	/** Keeps Out when it already fits. Returns true when it does, false when Out was replaced. */
	bool FindFreeElement(const FRHITextureDesc& Desc, TRefCountPtr<IPooledRenderTarget>& Out, const TCHAR* Name);
	bool FindFreeElement(FRHICommandListBase& RHICmdList, const FRHITextureDesc& Desc,
		TRefCountPtr<IPooledRenderTarget>& Out, const TCHAR* Name);

	/** An element around a texture, not pooled. The item form is the engine's of 5.3. */
	void CreateUntrackedElement(const FPooledRenderTargetDesc& Desc, TRefCountPtr<IPooledRenderTarget>& Out,
		const FSceneRenderTargetItem& Item);

	/** End of a frame: forgets elements unused for some frames. */
	void TickPoolElements();

	/** Gives up that one; its texture is free once nobody else holds it. */
	void FreeUnusedResource(TRefCountPtr<IPooledRenderTarget>& In) { In = nullptr; }
	/** Forgets every free element. */
	void FreeUnusedResources();
	void ReleaseRHI() { FreeUnusedResources(); }

	/** Elements, and bytes they hold. */
	int32 GetNumElements() const { return Elements.Num(); }
	uint64 GetSizeInBytes() const;

private:
	TArray<TRefCountPtr<FPooledRenderTarget>> Elements;
};

extern DRYDOCK_API FRenderTargetPool GRenderTargetPool;

/** Wraps a texture for RegisterExternalTexture. Every call makes a new wrapper. */
DRYDOCK_API TRefCountPtr<IPooledRenderTarget> CreateRenderTarget(FRHITexture* Texture, const TCHAR* Name);

/** Whether Texture is what TargetPtr wraps; makes TargetPtr a wrapper of it otherwise. */
DRYDOCK_API bool CacheRenderTarget(
	FRHITexture* Texture, const TCHAR* Name, TRefCountPtr<IPooledRenderTarget>& TargetPtr);
