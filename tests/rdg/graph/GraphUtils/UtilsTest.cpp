// Copies, clears, uploads, read-backs, group counts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rdg/graph/Graph/GraphTestBuilder.h"
#include "RenderGraphUtils.h"
#include "SystemTextures.h"

using namespace Drydock;

namespace
{

FRDGTextureRef MakeColorTexture(FGraphTest& Graph, const char* Name, EPixelFormat Format = PF_FloatRGBA)
{
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Format = Format;
	return Graph.Texture(Name, Desc);
}

FLinearColor GetColor(const FGraphTest& Graph, const char* Name, int32 X, int32 Y)
{
	return Graph.Pooled.at(Name)->GetRHI()->ReadTexel(X, Y);
}

} // namespace

TEST(TextureMSAA, OfOneTextureIsBoth)
{
	FGraphTest Graph;
	const FRDGTextureRef Texture = MakeColorTexture(Graph, "X");
	EXPECT_FALSE(FRDGTextureMSAA().IsValid());
	const FRDGTextureMSAA Pair = Texture;
	EXPECT_TRUE(Pair.IsValid());
	EXPECT_FALSE(Pair.IsSeparate());
	EXPECT_EQ(Texture, Pair.Target);
	EXPECT_EQ(Texture, Pair.Resolve);
	const FRDGTextureMSAA Two(MakeColorTexture(Graph, "Y"), Texture);
	EXPECT_TRUE(Two.IsSeparate());
	const FRDGTextureRef Read = Two;
	EXPECT_EQ(Texture, Read);
}

TEST(Utils, ClearRenderTargetGivesTheColor)
{
	FGraphTest Graph;
	AddClearRenderTargetPass(*Graph.Builder, MakeColorTexture(Graph, "X"), FLinearColor(1, 2, 3, 4));
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(FLinearColor(1, 2, 3, 4), GetColor(Graph, "X", 3, 3));
}

TEST(Utils, ClearRenderTargetWithoutAColorGivesTheClearValue)
{
	FGraphTest Graph;
	AddClearRenderTargetPass(*Graph.Builder, MakeColorTexture(Graph, "X"));
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(FLinearColor(0.25f, 0, 0, 0), GetColor(Graph, "X", 0, 0));
}

TEST(Utils, ClearRenderTargetOfARectLeavesTheRest)
{
	FGraphTest Graph;
	AddClearRenderTargetPass(*Graph.Builder, MakeColorTexture(Graph, "X"), FLinearColor(1, 1, 1, 1));
	AddClearRenderTargetPass(*Graph.Builder, Graph.Texture("X"), FLinearColor(5, 5, 5, 5), FIntRect(1, 1, 3, 2));
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(1.0f, GetColor(Graph, "X", 0, 1).R);
	EXPECT_EQ(5.0f, GetColor(Graph, "X", 1, 1).R);
	EXPECT_EQ(5.0f, GetColor(Graph, "X", 2, 1).R);
	EXPECT_EQ(1.0f, GetColor(Graph, "X", 3, 1).R);
	EXPECT_EQ(1.0f, GetColor(Graph, "X", 1, 2).R);
}

TEST(Utils, ClearUAVStoresWhatTheFormatCanHold)
{
	FGraphTest Graph;
	AddClearUAVPass(*Graph.Builder, Graph.Builder->CreateUAV(MakeColorTexture(Graph, "X", PF_R8G8B8A8)),
		FLinearColor(0.5f, 2, -1, 1));
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(FLinearColor(128.0f / 255.0f, 1, 0, 1), GetColor(Graph, "X", 2, 2));
}

TEST(Utils, ClearUAVClearsItsMipOnly)
{
	FGraphTest Graph;
	FRDGTextureRef X = Graph.Texture("X", 2);
	AddClearUAVPass(*Graph.Builder, Graph.Builder->CreateUAV(FRDGTextureUAVDesc(X, 0)), FLinearColor(1, 0, 0, 0));
	AddClearUAVPass(*Graph.Builder, Graph.Builder->CreateUAV(FRDGTextureUAVDesc(X, 1)), FLinearColor(2, 0, 0, 0));
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(1.0f, Graph.Pixel("X", 0, 0, 0));
	EXPECT_EQ(2.0f, Graph.Pixel("X", 0, 0, 1));
}

TEST(Utils, ClearUAVOfABufferSetsEveryWord)
{
	FGraphTest Graph;
	FRHIGPUBufferReadback Readback(TEXT("R"));
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateBufferDesc(4, 3), TEXT("B"));
	AddClearUAVPass(*Graph.Builder, Graph.Builder->CreateUAV(Buffer, PF_R32_UINT), 7u);
	AddEnqueueCopyPass(*Graph.Builder, &Readback, Buffer, 0);
	Graph.Run();
	const auto* Words = static_cast<const uint32*>(Readback.Lock(12));
	EXPECT_THAT(std::vector<uint32>(Words, Words + 3), testing::ElementsAre(7, 7, 7));
	Readback.Unlock();
}

