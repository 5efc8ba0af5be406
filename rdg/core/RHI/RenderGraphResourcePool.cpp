// Pooled buffers. Source: engine RenderGraphResourcePool.cpp for behaviour.
#include "RenderGraphResourcePool.h"

FRDGBufferPool GRenderGraphResourcePool;

namespace
{

constexpr uint32 GMaxUnusedBufferFrames = 30;

bool IsFree(const TRefCountPtr<FRDGPooledBuffer>& Buffer)
{
	return Buffer.GetRefCount() == 1;
}

} // namespace

TRefCountPtr<FRDGPooledBuffer> FRDGBufferPool::FindFreeBuffer(const FRDGBufferDesc& Desc, const TCHAR* Name)
{
	for (const TRefCountPtr<FRDGPooledBuffer>& Buffer : Buffers)
	{
		if (IsFree(Buffer) && Buffer->Desc == Desc)
		{
			Buffer->NumUnusedFrames = 0;
			Buffer->Name = Name;
			Buffer->Buffer->SetName(FName(Name));
			Buffer->Buffer->ClearCounters();
			return Buffer;
		}
	}
	Buffers.Add(new FRDGPooledBuffer(new FRHIBuffer(Translate(Desc), Name), Desc, Name));
	return Buffers.Last();
}

void FRDGBufferPool::TickPoolElements()
{
	for (int32 Index = Buffers.Num() - 1; Index >= 0; --Index)
	{
		FRDGPooledBuffer& Buffer = *Buffers[Index];
		Buffer.NumUnusedFrames = IsFree(Buffers[Index]) ? Buffer.NumUnusedFrames + 1 : 0;
		if (Buffer.NumUnusedFrames > GMaxUnusedBufferFrames)
		{
			Buffers.RemoveAt(Index);
		}
	}
}

void FRDGBufferPool::FreeUnusedResources()
{
	for (int32 Index = Buffers.Num() - 1; Index >= 0; --Index)
	{
		if (IsFree(Buffers[Index]))
		{
			Buffers.RemoveAt(Index);
		}
	}
}
