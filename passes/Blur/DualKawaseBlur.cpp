// The dual Kawase view extension, its console variables and its factory.
#include "Blur/DualKawaseBlur.h"

#include "Blur/DualKawaseBlurErrors.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Blur/MatchedGaussianBlur.h"
#include "ExtensionFactory.h"
#include "HAL/IConsoleManager.h"
#include "PostProcess/PostProcessMaterialInputs.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphNotes.h"
#include "SceneRendering.h"
#include "ScreenPass.h"

#include <string>

namespace Drydock
{

namespace
{

TAutoConsoleVariable<int32> CVarSeparableGaussian(TEXT("r.DualKawase.SeparableGaussian"), 0,
	TEXT("How the dual Kawase extension's UseGaussian blurs. 0: directly, with all taps of a square, as in the article "
		 "(default); 1: rows, then columns."),
	ECVF_RenderThreadSafe);

void NoteWidth(FRDGBuilder& GraphBuilder, float Wanted, double Reached)
{
	FDiagnostic Note;
	Note.Severity = ESeverity::Warning;
	Note.Code = DualKawaseNoteWidth;
	Note.Where = "DualKawaseBlur";
	Note.Message = "no levels and offset give a standard deviation of " + std::to_string(Wanted) +
				   " pixels to a picture of this size; the nearest is " + std::to_string(Reached);
	AddGraphNote(GraphBuilder, Note);
}

TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> CreateExtension(const FExtensionArguments& Arguments)
{
	const FParameterValues& Values = Arguments.Values;
	TSharedRef<FDualKawaseBlur, ESPMode::ThreadSafe> Extension = FSceneViewExtensions::NewExtension<FDualKawaseBlur>(
		Values.GetFloat("Offset"), Values.GetInteger("PassNum"), Values.GetBool("UseGaussian"));
	Extension->SetStandardDeviation(Values.GetFloat("StandardDeviation"));
	if (const auto Pass = FindPassByName(Arguments.Pass))
	{
		Extension->SetPass(*Pass);
	}

	FExtensionInfo Info = *GEngine->ViewExtensions->FindInfo(*Extension);
	Info.EngineMinor = AnyEngineVersion;
	GEngine->ViewExtensions->SetInfo(*Extension, Info);
	return Extension;
}

const FExtensionFactoryRegistration GDualKawaseFactory({
	.Type = "DualKawaseBlur",
	.Doc = "Blurs the picture: halves it PassNum times and doubles it again.",
	.Passes = {"MotionBlur", "SSRInput", "Tonemap", "FXAA", "VisualizeDepthOfField", "BeforeDOF", "AfterDOF"},
	.Parameters =
		{
			FParameterSpec::Number(
				"Offset", 1, 0, 8, "Distance of the taps; 1 is the published filter, above 2 shows blocks."),
			FParameterSpec::Integer("PassNum", 3, 0, GDualKawaseMaxPasses,
				"Levels down, and as many up; each doubles the width, 0: no blur."),
			FParameterSpec::Bool(
				"UseGaussian", false, "A Gaussian of the same width instead, to compare with; no effect as printed."),
			FParameterSpec::Number("StandardDeviation", 0, 0, 1000,
				"Width in pixels, for which levels and offset are found; 0: Offset and PassNum hold."),
		},
	.Create = CreateExtension,
});

} // namespace

FDualKawaseBlur::FDualKawaseBlur(
	const FAutoRegister& AutoRegister, float InOffset, int32 InPassNum, bool bInUseGaussian)
	: FSceneViewExtensionBase(AutoRegister)
	, Offset(InOffset)
	, PassNum(InPassNum)
	, bUseGaussian(bInUseGaussian)
{
}

void FDualKawaseBlur::SubscribeToPostProcessingPass(
	EPostProcessingPass InPass, FAfterPassCallbackDelegateArray& Callbacks, bool)
{
	if (InPass == Pass)
	{
		Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FDualKawaseBlur::AddPasses));
	}
}

FDualKawaseSetting FDualKawaseBlur::ChooseSetting(
	FRDGBuilder& GraphBuilder, const FSceneView& View, FIntPoint Size) const
{
	const FPostProcessSettings Defaults;
	const FPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const bool bHasPassNum = Settings.DualKawaseBlurPassNum != Defaults.DualKawaseBlurPassNum;
	const bool bHasOffset = Settings.DualKawaseBlurOffset != Defaults.DualKawaseBlurOffset;
	if (bHasPassNum || bHasOffset || !(StandardDeviation > 0.0f))
	{
		return {bHasPassNum ? Settings.DualKawaseBlurPassNum : PassNum,
			bHasOffset ? Settings.DualKawaseBlurOffset : Offset};
	}
	const int32 MaxPasses = GetDualKawaseLevelSizes(Size, GDualKawaseMaxPasses).Num() - 1;
	const FDualKawaseMatch Match = MatchDualKawaseWidth(StandardDeviation, MaxPasses);
	if (!Match.bReached)
	{
		NoteWidth(GraphBuilder, StandardDeviation, Match.StandardDeviation);
	}
	return Match.Setting;
}

FScreenPassTexture FDualKawaseBlur::AddPasses(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	check(View.bIsViewInfo);
	const Drydock::FRDGEffectScope EffectScope(GraphBuilder, "DualKawaseBlur");
	const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
	const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	const FIntPoint Size = SceneColor.ViewRect.Size();
	const FDualKawaseSetting Setting = ChooseSetting(GraphBuilder, View, Size);
	const bool bAsPrinted = IsDualKawaseAsPrinted();
	const int32 Levels =
		GetDualKawaseLevelSizes(Size, FMath::Clamp(Setting.PassNum, 0, GDualKawaseMaxPasses)).Num() - 1;

	if (bUseGaussian && !bAsPrinted && Levels > 0)
	{
		FMatchedGaussianBlurInputs PassInputs;
		PassInputs.SceneColor = SceneColor;
		PassInputs.OverrideOutput = Inputs.OverrideOutput;
		PassInputs.StandardDeviation = GetDualKawaseStandardDeviation(Levels, Setting.Offset);
		PassInputs.bSeparable = CVarSeparableGaussian.GetValueOnRenderThread() != 0;
		return AddMatchedGaussianBlurPasses(GraphBuilder, ViewInfo, PassInputs);
	}

	FDualKawaseBlurInputs PassInputs;
	PassInputs.SceneColor = SceneColor;
	PassInputs.OverrideOutput = Inputs.OverrideOutput;
	PassInputs.Offset = static_cast<float>(Setting.Offset);
	PassInputs.PassNum = Setting.PassNum;
	PassInputs.bAsPrinted = bAsPrinted;
	return AddDualKawaseBlurPass(GraphBuilder, ViewInfo, PassInputs);
}

} // namespace Drydock