TEST(Utils, ClearUAVFloatOfABufferSetsEveryFloat)
{
	FGraphTest Graph;
	FRHIGPUBufferReadback Readback(TEXT("R"));
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateBufferDesc(4, 2), TEXT("B"));
	AddClearUAVFloatPass(*Graph.Builder, Graph.Builder->CreateUAV(Buffer, PF_R32_FLOAT), 1.5f);
	AddEnqueueCopyPass(*Graph.Builder, &Readback, Buffer, 8);
	Graph.Run();
	const auto* Values = static_cast<const float*>(Readback.Lock(8));
	EXPECT_THAT(std::vector<float>(Values, Values + 2), testing::ElementsAre(1.5f, 1.5f));
	Readback.Unlock();
}

namespace
{

/** Clears a depth-stencil texture and reads a texel of both planes. */
std::pair<float, int32> ClearDepth(bool bClearDepth, bool bClearStencil)
{
	FGraphTest Graph;
	FRDGTextureRef Depth =
		Graph.Texture("D", FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_DepthStencil, FClearValueBinding::DepthFar,
							   TexCreate_DepthStencilTargetable | TexCreate_ShaderResource));
	AddClearDepthStencilPass(*Graph.Builder, Depth, true, 0.25f, true, 9);
	AddClearDepthStencilPass(*Graph.Builder, Depth, bClearDepth, 0.5f, bClearStencil, 7);
	std::pair<float, int32> Seen;
	AddReadbackTexturePass(*Graph.Builder, RDG_EVENT_NAME("Read"), Depth,
		[&](FRHICommandListImmediate&) {
			Seen = {Depth->GetRHI()->ReadTexel(2, 2).R, *Depth->GetRHI()->GetTexel(2, 2, 0, 0, 1)};
		});
	testing::internal::CaptureStderr();
	Graph.Run();
	EXPECT_EQ("", testing::internal::GetCapturedStderr());
	return Seen;
}

} // namespace

TEST(Utils, ClearDepthStencilClearsBothPlanes)
{
	EXPECT_EQ(std::make_pair(0.5f, 7), ClearDepth(true, true));
}
TEST(Utils, ClearDepthStencilOfDepthKeepsTheStencil)
{
	EXPECT_EQ(std::make_pair(0.5f, 9), ClearDepth(true, false));
}
TEST(Utils, ClearDepthStencilOfStencilKeepsTheDepth)
{
	EXPECT_EQ(std::make_pair(0.25f, 7), ClearDepth(false, true));
}

TEST(Utils, AMistakeInAHelperIsReportedWhereItWasCalled)
{
	FGraphTest Graph;
	const int Line = __LINE__ + 1;
	AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), Graph.Texture("X"));
	try
	{
		Graph.Run();
		ADD_FAILURE();
	}
	catch (const FError& Error)
	{
		EXPECT_THAT(Error.GetDiagnostics()[0].File, testing::EndsWith("UtilsTest.cpp"));
		EXPECT_EQ(Line, Error.GetDiagnostics()[0].Line);
	}
}

TEST(Utils, CopyTextureCopiesTheWhole)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X").Value(3);
	AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), Graph.Texture("Y"));
	Graph.Extract("Y");
	Graph.Run();
	EXPECT_EQ(3.0f, Graph.Pixel("Y", 3, 3));
}

TEST(Utils, CopyTextureCopiesARegion)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X").Value(3);
	Graph.Pass("B").Writes("Y").Value(1);
	AddCopyTexturePass(
		*Graph.Builder, Graph.Texture("X"), Graph.Texture("Y"), FIntPoint(0, 0), FIntPoint(2, 1), FIntPoint(2, 2));
	Graph.Extract("Y");
	Graph.Run();
	EXPECT_EQ(3.0f, Graph.Pixel("Y", 2, 1));
	EXPECT_EQ(3.0f, Graph.Pixel("Y", 3, 2));
	EXPECT_EQ(1.0f, Graph.Pixel("Y", 1, 1));
	EXPECT_EQ(1.0f, Graph.Pixel("Y", 3, 3));
}

TEST(Utils, CopyTextureCopiesAMip)
{
	FGraphTest Graph;
	Graph.Texture("X", 2);
	Graph.Pass("A").Writes("X", 0).Value(1);
	Graph.Pass("B").Writes("X", 1).Value(2);
	Graph.Texture("Y", FGraphTest::MakeDesc(1, 2));
	FRHICopyTextureInfo Info;
	Info.SourceMipIndex = 1;
	AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), Graph.Texture("Y"), Info);
	Graph.Extract("Y");
	Graph.Run();
	EXPECT_EQ(2.0f, Graph.Pixel("Y", 1, 1));
}

TEST(Utils, ACopyDependsOnItsSource)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	AddCopyTexturePass(*Graph.Builder, Graph.Texture("X"), Graph.Texture("Y"));
	const FRDGCompiledGraph Compiled = Graph.Builder->Compile();
	EXPECT_THAT(Compiled.Passes[2].Producers, testing::ElementsAre(1));
	EXPECT_EQ(ERDGPassFlags::Copy, Compiled.Passes[2].Flags);
}

