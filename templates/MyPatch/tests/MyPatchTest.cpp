// MyPatch on small made-up frames, through every hook that the engine calls in a frame.
#include <gtest/gtest.h>

#include "DrydockFrame.h"
#include "HAL/IConsoleManager.h"

namespace
{

// The picture has eight bits a channel: half a step each way.
constexpr float Tolerance = 0.5f / 255.0f + 1e-6f;

/** A black frame, of which the view is 8 x 8 pixels; black stays black in the tonemapper. */
Drydock::FFrameDesc MakeBlackFrame(FIntPoint Extent, FIntRect ViewRect)
{
	Drydock::FFrameDesc Desc;
	Desc.Extent = Extent;
	Desc.ViewRect = ViewRect;
	for (int32 Index = 0; Index < Extent.X * Extent.Y; ++Index)
	{
		Desc.SceneColor.Add(FLinearColor(0.0f, 0.0f, 0.0f, 1.0f));
	}
	return Desc;
}

/** The pixel of a view 8 pixels wide. */
FLinearColor GetPixel(const Drydock::FFrameOutput& Output, int32 X, int32 Y)
{
	return Output.Color[Y * 8 + X];
}

class MyPatchTest : public testing::Test
{
protected:
	void SetUp() override { SetIntensity(1.0f); }
	static void SetIntensity(float Intensity)
	{
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.MyPatch.Intensity"))->Set(Intensity);
	}
};

} // namespace

TEST_F(MyPatchTest, ACornerIsTinted)
{
	const Drydock::FFrameOutput Output = Drydock::RenderFrame(MakeBlackFrame(FIntPoint(8, 8), FIntRect(0, 0, 8, 8)));

	// The centre of pixel (0, 0) is 1/16 of the view's size from its corner, 7/16 from its middle, both ways:
	// the weight is 2 * (49 + 49) / 256 = 49/64. On black it is the tint's share of the pixel.
	const FLinearColor Corner = GetPixel(Output, 0, 0);
	EXPECT_NEAR(0.5f * 49.0f / 64.0f, Corner.R, Tolerance);
	EXPECT_NEAR(0.1f * 49.0f / 64.0f, Corner.G, Tolerance);
	EXPECT_NEAR(1.0f * 49.0f / 64.0f, Corner.B, Tolerance);
}

TEST_F(MyPatchTest, TheMiddleIsNearlyAsItWas)
{
	const Drydock::FFrameOutput Output = Drydock::RenderFrame(MakeBlackFrame(FIntPoint(8, 8), FIntRect(0, 0, 8, 8)));

	// 1/16 from the middle, both ways: 2 * (1 + 1) / 256 = 1/64.
	EXPECT_NEAR(1.0f / 64.0f, GetPixel(Output, 4, 4).B, Tolerance);
}

// The most frequent fault in the engine: a view that is only a part of its texture.
TEST_F(MyPatchTest, TheMiddleIsThatOfTheView)
{
	const Drydock::FFrameOutput Output =
		Drydock::RenderFrame(MakeBlackFrame(FIntPoint(24, 16), FIntRect(13, 5, 21, 13)));

	EXPECT_NEAR(49.0f / 64.0f, GetPixel(Output, 0, 0).B, Tolerance);
	EXPECT_NEAR(1.0f / 64.0f, GetPixel(Output, 4, 4).B, Tolerance);
	EXPECT_NEAR(49.0f / 64.0f, GetPixel(Output, 7, 7).B, Tolerance);
}

TEST_F(MyPatchTest, IntensityZeroSwitchesItOff)
{
	SetIntensity(0.0f);
	const Drydock::FFrameOutput Output = Drydock::RenderFrame(MakeBlackFrame(FIntPoint(8, 8), FIntRect(0, 0, 8, 8)));

	EXPECT_EQ(0.0f, GetPixel(Output, 0, 0).B);
}
