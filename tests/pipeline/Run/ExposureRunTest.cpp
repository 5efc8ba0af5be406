// Automatic exposure and local exposure in whole frames: when they run, what they report, how frames follow each other.
#include <gtest/gtest.h>

#include "Effects/Exposure.h"
#include "ExtensionTestUtils.h"
#include "HAL/IConsoleManager.h"
#include "Run/FinalSettings.h"
#include "Run/Run.h"
#include "SettingObjects.h"
#include "Text/ConfigErrors.h"
#include "Text/Json.h"

#include <cmath>
#include <filesystem>
#include <numeric>

using namespace Drydock;
using ExtensionTest::MakeFrame;
using ExtensionTest::Render;

namespace
{

FFrameInputs MakeAutoFrame()
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Settings.bAutoExposure = true;
	Inputs.Views[0].Settings.Settings.AutoExposureMaxBrightness = 1000.0f;
	return Inputs;
}

FRunResult RunBoxes(const std::string& View, const std::string& Settings,
	const std::vector<std::string>& Variables = {}, bool bExecute = true)
{
	FRunOptions Options;
	Options.ConfigFile = DRYDOCK_TEST_SOURCE_DIR "/configs/text.json";
	Options.ConfigText = R"({"scene": {"file": "scenes/two_boxes.exr"}, "view": {)" + View +
						 R"(}, "volumes": [{"bUnbound": true, "Settings": {)" + Settings + "}}]}";
	Options.Variables = Variables;
	Options.bExecute = bExecute;
	return RunConfig(Options);
}

bool HasPass(const FRunResult& Result, const std::string& Begin)
{
	return std::any_of(Result.Graph.Passes.begin(), Result.Graph.Passes.end(),
		[&](const FRDGCompiledPass& Pass) { return !Pass.bCulled && Pass.Name.starts_with(Begin); });
}

std::string GetReason(const FRunResult& Result, const std::string& Name)
{
	return std::find_if(Result.Effects.begin(), Result.Effects.end(),
		[&](const FEffectDecision& Effect) { return Effect.GetName() == Name; })
		->Reason;
}

FEffectDecision DecideOn(EEffect Id, const FViewSettings& View)
{
	return *FindEffect(DecideEffects(View), Id);
}

FViewSettings AutoChain()
{
	FViewSettings Chain;
	Chain.Settings = StartFinalPostProcessSettings();
	Chain.bAutoExposure = true;
	return Chain;
}

const std::string Auto = R"("exposure": "auto")";

} // namespace

TEST(ExposureRun, ASingleFrameIsConverged)
{
	const FFrameResult Frame = Render(MakeAutoFrame());
	ASSERT_TRUE(Frame.Views[0].Exposure.has_value());
	const FExposureReport& Report = *Frame.Views[0].Exposure;
	EXPECT_EQ("AEM_Histogram", Report.Method);
	EXPECT_EQ(Report.TargetScale, Report.Scale);
	EXPECT_NEAR(0.36f, Report.Scale * Report.AverageLuminance, 1e-5f); // twice middle grey
	EXPECT_NEAR(std::log2(Report.AverageLuminance), Report.EV100, 1e-5f);
	EXPECT_EQ(Report.Scale, Frame.Views[0].ExposureScale);
	const auto& Buckets = Report.Histogram.value().Buckets;
	EXPECT_NEAR(1.0, std::accumulate(Buckets.begin(), Buckets.end(), 0.0), 1e-5);
}

