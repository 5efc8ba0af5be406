// Source: drydock.
#include "Effects/ContentGates.h"

#include "Bloom/PostProcessToonBloom.h"
#include "Effects/ArticleEffects.h"
#include "Effects/ExposureDecisions.h"
#include "Text/TextFormat.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Above this part of the view a region saves nothing: what lies outside of it has to be copied. */
constexpr double LargestRegion = 0.75;

bool HasNone(const std::optional<FIntRect>& Bounds)
{
	return Bounds && Bounds->Area() == 0;
}

void Skip(FEffectDecision& Effect, const std::string& Why)
{
	Effect.bActive = false;
	Effect.bNothingToDo = true;
	Effect.Reason = Why + "; settings call for it: " + Effect.Reason;
}

/** Regions are drawn; compute entries dispatch over the whole view. */
void Confine(const FViewContent& Content, const FIntRect& Bounds, const char* What, FEffectDecision& Effect)
{
	const double Part = static_cast<double>(Bounds.Area()) / (static_cast<double>(Content.Size.X) * Content.Size.Y);
	if (Part > LargestRegion || IsComputePreferred())
	{
		return;
	}
	Effect.Region = Bounds;
	Effect.Reason += std::string("; ") + What + " in " + std::to_string(Bounds.Width()) + "x" +
					 std::to_string(Bounds.Height()) + " of " + std::to_string(Content.Size.X) + "x" +
					 std::to_string(Content.Size.Y) + " pixels";
}

/** An effect before bloom that can make a pixel brighter than the scene's brightest, or might. */
bool IsSceneChangedBeforeBloom(const FChainSettings& Chain)
{
	static const char* const Names[] = {"DepthOfField", "MotionBlur", "RED", "REDDepthOfField", "CharaGlow",
		"ToonShadowBlur", "UnityBloom", "DualKawaseBlur"};
	FChainSettings SettingsAlone = Chain;
	SettingsAlone.Content = {};
	const std::vector<FEffectDecision> Effects = DecideEffects(SettingsAlone);
	return std::any_of(
		std::begin(Names), std::end(Names), [&](const char* Name) { return IsEffectActive(Effects, Name); });
}

} // namespace

std::string FindNothingBright(const FChainSettings& Chain)
{
	constexpr double Rounding = 1.1;
	const double Threshold = static_cast<double>(Chain.Settings.BloomThreshold);
	if (!Chain.Content.Brightest || !(Threshold >= 0.0) || Chain.bAutoExposure || Chain.Settings.BloomMethod == BM_FFT)
	{
		return "";
	}
	const double Exposed = *Chain.Content.Brightest * static_cast<double>(Chain.ExposureScale);
	if (!(Exposed * Rounding <= Threshold) || DecideLocalExposure(Chain).bActive || IsSceneChangedBeforeBloom(Chain))
	{
		return "";
	}
	return "nothing is brighter than BloomThreshold " + NumberText(Chain.Settings.BloomThreshold) +
		   ": the scene's brightest value is " + NumberText(static_cast<float>(Exposed)) + ", exposed";
}

void ApplyContentGate(const FChainSettings& Chain, FEffectDecision& Effect)
{
	const FViewContent& Content = Chain.Content;
	if (!Effect.bActive || Effect.Region)
	{
		return;
	}
	if (Effect.Name == "ToonBloom" && GetToonBloomMode() < 0 && Content.Toon)
	{
		// The setup pass, which toon bloom brings into the graph, may change more than what is toon.
		const bool bChangesAll = (IsToonBloomAsPrinted() || Chain.Engine.bBloomRampWithoutThreshold) &&
								 !(Chain.Settings.BloomThreshold > -1.0f);
		if (HasNone(Content.Toon) && !bChangesAll)
		{
			Skip(Effect, "no pixel of the view is shaded as toon");
		}
		else if (!HasNone(Content.Toon) && !IsToonBloomAsPrinted())
		{
			Confine(Content, *Content.Toon, "toon", Effect);
		}
	}
	else if (Effect.Name == "ToonShadowBlur" && HasNone(Content.Toon))
	{
		Skip(Effect, "no pixel of the view is shaded as toon");
	}
	else if (Effect.Name == "CharaGlow" && HasNone(Content.GlowMask))
	{
		Skip(Effect, "the character mask is 0 in the whole view");
	}
	else if (Effect.Name == "CharaGlow" && Content.GlowMask)
	{
		Confine(Content, *Content.GlowMask, "the mask", Effect);
	}
	else if (Effect.Name == "MotionBlur" && Content.bStill && *Content.bStill)
	{
		Skip(Effect, "nothing moves in the view");
	}
}

void NoteContentUnseen(std::vector<FEffectDecision>& Effects, const std::string& Why)
{
	for (const char* const Gated : {"ToonBloom", "ToonShadowBlur", "CharaGlow", "MotionBlur"})
	{
		FEffectDecision* const Effect = FindEffect(Effects, Gated);
		if (Effect != nullptr && Effect->bActive)
		{
			Effect->Reason += "; " + Why;
		}
	}
}

FContentQuestions AskContent(const FChainSettings& Chain, const std::vector<FEffectDecision>& Effects)
{
	const auto IsActive = [&](const char* Name)
	{
		return IsEffectActive(Effects, Name);
	};
	FContentQuestions Questions;
	if (Chain.bNoSkip)
	{
		return Questions;
	}
	Questions.bToon = (IsActive("ToonBloom") && GetToonBloomMode() < 0) || IsActive("ToonShadowBlur");
	Questions.bGlowMask = IsActive("CharaGlow");
	Questions.bStill = IsActive("MotionBlur");
	FChainSettings Black = Chain;
	Black.Content.Brightest = 0.0;
	Questions.bBrightest = IsActive("Bloom") && !FindNothingBright(Black).empty();
	return Questions;
}

} // namespace Drydock
