// The dual Kawase view extension: where it subscribes, what it makes of its parameters, the settings and the console
// variables, and its factory.
#include "PassTestUtils.h"

#include "DualKawaseBlurReference.h"

#include "Blur/DualKawaseBlur.h"
#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurPass.h"
#include "ExtensionFactory.h"
#include "PassFactory.h"
#include "PostProcess/PostProcessMaterial.h"
#include "RenderGraphNotes.h"

using namespace Drydock;

using namespace PassTest;
using EPass = ISceneViewExtension::EPostProcessingPass;

namespace
{

using FExtensionRef = TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>;

FExtensionRef NewBlur(float Offset, int32 PassNum, bool bUseGaussian = false, float StandardDeviation = 0.0f)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(Offset, PassNum, bUseGaussian);
	Extension->SetStandardDeviation(StandardDeviation);
	return Extension;
}

int NumCallbacks(const FExtensionRef& Extension, EPass Pass)
{
	FAfterPassCallbackDelegateArray Callbacks;
	Extension->SubscribeToPostProcessingPass(Pass, Callbacks, true);
	return Callbacks.Num();
}

/** What the chain does at the motion blur's point. */
FScreenPassTexture CallBack(FPassRun& Run, const FExtensionRef& Extension, const FScreenPassRenderTarget& Override = {})
{
	FAfterPassCallbackDelegateArray Callbacks;
	Extension->SubscribeToPostProcessingPass(EPass::MotionBlur, Callbacks, true);
	FPostProcessMaterialInputs Inputs;
	Inputs.SetInput(Run.GraphBuilder, EPostProcessMaterialInput::SceneColor, Run.Input);
	Inputs.OverrideOutput = Override;
	return Callbacks[0].Execute(Run.GraphBuilder, Run.View, Inputs);
}

FImage RunExtension(const FImage& Image, const FExtensionRef& Extension)
{
	FPassRun Run(Image, EArithmetic::Native);
	return Run.Execute(CallBack(Run, Extension));
}

FImage RunPass(const FImage& Image, int32 PassNum, float Offset, bool bAsPrinted = false)
{
	FPassRun Run(Image, EArithmetic::Native);
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.PassNum = PassNum;
	Inputs.Offset = Offset;
	Inputs.bAsPrinted = bAsPrinted;
	return Run.Execute(AddDualKawaseBlurPass(Run.GraphBuilder, Run.View, Inputs));
}

Drydock::FParameterValues DefaultValues()
{
	return Drydock::FParameterValues(Drydock::FindExtensionFactory("DualKawaseBlur")->Parameters);
}

} // namespace

TEST(DualKawaseExtension, SubscribesAtTheMotionBlurOnly)
{
	const FExtensionRef Extension = NewBlur(1.0f, 3);
	EXPECT_EQ(1, NumCallbacks(Extension, EPass::MotionBlur));
	EXPECT_EQ(0, NumCallbacks(Extension, EPass::Tonemap));
	EXPECT_EQ(0, NumCallbacks(Extension, EPass::SSRInput));
}

TEST(DualKawaseExtension, BlursWithItsOffsetAndLevels)
{
	const FImage Image = FImage::Noise(40, 30);
	EXPECT_EQ(RunPass(Image, 2, 1.5f).Texels, RunExtension(Image, NewBlur(1.5f, 2)).Texels);
}

TEST(DualKawaseExtension, FindsLevelsAndOffsetForAStandardDeviation)
{
	const FImage Image = FImage::Noise(64, 64);
	// 17/6 is the variance of one level at offset 1.
	EXPECT_EQ(RunPass(Image, 1, 1.0f).Texels,
		RunExtension(Image, NewBlur(2.0f, 3, false, static_cast<float>(std::sqrt(17.0 / 6)))).Texels);
}

TEST(DualKawaseExtension, StandardDeviationHasTheLevelsThatThePictureHasRoomFor)
{
	// 12x12 has three levels, 6, 3 and 2 pixels wide: offset 4 gives them a standard deviation of 25 pixels.
	FPassRun Run(FImage::Noise(12, 12), EArithmetic::Native);
	const FScreenPassTexture Output = CallBack(Run, NewBlur(1.0f, 3, false, 100.0f));
	const std::vector<Drydock::FDiagnostic> Notes = Drydock::GetGraphNotes(Run.GraphBuilder);
	ASSERT_FALSE(Notes.empty());
	EXPECT_EQ(Drydock::DualKawaseNoteWidth, Notes[0].Code);
	EXPECT_STREQ("DualKawaseUp1", Output.Texture->Name);
	Run.Execute(Output);
}

