// Source: engine PostProcess/PostProcessing.cpp (order of the chain, what each part needs).
#include "PostProcess/PostProcessingChain.h"

#include "ExtensionErrors.h"
#include "ExtensionFactory.h"
#include "PostProcess/ArticleEffects.h"
#include "PostProcess/OverridePassSequence.h"
#include "PostProcess/PassCallbacks.h"
#include "DualKawaseBlurPass.h"
#include "PixelFormat.h"
#include "PostProcessBloomSetup.h"
#include "PostProcessDownsample.h"
#include "PostProcessEyeAdaptation.h"
#include "PostProcessGaussianBloom.h"
#include "PostProcessToonBloom.h"
#include "PostProcessTonemap.h"
#include "SystemTextures.h"

#include <algorithm>
#include <array>

namespace
{

using EPoint = ISceneViewExtension::EPostProcessingPass;

/** The passes that can be the last of a frame, in order. */
enum class EPass : uint32
{
	MotionBlur,
	Tonemap,
	UnityBloom, // after the tonemapper
	FXAA,
	VisualizeDepthOfField,
	PrimaryUpscale,
	MAX
};

constexpr EPixelFormat DisplayFormat = PF_B8G8R8A8;

bool IsActive(const std::vector<Drydock::FEffectDecision>& Effects, const char* Name)
{
	return std::any_of(Effects.begin(), Effects.end(),
		[&](const Drydock::FEffectDecision& Effect) { return Effect.bActive && Effect.Name == Name; });
}

/** Half resolution, in the format of all that follows from it. */
FScreenPassTexture AddHalfResolutionPass(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor)
{
	FDownsamplePassInputs Inputs;
	Inputs.Name = TEXT("HalfResolutionSceneColor");
	Inputs.SceneColor = SceneColor;
	Inputs.Quality = GetDownsampleQuality();
	Inputs.FormatOverride = PF_FloatRGB;
	return AddDownsamplePass(GraphBuilder, View, Inputs);
}

/** Toon: set where toon bloom is active. */
FScreenPassTexture AddBloomPasses(FRDGBuilder& GraphBuilder, const FViewInfo& View,
	const FScreenPassTexture& SceneColor, FRDGBufferRef EyeAdaptationBuffer, const FToonBloomInputs* Toon)
{
	RDG_EVENT_SCOPE(GraphBuilder, "Bloom");
	const FScreenPassTexture HalfResolution = AddHalfResolutionPass(GraphBuilder, View, SceneColor);

	// As in the engine the scene's own chain is always declared; with a threshold nobody reads it, and the graph culls
	// it.
	FTextureDownsampleChain SceneChain;
	SceneChain.Init(GraphBuilder, View, HalfResolution, GetDownsampleChainQuality(), TEXT("SceneDownsample"));
	const float Threshold = View.FinalPostProcessSettings.BloomThreshold;
	if (!(Threshold > -1.0f) && Toon == nullptr)
	{
		return AddGaussianBloomPasses(GraphBuilder, View, &SceneChain);
	}

	FBloomSetupInputs SetupInputs;
	SetupInputs.SceneColor = HalfResolution;
	SetupInputs.EyeAdaptationBuffer = EyeAdaptationBuffer;
	SetupInputs.Threshold = Threshold;
	if (Toon != nullptr)
	{
		SetupInputs.SceneTextures = Toon->SceneTextures;
		SetupInputs.ToonIntensity = Toon->ToonIntensity;
		SetupInputs.FullResolutionSceneColor = SceneColor;
		SetupInputs.DownsampleQuality = GetDownsampleQuality();
	}
	FTextureDownsampleChain BloomChain;
	BloomChain.Init(GraphBuilder, View, AddBloomSetupPass(GraphBuilder, View, SetupInputs), GetDownsampleChainQuality(),
		TEXT("BloomDownsample"));
	return AddGaussianBloomPasses(GraphBuilder, View, &BloomChain);
}

/** Called for by the settings alone: an extension would have read them. */
FScreenPassTexture AddDualKawasePasses(
	FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& SceneColor)
{
	FDualKawaseBlurInputs Inputs;
	Inputs.SceneColor = SceneColor;
	Inputs.Offset = View.FinalPostProcessSettings.DualKawaseBlurOffset;
	Inputs.PassNum = View.FinalPostProcessSettings.DualKawaseBlurPassNum;
	Inputs.bAsPrinted = IsDualKawaseAsPrinted();
	return AddDualKawaseBlurPass(GraphBuilder, View, Inputs);
}

/** The insertion points of one view's chain: who is there, and the calls in order. */
class FInsertionPoints
{
public:
	FInsertionPoints(FRDGBuilder& InGraphBuilder, const Drydock::FNamedView& InView,
		const FPostProcessingChainInputs& InInputs, TOverridePassSequence<EPass>& InSequence,
		Drydock::FViewExtensionFrame& InExtensions)
		: GraphBuilder(InGraphBuilder)
		, View(InView)
		, Inputs(InInputs)
		, Sequence(InSequence)
		, Extensions(InExtensions)
	{
	}

