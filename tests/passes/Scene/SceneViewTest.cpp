// The view's uniform buffer, from rect, extent and pre-exposure.
#include "PassTestUtils.h"

#include "ShaderParameterMetadata.h"

using namespace PassTest;

namespace
{

const FViewUniformShaderParameters& Contents(const FViewInfo& View)
{
	return *static_cast<const FViewUniformShaderParameters*>(View.ViewUniformBuffer->GetContents());
}

} // namespace

TEST(ViewUniformBuffer, DescribesRectAndExtent)
{
	const FViewInfo View(nullptr, FIntRect(10, 20, 110, 70), FIntPoint(200, 100), 4.0f);
	const FViewUniformShaderParameters& Parameters = Contents(View);
	EXPECT_EQ(10.0f, Parameters.ViewRectMin.X);
	EXPECT_EQ(20.0f, Parameters.ViewRectMin.Y);
	EXPECT_EQ(FVector4f(100.0f, 50.0f, 0.01f, 0.02f), Parameters.ViewSizeAndInvSize);
	EXPECT_EQ(FVector4f(200.0f, 100.0f, 0.005f, 0.01f), Parameters.BufferSizeAndInvSize);
	EXPECT_FLOAT_EQ(10.5f / 200, Parameters.BufferBilinearUVMinMax.X);
	EXPECT_FLOAT_EQ(69.5f / 100, Parameters.BufferBilinearUVMinMax.W);
}

TEST(ViewUniformBuffer, ScreenPositionMapsToTheRect)
{
	const FViewInfo View(nullptr, FIntRect(10, 20, 110, 70), FIntPoint(200, 100));
	const FVector4f& ScaleBias = Contents(View).ScreenPositionScaleBias;
	// Top left of the screen (-1, 1) is the rect's minimum, bottom right its maximum, as buffer UV.
	EXPECT_FLOAT_EQ(10.0f / 200, -1 * ScaleBias.X + ScaleBias.W);
	EXPECT_FLOAT_EQ(20.0f / 100, 1 * ScaleBias.Y + ScaleBias.Z);
	EXPECT_FLOAT_EQ(110.0f / 200, 1 * ScaleBias.X + ScaleBias.W);
	EXPECT_FLOAT_EQ(70.0f / 100, -1 * ScaleBias.Y + ScaleBias.Z);
}

TEST(ViewUniformBuffer, PreExposureAndItsInverse)
{
	const FViewInfo View(nullptr, FIntRect(0, 0, 4, 4), FIntPoint(4, 4), 4.0f);
	EXPECT_EQ(4.0f, Contents(View).PreExposure);
	EXPECT_EQ(0.25f, Contents(View).OneOverPreExposure);
}

TEST(ViewInfo, IsMarkedForTheCastFromSceneView)
{
	const FViewInfo View(nullptr, FIntRect(0, 0, 4, 4), FIntPoint(4, 4));
	const FSceneView& Base = View;
	EXPECT_TRUE(Base.bIsViewInfo);
	EXPECT_EQ(FIntRect(0, 0, 4, 4), static_cast<const FViewInfo&>(Base).ViewRect);
}

TEST(ViewInfo, PrefersComputeWhenToldTo)
{
	EXPECT_FALSE(FViewInfo().bUseComputePasses);
	const FScopedConsoleVariable PreferCompute(TEXT("r.PostProcessing.PreferCompute"), 1);
	EXPECT_TRUE(FViewInfo().bUseComputePasses);
}

TEST(SceneView, LaterViewsOfAFamilyKeepWhatEarlierOnesDrew)
{
	FSceneViewFamily Family;
	const FViewInfo First(&Family, FIntRect(0, 0, 4, 4), FIntPoint(8, 4));
	const FViewInfo Second(&Family, FIntRect(4, 0, 8, 4), FIntPoint(8, 4));
	Family.Views.Add(&First);
	Family.Views.Add(&Second);
	EXPECT_EQ(ERenderTargetLoadAction::ENoAction, First.GetOverwriteLoadAction());
	EXPECT_EQ(ERenderTargetLoadAction::ELoad, Second.GetOverwriteLoadAction());
}
