// Source: engine PostProcess/PostProcessing.cpp (order of the chain, what each part needs).
#include "Chain/PostProcessingChain.h"

#include "Bloom/PostProcessFFTBloom.h"
#include "Bloom/PostProcessToonBloom.h"
#include "Blur/DualKawaseBlurPass.h"
#include "Chain/BloomChain.h"
#include "Chain/ExposureChain.h"
#include "Chain/InsertionPoints.h"
#include "Effects/ArticleEffects.h"
#include "Lens/DiaphragmDOF.h"
#include "Lens/PostProcessMotionBlur.h"
#include "SceneViewState.h"
#include "Screen/PostProcessAA.h"
#include "Screen/PostProcessDownsample.h"
#include "Screen/PostProcessUpscale.h"
#include "Tonemap/PostProcessCombineLUTs.h"
#include "Tonemap/PostProcessTonemap.h"

#include <algorithm>

using namespace Drydock;

namespace
{

using Drydock::EFramePass;
using Drydock::FInsertionPoints;
using EPoint = FInsertionPoints::EPoint;

/** The passes of one view, in the order of its methods. */
class FPostProcessingChain
{
public:
	FPostProcessingChain(FRDGBuilder& InGraphBuilder, const Drydock::FNamedView& NamedView,
		const FPostProcessingChainInputs& InInputs, const std::vector<Drydock::FEffectDecision>& InEffects,
		Drydock::FViewExtensionFrame& InExtensions)
		: GraphBuilder(InGraphBuilder)
		, View(*NamedView.View)
		, Inputs(InInputs)
		, Effects(InEffects)
		, Extensions(InExtensions)
		, bPostProcessing(View.Family == nullptr || View.Family->EngineShowFlags.PostProcessing)
		, bTonemapper(View.Family == nullptr || View.Family->EngineShowFlags.Tonemapper)
		, ArticleEffects(GraphBuilder, View, {Inputs.SceneTextures, Inputs.LightColor}, Effects)
		, Sequence(FScreenPassRenderTarget::CreateViewFamilyOutput(Inputs.ViewFamilyTexture, View))
		, Points(GraphBuilder, NamedView, Inputs.SceneTextures, Sequence, Extensions)
		, SceneColor(Inputs.SceneColor)
	{
		Sequence.SetEnabled(EFramePass::MotionBlur, bPostProcessing && IsActive("MotionBlur"));
		Sequence.SetEnabled(EFramePass::Tonemap, true);
		Sequence.SetEnabled(EFramePass::UnityBloom, ArticleEffects.HasUnityBloomAfterTonemap());
		Sequence.SetEnabled(EFramePass::FXAA, bPostProcessing && IsActive("FXAA"));
		Sequence.SetEnabled(EFramePass::VisualizeDepthOfField, false);
		Sequence.SetEnabled(EFramePass::PrimaryUpscale, IsActive("Upscale"));
		Sequence.Finalize();
		Points.Subscribe();
	}

