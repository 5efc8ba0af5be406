// Source: drydock.
#include "Effects/ArticleEffects.h"

#include "Bloom/UnityBloom.h"
#include "Lens/REDDepthOfField.h"
#include "RenderGraphBuilder.h"
#include "SceneRendering.h"
#include "Text/TextFormat.h"
#include "Toon/CharaGlow.h"
#include "Toon/ToonShadowBlur.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** A setting that switches an effect on, and the value at which it does nothing. */
struct FSwitch
{
	const char* Setting;
	float FPostProcessSettings::*Member;
	float Neutral;
};

struct FArticleEffect
{
	const char* Name;
	std::vector<const char*> Prefixes; // of its settings
	std::vector<FSwitch> Switches;     // active where one is not neutral
};

const std::vector<FArticleEffect>& GetArticleEffects()
{
	using S = FPostProcessSettings;
	static const std::vector<FArticleEffect> Effects = {
		{"RED", {"DiffusionFilter", "SoftFocus", "Glow"},
			{{"DiffusionFilterIntensity", &S::DiffusionFilterIntensity, 0.0f},
				{"SoftFocusBlend", &S::SoftFocusBlend, 0.0f}, {"SoftFocusSaturation", &S::SoftFocusSaturation, 1.0f},
				{"GlowIntensity", &S::GlowIntensity, 0.0f}}},
		{"REDDepthOfField", {"REDDof"}, {{"REDDofFocalDistance", &S::REDDofFocalDistance, 0.0f}}},
		{"CharaGlow", {"CharaGlow"}, {{"CharaGlowArea", &S::CharaGlowArea, 0.0f}}},
		{"ToonShadowBlur", {"ToonShadowBlur"}, {{"ToonShadowBlurIntensity", &S::ToonShadowBlurIntensity, 0.0f}}},
		{"UnityBloom", {"UnityBloom"}, {{"UnityBloomIntensity", &S::UnityBloomIntensity, 0.0f}}},
	};
	return Effects;
}

bool IsNamed(const FArticleEffect& Effect, const FChainSettings& Chain)
{
	return std::any_of(Chain.NamedSettings.begin(), Chain.NamedSettings.end(),
		[&](const std::string& Setting)
		{
			return std::any_of(Effect.Prefixes.begin(), Effect.Prefixes.end(),
				[&](const char* Prefix) { return Setting.starts_with(Prefix); });
		});
}

std::string DescribeSwitches(const FArticleEffect& Effect, const FChainSettings& Chain)
{
	std::string Text;
	for (const FSwitch& Switch : Effect.Switches)
	{
		Text += (Text.empty() ? "" : ", ") + std::string(Switch.Setting) + (Text.empty() ? " is " : " ") +
				NumberText(Chain.Settings.*Switch.Member);
	}
	return Text;
}

const char* DescribePlace(const std::string& Effect)
{
	if (Effect == "UnityBloom")
	{
		return IsUnityBloomAfterTonemap() ? "; after the tonemapper" : "; before the tonemapper";
	}
	if (Effect == "ToonShadowBlur")
	{
		return "";
	}
	switch (GetREDPostProcessInsertion())
	{
	case EREDPostProcessInsertion::BeforeTranslucency:
		return "; before separate translucency";
	case EREDPostProcessInsertion::AfterTranslucency:
		return "; after separate translucency";
	default:
		return "; after bloom";
	}
}

} // namespace

std::optional<FEffectDecision> DecideArticleEffect(const std::string& Name, const FChainSettings& Chain)
{
	const auto& Effects = GetArticleEffects();
	const auto Effect = std::find_if(
		Effects.begin(), Effects.end(), [&](const FArticleEffect& Candidate) { return Name == Candidate.Name; });
	if (Effect == Effects.end())
	{
		return {};
	}
	FEffectDecision Decision{Name, false, IsNamed(*Effect, Chain), DescribeSwitches(*Effect, Chain)};
	const bool bNeutral = std::all_of(Effect->Switches.begin(), Effect->Switches.end(),
		[&](const FSwitch& Switch) { return Chain.Settings.*Switch.Member == Switch.Neutral; });
	if (bNeutral)
	{
		Decision.Reason += Decision.bConfigured ? ": neutral" : ": neutral, and nothing in the config sets it";
	}
	else if (!Chain.ShowFlags.PostProcessing)
	{
		Decision.Reason = "ShowFlag.PostProcessing is off";
	}
	else
	{
		Decision.bActive = true;
		Decision.Reason += DescribePlace(Name);
	}
	return Decision;
}