	/** Asks the extensions for their callbacks at every point there is in this version. */
	void Subscribe()
	{
		for (const Drydock::FInsertionPoint& Point : Drydock::GetInsertionPoints())
		{
			if (!Drydock::HasInsertionPoint(Point.Pass, Extensions.GetEngineMinor()))
			{
				continue;
			}
			const std::optional<EPass> Pass = FindPass(Point.Pass);
			At(Point.Pass) = Extensions.Subscribe(Point.Pass, View, !Pass || Sequence.IsEnabled(*Pass));
			if (Pass)
			{
				Sequence.SetNumCallbacks(*Pass, static_cast<int32>(At(Point.Pass).size()));
			}
		}
	}

	bool HasCallbacks(EPoint Point) const { return !Callbacks[static_cast<size_t>(Point)].empty(); }

	/** Slots that callbacks find beside the picture. */
	void SetSlot(EPostProcessMaterialInput Slot, const FScreenPassTexture& Texture)
	{
		Slots[static_cast<size_t>(Slot)] = Texture;
	}

	/** The picture after all callbacks of a point. Note: what else is to be known of it. */
	FScreenPassTexture Run(EPoint Point, FScreenPassTexture SceneColor, const std::string& Note = "")
	{
		if (!IsThere(Point))
		{
			return SceneColor;
		}
		const std::optional<EPass> Pass = FindPass(Point);
		const bool bDropped = Pass && Sequence.IsAfterLastPass(*Pass);
		Record(Point, SceneColor, true, bDropped ? GetDroppedReason(Point) : Note);
		const std::vector<Drydock::FPassCallback>& PointCallbacks = At(Point);
		for (size_t Index = 0; Index < PointCallbacks.size(); ++Index)
		{
			FPostProcessMaterialInputs CallbackInputs = MakeInputs(SceneColor);
			if (Pass)
			{
				Sequence.AcceptOverrideIfLastPass(*Pass, CallbackInputs.OverrideOutput, static_cast<int32>(Index));
			}
			SceneColor = RunPassCallback(GraphBuilder, View, Drydock::GetPassName(Point), PointCallbacks[Index],
				CallbackInputs, Extensions.GetLog());
			if (bDropped && SceneColor.Texture != CallbackInputs.Textures[0].Texture)
			{
				Extensions.GetLog().Diagnostics.push_back(Drydock::MakeExtensionDiagnostic(Drydock::ESeverity::Warning,
					Drydock::WarnCallbackDropped, PointCallbacks[Index].Extension, GetDroppedReason(Point)));
			}
		}
		return SceneColor;
	}

	/** The one callback that stands in for the tonemapper. The first subscribed wins. */
	FScreenPassTexture RunReplacingTonemapper(const FScreenPassTexture& SceneColor, const FScreenPassTexture& Bloom)
	{
		Record(EPoint::ReplacingTonemapper, SceneColor, true,
			At(EPoint::ReplacingTonemapper).size() > 1 ? "only the first runs" : "");
		FPostProcessMaterialInputs CallbackInputs = MakeInputs(SceneColor);
		CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::CombinedBloom,
			Bloom.IsValid() ? Bloom : FScreenPassTexture(FRDGSystemTextures::Get(GraphBuilder).Black));
		if (!Sequence.AcceptOverrideIfLastPass(EPass::Tonemap, CallbackInputs.OverrideOutput))
		{
			CallbackInputs.OutputFormat = DisplayFormat;
		}
		return RunPassCallback(GraphBuilder, View, Drydock::GetPassName(EPoint::ReplacingTonemapper),
			At(EPoint::ReplacingTonemapper)[0], CallbackInputs, Extensions.GetLog());
	}