TEST(Utils, CopyBufferCopiesTheRange)
{
	FGraphTest Graph;
	const uint32 Data[] = {1, 2, 3, 4};
	FRHIGPUBufferReadback Readback(TEXT("R"));
	FRDGBufferRef Source = CreateStructuredBuffer(*Graph.Builder, TEXT("S"), 4, 4, Data, sizeof(Data));
	FRDGBufferRef Dest = CreateStructuredBuffer(*Graph.Builder, TEXT("D"), 4, 4, Data, sizeof(Data));
	AddCopyBufferPass(*Graph.Builder, Dest, 0, Source, 8, 8);
	AddEnqueueCopyPass(*Graph.Builder, &Readback, Dest, 0);
	Graph.Run();
	const auto* Words = static_cast<const uint32*>(Readback.Lock(16));
	EXPECT_THAT(std::vector<uint32>(Words, Words + 4), testing::ElementsAre(3, 4, 3, 4));
	Readback.Unlock();
}

TEST(Utils, AStructuredBufferComesWithItsData)
{
	FGraphTest Graph;
	FRHIGPUBufferReadback Readback(TEXT("R"));
	const TArray<float> Data = {1.0f, 2.0f};
	FRDGBufferRef Buffer = CreateStructuredBuffer(*Graph.Builder, TEXT("B"), Data);
	EXPECT_EQ(4u, Buffer->GetStride());
	AddEnqueueCopyPass(*Graph.Builder, &Readback, Buffer, 0);
	Graph.Run();
	EXPECT_EQ(2.0f, static_cast<const float*>(Readback.Lock(8))[1]);
	Readback.Unlock();
}

TEST(Utils, ATextureReadbackIsReadyAfterExecute)
{
	FGraphTest Graph;
	FRHIGPUTextureReadback Readback(TEXT("R"));
	Graph.Pass("A").Writes("X").Value(6);
	AddEnqueueCopyPass(*Graph.Builder, &Readback, Graph.Texture("X"));
	EXPECT_EQ("A", Graph.Run());
	ASSERT_TRUE(Readback.IsReady());
	int32 Pitch = 0;
	EXPECT_EQ(6.0f, static_cast<const float*>(Readback.Lock(Pitch))[Pitch * 3 + 3]);
	Readback.Unlock();
}

TEST(Utils, AnRHITextureIsRegisteredUnderItsName)
{
	FGraphTest Graph;
	const TRefCountPtr<FRHITexture> Texture(new FRHITexture(FGraphTest::MakeDesc(), TEXT("Mine")));
	FRDGTextureRef First = RegisterExternalTexture(*Graph.Builder, Texture, TEXT("Mine"));
	EXPECT_STREQ("Mine", First->Name);
	EXPECT_EQ(First, RegisterExternalTexture(*Graph.Builder, Texture, TEXT("Again")));
}

TEST(Utils, SystemTexturesAreSharedInAGraph)
{
	FGraphTest Graph;
	const FRDGSystemTextures& Textures = FRDGSystemTextures::Get(*Graph.Builder);
	EXPECT_EQ(&Textures, &FRDGSystemTextures::Get(*Graph.Builder));
	EXPECT_EQ(Textures.Black, GSystemTextures.GetBlackDummy(*Graph.Builder));
}

TEST(Utils, SystemTexturesHoldTheirColor)
{
	FGraphTest Graph;
	FLinearColor White;
	FLinearColor Black(9, 9, 9, 9);
	FRDGTextureRef WhiteTexture = FRDGSystemTextures::Get(*Graph.Builder).White;
	FRDGTextureRef BlackTexture = FRDGSystemTextures::Get(*Graph.Builder).Black;
	AddReadbackTexturePass(*Graph.Builder, RDG_EVENT_NAME("White"), WhiteTexture,
		[&](FRHICommandListImmediate&) { White = WhiteTexture->GetRHI()->ReadTexel(0, 0); });
	AddReadbackTexturePass(*Graph.Builder, RDG_EVENT_NAME("Black"), BlackTexture,
		[&](FRHICommandListImmediate&) { Black = BlackTexture->GetRHI()->ReadTexel(0, 0); });
	Graph.Run();
	EXPECT_EQ(FLinearColor(1, 1, 1, 1), White);
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), Black);
}

TEST(Utils, GroupCountsAreRoundedUp)
{
	EXPECT_EQ(FIntVector(13, 1, 1), FComputeShaderUtils::GetGroupCount(100, 8));
	EXPECT_EQ(FIntVector(240, 135, 1),
		FComputeShaderUtils::GetGroupCount(FIntPoint(1919, 1079), FComputeShaderUtils::kGolden2DGroupSize));
	EXPECT_EQ(FIntVector(1, 2, 3), FComputeShaderUtils::GetGroupCount(FIntVector(4, 5, 9), FIntVector(4, 4, 4)));
	EXPECT_EQ(FIntVector(2, 1, 1), FComputeShaderUtils::GetGroupCount(FIntPoint(17, 8), FIntPoint(16, 8)));
}
