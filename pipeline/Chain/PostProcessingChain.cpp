// Builds the chain of one view, part by part in the engine's order. Source: engine PostProcess/PostProcessing.cpp
// (order of the chain, what each part needs).
#include "Chain/PostProcessingChain.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Bloom/UnityBloom.h"
#include "Chain/BloomChain.h"
#include "Chain/ExposureChain.h"
#include "Chain/InsertionPoints.h"
#include "Effects/Effects.h"
#include "Overlay/ChainPlaces.h"
#include "SceneViewState.h"
#include "Screen/PostProcessAA.h"
#include "Screen/PostProcessDownsample.h"
#include "Screen/PostProcessUpscale.h"
#include "Screen/SeparateTranslucencyComposition.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

#include <algorithm>

using namespace Drydock;

namespace
{

/** The passes of one view, in the order of its methods. */
class FPostProcessingChain
{
	using EPoint = FInsertionPoints::EPoint;

public:
	FPostProcessingChain(FRDGBuilder& InGraphBuilder, const FNamedView& NamedView,
		const FPostProcessingChainInputs& InInputs, const std::vector<FEffectDecision>& InEffects,
		FViewExtensionFrame& InExtensions)
		: GraphBuilder(InGraphBuilder)
		, View(*NamedView.View)
		, Inputs(InInputs)
		, Effects(InEffects)
		, Extensions(InExtensions)
		, bPostProcessing(View.Family == nullptr || View.Family->EngineShowFlags.PostProcessing)
		, bTonemapper(View.Family == nullptr || View.Family->EngineShowFlags.Tonemapper)
		, Sequence(FScreenPassRenderTarget::CreateViewFamilyOutput(Inputs.ViewFamilyTexture, View))
		, Points(GraphBuilder, NamedView, Inputs.SceneTextures, Sequence, Extensions)
		, SceneColor(Inputs.SceneColor)
	{
		Sequence.SetEnabled(EFramePass::MotionBlur, bPostProcessing && IsActive(EEffect::MotionBlur));
		Sequence.SetEnabled(EFramePass::Tonemap, true);
		Sequence.SetEnabled(EFramePass::AfterTonemap, HasPasses(EChainPlace::AfterTonemap));
		Sequence.SetEnabled(EFramePass::FXAA, bPostProcessing && IsActive(EEffect::FXAA));
		Sequence.SetEnabled(EFramePass::SMAA, false);
		Sequence.SetEnabled(EFramePass::VisualizeDepthOfField, false);
		Sequence.SetEnabled(EFramePass::PrimaryUpscale, IsActive(EEffect::Upscale));
		Sequence.Finalize();
		Points.Subscribe();
	}

	/** All at full resolution that sees neither bloom nor exposure. */
	void AddSceneLinear()
	{
		AddEffects(EChainPlace::Lighting);
		SceneColor = Points.Run(EPoint::BeforeDOF, SceneColor);
		AddEffects(EChainPlace::DepthOfField);
		AddEffects(EChainPlace::BeforeTranslucency);
		if (IsActive(EEffect::Translucency))
		{
			const FScreenPassTexture Translucency = Points.Run(EPoint::TranslucencyAfterDOF, GetSeparateTranslucency());
			Points.SetSlot(EPostProcessMaterialInput::SeparateTranslucency, Translucency);
			ComposeTranslucency(Translucency);
		}
		SceneColor = Points.Run(EPoint::AfterDOF, SceneColor);
		AddEffects(EChainPlace::AfterTranslucency);
		if (!IsActive(EEffect::Translucency))
		{
			Points.Skip(EPoint::TranslucencyAfterDOF, FindEffect(Effects, EEffect::Translucency)->Reason);
		}
		AddEffects(EChainPlace::TemporalAA);
		RunSSRInput();
		AddEffects(EChainPlace::MotionBlur);
		SceneColor = Points.Run(EPoint::MotionBlur, SceneColor);
		AddEffects(EChainPlace::BeforeBloom);
	}

