// The glow around characters, by the widened character mask. Source: docs/effects.md (the article); the gate is
// drydock's.
#include "Effects/ContentGate.h"
#include "Effects/REDPlace.h"
#include "Effects/Switches.h"
#include "SceneRendering.h"
#include "Toon/CharaGlow.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim Settings[] = {{"CharaGlow"}};

constexpr FSwitch Switches[] = {{"CharaGlowArea", &FPostProcessSettings::CharaGlowArea, 0.0f}};

FEffectDecision Decide(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, Switches, DescribeREDPlace());
}

FContentQuestions Ask(const FGateInputs&, const FEffectDecision&)
{
	FContentQuestions Questions;
	Questions.bGlowMask = true;
	return Questions;
}

/** It adds the widened mask less the mask: of nothing, nothing. */
void ApplyGate(const FGateInputs& Gate, FEffectDecision& Glow)
{
	if (HasNone(Gate.Content.GlowMask))
	{
		Skip(Glow, "the character mask is 0 in the whole view");
	}
	else if (Gate.Content.GlowMask)
	{
		Confine(Gate.Content, *Gate.Content.GlowMask, "the mask", Glow);
	}
}

FScreenPassTexture AddPasses(const FEffectPassInputs& Inputs)
{
	FCharaGlowInputs Glow = FCharaGlowInputs::FromSettings(Inputs.View.FinalPostProcessSettings, Inputs.SceneColor);
	Glow.SceneTextures = Inputs.GetSceneTextures();
	Glow.MaskBounds = Inputs.GetRegion();
	return AddCharaGlow(Inputs.GraphBuilder, Inputs.View, Glow);
}

} // namespace

const FEffect GCharaGlowEffect{
	.Id = EEffect::CharaGlow,
	.Name = "CharaGlow",
	.Doc = "A coloured glow around characters.",
	.Settings = Settings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &Decide,
	.Ask = &Ask,
	.Gate = &ApplyGate,
	.Complete = nullptr,
	.GetPlace = [] { return GetREDPlace(2); },
	.AddPasses = &AddPasses,
	.Measured = NothingMeasured,
	.Measure = nullptr,
};

} // namespace Drydock
