// Directions in four bytes, and the fence of render commands.
#include <gtest/gtest.h>

#include "PackedNormal.h"
#include "RenderingThread.h"

TEST(PackedNormal, KeepsDirectionsToABytesStep)
{
	const FPackedNormal Normal(FVector3f(1.0f, -0.5f, 2.0f));
	EXPECT_EQ(127, Normal.Vector.X);
	EXPECT_EQ(-63, Normal.Vector.Y); // -63.5: halves go up
	EXPECT_EQ(127, Normal.Vector.Z);
	EXPECT_EQ(127, Normal.Vector.W);
	EXPECT_EQ(4u, sizeof(FPackedNormal));
	EXPECT_TRUE(FVector(1.0, -63.0 / 127.0, 1.0).Equals(Normal.ToFVector(), 1e-6));
	EXPECT_EQ(-127, FPackedNormal(FVector4f(0.0f, 0.0f, 0.0f, -1.0f)).Vector.W);
}

TEST(RenderCommandFence, IsCompleteOnceCommandsAreEnqueued)
{
	bool bRan = false;
	FRenderCommandFence Fence;
	ENQUEUE_RENDER_COMMAND(Test)([&bRan](FRHICommandListImmediate&) { bRan = true; });
	Fence.BeginFence();
	EXPECT_TRUE(Fence.IsFenceComplete());
	Fence.Wait();
	EXPECT_TRUE(bRan);
}
