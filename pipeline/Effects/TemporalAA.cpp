// Temporal antialiasing of the scene's colour. Source: engine PostProcess/PostProcessing.cpp (conditions, place in the
// chain); the wording is drydock's.
#include "Effects/Effect.h"
#include "HAL/IConsoleManager.h"
#include "SceneRendering.h"
#include "SceneViewState.h"
#include "Screen/TemporalAA.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

FEffectDecision DecideTemporalAA(const FEffect&, const FEffectInputs& Inputs)
{
	const int32 Method = IConsoleManager::Get().FindConsoleVariable(TEXT("r.AntiAliasingMethod"))->GetInt();
	const std::string Variable = "r.AntiAliasingMethod is " + std::to_string(Method);
	FEffectDecision Decision;
	Decision.bConfigured = Method == AAM_TemporalAA || Method == AAM_TSR;
	Decision.Reason = Variable;
	if (!Decision.bConfigured)
	{
		return Decision;
	}
	if (const std::string Off = Inputs.FindShowFlagOff(Inputs.Conditions.ShowFlags.AntiAliasing, "AntiAliasing");
		!Off.empty())
	{
		Decision.Reason = Off;
	}
	else if (!Inputs.Conditions.ShowFlags.TemporalAA)
	{
		Decision.Reason = "ShowFlag.TemporalAA is off";
	}
	else
	{
		Decision.bActive = true;
		Decision.Reason += Method == AAM_TSR ? " (TSR), for which temporal antialiasing stands in" : "";
		Decision.Reason +=
			", r.TemporalAACurrentFrameWeight " + NumberText(FTemporalAAInputs::FromVariables().CurrentFrameWeight);
	}
	return Decision;
}

FScreenPassTexture AddTemporalAAEffect(const FEffectPassInputs& Inputs)
{
	FSceneViewState* const State = Inputs.View.ViewState;
	FTemporalAAInputs TemporalAA = FTemporalAAInputs::FromVariables();
	TemporalAA.SceneColor = Inputs.SceneColor;
	TemporalAA.SceneTextures = Inputs.GetSceneTextures();
	TemporalAA.ExposureScale = Inputs.ExposureScale;
	if (State != nullptr && !Inputs.View.bCameraCut)
	{
		TemporalAA.History = State->RegisterLastTexture(Inputs.GraphBuilder, TemporalAAHistoryName);
	}
	const FTemporalAAOutputs Outputs = AddTemporalAAPass(Inputs.GraphBuilder, Inputs.View, TemporalAA);
	if (State != nullptr)
	{
		State->KeepTexture(Inputs.GraphBuilder, TemporalAAHistoryName, Outputs.History);
	}
	return Outputs.SceneColor;
}

} // namespace

const FEffect GTemporalAAEffect{
	.Id = EEffect::TemporalAA,
	.Name = "TemporalAA",
	.Doc = "Average the jittered frames of a sequence along their movement.",
	.Settings = NoSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideTemporalAA,
	.Content = FContentGate{},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::TemporalAA}; },
	.AddPasses = &AddTemporalAAEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
