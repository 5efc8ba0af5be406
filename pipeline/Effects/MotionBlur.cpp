// Motion blur along the velocities of the scene. Source: engine PostProcess/PostProcessMotionBlur.cpp (conditions); the
// wording and the gate are drydock's.
#include "Effects/ContentGate.h"
#include "Lens/PostProcessMotionBlur.h"
#include "SceneRendering.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim MotionBlurSettings[] = {
	{"MotionBlur"},
	{"MotionBlurPerObjectSize", NoPassReadsIt},
};

/** Unlike the engine, whose default amount is 0.5: a rendered frame may hold motion blur already, so it has to be
 * called for. */
FEffectDecision DecideMotionBlur(const FEffect&, const FEffectInputs& Inputs)
{
	const FFinalPostProcessSettings& Values = Inputs.Settings;
	FEffectDecision Decision;
	Decision.bConfigured = Inputs.IsNamed("MotionBlur");
	const std::string Off = Inputs.FindShowFlagOff(Inputs.Conditions.ShowFlags.MotionBlur, "MotionBlur");
	if (!Decision.bConfigured)
	{
		Decision.Reason = "not called for: nothing in the config sets MotionBlurAmount, Max or TargetFPS";
	}
	else if (!Off.empty())
	{
		Decision.Reason = Off;
	}
	else if (GetMotionBlurQuality() == EMotionBlurQuality::Off)
	{
		Decision.Reason = "r.MotionBlurQuality is 0";
	}
	else
	{
		Decision.bActive = Values.MotionBlurAmount > 0.0f && Values.MotionBlurMax > 0.0f;
		Decision.Reason = "MotionBlurAmount is " + NumberText(Values.MotionBlurAmount) + ", MotionBlurMax " +
						  NumberText(Values.MotionBlurMax);
	}
	return Decision;
}

FContentQuestions AskMotionBlur(const FGateInputs&, const FEffectDecision&)
{
	return {.bStill = true};
}

/** It leaves a picture in which nothing moves by half a pixel as it is. */
void GateMotionBlur(const FGateInputs& Gate, FEffectDecision& MotionBlur)
{
	if (Gate.Content.bStill && *Gate.Content.bStill)
	{
		Skip(MotionBlur, "nothing moves in the view");
	}
}

FScreenPassTexture AddMotionBlurEffect(const FEffectPassInputs& Inputs)
{
	const FViewInfo& View = Inputs.View;
	const float DeltaTime = View.Family != nullptr ? View.Family->Time.GetDeltaWorldTimeSeconds() : 0.0f;
	FMotionBlurInputs Blur =
		FMotionBlurInputs::FromSettings(View.FinalPostProcessSettings, Inputs.SceneColor, DeltaTime);
	Blur.SceneTextures = Inputs.GetSceneTextures();
	return AddMotionBlurPass(Inputs.GraphBuilder, View, Blur);
}

} // namespace

const FEffect GMotionBlurEffect{
	.Id = EEffect::MotionBlur,
	.Name = "MotionBlur",
	.Doc = "Blur along the velocities of the scene.",
	.Settings = MotionBlurSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideMotionBlur,
	.Content = FContentGate{&AskMotionBlur, &GateMotionBlur},
	.Complete = nullptr,
	.GetPlace = [] { return FChainPlace{EChainPlace::MotionBlur}; },
	.AddPasses = &AddMotionBlurEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