TEST(ExposureRun, TheNextFrameAdaptsFromTheViewsState)
{
	FFrameInputs Inputs = MakeAutoFrame();
	const FFrameResult FirstFrame = Render(Inputs);
	const float First = FirstFrame.Views[0].Exposure->Scale;
	// The same texels with a quarter of the pre-exposure are a scene two stops brighter; at 3 EV per second and 1/24 s.
	Inputs.Views[0].PreExposure = 0.25f;
	Inputs.Time.DeltaWorldTimeSeconds = 1.0f / 24.0f;
	Inputs.ViewStates = FirstFrame.ViewStates;
	const FFrameResult SecondFrame = Render(Inputs);
	const FExposureReport Second = *SecondFrame.Views[0].Exposure;
	// Two stops are 10.5 buckets: the ends of the percentages fall differently.
	EXPECT_NEAR(First / 4.0f, Second.TargetScale, 2e-3f * First);
	EXPECT_NEAR(First * std::exp2(-0.125f), Second.Scale, 1e-4f * First);
	Inputs.Time.DeltaWorldTimeSeconds = 0.25f;
	Inputs.ViewStates = SecondFrame.ViewStates;
	EXPECT_NEAR(Second.Scale * std::exp2(-0.75f), Render(Inputs).Views[0].Exposure->Scale, 1e-4f * First);
}

TEST(ExposureRun, TheCurveCompensatesByTheEV100OfTheAverage)
{
	// The curve is a line: -0.2 EV for each EV100.
	const FFrameInputs Inputs = MakeAutoFrame();
	for (const EAutoExposureMethod Method : {AEM_Histogram, AEM_Basic, AEM_Manual})
	{
		FFrameInputs Plain = Inputs;
		Plain.Views[0].Settings.Settings.AutoExposureMethod = Method;
		Plain.Views[0].Settings.Settings.AutoExposureApplyPhysicalCameraExposure = true;
		FFrameInputs Curved = Plain;
		Curved.Views[0].Settings.Settings.AutoExposureBiasCurve = FindOrAddCurve("linear(-20 4, 20 -4)");
		const FExposureReport Without = *Render(Plain).Views[0].Exposure;
		const FExposureReport With = *Render(Curved).Views[0].Exposure;
		const double Factor = std::exp2(-0.2 * static_cast<double>(Without.EV100));
		EXPECT_EQ(Without.AverageLuminance, With.AverageLuminance) << Without.Method;
		EXPECT_NEAR(1.0, With.Scale / (static_cast<double>(Without.Scale) * Factor), 1e-5) << Without.Method;
		EXPECT_NEAR(1.0, With.TargetScale / (static_cast<double>(Without.TargetScale) * Factor), 1e-5);
		EXPECT_NEAR(1.0, With.Compensation / (static_cast<double>(Without.Compensation) * Factor), 1e-5);
	}
}

TEST(ExposureRun, FromTheSecondFrameOnTheCurveGoesByTheLastOnesAverage)
{
	FFrameInputs Inputs = MakeAutoFrame();
	Inputs.Views[0].Settings.Settings.AutoExposureBiasCurve = FindOrAddCurve("linear(-20 4, 20 -4)");
	const FFrameResult First = Render(Inputs);
	Inputs.Views[0].PreExposure = 0.25f; // two stops brighter
	Inputs.Time.DeltaWorldTimeSeconds = 1.0f / 24.0f;
	Inputs.ViewStates = First.ViewStates;
	const FExposureReport Last = *First.Views[0].Exposure;
	const FExposureReport Second = *Render(Inputs).Views[0].Exposure;
	const double Compensation = 2.0 * std::exp2(-0.2 * static_cast<double>(Last.EV100));
	EXPECT_NEAR(1.0, Second.Compensation / Compensation, 1e-5);
	EXPECT_NEAR(1.0, Second.TargetScale * Second.AverageLuminance / (0.18 * Compensation), 1e-5);
	EXPECT_NEAR(Last.EV100 + 2, Second.EV100, 0.1);
}

TEST(ExposureRun, AConfigGivesTheCurveItsKeys)
{
	const FRunResult Without = RunBoxes(Auto, "");
	const FRunResult With =
		RunBoxes(Auto, R"("AutoExposureBiasCurve": {"keys": [[-20, 1.5], [20, 1.5]], "interp": "constant"})");
	EXPECT_NEAR(std::exp2(1.5), With.ExposureScale / Without.ExposureScale, 1e-5);
	EXPECT_TRUE(With.Diagnostics.empty());
	const FRunResult Asset = RunBoxes(Auto, R"("AutoExposureBiasCurve": "/Game/C.C")");
	EXPECT_EQ(Without.Final.ToImage().Values, Asset.Final.ToImage().Values);
	ASSERT_EQ(1u, Asset.Diagnostics.size());
	EXPECT_EQ(WarnIneffectiveValue, Asset.Diagnostics[0].Code);
	EXPECT_EQ(0u, Asset.Diagnostics[0].Message.find("AutoExposureBiasCurve /Game/C.C has no keys here"));
}

