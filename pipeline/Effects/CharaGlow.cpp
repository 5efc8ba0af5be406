// The glow around characters, by the widened character mask. Source: docs/effects.md (the article); the gate is
// drydock's.
#include "Effects/ContentGate.h"
#include "Effects/REDPlace.h"
#include "Effects/Switches.h"
#include "Lens/REDPostProcess.h"
#include "SceneRendering.h"
#include "Toon/CharaGlow.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim CharaGlowSettings[] = {{"CharaGlow"}};

constexpr FSwitch CharaGlowSwitches[] = {{"CharaGlowArea", &FPostProcessSettings::CharaGlowArea, 0.0f}};

FEffectDecision DecideCharaGlow(const FEffect& Effect, const FEffectInputs& Inputs)
{
	return DecideBySwitches(Effect, Inputs, CharaGlowSwitches, DescribeREDPlace());
}

/** As printed the last pass writes alpha 1 in every pixel, so that no content leaves it nothing to do. */
bool IsPrinted(const FGateInputs& Gate)
{
	return FREDPostProcessParameters::FromSettings(Gate.Inputs.Settings).bAsPrinted;
}

FContentQuestions AskCharaGlow(const FGateInputs& Gate, const FEffectDecision&)
{
	return {.bGlowMask = !IsPrinted(Gate)};
}

/** It adds the widened mask less the mask: of nothing, nothing. */
void GateCharaGlow(const FGateInputs& Gate, FEffectDecision& Glow)
{
	if (IsPrinted(Gate))
	{
		return;
	}
	if (HasNone(Gate.Content.GlowMask))
	{
		Skip(Glow, "the character mask is 0 in the whole view");
	}
	else if (Gate.Content.GlowMask)
	{
		Confine(Gate.Content, *Gate.Content.GlowMask, "the mask", Glow);
	}
}

FScreenPassTexture AddCharaGlowEffect(const FEffectPassInputs& Inputs)
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
	.Settings = CharaGlowSettings,
	.bMayBrightenBeforeBloom = true,
	.Decide = &DecideCharaGlow,
	.Content = FContentGate{&AskCharaGlow, &GateCharaGlow},
	.Complete = nullptr,
	.GetPlace = [] { return GetREDPlace(2); },
	.AddPasses = &AddCharaGlowEffect,
	.Measurement = FMeasurement{},
};

} // namespace Drydock