	/** If post-processing is off, only translucency is left before the tonemapper. */
	void SkipSceneLinear()
	{
		if (IsActive(EEffect::Translucency))
		{
			ComposeTranslucency(GetSeparateTranslucency());
		}
		for (const EPoint Point : {EPoint::BeforeDOF, EPoint::AfterDOF, EPoint::TranslucencyAfterDOF, EPoint::SSRInput,
				 EPoint::MotionBlur, EPoint::ReplacingTonemapper})
		{
			Points.Skip(Point, Off);
		}
	}

	/** The images that exposure and bloom share. As in the engine all levels are declared; those that nobody reads
	 *  are culled. */
	void AddDownsampleChain()
	{
		if (!IsActive(EEffect::Bloom) && !IsActive(EEffect::LocalExposure) && !Inputs.bAutoExposure)
		{
			return;
		}
		const FRDGEffectScope Scope(GraphBuilder, *GBloomEffect.Name);
		FDownsamplePassInputs HalfInputs;
		HalfInputs.Name = TEXT("HalfResolutionSceneColor");
		HalfInputs.SceneColor = SceneColor;
		HalfInputs.Quality = GetDownsampleQuality();
		HalfInputs.FormatOverride = PF_FloatRGB;
		HalfResolution = AddDownsamplePass(GraphBuilder, View, HalfInputs);
		SceneDownsampleChain.Init(
			GraphBuilder, View, HalfResolution, GetDownsampleChainQuality(), TEXT("SceneDownsample"));
	}

	void AddExposure()
	{
		const FRDGEffectScope Scope(GraphBuilder, *GExposureEffect.Name);
		FExposureChainInputs ExposureInputs;
		ExposureInputs.HalfResolution = HalfResolution;
		ExposureInputs.SceneDownsampleChain = &SceneDownsampleChain;
		ExposureInputs.bAutoExposure = Inputs.bAutoExposure;
		ExposureInputs.ExposureScale = Inputs.ExposureScale;
		ExposureInputs.bLocalExposure = IsActive(EEffect::LocalExposure);
		const FExposureChainOutputs Exposure = AddExposurePasses(GraphBuilder, View, ExposureInputs);
		EyeAdaptationBuffer = Exposure.EyeAdaptationBuffer;
		EyeAdaptationParameters = Exposure.EyeAdaptationParameters;
		LocalExposure = Exposure.LocalExposure;
		Outputs.Histogram = Exposure.Histogram;
	}

	/** Bloom for the tonemapper to add; the mask of toon bloom in the picture's place where it is asked for. */
	void AddBloom()
	{
		const FRDGEffectScope Scope(GraphBuilder, *GBloomEffect.Name);
		FToonBloomInputs ToonInputs;
		ToonInputs.SceneColor = SceneColor;
		ToonInputs.ToonIntensity = View.FinalPostProcessSettings.BloomToonIntensity;
		const bool bToonBloom = IsActive(EEffect::ToonBloom);
		const bool bVisualizeToon = bPostProcessing && IsToonBloomMaskVisualized();
		if (bToonBloom || bVisualizeToon)
		{
			ToonInputs.SceneTextures = GetSceneTextures();
			ToonInputs.ToonBounds = FindRegion(EEffect::ToonBloom);
		}
		if (bVisualizeToon)
		{
			SceneColor = AddToonBloomVisualizePass(GraphBuilder, View, ToonInputs);
			return;
		}
		if (IsActive(EEffect::Bloom))
		{
			FBloomChainInputs BloomInputs;
			BloomInputs.SceneColor = SceneColor;
			BloomInputs.HalfResolution = HalfResolution;
			BloomInputs.SceneDownsampleChain = &SceneDownsampleChain;
			BloomInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
			// One that runs without an effect (--no-skip) does not bring the setup pass, which ends at 65536.
			const FFinalPostProcessSettings& Settings = View.FinalPostProcessSettings;
			if (IsLocalExposureAppliedToBloom() &&
				(IsLocalExposureEnabled(Settings) || Settings.BloomThreshold > -1.0f))
			{
				BloomInputs.LocalExposure = LocalExposure;
			}
			BloomInputs.Toon = bToonBloom ? &ToonInputs : nullptr;
			BloomInputs.EyeAdaptationParameters = EyeAdaptationParameters;
			BloomInputs.LocalExposureParameters = LocalExposure.Parameters;
			FPostProcessingInputs PostProcessing;
			if (FindPassReplacement(BloomSetupPlaceName))
			{
				PostProcessing.SceneTextures = GetSceneTextures();
				PostProcessing.ViewFamilyTexture = Inputs.ViewFamilyTexture;
				BloomInputs.PostProcessing = &PostProcessing;
			}
			const FBloomChainOutputs BloomOutputs = AddBloomPasses(GraphBuilder, View, BloomInputs);
			Bloom = BloomOutputs.Bloom;
			SceneColorApplyParameters = BloomOutputs.SceneColorApplyParameters;
		}
		Outputs.Bloom = Bloom;
		if (Bloom.IsValid())
		{
			Outputs.Kept["Bloom"] = Bloom;
		}
		if (!FindEffectsAt(EChainPlace::AfterBloom, Effects).empty())
		{
			AddBloomToSceneColor();
			AddEffects(EChainPlace::AfterBloom);
		}
	}