TEST(DualKawaseExtension, GaussianHasTheSameWidth)
{
	const FImage Impulse = DualKawaseReference::Impulse(64, 60, 32, 30, 4096);
	const DualKawaseReference::FMoments Moments =
		DualKawaseReference::GetMoments(RunExtension(Impulse, NewBlur(1.0f, 2, true)), 32, 30);
	EXPECT_NEAR(std::sqrt(17.0 / 6 * 5), std::sqrt(Moments.XX / Moments.Sum), 0.003);
}

TEST(DualKawaseExtension, GaussianRunsDirectlyOrInTwoPasses)
{
	const FExtensionRef Extension = NewBlur(1.0f, 1, true);
	for (const bool bSeparable : {false, true})
	{
		const FScopedConsoleVariable Separable(TEXT("r.DualKawase.SeparableGaussian"), bSeparable);
		FPassRun Run(FImage::Noise(16, 16), EArithmetic::Native);
		const FScreenPassTexture Output = CallBack(Run, Extension);
		TRefCountPtr<IPooledRenderTarget> Extracted;
		Run.GraphBuilder.QueueTextureExtraction(Output.Texture, &Extracted);
		int NumPasses = 0;
		for (const auto& Pass : Run.GraphBuilder.Compile().Passes)
		{
			NumPasses += Pass.Name.starts_with("DualKawaseGaussian");
		}
		EXPECT_EQ(bSeparable ? 2 : 1, NumPasses);
		Run.GraphBuilder.Execute();
	}
}

TEST(DualKawaseExtension, SettingsWinOverItsParameters)
{
	const FImage Image = FImage::Noise(40, 30);
	const FImage Expected = RunPass(Image, 1, 1.75f);
	FPassRun Run(Image, EArithmetic::Native);
	Run.View.FinalPostProcessSettings.DualKawaseBlurPassNum = 1;
	Run.View.FinalPostProcessSettings.DualKawaseBlurOffset = 1.75f;
	const FImage Result = Run.Execute(CallBack(Run, NewBlur(1.0f, 3, false, 9.0f)));
	EXPECT_EQ(Expected.Texels, Result.Texels);
}

TEST(DualKawaseExtension, ASettingAtItsDefaultLeavesTheParameter)
{
	const FImage Image = FImage::Noise(40, 30);
	const FImage Expected = RunPass(Image, 1, 0.75f);
	FPassRun Run(Image, EArithmetic::Native);
	Run.View.FinalPostProcessSettings.DualKawaseBlurPassNum = 1;
	const FImage Result = Run.Execute(CallBack(Run, NewBlur(0.75f, 3)));
	EXPECT_EQ(Expected.Texels, Result.Texels);
}

TEST(DualKawaseExtension, AsPrintedIsChosenByTheConsoleVariable)
{
	const FImage Image = FImage::Noise(40, 30);
	const FScopedConsoleVariable AsPrinted(TEXT("r.DualKawase.AsPrinted"), 1);
	EXPECT_EQ(RunPass(Image, 2, 1.0f, true).Texels, RunExtension(Image, NewBlur(1.0f, 2)).Texels);
}

TEST(DualKawaseExtension, AsPrintedUseGaussianHasNoEffect)
{
	// The article's constructor takes the flag and stores it nowhere.
	const FImage Image = FImage::Noise(40, 30);
	const FScopedConsoleVariable AsPrinted(TEXT("r.DualKawase.AsPrinted"), 1);
	EXPECT_EQ(RunPass(Image, 2, 1.0f, true).Texels, RunExtension(Image, NewBlur(1.0f, 2, true)).Texels);
}

TEST(DualKawaseExtension, NoPassLeavesThePictureInEitherForm)
{
	const FImage Image = FImage::Noise(40, 30);
	for (const bool bAsPrinted : {false, true})
	{
		const FScopedConsoleVariable AsPrinted(TEXT("r.DualKawase.AsPrinted"), bAsPrinted);
		EXPECT_EQ(Image.Texels, RunExtension(Image, NewBlur(1.0f, 0)).Texels);
		EXPECT_EQ(Image.Texels, RunExtension(Image, NewBlur(1.0f, 0, true)).Texels);
	}
}

