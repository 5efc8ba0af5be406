// The effects of the articles in the chain: which of them the settings call for, and their passes at their places.
// Source: drydock.
#pragma once

#include "Effects/EffectDecisions.h"
#include "Lens/REDPostProcess.h"
#include "SceneTextureParameters.h"
#include "ScreenPass.h"

#include <optional>
#include <string>
#include <vector>

class FRDGBuilder;
class FViewInfo;

namespace Drydock
{

/** RED, REDDepthOfField, CharaGlow, ToonShadowBlur and UnityBloom: active where the blended settings are not neutral.
 *  Unset for effects that are not of the articles. */
DRYDOCK_API std::optional<FEffectDecision> DecideArticleEffect(const std::string& Name, const FChainSettings& Chain);

/** What the effects read beside the picture. */
struct FArticleEffectInputs
{
	/** [REDDepthOfField, CharaGlow, ToonShadowBlur] Null: made of the view's scene textures where one is active. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;
	/** Colour of the main light, relative. */
	FLinearColor LightColor = FLinearColor(1.0f, 1.0f, 1.0f, 1.0f);
};

/** Each call adds the passes that belong to a place of the chain, and gives the picture as it was where none do. */
class DRYDOCK_API FArticleEffects
{
public:
	FArticleEffects(FRDGBuilder& InGraphBuilder, const FViewInfo& InView, const FArticleEffectInputs& InInputs,
		const std::vector<FEffectDecision>& Effects);

	/** First of all: lighting with the blurred toon shadow. */
	FScreenPassTexture AddLighting(const FScreenPassTexture& SceneColor);

	/** RED depth of field, diffusion filter, soft focus, glow, CharaGlow, where r.REDPostprocessAfterTranslucency puts
	 * them. */
	FScreenPassTexture AddRED(EREDPostProcessInsertion Place, const FScreenPassTexture& SceneColor);

	/** Whether RED wants bloom in its input: the tonemapper then adds none. */
	bool WantsBloomInSceneColor() const;
	FScreenPassTexture AddBloomComposite(const FScreenPassTexture& SceneColor, const FScreenPassTexture& Bloom);

	/** Whether the Unity-style bloom runs, and after the tonemapper. */
	bool HasUnityBloomBeforeTonemap() const;
	bool HasUnityBloomAfterTonemap() const;
	FScreenPassTexture AddUnityBloom(const FScreenPassTexture& SceneColor,
		const FScreenPassRenderTarget& OverrideOutput = FScreenPassRenderTarget());

	/** The shadow buffer with the blurred shadow in A; invalid where the effect did not run. */
	const FScreenPassTexture& GetBlurredToonShadow() const { return BlurredToonShadow; }

private:
	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	FArticleEffectInputs Inputs;
	FScreenPassTexture ToonShadow; // invalid: the frame has none and stays as it is lit
	bool bRED = false;
	bool bREDDepthOfField = false;
	bool bCharaGlow = false;
	bool bCharaGlowCalledFor = false; // by the settings: with nothing to do, the picture still goes its way
	std::optional<FIntRect> CharaGlowRegion;
	bool bToonShadowBlur = false;
	bool bUnityBloom = false;
	FScreenPassTexture BlurredToonShadow;
};

} // namespace Drydock
