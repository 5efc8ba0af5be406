// The factor on the bloom of toon-shaded pixels (BloomToonIntensity), which the bloom setup pass applies. Source:
// docs/effects.md (the article); conditions, gate and wording are drydock's.
#include "Bloom/PostProcessToonBloom.h"
#include "Overlay/ChainPlaces.h"

#include "Effects/Bloom.h"
#include "Effects/ContentGate.h"
#include "Effects/ToonBleed.h"
#include "Picture/Picture.h"
#include "Picture/TextureImage.h"
#include "Text/TextFormat.h"

namespace Drydock
{

namespace
{

constexpr FSettingClaim ToonBloomSettings[] = {{"BloomToonIntensity"}};
constexpr const char* ToonBloomMeasured[] = {"Bloom", "GBufferB"};

/** Describes the effect in the article's form. */
std::string AsPrintedText()
{
	if (!IsToonBloomAsPrinted())
	{
		return "";
	}
	return IsComputePreferred() ? "; as printed, and lost: the article patches the pixel shader only, and "
								  "r.PostProcessing.PreferCompute is 1"
								: "; as printed: one id for each half-resolution pixel";
}

/** It brings the setup pass into the graph, and the pass changes every pixel: it has a ramp, or rounds. */
bool ChangesAll(const FEffectInputs& Inputs)
{
	return HasRampWithoutThreshold(Inputs) || (IsToonBloomAsPrinted() && !(Inputs.Settings.BloomThreshold > -1.0f));
}

FEffectDecision DecideToonBloom(const FEffect&, const FEffectInputs& Inputs)
{
	const int32 Mode = GetToonBloomMode();
	const float Factor = Inputs.Settings.BloomToonIntensity;
	const bool bThreshold = Inputs.Settings.BloomThreshold > -1.0f;
	// A view extension that sets the final settings also sets the override bit.
	const bool bNamed = Inputs.IsNamed("BloomToonIntensity") || Inputs.Settings.bOverride_BloomToonIntensity;
	const std::string NoBloom = FindNoBloomReason(Inputs);
	// r.DefaultFeature.Bloom 0 makes the strength 0 without anyone naming it, and bloom that a volume brings back does
	// not bring it back: the engine, which knows no "named", then blooms without toon.
	const bool bTakenAway = !bNamed && NoBloom.empty() && Factor != FPostProcessSettings().BloomToonIntensity;
	const bool bCalledFor = bNamed || bTakenAway;
	FEffectDecision Toon;
	Toon.bConfigured = bCalledFor || Mode > 0;
	if (Mode == 0)
	{
		Toon.Reason = "r.ToonBloom is 0";
	}
	else if (IsBloomSetupReplaced())
	{
		Toon.Reason = "the bloom setup is an engine overlay's, and drydock's own factor stands back";
	}
	else if (Mode < 0 && !bCalledFor)
	{
		Toon.Reason = "not called for: nothing names BloomToonIntensity";
	}
	else if (!NoBloom.empty())
	{
		Toon.Reason = "there is no bloom to mask: " + NoBloom;
	}
	else if (!(Factor > -1.0f))
	{
		Toon.Reason = "BloomToonIntensity is " + NumberText(Factor) + ": the setup pass takes values above -1";
	}
	else if (Mode < 0 && Factor == 1.0f && !Inputs.Conditions.bNoSkip && !ChangesAll(Inputs))
	{
		Toon.Reason = "BloomToonIntensity is 1, which changes nothing";
	}
	else
	{
		Toon.bActive = true;
		Toon.Reason = "BloomToonIntensity is " + NumberText(Factor) + (bTakenAway ? ", though nothing names it" : "") +
					  (bThreshold ? "" : ": it brings the setup pass into the graph") + AsPrintedText();
	}
	if (!Toon.bActive && NoBloom.empty() && !bThreshold && FindPassReplacement(BloomSetupPlaceName) == nullptr)
	{
		Toon.Reason += "; without it the bloom setup pass is not in the graph (BloomThreshold is " +
					   NumberText(Inputs.Settings.BloomThreshold) + ")";
	}
	return Toon;
}

FContentQuestions AskToonBloom(const FGateInputs&, const FEffectDecision&)
{
	return {.bToon = GetToonBloomMode() < 0};
}

/** It multiplies pixels of the toon model; without one the masked picture is the picture. As printed without a
 * threshold it brings a pass that rounds: it stays. */
void GateToonBloom(const FGateInputs& Gate, FEffectDecision& Toon)
{
	const FEffectDecision* const Bloom = FindEffect(Gate.Gated, EEffect::Bloom);
	if (Bloom != nullptr && !Bloom->bActive)
	{
		Toon.bActive = false;
		Toon.Reason = "there is no bloom to mask: " + Bloom->Reason;
		return;
	}
	if (GetToonBloomMode() >= 0 || !Gate.Content.Toon)
	{
		return;
	}
	if (HasNone(Gate.Content.Toon) && !ChangesAll(Gate.Inputs))
	{
		Skip(Toon, "no pixel of the view is shaded as toon");
	}
	else if (!HasNone(Gate.Content.Toon) && !IsToonBloomAsPrinted())
	{
		Confine(Gate.Content, *Gate.Content.Toon, "toon", Toon);
	}
}

/** How much bloom lands outside what is toon, and how much inside. */
FEffectFigures MeasureToonBloom(const FMeasureInputs& Inputs)
{
	constexpr int Alpha = 3;
	const FKeptTexture& Bloom = Inputs.Textures.at("Bloom");
	const FKeptTexture& GBufferB = Inputs.Textures.at("GBufferB");
	const FToonBleed Bleed = MeasureToonBleed(FPicture(Bloom.Texture, Bloom.Rect).ToImage(),
		ReadChannel(*GBufferB.Texture->GetRHI(), GBufferB.Rect, Alpha), static_cast<double>(Inputs.PreExposure));
	return {{{"bleed", {{"outside", Bleed.Outside}, {"inside", Bleed.Inside}, {"ratio", Bleed.GetRatio()}}}}, {}};
}

} // namespace

const FEffect GToonBloomEffect{
	.Id = EEffect::ToonBloom,
	.Name = "ToonBloom",
	.Doc = "A factor on the bloom of toon-shaded pixels.",
	.Settings = ToonBloomSettings,
	.bMayBrightenBeforeBloom = false,
	.Decide = &DecideToonBloom,
	.Content = FContentGate{&AskToonBloom, &GateToonBloom},
	.Complete = nullptr,
	.GetPlace =
		[] {
			return FChainPlace{EChainPlace::Bloom, -1};
		},
	.AddPasses = nullptr,
	.Measurement = FMeasurement{ToonBloomMeasured, &MeasureToonBloom},
};

} // namespace Drydock
