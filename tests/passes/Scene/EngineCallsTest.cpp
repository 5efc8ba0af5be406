// Calls of the graph and of screen passes that plugins write: what they give, and that they compile as the engine has
// them.
#include "PassTestUtils.h"

#include "PostProcess/PostProcessing.h"
#include "RHIGPUReadback.h"
#include "ShowFlags.h"

using namespace PassTest;

TEST(EngineCalls, UploadDataIsFilledAndUploaded)
{
	FRHIGPUBufferReadback Readback(TEXT("Readback"));
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGBufferRef Buffer =
		GraphBuilder.CreateBuffer(FRDGBufferDesc::CreateUploadDesc(sizeof(int32), 3), TEXT("Numbers"));
	const FRDGUploadData<int32> Data(GraphBuilder, 3);
	EXPECT_EQ(12u, Data.GetTotalSize());
	Data[0] = 4;
	Data[2] = 6;
	GraphBuilder.QueueBufferUpload(Buffer, Data, ERDGInitialDataFlags::NoCopy);
	AddEnqueueCopyPass(GraphBuilder, &Readback, Buffer, 0u);
	GraphBuilder.Execute();
	const int32* const Back = static_cast<const int32*>(Readback.Lock(12));
	EXPECT_EQ((std::vector<int32>{4, 0, 6}), std::vector<int32>(Back, Back + 3));
	Readback.Unlock();
}

TEST(EngineCalls, ViewsOfPlanesAreThoseThatACpuHas)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGTextureRef Depth = GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_DepthStencil, FClearValueBinding::DepthFar,
			TexCreate_DepthStencilTargetable | TexCreate_ShaderResource),
		TEXT("Depth"));
	using EPlane = ERDGTextureMetaDataAccess;
	EXPECT_EQ(PF_X24_G8, FRDGTextureSRVDesc::CreateForMetaData(Depth, EPlane::Stencil).Format);
	EXPECT_EQ(
		FRDGTextureSRVDesc::Create(Depth).Format, FRDGTextureSRVDesc::CreateForMetaData(Depth, EPlane::Depth).Format);
	EXPECT_THROW(FRDGTextureSRVDesc::CreateForMetaData(Depth, EPlane::HTile), Drydock::FCheckFailure);
	GraphBuilder.Execute();
}

TEST(EngineCalls, CopyFromSliceDrawsIntoTheOverride)
{
	const FImage Image = FImage::Noise(8, 6);
	FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	const FScreenPassTextureSlice Slice =
		FScreenPassTextureSlice::CreateFromScreenPassTexture(Run.GraphBuilder, Run.Input);
	EXPECT_EQ(Run.Input, FScreenPassTexture::CopyFromSlice(Run.GraphBuilder, Slice, FScreenPassTexture()));
	const FRDGTextureRef Texture = Run.GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(12, 10), PF_A32B32G32R32F, FClearValueBinding::Black,
			TexCreate_ShaderResource | TexCreate_RenderTargetable),
		TEXT("Override"));
	AddClearRenderTargetPass(Run.GraphBuilder, Texture, FLinearColor(9.0f, 9.0f, 9.0f, 9.0f));
	const FScreenPassTexture Override(Texture, FIntRect(2, 3, 10, 9));
	const FScreenPassTexture Result = FScreenPassTexture::CopyFromSlice(Run.GraphBuilder, Slice, Override);
	EXPECT_EQ(Override, Result);
	EXPECT_EQ(0.0, PassReference::MaxDifference(Image, Run.Execute(Result), 4));
}

TEST(EngineCalls, RectToExtentRatioIsByAxis)
{
	const FScreenPassTextureViewport Viewport(FIntPoint(64, 32), FIntRect(10, 4, 42, 12));
	EXPECT_EQ(FVector2D(0.5, 0.25), Viewport.GetRectToExtentRatio());
}

TEST(EngineCalls, ParametersOfAUniformBufferAreAReference)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const TRDGUniformBufferRef<FSceneTextureUniformParameters> Buffer =
		CreateSceneTextureUniformBuffer(GraphBuilder, static_cast<const FSceneTextures*>(nullptr));
	auto& Parameters = Buffer->GetParameters();
	EXPECT_EQ(&Parameters, &Buffer->GetParameters());
	EXPECT_EQ(Buffer->GetContents()->SceneColorTexture, Parameters->SceneColorTexture);
	GraphBuilder.Execute();
}

TEST(EngineCalls, ViewsAnswerBeforeAFrame)
{
	FSceneViewFamily Family;
	Family.SecondaryViewFraction = 0.5f;
	EXPECT_EQ(SCS_FinalToneCurveHDR, Family.SceneCaptureSource);
	EXPECT_TRUE(Family.EngineShowFlags.Game && Family.EngineShowFlags.Lighting && Family.EngineShowFlags.Rendering);
	EXPECT_FALSE(Family.EngineShowFlags.Wireframe);
	const FViewInfo View(&Family, FIntRect(0, 0, 9, 6), FIntPoint(16, 8), 2.0f);
	EXPECT_EQ(FIntPoint(5, 3), View.GetSecondaryViewRectSize());
	EXPECT_EQ(2.0f, View.CachedViewUniformShaderParameters->PreExposure);
	EXPECT_EQ(0u, View.GetViewKey());
	EXPECT_EQ(0.0f, View.GetLastEyeAdaptationExposure());
	EXPECT_EQ(nullptr, View.ViewActor);
	EXPECT_EQ(INDEX_NONE, View.PlayerIndex);
	EXPECT_EQ(INDEX_NONE, View.StereoViewIndex);
	EXPECT_FALSE(View.bIsOfflineRender || View.bIsSceneCaptureCube);
	EXPECT_THROW(FViewFamilyInfo(Family).GetSceneTextures(), Drydock::FCheckFailure);
}