TEST(ExposureRun, WithoutAStateEveryFrameStartsAfresh)
{
	FFrameInputs Inputs = MakeAutoFrame();
	Render(Inputs);
	Inputs.Views[0].PreExposure = 0.25f;
	const FExposureReport Second = *Render(Inputs).Views[0].Exposure;
	EXPECT_EQ(Second.TargetScale, Second.Scale);
}

TEST(ExposureRun, ViewsMeterThemselves)
{
	FFrameInputs Inputs = MakeAutoFrame();
	Inputs.Views[0].Rect = FIntRect(0, 0, 12, 12);
	FFrameView Right = Inputs.Views[0];
	Right.Rect = FIntRect(12, 0, 24, 12);
	Inputs.Views.push_back(Right);
	const FFrameResult Frame = Render(Inputs);
	EXPECT_LT(Frame.Views[0].Exposure->AverageLuminance, Frame.Views[1].Exposure->AverageLuminance);
}

TEST(ExposureRun, EveryMethodRunsAndReports)
{
	EXPECT_TRUE(HasPass(RunBoxes(Auto, ""), "Histogram "));
	const FRunResult Basic = RunBoxes(Auto, R"("AutoExposureMethod": "AEM_Basic")");
	EXPECT_TRUE(HasPass(Basic, "BasicEyeAdaptation "));
	EXPECT_FALSE(HasPass(Basic, "Histogram "));
	EXPECT_FALSE(Basic.Exposure.value().Histogram.has_value());
	const FRunResult Manual = RunBoxes(Auto, R"("AutoExposureMethod": "AEM_Manual")");
	EXPECT_NEAR(2.0f / 960, Manual.ExposureScale, 1e-8f);
	EXPECT_EQ("AEM_Manual: EV100 9.91 by the camera's settings", GetReason(Manual, "Exposure"));
}

TEST(ExposureRun, BasicMeteringExposesAsTheSameNumberDoes)
{
	const FRunResult Basic = RunBoxes(Auto, R"("AutoExposureMethod": "AEM_Basic")");
	const FRunResult Fixed =
		RunBoxes(R"("exposure": )" + std::to_string(Basic.ExposureScale), R"("VignetteIntensity": 0.4)");
	ASSERT_EQ(Fixed.Final.ToImage().Values.size(), Basic.Final.ToImage().Values.size());
	const FImage BasicFinal = Basic.Final.ToImage();
	const FImage FixedFinal = Fixed.Final.ToImage();
	for (size_t Index = 0; Index < BasicFinal.Values.size(); ++Index)
	{
		// The number is written with six digits.
		EXPECT_NEAR(FixedFinal.Values[Index], BasicFinal.Values[Index], 1.01 / 255) << Index;
	}
}