	/** All at full resolution that sees neither bloom nor exposure. */
	void AddSceneLinear()
	{
		SceneColor = ArticleEffects.AddLighting(SceneColor);
		SceneColor = Points.Run(EPoint::BeforeDOF, SceneColor);
		if (IsActive("DepthOfField"))
		{
			AddDepthOfField();
		}
		SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::BeforeTranslucency, SceneColor);
		SceneColor = Points.Run(EPoint::AfterDOF, SceneColor);
		SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::AfterTranslucency, SceneColor);
		Points.Skip(EPoint::TranslucencyAfterDOF, "the scene has no separate translucency");
		RunSSRInput();
		if (IsActive("MotionBlur"))
		{
			AddMotionBlur();
		}
		SceneColor = Points.Run(EPoint::MotionBlur, SceneColor);
		if (IsActive("DualKawaseBlur") && !Extensions.Has("FDualKawaseBlur"))
		{
			AddDualKawase();
		}
		if (ArticleEffects.HasUnityBloomBeforeTonemap())
		{
			SceneColor = ArticleEffects.AddUnityBloom(SceneColor);
		}
	}

	/** Where post-processing is off: what comes before the tonemapper is not there. */
	void SkipSceneLinear()
	{
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
		if (!IsActive("Bloom") && !IsActive("LocalExposure") && !Inputs.bAutoExposure)
		{
			return;
		}
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
		FExposureChainInputs ExposureInputs;
		ExposureInputs.HalfResolution = HalfResolution;
		ExposureInputs.SceneDownsampleChain = &SceneDownsampleChain;
		ExposureInputs.bAutoExposure = Inputs.bAutoExposure;
		ExposureInputs.ExposureScale = Inputs.ExposureScale;
		ExposureInputs.bLocalExposure = IsActive("LocalExposure");
		const FExposureChainOutputs Exposure = AddExposurePasses(GraphBuilder, View, ExposureInputs);
		EyeAdaptationBuffer = Exposure.EyeAdaptationBuffer;
		LocalExposure = Exposure.LocalExposure;
		Outputs.Histogram = Exposure.Histogram;
	}

	/** Bloom for the tonemapper to add; the mask of toon bloom in the picture's place where it is asked for. */
	void AddBloom()
	{
		FToonBloomInputs ToonInputs;
		ToonInputs.SceneColor = SceneColor;
		ToonInputs.ToonIntensity = View.FinalPostProcessSettings.BloomToonIntensity;
		const bool bToonBloom = IsActive("ToonBloom");
		const bool bVisualizeToon = bPostProcessing && IsToonBloomMaskVisualized();
		if (bToonBloom || bVisualizeToon)
		{
			ToonInputs.SceneTextures = GetSceneTextures();
			ToonInputs.ToonBounds = FindRegion("ToonBloom");
		}
		if (bVisualizeToon)
		{
			SceneColor = AddToonBloomVisualizePass(GraphBuilder, View, ToonInputs);
			return;
		}
		if (IsActive("Bloom"))
		{
			FBloomChainInputs BloomInputs;
			BloomInputs.SceneColor = SceneColor;
			BloomInputs.HalfResolution = HalfResolution;
			BloomInputs.SceneDownsampleChain = &SceneDownsampleChain;
			BloomInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
			if (IsLocalExposureAppliedToBloom())
			{
				BloomInputs.LocalExposure = LocalExposure;
			}
			BloomInputs.Toon = bToonBloom ? &ToonInputs : nullptr;
			const FBloomChainOutputs BloomOutputs = AddBloomPasses(GraphBuilder, View, BloomInputs);
			Bloom = BloomOutputs.Bloom;
			SceneColorApplyParameters = BloomOutputs.SceneColorApplyParameters;
		}
		Outputs.Bloom = Bloom;
		if (ArticleEffects.WantsBloomInSceneColor())
		{
			if (SceneColorApplyParameters)
			{
				SceneColor = Drydock::AddApplyFFTBloomPass(GraphBuilder, View, SceneColor, SceneColorApplyParameters);
				SceneColorApplyParameters = nullptr;
			}
			SceneColor = ArticleEffects.AddBloomComposite(SceneColor, Bloom);
			SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::AfterBloom, SceneColor);
			Bloom = FScreenPassTexture();
		}
	}

	/** From scene-linear to display-encoded, and what sees that. */
	void AddTonemap()
	{
		Outputs.SceneLinear = SceneColor;
		Outputs.BlurredToonShadow = ArticleEffects.GetBlurredToonShadow();
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
			FTonemapInputs TonemapInputs;
			TonemapInputs.SceneColor = SceneColor;
			TonemapInputs.Bloom = Bloom;
			TonemapInputs.SceneColorApplyParamaters = SceneColorApplyParameters;
			TonemapInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
			TonemapInputs.bGammaOnly = !bPostProcessing || !bTonemapper;
			TonemapInputs.bWriteAlphaChannel = Sequence.IsEnabled(EFramePass::FXAA);
			TonemapInputs.OutputFormat = GetTonemapFormat();
			if (!TonemapInputs.bGammaOnly && Drydock::IsTonemapLUTUsed())
			{
				TonemapInputs.ColorGradingTexture = AddCombineLUTPass(GraphBuilder, View);
			}
			TonemapInputs.LocalExposure = LocalExposure;
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
		if (ArticleEffects.HasUnityBloomAfterTonemap())
		{
			FScreenPassRenderTarget OverrideOutput;
			Sequence.AcceptOverrideIfLastPass(EFramePass::UnityBloom, OverrideOutput);
			SceneColor = ArticleEffects.AddUnityBloom(SceneColor, OverrideOutput);
		}
		if (Sequence.IsEnabled(EFramePass::FXAA))
		{
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
			SceneColor = Points.Run(EPoint::VisualizeDepthOfField, SceneColor);
		}
		else
		{
			Points.Skip(EPoint::FXAA, Off);
			Points.Skip(EPoint::VisualizeDepthOfField, Off);
		}
	}

	/** From the scene's resolution to the output's. */
	void AddUpscale()
	{
		if (Sequence.IsEnabled(EFramePass::PrimaryUpscale))
		{
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
	bool IsActive(const char* Name) const { return Drydock::IsEffectActive(Effects, Name); }

	/** Where alone an effect has something to do, from the view's corner; not set: anywhere, or the picture is no
	 * longer of the view's size. */
	std::optional<FIntRect> FindRegion(const char* Name) const
	{
		const Drydock::FEffectDecision* const Effect = Drydock::FindEffect(Effects, Name);
		const bool bSameSize = SceneColor.ViewRect.Size() == View.ViewRect.Size();
		return Effect != nullptr && bSameSize ? Effect->Region : std::nullopt;
	}

	TRDGUniformBufferRef<FSceneTextureUniformParameters> GetSceneTextures() const
	{
		return Inputs.SceneTextures ? Inputs.SceneTextures : CreateSceneTextureUniformBuffer(GraphBuilder, View);
	}

	void AddDepthOfField()
	{
		const auto Model = DiaphragmDOF::FPhysicalCocModel::Compile(View.FinalPostProcessSettings,
			SceneColor.ViewRect.Width(), static_cast<float>(View.UniformParameters.ViewToClip.M[0][0]));
		SceneColor = DiaphragmDOF::AddPasses(GraphBuilder, View, GetSceneTextures(), SceneColor, Model);
	}

	void AddMotionBlur()
	{
		const float DeltaTime = View.Family != nullptr ? View.Family->Time.GetDeltaWorldTimeSeconds() : 0.0f;
		FMotionBlurInputs BlurInputs =
			FMotionBlurInputs::FromSettings(View.FinalPostProcessSettings, SceneColor, DeltaTime);
		BlurInputs.SceneTextures = GetSceneTextures();
		SceneColor = AddMotionBlurPass(GraphBuilder, View, BlurInputs);
	}

	/** The display's own; where FXAA reads luma from two bits of alpha, half float. */
	EPixelFormat GetTonemapFormat() const
	{
		const EPixelFormat Format = Drydock::GetDisplayFormat(GetTonemapperOutputDeviceParameters().OutputDevice);
		return Sequence.IsEnabled(EFramePass::FXAA) && Format == PF_A2B10G10R10 ? PF_FloatRGBA : Format;
	}

	/** Called for by the settings alone: an extension would have read them. */
	void AddDualKawase()
	{
		FDualKawaseBlurInputs BlurInputs;
		BlurInputs.SceneColor = SceneColor;
		BlurInputs.Offset = View.FinalPostProcessSettings.DualKawaseBlurOffset;
		BlurInputs.PassNum = View.FinalPostProcessSettings.DualKawaseBlurPassNum;
		BlurInputs.bAsPrinted = IsDualKawaseAsPrinted();
		SceneColor = AddDualKawaseBlurPass(GraphBuilder, View, BlurInputs);
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
			View.ViewState->KeepTexture(GraphBuilder, Drydock::CustomSSRInputName, Result);
		}
	}

	static constexpr const char* Off = "ShowFlag.PostProcessing is off";

	FRDGBuilder& GraphBuilder;
	const FViewInfo& View;
	const FPostProcessingChainInputs& Inputs;
	const std::vector<Drydock::FEffectDecision>& Effects;
	Drydock::FViewExtensionFrame& Extensions;
	const bool bPostProcessing;
	const bool bTonemapper;
	Drydock::FArticleEffects ArticleEffects;
	FInsertionPoints::FSequence Sequence;
	FInsertionPoints Points;

	// What one part leaves for the next.
	FScreenPassTexture SceneColor; // the picture so far
	FScreenPassTexture HalfResolution;
	FSceneDownsampleChain SceneDownsampleChain;
	FRDGBufferRef EyeAdaptationBuffer = nullptr;
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