	/** From scene-linear to display-encoded, and what sees that. */
	void AddTonemap()
	{
		Outputs.SceneLinear = SceneColor;
		if (bPostProcessing && Points.HasCallbacks(EPoint::ReplacingTonemapper))
		{
			SceneColor = Points.RunReplacingTonemapper(SceneColor, Bloom);
		}
		else
		{
			if (bPostProcessing)
			{
				Points.Skip(EPoint::ReplacingTonemapper, "nobody subscribed");
			}
			const FRDGEffectScope Scope(GraphBuilder, *GTonemapEffect.Name);
			FTonemapInputs TonemapInputs;
			TonemapInputs.SceneColor = SceneColor;
			TonemapInputs.Bloom = Bloom;
			TonemapInputs.SceneColorApplyParamaters = SceneColorApplyParameters;
			TonemapInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
			TonemapInputs.bGammaOnly = !bPostProcessing || !bTonemapper;
			TonemapInputs.bWriteAlphaChannel = Sequence.IsEnabled(EFramePass::FXAA);
			TonemapInputs.OutputFormat = GetTonemapFormat();
			if (!TonemapInputs.bGammaOnly && IsTonemapLUTUsed())
			{
				TonemapInputs.ColorGradingTexture = AddCombineLUTPass(GraphBuilder, View);
			}
			TonemapInputs.EyeAdaptationParameters = &EyeAdaptationParameters;
			TonemapInputs.LocalExposureParameters = &LocalExposure.Parameters;
			if (LocalExposure.IsValid())
			{
				LocalExposure.GiveTo(TonemapInputs);
			}
			Sequence.AcceptOverrideIfLastPass(EFramePass::Tonemap, TonemapInputs.OverrideOutput);
			SceneColor = AddTonemapPass(GraphBuilder, View, TonemapInputs);
			Tonemapped = SceneColor;
		}
		Points.SetSlot(EPostProcessMaterialInput::PreTonemapHDRColor, Outputs.SceneLinear);
		Points.SetSlot(EPostProcessMaterialInput::PostTonemapHDRColor, SceneColor);
		SceneColor = Points.Run(EPoint::Tonemap, SceneColor);
	}

	void AddDisplay()
	{
		AddEffects(EChainPlace::AfterTonemap);
		if (Sequence.IsEnabled(EFramePass::FXAA))
		{
			const FRDGEffectScope Scope(GraphBuilder, *GFXAAEffect.Name);
			FFXAAInputs FXAAInputs;
			FXAAInputs.SceneColor = SceneColor;
			FXAAInputs.Quality = GetFXAAQuality();
			FXAAInputs.bLumaInAlpha = SceneColor == Tonemapped;
			Sequence.AcceptOverrideIfLastPass(EFramePass::FXAA, FXAAInputs.OverrideOutput);
			SceneColor = AddFXAAPass(GraphBuilder, View, FXAAInputs);
		}
		if (bPostProcessing)
		{
			SceneColor = Points.Run(EPoint::FXAA, SceneColor);
			SceneColor = Points.Run(EPoint::SMAA, SceneColor);
			SceneColor = Points.Run(EPoint::VisualizeDepthOfField, SceneColor);
		}
		else
		{
			Points.Skip(EPoint::FXAA, Off);
			Points.Skip(EPoint::SMAA, Off);
			Points.Skip(EPoint::VisualizeDepthOfField, Off);
		}
	}

