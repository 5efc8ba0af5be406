// Pooled textures. Source: engine RenderTargetPool.cpp for behaviour.
#include "RenderTargetPool.h"

FRenderTargetPool GRenderTargetPool;

namespace
{

// Long enough for what is used every other frame, short enough that a change of resolution does not keep both sizes.
constexpr uint32 GMaxUnusedFrames = 30;

} // namespace

IPooledRenderTarget::~IPooledRenderTarget() = default;

FPooledRenderTarget::FPooledRenderTarget(
	FRHITexture* InTexture, const FPooledRenderTargetDesc& InDesc, FRenderTargetPool* InPool)
	: Texture(InTexture)
	, Desc(InDesc)
	, Pool(InPool)
{
}

uint32 FPooledRenderTarget::Release()
{
	const uint32 Left = NumRefs.fetch_sub(1, std::memory_order_acq_rel) - 1;
	if (Left == 0)
	{
		delete this;
	}
	return Left;
}

void FPooledRenderTarget::SetDebugName(const TCHAR* Name)
{
	Desc.DebugName = Name;
	Texture->SetName(FName(Name));
}

TRefCountPtr<IPooledRenderTarget> FRenderTargetPool::FindFreeElement(const FRHITextureDesc& Desc, const TCHAR* Name)
{
	for (const TRefCountPtr<FPooledRenderTarget>& Element : Elements)
	{
		const bool bSameStorage = Element->GetRHI()->GetStorage() == Drydock::GetTexelStorage(Desc);
		if (Element->IsFree() && bSameStorage && static_cast<const FRHITextureDesc&>(Element->GetDesc()) == Desc)
		{
			Element->NumUnusedFrames = 0;
			Element->SetDebugName(Name);
			return Element.GetReference();
		}
	}
	const FPooledRenderTargetDesc PooledDesc(Desc, Name);
	Elements.Add(new FPooledRenderTarget(new FRHITexture(Desc, Name), PooledDesc, this));
	return Elements.Last().GetReference();
}

bool FRenderTargetPool::FindFreeElement(
	const FRHITextureDesc& Desc, TRefCountPtr<IPooledRenderTarget>& Out, const TCHAR* Name)
{
	if (Out.IsValid() && static_cast<const FRHITextureDesc&>(Out->GetDesc()) == Desc &&
		Out->GetRHI()->GetStorage() == Drydock::GetTexelStorage(Desc))
	{
		Out->SetDebugName(Name);
		return true;
	}
	Out.SafeRelease(); // before the search: the old element may be what fits
	Out = FindFreeElement(Desc, Name);
	return false;
}

bool FRenderTargetPool::FindFreeElement(
	FRHICommandListBase&, const FRHITextureDesc& Desc, TRefCountPtr<IPooledRenderTarget>& Out, const TCHAR* Name)
{
	return FindFreeElement(Desc, Out, Name);
}

void FRenderTargetPool::CreateUntrackedElement(
	const FPooledRenderTargetDesc& Desc, TRefCountPtr<IPooledRenderTarget>& Out, const FSceneRenderTargetItem& Item)
{
	check(Item.IsValid());
	Out = new FPooledRenderTarget(Item.GetRHI(), Desc, nullptr);
}

void FRenderTargetPool::TickPoolElements()
{
	for (int32 Index = Elements.Num() - 1; Index >= 0; --Index)
	{
		FPooledRenderTarget& Element = *Elements[Index];
		Element.NumUnusedFrames = Element.IsFree() ? Element.NumUnusedFrames + 1 : 0;
		if (Element.NumUnusedFrames > GMaxUnusedFrames)
		{
			Elements.RemoveAt(Index);
		}
	}
}

void FRenderTargetPool::FreeUnusedResources()
{
	for (int32 Index = Elements.Num() - 1; Index >= 0; --Index)
	{
		if (Elements[Index]->IsFree())
		{
			Elements.RemoveAt(Index);
		}
	}
}

uint64 FRenderTargetPool::GetSizeInBytes() const
{
	uint64 Bytes = 0;
	for (const TRefCountPtr<FPooledRenderTarget>& Element : Elements)
	{
		Bytes += Element->GetRHI()->GetSizeInBytes();
	}
	return Bytes;
}

TRefCountPtr<IPooledRenderTarget> CreateRenderTarget(FRHITexture* Texture, const TCHAR* Name)
{
	check(Texture);
	return new FPooledRenderTarget(Texture, FPooledRenderTargetDesc(Texture->GetDesc(), Name), nullptr);
}

bool CacheRenderTarget(FRHITexture* Texture, const TCHAR* Name, TRefCountPtr<IPooledRenderTarget>& TargetPtr)
{
	if (TargetPtr.IsValid() && TargetPtr->GetRHI() == Texture)
	{
		return true;
	}
	TargetPtr = CreateRenderTarget(Texture, Name);
	return false;
}