TEST(DualKawaseExtension, DrawsToTheOverrideOutput)
{
	for (const bool bUseGaussian : {false, true})
	{
		FPassRun Run(FImage::Noise(16, 16), EArithmetic::Native);
		const FScreenPassRenderTarget Override = FScreenPassRenderTarget::CreateFromInput(
			Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Override"));
		const FScreenPassTexture Output = CallBack(Run, NewBlur(1.0f, 1, bUseGaussian), Override);
		EXPECT_EQ(Override.Texture, Output.Texture);
		Run.Execute(Output);
	}
}

TEST(DualKawaseExtension, ATinyPictureStaysAsItIs)
{
	const FImage Image = FImage::Noise(2, 2);
	EXPECT_EQ(Image.Texels, RunExtension(Image, NewBlur(1.0f, 3)).Texels);
	EXPECT_EQ(Image.Texels, RunExtension(Image, NewBlur(1.0f, 3, true)).Texels);
	EXPECT_EQ(Image.Texels, RunExtension(Image, NewBlur(1.0f, 3, false, 5.0f)).Texels);
}

TEST(DualKawaseFactory, DefaultsAreTheArticles)
{
	const Drydock::FParameterValues Values = DefaultValues();
	EXPECT_EQ(1.0, Values.GetNumber("Offset"));
	EXPECT_EQ(3, Values.GetInteger("PassNum"));
	EXPECT_FALSE(Values.GetBool("UseGaussian"));
	EXPECT_EQ(0.0, Values.GetNumber("StandardDeviation"));
	EXPECT_EQ("MotionBlur", Drydock::FindExtensionFactory("DualKawaseBlur")->Passes.at(0));
}

TEST(DualKawaseFactory, MakesAnExtensionThatFollowsTheRunsEngineVersion)
{
	const FExtensionRef Extension =
		Drydock::FindExtensionFactory("DualKawaseBlur")->Create({"MotionBlur", DefaultValues()});
	EXPECT_EQ(Drydock::AnyEngineVersion, GEngine->ViewExtensions->FindInfo(*Extension)->EngineMinor);
	EXPECT_EQ("FDualKawaseBlur", GEngine->ViewExtensions->FindInfo(*Extension)->Name);
}

TEST(DualKawaseFactory, HandsItsParametersOn)
{
	Drydock::FParameterValues Values = DefaultValues();
	Values.Set("Offset", 1.25);
	Values.Set("PassNum", 2.0);
	const FImage Image = FImage::Noise(40, 30);
	EXPECT_EQ(RunPass(Image, 2, 1.25f).Texels,
		RunExtension(Image, Drydock::FindExtensionFactory("DualKawaseBlur")->Create({"MotionBlur", Values})).Texels);
}

TEST(DualKawaseFactory, EveryPassIsOneOfTheEngines)
{
	for (const std::string& Name : Drydock::FindExtensionFactory("DualKawaseBlur")->Passes)
	{
		const FExtensionRef Extension =
			Drydock::FindExtensionFactory("DualKawaseBlur")->Create({Name, DefaultValues()});
		ASSERT_TRUE(Drydock::FindPassByName(Name).has_value()) << Name;
		EXPECT_EQ(1, NumCallbacks(Extension, *Drydock::FindPassByName(Name))) << Name;
	}
}

namespace
{

/** The inserted pass at its defaults. */
FImage RunInserted(const FImage& Image, const char* Type)
{
	const Drydock::FPassFactory* Factory = Drydock::FindPassFactory(Type);
	FPassRun Run(Image, EArithmetic::Native);
	Drydock::FPassArguments Arguments;
	Arguments.Inputs["Input"] = Run.Input;
	Arguments.Values = Drydock::FParameterValues(Factory->Parameters);
	return Run.Execute(Factory->Add(Run.GraphBuilder, Run.View, Arguments));
}

} // namespace

TEST(DualKawaseFactory, TheBlurCanBeInsertedByName)
{
	const FImage Image = FImage::Noise(40, 30);
	EXPECT_EQ(RunPass(Image, 3, 1.0f).Texels, RunInserted(Image, "DualKawase").Texels);
}

TEST(DualKawaseFactory, TheGaussianCanBeInsertedByName)
{
	// As wide as three levels at offset 1: variance 17/6 * 21.
	const FImage Impulse = DualKawaseReference::Impulse(64, 60, 32, 30, 65504);
	const DualKawaseReference::FMoments Moments =
		DualKawaseReference::GetMoments(RunInserted(Impulse, "MatchedGaussian"), 32, 30);
	EXPECT_NEAR(std::sqrt(17.0 / 6 * 21), std::sqrt(Moments.XX / Moments.Sum), 0.01);
}