TEST(ExposureRun, TheMeterMaskIsAnImageFile)
{
	const std::string Mask = (std::filesystem::temp_directory_path() / "drydock_exposure_mask.exr").string();
	WriteExr(Mask, {1, 1, 3, {0.0, 0.0, 0.0}}, {"R", "G", "B"});
	// Nothing counts: an empty histogram averages to 1.
	EXPECT_NEAR(1.0f, RunBoxes(Auto, R"("AutoExposureMeterMask": ")" + Mask + '"').Exposure->AverageLuminance, 1e-5f);
	std::filesystem::remove(Mask);
	EXPECT_NE(std::string::npos,
		GetReason(RunBoxes(Auto, R"("AutoExposureMeterMask": "/Game/Mask.Mask")", {}, false), "Exposure")
			.find("AutoExposureMeterMask is not an image file"));
}

TEST(ExposureRun, RunJsonTellsWhatWasMetered)
{
	const FRunResult Result = RunBoxes(Auto, "");
	const std::string& Text = Result.RunJson;
	EXPECT_NE(std::string::npos, Text.find(R"("method": "AEM_Histogram")"));
	EXPECT_NE(std::string::npos, Text.find(R"("buckets": [)"));
	EXPECT_EQ(std::string::npos, RunBoxes(R"("exposure": 1)", "").RunJson.find("\"buckets\""));
}

TEST(ExposureRun, ANumberIgnoresMeteringAndItsVariables)
{
	const FRunResult Plain = RunBoxes(R"("exposure": 1)", "");
	const FRunResult Other = RunBoxes(R"("exposure": 1)", R"("AutoExposureMethod": "AEM_Manual")",
		{"r.EyeAdaptationQuality=0", "r.EyeAdaptation.MethodOverride=2"});
	EXPECT_EQ(Plain.Final.ToImage().Values, Other.Final.ToImage().Values);
	EXPECT_FALSE(HasPass(Plain, "Histogram "));
}

TEST(ExposureRun, MeteringSettingsWarnWhereTheExposureIsANumber)
{
	const auto CountWarnings = [](const std::string& View)
	{
		const FRunResult Result = RunBoxes(View, R"("AutoExposureSpeedUp": 2, "CameraISO": 200)", {}, false);
		return std::count_if(Result.Diagnostics.begin(), Result.Diagnostics.end(),
			[](const FDiagnostic& Diagnostic) { return Diagnostic.Code == WarnIneffectiveValue; });
	};
	EXPECT_EQ(2, CountWarnings(R"("exposure": 1)"));
	EXPECT_EQ(0, CountWarnings(Auto));
}

TEST(ExposureDecision, ShowFlagsAndQualitySwitchAutoOff)
{
	FViewSettings Chain = AutoChain();
	EXPECT_TRUE(IsAutoExposureActive(Chain));
	Chain.ShowFlags.EyeAdaptation = false;
	EXPECT_FALSE(IsAutoExposureActive(Chain));
	EXPECT_EQ("scale 1, not \"auto\": ShowFlag.EyeAdaptation is off", DecideOn(EEffect::Exposure, Chain).Reason);
	IConsoleVariable& Quality = *IConsoleManager::Get().FindConsoleVariable(TEXT("r.EyeAdaptationQuality"));
	Quality.Set(0);
	EXPECT_EQ("scale 1, not \"auto\": r.EyeAdaptationQuality is 0", DecideOn(EEffect::Exposure, AutoChain()).Reason);
	Quality.Set(2);
}

TEST(ExposureDecision, TheMethodIsNamedWithWhatChangedIt)
{
	EXPECT_EQ("AEM_Histogram: AutoExposureMinBrightness 0.03, MaxBrightness 8, AutoExposureBias 1",
		DecideOn(EEffect::Exposure, AutoChain()).Reason);
	IConsoleVariable& Override = *IConsoleManager::Get().FindConsoleVariable(TEXT("r.EyeAdaptation.MethodOverride"));
	Override.Set(2);
	EXPECT_EQ(0u, DecideOn(EEffect::Exposure, AutoChain())
					  .Reason.find("AEM_Basic in place of AEM_Histogram (console variables)"));
	Override.Set(-1);
}

TEST(ExposureRun, ABiasWhoseScaleIsNoNumberIsTheUsersMistake)
{
	for (const char* const Bias : {"200", "-200", "1e9"})
	{
		try
		{
			RunBoxes(R"("exposure": 1)", std::string(R"("AutoExposureBias": )") + Bias);
			FAIL() << Bias;
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitUsage, Error.GetExitCode());
			EXPECT_EQ(1010, Error.GetDiagnostics().at(0).Code);
			EXPECT_EQ("AutoExposureBias", Error.GetDiagnostics().at(0).Where);
		}
		RunBoxes(R"("exposure": "auto")", std::string(R"("AutoExposureBias": )") + Bias);
	}
}