	/** From the scene's resolution to the output's. */
	void AddUpscale()
	{
		if (Sequence.IsEnabled(EFramePass::PrimaryUpscale))
		{
			const FRDGEffectScope Scope(GraphBuilder, *GUpscaleEffect.Name);
			FUpscaleInputs UpscaleInputs;
			UpscaleInputs.SceneColor = SceneColor;
			UpscaleInputs.Method = GetUpscaleMethod();
			Sequence.AcceptOverrideIfLastPass(EFramePass::PrimaryUpscale, UpscaleInputs.OverrideOutput);
			SceneColor = AddUpscalePass(GraphBuilder, View, UpscaleInputs);
		}
	}

	FPostProcessingChainOutputs Build()
	{
		bPostProcessing ? AddSceneLinear() : SkipSceneLinear();
		AddDownsampleChain();
		AddExposure();
		AddBloom();
		AddTonemap();
		AddDisplay();
		AddUpscale();
		Outputs.Final = FScreenPassTexture(Inputs.ViewFamilyTexture, View.UnscaledViewRect);
		return Outputs;
	}

private:
	bool IsActive(EEffect Id) const { return IsEffectActive(Effects, Id); }

	/** Whether an active effect of the table has its passes in a place. */
	bool HasPasses(EChainPlace Place) const
	{
		const auto Decisions = FindEffectsAt(Place, Effects);
		return std::any_of(Decisions.begin(), Decisions.end(), MakesPasses);
	}

	static bool MakesPasses(const FEffectDecision* Decision)
	{
		return Decision->bActive && !Decision->bByExtension && *Decision->Effect->AddPasses != nullptr;
	}

	/** The passes of all effects that stand in a place, one after another. */
	void AddEffects(EChainPlace Place)
	{
		for (const FEffectDecision* const Decision : FindEffectsAt(Place, Effects))
		{
			if (!MakesPasses(Decision))
			{
				continue;
			}
			FScreenPassRenderTarget OverrideOutput;
			if (Place == EChainPlace::AfterTonemap)
			{
				Sequence.AcceptOverrideIfLastPass(EFramePass::AfterTonemap, OverrideOutput);
			}
			const FRDGEffectScope Scope(GraphBuilder, *Decision->Effect->Name);
			SceneColor = (*Decision->Effect->AddPasses)({GraphBuilder, View, *Decision, SceneColor, Inputs.LightColor,
				OverrideOutput, [this] { return GetSceneTextures(); }, Outputs.Kept, GetKnownExposureScale()});
		}
	}

	FScreenPassTexture GetSeparateTranslucency() const
	{
		return FScreenPassTexture(View.SceneTextures->SeparateTranslucency, View.ViewRect);
	}

	void ComposeTranslucency(const FScreenPassTexture& Translucency)
	{
		const FRDGEffectScope Scope(GraphBuilder, *GTranslucencyEffect.Name);
		SceneColor = AddSeparateTranslucencyCompositionPass(GraphBuilder, View, SceneColor, Translucency);
	}

	/** For effects that want bloom in the picture: the tonemapper then adds none. */
	void AddBloomToSceneColor()
	{
		if (SceneColorApplyParameters)
		{
			SceneColor = AddApplyFFTBloomPass(GraphBuilder, View, SceneColor, SceneColorApplyParameters);
			SceneColorApplyParameters = nullptr;
		}
		if (Bloom.IsValid())
		{
			FUnityBloomPassInputs Composite;
			Composite.Pass = EUnityBloomPass::Composite;
			Composite.Name = TEXT("BloomComposite");
			Composite.Source = SceneColor;
			Composite.Bloom = Bloom;
			SceneColor = AddUnityBloomPass(GraphBuilder, View, Composite);
			Bloom = FScreenPassTexture();
		}
	}

