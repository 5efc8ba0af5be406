// PreExposure that follows the exposure: what each frame of a run is stored with, and that pictures stay the same.
#include <gtest/gtest.h>

#include "Run/Run.h"

#include <cmath>

using namespace Drydock;

namespace
{

FRunOptions Boxes(const std::string& View)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/test.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/two_boxes.exr"}, "view": {)" + View +
						 R"(}, "camera": {"Settings": {"BloomIntensity": 0, "VignetteIntensity": 0}}})";
	return Options;
}

double GetPreExposure(const FRunResult& Result)
{
	return Result.Config.View.PreExposure.Value;
}

/** Pixels whose display code is another one, and that none is another by more than a code. */
double CountOtherCodes(const FPicture& PictureA, const FPicture& PictureB)
{
	const FImage A = PictureA.ToImage(), B = PictureB.ToImage();
	size_t Others = 0;
	for (size_t Index = 0; Index < A.Values.size(); ++Index)
	{
		const double Codes = std::abs(A.Values[Index] - B.Values[Index]) * 255.0;
		EXPECT_LE(Codes, 1.001);
		Others += Codes > 0.5 ? 1 : 0;
	}
	return static_cast<double>(Others) / static_cast<double>(A.Values.size());
}

} // namespace

TEST(PreExposure, FollowsTheFrameBefore)
{
	FRunSession Session(Boxes(R"("exposure": "auto", "preExposure": "auto")"));
	const FRunResult First = Session.Run(std::nullopt, {});
	const FRunResult Second = Session.Run(std::nullopt, First.ViewStates);
	const float Scale = First.Exposure.value().Scale;
	EXPECT_EQ(1.0, GetPreExposure(First));
	EXPECT_GT(std::abs(std::log2(Scale)), 0.25f); // or there is nothing to see here
	EXPECT_EQ(static_cast<double>(Scale), GetPreExposure(Second));
	const FImage FirstSceneLinear = First.SceneLinear.ToImage();
	const FImage SecondSceneLinear = Second.SceneLinear.ToImage();
	for (size_t Index = 0; Index < FirstSceneLinear.Values.size(); Index += 4)
	{
		const double Expected = FirstSceneLinear.Values[Index] * static_cast<double>(Scale);
		ASSERT_NEAR(Expected, SecondSceneLinear.Values[Index], std::ldexp(Expected, -11) + 1e-7);
	}
}

TEST(PreExposure, LeavesThePictureAsItIs)
{
	FRunSession Session(Boxes(R"("exposure": "auto", "preExposure": "auto")"));
	const FRunResult First = Session.Run(std::nullopt, {});
	const FRunResult Second = Session.Run(std::nullopt, First.ViewStates);
	// Stored with another scale, half floats round otherwise.
	EXPECT_LT(CountOtherCodes(First.Final, Second.Final), 0.02);
}

TEST(PreExposure, OfAFixedExposureIsThatScale)
{
	const FRunResult Result = RunConfig(Boxes(R"("exposure": 0.25, "preExposure": "auto")"));
	EXPECT_EQ(static_cast<double>(Result.ExposureScale), GetPreExposure(Result));
	EXPECT_EQ(0.25, GetPreExposure(Result));
	EXPECT_EQ(RunConfig(Boxes(R"("exposure": 0.25, "preExposure": 0.25)")).Final.ToImage().Values,
		Result.Final.ToImage().Values);
}

TEST(PreExposure, VariableBeatsAuto)
{
	FRunOptions Options = Boxes(R"("exposure": 0.25, "preExposure": "auto")");
	Options.Variables = {"r.EyeAdaptation.PreExposureOverride=2"};
	EXPECT_EQ(2.0, GetPreExposure(RunConfig(Options)));
}
