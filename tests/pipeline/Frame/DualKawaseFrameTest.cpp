// The dual Kawase blur in a frame: by its settings, by its extension, and what the frame says of it.
#include <gtest/gtest.h>

#include "ExtensionTestUtils.h"

#include "Blur/DualKawaseBlur.h"
#include "Blur/DualKawaseBlurErrors.h"
#include "HAL/ConsoleVariableTools.h"

using namespace Drydock;

using namespace ExtensionTest;

namespace
{

FFrameInputs MakeBlurredFrame(int32 PassNum, float Offset = 1.0f)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Settings.Settings.DualKawaseBlurPassNum = PassNum;
	Inputs.Views[0].Settings.Settings.DualKawaseBlurOffset = Offset;
	return Inputs;
}

const FEffectDecision& FindEffect(const FFrameResult& Frame)
{
	static const FEffectDecision None;
	for (const FEffectDecision& Effect : Frame.Views[0].Effects)
	{
		if (Effect.GetId() == EEffect::DualKawaseBlur)
		{
			return Effect;
		}
	}
	return None;
}

} // namespace

TEST(DualKawaseFrame, IsOffByDefault)
{
	const FFrameResult Frame = Render(MakeFrame());
	EXPECT_FALSE(FindEffect(Frame).bActive);
}

TEST(DualKawaseFrame, SettingsAloneSwitchItOn)
{
	const FFrameResult Sharp = Render(MakeFrame());
	const FFrameResult Blurred = Render(MakeBlurredFrame(2));
	EXPECT_TRUE(FindEffect(Blurred).bActive);
	EXPECT_NE(Sharp.SceneLinear.ToImage().Values, Blurred.SceneLinear.ToImage().Values);
}

TEST(DualKawaseFrame, ExtensionAndSettingsGiveTheSamePictureAndBlurOnce)
{
	const FFrameResult BySettings = Render(MakeBlurredFrame(2, 1.5f));
	const auto Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.5f, 2, false);
	const FFrameResult ByExtension = Render(MakeFrame());
	EXPECT_EQ(BySettings.SceneLinear.ToImage().Values, ByExtension.SceneLinear.ToImage().Values);
	EXPECT_EQ("a view extension makes it", FindEffect(ByExtension).Reason);
	const FFrameResult ByBoth = Render(MakeBlurredFrame(2, 1.5f));
	EXPECT_EQ(BySettings.SceneLinear.ToImage().Values, ByBoth.SceneLinear.ToImage().Values);
}

TEST(DualKawaseFrame, AtTheTonemapPointItBlursTheDisplayedPicture)
{
	const FFrameResult Sharp = Render(MakeFrame());
	const auto Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.0f, 2, false);
	Extension->SetPass(EPoint::Tonemap);
	const FFrameResult Frame = Render(MakeFrame());
	EXPECT_EQ(Sharp.SceneLinear.ToImage().Values, Frame.SceneLinear.ToImage().Values);
	EXPECT_NE(Sharp.Final.ToImage().Values, Frame.Final.ToImage().Values);
	EXPECT_TRUE(Frame.Log.Diagnostics.empty());
}

TEST(DualKawaseFrame, RemarksReachTheFramesLog)
{
	// 24 x 12 has three levels: 12 x 6, 6 x 3, 3 x 2.
	const FFrameResult Frame = Render(MakeBlurredFrame(5));
	ASSERT_FALSE(Frame.Log.Diagnostics.empty());
	EXPECT_EQ(DualKawaseNoteLevels, Frame.Log.Diagnostics[0].Code);
}

TEST(DualKawaseFrame, AsPrintedIgnoresTheOverrideOutputAndTheFrameSaysSo)
{
	const Drydock::FScopedConsoleVariable AsPrinted(TEXT("r.DualKawase.AsPrinted"), TEXT("1"));
	const auto Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(1.0f, 2, false);
	Extension->SetPass(EPoint::Tonemap);
	const FFrameResult Frame = Render(MakeFrame());
	ASSERT_FALSE(Frame.Log.Diagnostics.empty());
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find("OverrideOutput"));
}
