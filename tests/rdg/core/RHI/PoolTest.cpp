// Pools hand out what is free, and read-backs what was written.
#include <cstring>

#include "Containers/DynamicRHIResourceArray.h"
#include "RHITestHelpers.h"
#include "RenderGraphResourcePool.h"
#include "RenderTargetPool.h"
#include "RenderingThread.h"

using namespace Drydock;
using namespace Drydock::Tests;

TEST(RenderTargetPool, AFreeElementOfTheSameDescriptionIsUsedAgain)
{
	FRenderTargetPool Pool;
	TRefCountPtr<IPooledRenderTarget> Target = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"));
	FRHITexture* const Texture = Target->GetRHI();
	Target = nullptr;
	Target = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("B"));
	EXPECT_EQ(Texture, Target->GetRHI());
	EXPECT_STREQ("B", *Texture->GetName().ToString());
	EXPECT_EQ(1, Pool.GetNumElements());
}

TEST(RenderTargetPool, AnElementInUseIsNot)
{
	FRenderTargetPool Pool;
	const TRefCountPtr<IPooledRenderTarget> A = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"));
	const TRefCountPtr<IPooledRenderTarget> B = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("B"));
	EXPECT_NE(A->GetRHI(), B->GetRHI());
	EXPECT_FALSE(A->IsFree());
}

TEST(RenderTargetPool, DescriptionsMatchExactly)
{
	FRenderTargetPool Pool;
	FRHITexture* const A = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"))->GetRHI();
	EXPECT_NE(A, Pool.FindFreeElement(Make2D(FIntPoint(8, 9), PF_FloatRGBA), TEXT("A"))->GetRHI());
	EXPECT_NE(A, Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_R16F), TEXT("A"))->GetRHI());
	EXPECT_EQ(A, Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"))->GetRHI());
}

TEST(RenderTargetPool, AnotherStorageIsAnotherTexture)
{
	FRenderTargetPool Pool;
	FRHITexture* const Native = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"))->GetRHI();
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	EXPECT_NE(Native, Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"))->GetRHI());
}

TEST(RenderTargetPool, AFittingReferenceIsKept)
{
	FRenderTargetPool Pool;
	TRefCountPtr<IPooledRenderTarget> Target;
	EXPECT_FALSE(Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), Target, TEXT("A")));
	FRHITexture* const Texture = Target->GetRHI();
	EXPECT_TRUE(Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), Target, TEXT("B")));
	EXPECT_EQ(Texture, Target->GetRHI());
	EXPECT_FALSE(Pool.FindFreeElement(Make2D(FIntPoint(4, 8), PF_FloatRGBA), Target, TEXT("C")));
	EXPECT_EQ(4, Target->GetDesc().Extent.X);
}

TEST(RenderTargetPool, ElementsUnusedForSomeFramesGo)
{
	FRenderTargetPool Pool;
	const TRefCountPtr<IPooledRenderTarget> Held =
		Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"));
	Pool.FindFreeElement(Make2D(FIntPoint(4, 4), PF_FloatRGBA), TEXT("B"));
	for (int32 Frame = 0; Frame < 100; ++Frame)
	{
		Pool.TickPoolElements();
	}
	EXPECT_EQ(1, Pool.GetNumElements());
	EXPECT_EQ(Held->GetRHI()->GetSizeInBytes(), Pool.GetSizeInBytes());
}

TEST(RenderTargetPool, AnElementInUseOutlivesThePool)
{
	TRefCountPtr<IPooledRenderTarget> Target;
	{
		FRenderTargetPool Pool;
		Target = Pool.FindFreeElement(Make2D(FIntPoint(8, 8), PF_FloatRGBA), TEXT("A"));
	}
	EXPECT_EQ(1u, Target->GetRefCount());
	EXPECT_EQ(8u, Target->GetRHI()->GetSizeX());
}

TEST(RenderTargetPool, AWrappedTextureIsUntracked)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(8, 4), PF_R16F);
	TRefCountPtr<IPooledRenderTarget> Target = CreateRenderTarget(Texture, TEXT("Wrapped"));
	EXPECT_EQ(Texture.GetReference(), Target->GetRHI());
	EXPECT_EQ(FIntPoint(8, 4), Target->GetDesc().Extent);
	EXPECT_FALSE(Target->IsTracked());
	EXPECT_FALSE(Target->IsFree());
	EXPECT_TRUE(CacheRenderTarget(Texture, TEXT("Wrapped"), Target));
	EXPECT_FALSE(CacheRenderTarget(MakeTexture(FIntPoint(1, 1), PF_R16F), TEXT("Other"), Target));
}

