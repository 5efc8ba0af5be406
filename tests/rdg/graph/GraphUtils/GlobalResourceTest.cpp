// Resources that live as long as the program: made when the first graph begins, once.
#include <gtest/gtest.h>

#include "RenderGraphBuilder.h"
#include "RenderResource.h"

using namespace Drydock;

TEST(GlobalResource, IsMadeBeforeTheFirstGraphThatFindsIt)
{
	struct FCounted : public FVertexBuffer
	{
		void InitRHI(FRHICommandListBase& RHICmdList) override
		{
			++NumMade;
			VertexBufferRHI = RHICmdList.CreateVertexBuffer(16, BUF_Static, FRHIResourceCreateInfo(TEXT("Counted")));
		}
		int32 NumMade = 0;
	};
	TGlobalResource<FCounted> Resource;
	EXPECT_EQ(0, Resource.NumMade);
	for (int32 i = 0; i < 2; ++i)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
		EXPECT_EQ(1, Resource.NumMade);
		EXPECT_EQ(16u, Resource.VertexBufferRHI->GetSize());
		GraphBuilder.Execute();
	}
}