FArticleEffects::FArticleEffects(FRDGBuilder& InGraphBuilder, const FViewInfo& InView,
	const FArticleEffectInputs& InInputs, const std::vector<FEffectDecision>& Effects)
	: GraphBuilder(InGraphBuilder)
	, View(InView)
	, Inputs(InInputs)
	, bRED(IsEffectActive(Effects, "RED"))
	, bREDDepthOfField(IsEffectActive(Effects, "REDDepthOfField"))
	, bToonShadowBlur(IsEffectActive(Effects, "ToonShadowBlur"))
	, bUnityBloom(IsEffectActive(Effects, "UnityBloom"))
{
	if (const FEffectDecision* const CharaGlow = FindEffect(Effects, "CharaGlow"))
	{
		bCharaGlow = CharaGlow->bActive;
		bCharaGlowCalledFor = CharaGlow->bActive || CharaGlow->bNothingToDo;
		CharaGlowRegion = CharaGlow->Region;
	}
	if (!Inputs.SceneTextures && (bREDDepthOfField || bCharaGlow || bToonShadowBlur))
	{
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, View);
	}
	if (View.SceneTextures && View.SceneTextures->ToonShadow)
	{
		ToonShadow = FScreenPassTexture(View.SceneTextures->ToonShadow, View.ViewRect);
	}
}

FScreenPassTexture FArticleEffects::AddLighting(const FScreenPassTexture& SceneColor)
{
	if (!bToonShadowBlur || !ToonShadow.IsValid())
	{
		return SceneColor;
	}
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	const FToonShadowBlurInputs Blur = FToonShadowBlurInputs::FromSettings(Settings, ToonShadow);
	BlurredToonShadow = AddToonShadowBlurPasses(GraphBuilder, View, Blur);

	FToonShadowLightingInputs Lighting;
	Lighting.SceneColor = SceneColor;
	Lighting.ToonShadow = BlurredToonShadow;
	Lighting.SceneTextures = Inputs.SceneTextures;
	Lighting.LightColor = Inputs.LightColor;
	Lighting.Intensity = Settings.ToonShadowBlurIntensity;
	Lighting.Blend = Settings.ToonShadowBlurBlend;
	Lighting.Store = Blur.Store;
	Lighting.bAsPrinted = Blur.bAsPrinted;
	return AddToonShadowLightingPass(GraphBuilder, View, Lighting);
}

FScreenPassTexture FArticleEffects::AddRED(EREDPostProcessInsertion Place, const FScreenPassTexture& SceneColor)
{
	if (Place != GetREDPostProcessInsertion())
	{
		return SceneColor;
	}
	const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
	FScreenPassTexture Result = SceneColor;
	if (bREDDepthOfField)
	{
		FREDDepthOfFieldInputs DepthOfField = FREDDepthOfFieldInputs::FromSettings(Settings, Result);
		DepthOfField.SceneTextures = Inputs.SceneTextures;
		Result = AddREDDepthOfFieldPasses(GraphBuilder, View, DepthOfField);
	}
	if (bRED)
	{
		Result = AddREDPostProcessPasses(GraphBuilder, View, Result, FREDPostProcessParameters::FromSettings(Settings));
	}
	if (bCharaGlow)
	{
		FCharaGlowInputs Glow = FCharaGlowInputs::FromSettings(Settings, Result);
		Glow.SceneTextures = Inputs.SceneTextures;
		if (Result.ViewRect.Size() == View.ViewRect.Size())
		{
			Glow.MaskBounds = CharaGlowRegion;
		}
		Result = AddCharaGlow(GraphBuilder, View, Glow);
	}
	return Result;
}

bool FArticleEffects::WantsBloomInSceneColor() const
{
	return (bRED || bREDDepthOfField || bCharaGlowCalledFor) &&
		   GetREDPostProcessInsertion() == EREDPostProcessInsertion::AfterBloom;
}

FScreenPassTexture FArticleEffects::AddBloomComposite(
	const FScreenPassTexture& SceneColor, const FScreenPassTexture& Bloom)
{
	if (!Bloom.IsValid())
	{
		return SceneColor;
	}
	FUnityBloomPassInputs Composite;
	Composite.Pass = EUnityBloomPass::Composite;
	Composite.Name = TEXT("BloomComposite");
	Composite.Source = SceneColor;
	Composite.Bloom = Bloom;
	return AddUnityBloomPass(GraphBuilder, View, Composite);
}

bool FArticleEffects::HasUnityBloomBeforeTonemap() const
{
	return bUnityBloom && !IsUnityBloomAfterTonemap();
}

bool FArticleEffects::HasUnityBloomAfterTonemap() const
{
	return bUnityBloom && IsUnityBloomAfterTonemap();
}

FScreenPassTexture FArticleEffects::AddUnityBloom(
	const FScreenPassTexture& SceneColor, const FScreenPassRenderTarget& OverrideOutput)
{
	FUnityBloomInputs Bloom = FUnityBloomInputs::FromSettings(View.FinalPostProcessSettings, SceneColor);
	Bloom.OverrideOutput = OverrideOutput;
	return AddUnityBloomPasses(GraphBuilder, View, Bloom);
}

} // namespace Drydock