TEST(BufferPool, AFreeBufferIsUsedAgain)
{
	FRDGBufferPool Pool;
	TRefCountPtr<FRDGPooledBuffer> Buffer = Pool.FindFreeBuffer(FRDGBufferDesc::CreateStructuredDesc(16, 4), TEXT("A"));
	FRHIBuffer* const First = Buffer->GetRHI();
	EXPECT_NE(First, Pool.FindFreeBuffer(FRDGBufferDesc::CreateStructuredDesc(16, 4), TEXT("B"))->GetRHI());
	Buffer = nullptr;
	EXPECT_EQ(First, Pool.FindFreeBuffer(FRDGBufferDesc::CreateStructuredDesc(16, 4), TEXT("C"))->GetRHI());
}

TEST(BufferPool, DescriptionsSayTheSize)
{
	EXPECT_EQ(64u, FRDGBufferDesc::CreateStructuredDesc(16, 4).GetSize());
	EXPECT_EQ(12u, FRDGBufferDesc::CreateIndirectDesc(3).GetSize());
	EXPECT_EQ(40u, FRDGBufferDesc::CreateByteAddressDesc(40).GetSize());
	EXPECT_EQ(16u, Translate(FRDGBufferDesc::CreateStructuredDesc(16, 4)).Stride);
	EXPECT_EQ(0u, Translate(FRDGBufferDesc::CreateBufferDesc(16, 4)).Stride);
}

TEST(Readback, ABufferIsReadyAtOnceAndIsACopy)
{
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(4, 16, BUF_None, TEXT("Test"));
	FRHIGPUBufferReadback Readback(TEXT("Readback"));
	EXPECT_FALSE(Readback.IsReady());
	Buffer->GetData()[5] = 42;
	Readback.EnqueueCopy(FRHICommandListExecutor::GetImmediateCommandList(), Buffer, 8);
	Buffer->GetData()[5] = 0;
	EXPECT_TRUE(Readback.IsReady());
	EXPECT_EQ(42, static_cast<const uint8*>(Readback.Lock(8))[5]);
	Readback.Unlock();
	EXPECT_THROW(Readback.Lock(9), FCheckFailure);
}

TEST(Readback, ATextureComesInItsOwnFormat)
{
	const FScopedCVar Storage(TEXT("r.Drydock.Storage"), 2);
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(3, 2), PF_R16F);
	Texture->WriteTexel(2, 1, FLinearColor(0.5f, 0, 0, 0));
	FRHIGPUTextureReadback Readback(TEXT("Readback"));
	Readback.EnqueueCopy(FRHICommandListExecutor::GetImmediateCommandList(), Texture);
	int32 Pitch;
	int32 Height;
	const uint16* const Data = static_cast<const uint16*>(Readback.Lock(Pitch, &Height));
	EXPECT_EQ(3, Pitch);
	EXPECT_EQ(2, Height);
	EXPECT_EQ(0x3800, Data[5]);
	Readback.Unlock();
}

TEST(Readback, APartOfATexture)
{
	const FTextureRHIRef Texture = MakeTexture(FIntPoint(3, 2), PF_R8_UINT);
	Texture->WriteTexelUint(2, 1, FUintVector4(9, 0, 0, 0));
	FRHIGPUTextureReadback Readback(TEXT("Readback"));
	Readback.EnqueueCopy(
		FRHICommandListExecutor::GetImmediateCommandList(), Texture, FIntVector(1, 1, 0), 0, FIntVector(2, 1, 1));
	EXPECT_EQ(9, static_cast<const uint8*>(Readback.Lock(0))[1]);
	Readback.Unlock();
}

TEST(ResourceArray, IsABuffersFirstContents)
{
	TResourceArray<uint32> Words;
	Words.Add(3);
	Words.Add(5);
	const FRHIResourceCreateInfo Info(TEXT("Test"), &Words);
	const FBufferRHIRef Buffer = RHICreateStructuredBuffer(4, 8, BUF_ShaderResource, Info);
	EXPECT_EQ(5, Buffer->GetData()[4]);
}

TEST(RenderingThread, CommandsRunWhereTheyAreEnqueued)
{
	int32 Value = 0;
	ENQUEUE_RENDER_COMMAND(SetValue)
	([&Value](FRHICommandListImmediate& RHICmdList) { Value = RHICmdList.IsImmediate() ? 7 : 0; });
	EXPECT_EQ(7, Value);
}