TEST(ExposureRun, APictureBelowTheHistogramSaysThatNothingIsMetered)
{
	const auto IsSaid = [](const char* LogMin)
	{
		const FRunResult Result =
			RunBoxes(R"("exposure": "auto")", std::string(R"("HistogramLogMax": 15, "HistogramLogMin": )") + LogMin);
		return std::any_of(Result.Diagnostics.begin(), Result.Diagnostics.end(),
			[](const FDiagnostic& Each) { return Each.Code == WarnNothingMetered; });
	};
	EXPECT_TRUE(IsSaid("14"));
	EXPECT_FALSE(IsSaid("-8"));
}

TEST(LocalExposureDecision, NeutralValuesDoNotRunAndSayWhy)
{
	FViewSettings Chain = AutoChain();
	EXPECT_FALSE(DecideOn(EEffect::LocalExposure, Chain).bActive);
	EXPECT_FALSE(DecideOn(EEffect::LocalExposure, Chain).bConfigured);
	EXPECT_EQ("its contrast scales and detail strength are 1", DecideOn(EEffect::LocalExposure, Chain).Reason);
	Chain.NamedSettings = {"LocalExposureHighlightThreshold"};
	EXPECT_TRUE(DecideOn(EEffect::LocalExposure, Chain).bConfigured);
	Chain.Settings.LocalExposureShadowContrastScale = 0.5f;
	EXPECT_TRUE(DecideOn(EEffect::LocalExposure, Chain).bActive);
}

TEST(LocalExposureRun, BuildsItsPassesAndChangesThePicture)
{
	const FRunResult Plain = RunBoxes(R"("exposure": 1)", "");
	EXPECT_FALSE(HasPass(Plain, "LocalExposureBilateralGrid"));
	EXPECT_FALSE(HasPass(Plain, "BloomSetup"));
	const FRunResult Local = RunBoxes(R"("exposure": 1)", R"("LocalExposureHighlightContrastScale": 0.5)");
	EXPECT_TRUE(HasPass(Local, "LocalExposureBilateralGrid"));
	EXPECT_TRUE(HasPass(Local, "BlurredLogLuminance"));
	EXPECT_TRUE(HasPass(Local, "BloomSetup"));
	EXPECT_NE(Plain.Final.ToImage().Values, Local.Final.ToImage().Values);
	EXPECT_EQ(Plain.SceneLinear.ToImage().Values, Local.SceneLinear.ToImage().Values);
}

TEST(LocalExposureRun, NeutralValuesKeepEveryBit)
{
	EXPECT_EQ(RunBoxes(R"("exposure": 1)", "").Final.ToImage().Values,
		RunBoxes(R"("exposure": 1)", R"("LocalExposureHighlightContrastScale": 1, "LocalExposureShadowThreshold": 2,
			"LocalExposureDetailStrength": 1, "LocalExposureBlurredLuminanceBlend": 0.1)")
			.Final.ToImage()
			.Values);
}

TEST(LocalExposureRun, VariablesSwitchItOffForBloomAndAltogether)
{
	const std::string Settings = R"("LocalExposureShadowContrastScale": 0.5)";
	const FRunResult NoBloom = RunBoxes(R"("exposure": 1)", Settings, {"r.Bloom.ApplyLocalExposure=0"});
	EXPECT_TRUE(HasPass(NoBloom, "LocalExposureBilateralGrid"));
	EXPECT_FALSE(HasPass(NoBloom, "BloomSetup"));
	const FRunResult Off = RunBoxes(R"("exposure": 1)", Settings, {"r.LocalExposure=0"});
	EXPECT_FALSE(HasPass(Off, "LocalExposureBilateralGrid"));
	EXPECT_EQ("its contrast scales and detail strength are 1: r.LocalExposure is 0", GetReason(Off, "LocalExposure"));
}

TEST(LocalExposureRun, RunsWithoutBloom)
{
	const FRunResult Result =
		RunBoxes(R"("exposure": 1)", R"("BloomIntensity": 0, "LocalExposureShadowContrastScale": 0.5)");
	EXPECT_TRUE(HasPass(Result, "LocalExposureBilateralGrid"));
	EXPECT_FALSE(HasPass(Result, "BloomSetup"));
}