	/** The only region where an effect has something to do, from the view's corner; not set: anywhere, or the picture
	 * no longer has the view's size. */
	std::optional<FIntRect> FindRegion(EEffect Id) const
	{
		const FEffectDecision* const Effect = FindEffect(Effects, Id);
		const bool bSameSize = SceneColor.ViewRect.Size() == View.ViewRect.Size();
		return Effect != nullptr && bSameSize ? Effect->Region : std::nullopt;
	}

	/** The scale that is known before this frame is metered. */
	float GetKnownExposureScale() const
	{
		const float Last = Inputs.bAutoExposure ? View.GetLastEyeAdaptationExposure() : Inputs.ExposureScale;
		return Last > 0.0f && FMath::IsFinite(Last) ? Last : 1.0f;
	}

	/** Those of the inputs, or made when first asked for. */
	TRDGUniformBufferRef<FSceneTextureUniformParameters> GetSceneTextures()
	{
		if (!SceneTextures)
		{
			SceneTextures =
				Inputs.SceneTextures ? Inputs.SceneTextures : CreateSceneTextureUniformBuffer(GraphBuilder, View);
		}
		return SceneTextures;
	}

	/** The display's own; where FXAA reads luma from two bits of alpha, half float. */
	EPixelFormat GetTonemapFormat() const
	{
		const EPixelFormat Format = GetDisplayFormat(GetTonemapperOutputDeviceParameters().OutputDevice);
		return Sequence.IsEnabled(EFramePass::FXAA) && Format == PF_A2B10G10R10 ? PF_FloatRGBA : Format;
	}

	/** Reads what next frame's screen-space reflections see; the picture of this frame is not changed by it. */
	void RunSSRInput()
	{
		if (View.State == nullptr)
		{
			Points.Skip(EPoint::SSRInput, "the view has no state that lives on to the next frame");
			return;
		}
		const FScreenPassTexture Result = Points.Run(EPoint::SSRInput, SceneColor,
			"the result is kept for the next frame's reflections and not seen in this one");
		if (Result.Texture != SceneColor.Texture && View.ViewState != nullptr)
		{
			View.ViewState->KeepTexture(GraphBuilder, CustomSSRInputName, Result);
		}
	}

	static constexpr const char* Off = "ShowFlag.PostProcessing is off";

	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FPostProcessingChainInputs& Inputs;
	const std::vector<FEffectDecision>& Effects;
	FViewExtensionFrame& Extensions;
	const bool bPostProcessing;
	const bool bTonemapper;
	FInsertionPoints::FSequence Sequence;
	FInsertionPoints Points;

	TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures = nullptr;

	// One part leaves these for the next.
	FScreenPassTexture SceneColor; // the picture so far
	FScreenPassTexture HalfResolution;
	FSceneDownsampleChain SceneDownsampleChain;
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
	FEyeAdaptationParameters EyeAdaptationParameters;
	FLocalExposureTextures LocalExposure;
	FScreenPassTexture Bloom;
	FRDGBufferRef SceneColorApplyParameters = nullptr;
	FScreenPassTexture Tonemapped; // with luma in alpha where FXAA follows
	FPostProcessingChainOutputs Outputs;
};

} // namespace

FPostProcessingChainOutputs AddPostProcessingPasses(FRDGBuilder& GraphBuilder, const Drydock::FNamedView& NamedView,
	const FPostProcessingChainInputs& Inputs, const std::vector<Drydock::FEffectDecision>& Effects,
	Drydock::FViewExtensionFrame& Extensions)
{
	RDG_EVENT_SCOPE(GraphBuilder, "PostProcessing");
	check(Inputs.SceneColor.IsValid());
	return FPostProcessingChain(GraphBuilder, NamedView, Inputs, Effects, Extensions).Build();
}