	/** A point that this frame does not come to. */
	void Skip(EPoint Point, const std::string& Reason)
	{
		if (!IsThere(Point))
		{
			return;
		}
		Record(Point, FScreenPassTexture(), false, Reason);
		for (const Drydock::FPassCallback& Callback : At(Point))
		{
			Extensions.GetLog().Diagnostics.push_back(Drydock::MakeExtensionDiagnostic(Drydock::ESeverity::Warning,
				Drydock::WarnPointNotReached, Callback.Extension,
				std::string("its callback at ") + Drydock::GetPassName(Point) + " is not called: " + Reason));
		}
	}

private:
	static std::optional<EPass> FindPass(EPoint Point)
	{
		switch (Point)
		{
		case EPoint::MotionBlur:
			return EPass::MotionBlur;
		case EPoint::Tonemap:
			return EPass::Tonemap;
		case EPoint::FXAA:
			return EPass::FXAA;
		case EPoint::VisualizeDepthOfField:
			return EPass::VisualizeDepthOfField;
		default:
			return {};
		}
	}

	std::vector<Drydock::FPassCallback>& At(EPoint Point) { return Callbacks[static_cast<size_t>(Point)]; }

	bool IsThere(EPoint Point) const { return Drydock::HasInsertionPoint(Point, Extensions.GetEngineMinor()); }

	static std::string GetDroppedReason(EPoint Point)
	{
		return std::string("the pass ") + Drydock::GetPassName(Point) +
			   " is disabled and comes after the last enabled one, which has written the output: a texture returned "
			   "here is not seen; subscribe to Tonemap, or where bIsPassEnabled is true";
	}

	FPostProcessMaterialInputs MakeInputs(const FScreenPassTexture& SceneColor) const
	{
		FPostProcessMaterialInputs CallbackInputs;
		CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, SceneColor);
		const FRDGSystemTextures& SystemTextures = FRDGSystemTextures::Get(GraphBuilder);
		CallbackInputs.SetInput(
			GraphBuilder, EPostProcessMaterialInput::SeparateTranslucency, FScreenPassTexture(SystemTextures.Black));
		const FRDGTextureRef Velocity =
			Inputs.SceneTextures ? Inputs.SceneTextures->GetContents()->GBufferVelocityTexture : SystemTextures.Black;
		CallbackInputs.SetInput(GraphBuilder, EPostProcessMaterialInput::Velocity,
			Velocity == SystemTextures.Black ? FScreenPassTexture(Velocity)
											 : FScreenPassTexture(Velocity, View.View->ViewRect));
		for (size_t Slot = 0; Slot < Slots.size(); ++Slot)
		{
			if (Slots[Slot].IsValid())
			{
				CallbackInputs.SetInput(GraphBuilder, static_cast<EPostProcessMaterialInput>(Slot), Slots[Slot]);
			}
		}
		CallbackInputs.SceneTextures = GetSceneTextureShaderParameters(Inputs.SceneTextures);
		CallbackInputs.CustomDepthTexture =
			Inputs.SceneTextures ? Inputs.SceneTextures->GetContents()->CustomDepthTexture : nullptr;
		return CallbackInputs;
	}

	void Record(EPoint Point, const FScreenPassTexture& SceneColor, bool bReached, const std::string& Reason)
	{
		Drydock::FHookPoint Entry;
		Entry.Point = Drydock::GetPassName(Point);
		Entry.View = View.Name;
		Entry.Space = ToString(Drydock::GetInsertionPoint(Point).Space);
		if (SceneColor.IsValid())
		{
			Entry.Resource = SceneColor.Texture->Name;
			Entry.Format = GetPixelFormatString(SceneColor.Texture->Desc.Format);
			Entry.Width = SceneColor.ViewRect.Width();
			Entry.Height = SceneColor.ViewRect.Height();
		}
		for (const Drydock::FPassCallback& Callback : At(Point))
		{
			Entry.Subscribers.push_back(Callback.Extension);
		}
		Entry.bCalled = bReached && !Entry.Subscribers.empty();
		Entry.Reason = !Reason.empty() ? Reason : Entry.Subscribers.empty() ? "nobody subscribed" : "";
		Extensions.GetLog().Points.push_back(Entry);
	}

	FRDGBuilder& GraphBuilder;
	const Drydock::FNamedView& View;
	const FPostProcessingChainInputs& Inputs;
	TOverridePassSequence<EPass>& Sequence;
	Drydock::FViewExtensionFrame& Extensions;
	std::array<std::vector<Drydock::FPassCallback>, static_cast<size_t>(EPoint::MAX)> Callbacks;
	std::array<FScreenPassTexture, kPostProcessMaterialInputCountMax> Slots;
};

/** Reads what next frame's screen-space reflections see; the picture of this frame is not changed by it. */
void RunSSRInput(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FPostProcessingChainInputs& Inputs,
	const FScreenPassTexture& SceneColor, FInsertionPoints& Points)
{
	if (View.State == nullptr)
	{
		Points.Skip(EPoint::SSRInput, "the view has no state that lives on to the next frame");
		return;
	}
	const FScreenPassTexture Result = Points.Run(
		EPoint::SSRInput, SceneColor, "the result is kept for the next frame's reflections and not seen in this one");
	if (Result.Texture != SceneColor.Texture && Inputs.CustomSSRInput != nullptr)
	{
		GraphBuilder.QueueTextureExtraction(Result.Texture, Inputs.CustomSSRInput);
	}
}

} // namespace

FPostProcessingChainOutputs AddPostProcessingPasses(FRDGBuilder& GraphBuilder, const Drydock::FNamedView& NamedView,
	const FPostProcessingChainInputs& Inputs, const std::vector<Drydock::FEffectDecision>& Effects,
	Drydock::FViewExtensionFrame& Extensions)
{
	RDG_EVENT_SCOPE(GraphBuilder, "PostProcessing");
	check(Inputs.SceneColor.IsValid());
	const FViewInfo& View = *NamedView.View;
	const bool bPostProcessing = View.Family == nullptr || View.Family->EngineShowFlags.PostProcessing;

	Drydock::FArticleEffects ArticleEffects(
		GraphBuilder, View, Drydock::FArticleEffectInputs{Inputs.SceneTextures, Inputs.LightColor}, Effects);

	TOverridePassSequence<EPass> Sequence(
		FScreenPassRenderTarget::CreateViewFamilyOutput(Inputs.ViewFamilyTexture, View));
	Sequence.SetEnabled(EPass::MotionBlur, bPostProcessing && IsActive(Effects, "MotionBlur"));
	Sequence.SetEnabled(EPass::Tonemap, true);
	Sequence.SetEnabled(EPass::UnityBloom, ArticleEffects.HasUnityBloomAfterTonemap());
	Sequence.SetEnabled(EPass::FXAA, bPostProcessing && IsActive(Effects, "FXAA"));
	Sequence.SetEnabled(EPass::VisualizeDepthOfField, false);
	Sequence.SetEnabled(EPass::PrimaryUpscale, IsActive(Effects, "Upscale"));
	Sequence.Finalize();

	FInsertionPoints Points(GraphBuilder, NamedView, Inputs, Sequence, Extensions);
	Points.Subscribe();

	FScreenPassTexture SceneColor = Inputs.SceneColor;
	const std::string Off = "ShowFlag.PostProcessing is off";
	if (bPostProcessing)
	{
		SceneColor = ArticleEffects.AddLighting(SceneColor);
		SceneColor = Points.Run(EPoint::BeforeDOF, SceneColor);
		SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::BeforeTranslucency, SceneColor);
		SceneColor = Points.Run(EPoint::AfterDOF, SceneColor);
		SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::AfterTranslucency, SceneColor);
		Points.Skip(EPoint::TranslucencyAfterDOF, "the scene has no separate translucency");
		RunSSRInput(GraphBuilder, View, Inputs, SceneColor, Points);
		SceneColor = Points.Run(EPoint::MotionBlur, SceneColor);
		if (IsActive(Effects, "DualKawaseBlur") && !Extensions.Has("FDualKawaseBlur"))
		{
			SceneColor = AddDualKawasePasses(GraphBuilder, View, SceneColor);
		}
		if (ArticleEffects.HasUnityBloomBeforeTonemap())
		{
			SceneColor = ArticleEffects.AddUnityBloom(SceneColor);
		}
	}
	else
	{
		for (const EPoint Point : {EPoint::BeforeDOF, EPoint::AfterDOF, EPoint::TranslucencyAfterDOF, EPoint::SSRInput,
				 EPoint::MotionBlur, EPoint::ReplacingTonemapper})
		{
			Points.Skip(Point, Off);
		}
	}

	FTonemapInputs TonemapInputs;
	TonemapInputs.EyeAdaptationBuffer = CreateEyeAdaptationBuffer(GraphBuilder, Inputs.ExposureScale);
	TonemapInputs.OutputFormat = DisplayFormat;
	FToonBloomInputs ToonInputs;
	ToonInputs.SceneColor = SceneColor;
	ToonInputs.ToonIntensity = View.FinalPostProcessSettings.BloomToonIntensity;
	const bool bToonBloom = IsActive(Effects, "ToonBloom");
	const bool bVisualizeToon = bPostProcessing && IsToonBloomMaskVisualized();
	if (bToonBloom || bVisualizeToon)
	{
		ToonInputs.SceneTextures =
			Inputs.SceneTextures ? Inputs.SceneTextures : CreateSceneTextureUniformBuffer(GraphBuilder, View);
	}
	if (bVisualizeToon)
	{
		SceneColor = AddToonBloomVisualizePass(GraphBuilder, View, ToonInputs);
	}
	else if (IsActive(Effects, "Bloom"))
	{
		TonemapInputs.Bloom = AddBloomPasses(
			GraphBuilder, View, SceneColor, TonemapInputs.EyeAdaptationBuffer, bToonBloom ? &ToonInputs : nullptr);
	}
	FPostProcessingChainOutputs Outputs;
	Outputs.Bloom = TonemapInputs.Bloom;
	if (!bVisualizeToon && ArticleEffects.WantsBloomInSceneColor())
	{
		SceneColor = ArticleEffects.AddBloomComposite(SceneColor, TonemapInputs.Bloom);
		SceneColor = ArticleEffects.AddRED(EREDPostProcessInsertion::AfterBloom, SceneColor);
		TonemapInputs.Bloom = FScreenPassTexture();
	}
	TonemapInputs.SceneColor = SceneColor;
	Outputs.SceneLinear = SceneColor;
	Outputs.BlurredToonShadow = ArticleEffects.GetBlurredToonShadow();
	if (bPostProcessing && Points.HasCallbacks(EPoint::ReplacingTonemapper))
	{
		SceneColor = Points.RunReplacingTonemapper(SceneColor, TonemapInputs.Bloom);
	}
	else
	{
		if (bPostProcessing)
		{
			Points.Skip(EPoint::ReplacingTonemapper, "nobody subscribed");
		}
		Sequence.AcceptOverrideIfLastPass(EPass::Tonemap, TonemapInputs.OverrideOutput);
		SceneColor = AddTonemapPass(GraphBuilder, View, TonemapInputs);
	}
	Points.SetSlot(EPostProcessMaterialInput::PreTonemapHDRColor, Outputs.SceneLinear);
	Points.SetSlot(EPostProcessMaterialInput::PostTonemapHDRColor, SceneColor);
	SceneColor = Points.Run(EPoint::Tonemap, SceneColor);
	if (ArticleEffects.HasUnityBloomAfterTonemap())
	{
		FScreenPassRenderTarget OverrideOutput;
		Sequence.AcceptOverrideIfLastPass(EPass::UnityBloom, OverrideOutput);
		SceneColor = ArticleEffects.AddUnityBloom(SceneColor, OverrideOutput);
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

	Outputs.Final = FScreenPassTexture(Inputs.ViewFamilyTexture, View.UnscaledViewRect);
	return Outputs;
}
