// Renders one frame, in the order in which the engine does. A little past 500 lines: one class, which goes through a
// frame.
#include "Frame/Frame.h"

#include "Async/Async.h"
#include "Chain/PostProcessingChain.h"
#include "Effects/Effects.h"
#include "Effects/Exposure.h"
#include "Engine/BlendableInterface.h"
#include "Engine/Engine.h"
#include "Extensions/ViewExtensions.h"
#include "Frame/BasePassTargets.h"
#include "Frame/FamilyTarget.h"
#include "Frame/FrameCamera.h"
#include "Frame/RendererDelegates.h"
#include "Misc/App.h"
#include "Misc/CoreDelegates.h"
#include "Modules/ModuleManager.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphNotes.h"
#include "RenderGraphObserver.h"
#include "RenderGraphUtils.h"
#include "Tonemap/TonemapOutputDevice.h"
#include "UniformBufferStructs.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace Drydock
{

namespace
{

/** A view with what belongs to it for the length of a frame. */
struct FViewOfFrame
{
	explicit FViewOfFrame(const std::shared_ptr<FSceneViewState>& InState)
		: State(InState)
	{
	}

	std::shared_ptr<FSceneViewState> State;
	FViewInfo View; // its FinalPostProcessSettings are the only live settings
	FViewConditions Conditions;
	std::vector<FEffectDecision> Effects;
	FPostProcessingChainOutputs Outputs;
	TRefCountPtr<IPooledRenderTarget> SceneLinear;
	std::map<std::string, FKeptTexture> Kept;
	TRefCountPtr<IPooledRenderTarget> Histogram;
	std::optional<FExposureReport> Exposure;
};

/** Passes the graph's events on to the host's observer, and keeps the compiled graph for the log. */
class FFrameObserver final : public IRDGObserver
{
public:
	explicit FFrameObserver(IRDGObserver* InNext)
		: Next(InNext)
	{
	}

	void OnGraphCompiled(const FRDGCompiledGraph& InGraph) override
	{
		Graph = InGraph;
		if (Next != nullptr)
		{
			Next->OnGraphCompiled(InGraph);
		}
	}
	void OnLoadExternals(const std::vector<FRDGExternalLoad>& Loads) override
	{
		if (Next != nullptr)
		{
			Next->OnLoadExternals(Loads);
		}
	}
	bool WantsPlannedExternals() const override { return Next != nullptr && Next->WantsPlannedExternals(); }
	void OnExternalsPlanned(const std::vector<FRDGExternalLoad>& Loads) override
	{
		if (Next != nullptr)
		{
			Next->OnExternalsPlanned(Loads);
		}
	}
	void OnPassPlanned(int32_t PassIndex, const FRDGPass& Pass) override
	{
		if (Next != nullptr)
		{
			Next->OnPassPlanned(PassIndex, Pass);
		}
	}
	bool WantsZeroedTextures() const override { return Next != nullptr && Next->WantsZeroedTextures(); }
	bool OnTextureMade(FRHITexture& Texture) override { return Next != nullptr && Next->OnTextureMade(Texture); }
	bool ShowsWarnings() const override { return Next != nullptr && Next->ShowsWarnings(); }
	void OnPassExecuted(int32_t PassIndex, const FRDGPass& Pass, double Milliseconds, const FPassCounters& Counters,
		const std::vector<FRDGTexture*>& WrittenTextures) override
	{
		if (Next != nullptr)
		{
			Next->OnPassExecuted(PassIndex, Pass, Milliseconds, Counters, WrittenTextures);
		}
	}

	FRDGCompiledGraph Graph;

private:
	IRDGObserver* Next;
};

bool IsSameCamera(const FMinimalViewInfo& A, const FMinimalViewInfo& B)
{
	return A.Location == B.Location && A.Rotation == B.Rotation && A.FOV == B.FOV;
}

bool AreSameFlags(const FEngineShowFlags& A, const FEngineShowFlags& B)
{
	for (int32 Index = 0; Index < GetShowFlagInfos().Num(); ++Index)
	{
		if (A.GetSingleFlag(static_cast<uint32>(Index)) != B.GetSingleFlag(static_cast<uint32>(Index)))
		{
			return false;
		}
	}
	return true;
}

class FFrameRenderer
{
public:
	explicit FFrameRenderer(const FFrameInputs& InInputs)
		: Inputs(InInputs)
		, Extensions(InInputs.Engine, Result.Log)
		, Observer(InInputs.Observer)
	{
		check(!Inputs.Views.empty());
		Result.Rect = Inputs.Views[0].Rect;
		for (const FFrameView& View : Inputs.Views)
		{
			Result.Rect.Union(View.Rect);
		}
	}

	FFrameResult Render()
	{
		const auto Begin = std::chrono::steady_clock::now();
		FModuleManager::Get().StartupPendingModules();
		FApp::SetCurrentTime(static_cast<double>(Inputs.Time.RealTimeSeconds - Inputs.Time.DeltaRealTimeSeconds));
		FApp::UpdateLastTime();
		FApp::SetCurrentTime(static_cast<double>(Inputs.Time.RealTimeSeconds));
		FApp::SetDeltaTime(static_cast<double>(Inputs.Time.DeltaRealTimeSeconds));
		FCoreDelegates::OnBeginFrame.Broadcast();
		GWorld->Tick(Inputs.Time.DeltaWorldTimeSeconds, static_cast<double>(Inputs.Time.WorldTimeSeconds));
		SetUpFamily();
		BuildAndRunGraph();
		RunWaitingTasks();
		FCoreDelegates::OnEndFrame.Broadcast();
		Result.Milliseconds =
			std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - Begin).count();
		Extensions.Finish(Observer.Graph);
		for (const std::unique_ptr<FViewOfFrame>& View : Views)
		{
			ReadExposure(*View);
		}
		for (size_t Index = 0; Index < Views.size(); ++Index)
		{
			FViewOfFrame& View = *Views[Index];
			Result.Views.push_back({Inputs.Views[Index].Name, Inputs.Views[Index].Rect,
				View.View.FinalPostProcessSettings, View.Conditions.ExposureScale, View.View.PreExposure,
				std::move(View.Effects), std::move(View.Kept), std::move(View.Exposure)});
		}
		if (Inputs.bExecute)
		{
			ReadPictures();
			for (const std::unique_ptr<FViewOfFrame>& View : Views)
			{
				Result.ViewStates.push_back(View->State->EndFrame());
			}
		}
		else
		{
			Result.Graph = std::move(Observer.Graph);
		}
		return std::move(Result);
	}

private:
	/** The game thread's half. */
	void SetUpFamily()
	{
		Family.EngineShowFlags = Inputs.ShowFlags;
		Family.Scene = GWorld->Scene;
		FamilyTarget.SetDesc(MakeTargetDesc());
		Family.RenderTarget = &FamilyTarget;
		Family.FrameNumber = Inputs.FrameNumber;
		Family.FrameCounter = Inputs.FrameNumber;
		GFrameNumber = GFrameNumberRenderThread = Inputs.FrameNumber;
		GFrameCounter = GFrameCounterRenderThread = Inputs.FrameNumber;
		Family.Time = Inputs.Time;
		Extensions.Gather(Family, Inputs.Plugins);
		Extensions.SetupViewFamily(Family);
		for (size_t Index = 0; Index < Inputs.Views.size(); ++Index)
		{
			const std::shared_ptr<FSceneViewState>& Kept = Inputs.Views[Index].State;
			Views.push_back(std::make_unique<FViewOfFrame>(
				Kept ? Kept : std::make_shared<FSceneViewState>(static_cast<uint32>(Index + 1))));
			Views.back()->State->BeginFrame(
				Index < Inputs.ViewStates.size() ? Inputs.ViewStates[Index] : FViewHistory());
			NamedViews.push_back({&Views.back()->View, Inputs.Views[Index].Name});
			SetUpView(Inputs.Views[Index], *Views.back());
			Family.Views.Add(&Views.back()->View);
			Extensions.SetupView(Family, NamedViews.back(), Views.back()->Conditions.Gates);
		}
		Extensions.BeginRenderViewFamily(Family);
		Extensions.PostCreateSceneRenderer(Family);
	}

	void SetUpView(const FFrameView& Source, FViewOfFrame& Target)
	{
		FMinimalViewInfo Camera = Source.Camera;
		Extensions.SetupViewPoint(Source.Name, Camera);
		FSceneViewProjectionData Projection = MakeProjection(Source, Camera);
		Extensions.SetupViewProjectionMatrix(Source.Name, Projection);

		const bool bMoved = !IsSameCamera(Camera, Source.Camera);
		FViewSettings Settings = bMoved && Source.MakeSettings ? Source.MakeSettings(Camera) : Source.Settings;
		Settings.Engine = Inputs.Engine;
		Settings.PreExposure = Source.PreExposure;
		if (!AreSameFlags(Family.EngineShowFlags, Inputs.ShowFlags))
		{
			Settings.ShowFlags = Family.EngineShowFlags;
			const std::vector<FSettingGate> Gates = ApplyShowFlags(Settings.Settings, Family.EngineShowFlags);
			Settings.Gates.insert(Settings.Gates.end(), Gates.begin(), Gates.end());
		}

		FViewInfo& View = Target.View;
		View.Family = &Family;
		View.State = Target.State.get();
		View.ViewState = Target.State.get();
		View.bCameraCut = Target.State->IsFirstFrame() || Source.Lens.bCut;
		Target.State->LastRenderTime = Family.Time.GetWorldTimeSeconds();
		Target.State->LastRenderTimeDelta = Family.Time.GetDeltaWorldTimeSeconds();
		View.ViewRect = GetSceneRect(Source);
		View.UnscaledViewRect = Source.Rect;
		View.UnconstrainedViewRect = Source.Rect;
		View.PreExposure = Source.PreExposure;
		View.EngineProfile = Inputs.Engine;
		View.ViewLocation = Projection.ViewOrigin;
		View.FinalPostProcessSettings = std::move(Settings.Settings);
		const TArray<FWeightedBlendable> Blendables = View.FinalPostProcessSettings.BlendableManager.Blendables;
		for (const FWeightedBlendable& Blendable : Blendables)
		{
			if (const auto* const Blended = Cast<IBlendableInterface>(Blendable.Object.Get()))
			{
				Blended->OverrideBlendableSettings(View, Blendable.Weight);
			}
		}
		Target.Conditions = std::move(Settings);
		if (View.ViewRect != Source.Rect)
		{
			Projection.SetViewRectangle(View.ViewRect);
		}
		SetUpCamera(Projection, MakeClipJitter(Source.Lens, Source.Rect), View);
		FViewHistory& Next = Target.State->Next;
		Next.bValid = true;
		Next.FrameNumber = Inputs.FrameNumber;
		View.UniformParameters.GameTime = Inputs.Time.WorldTimeSeconds;
		View.UniformParameters.RealTime = Inputs.Time.RealTimeSeconds;
		View.UniformParameters.DeltaTime = Inputs.Time.DeltaWorldTimeSeconds;
		View.UniformParameters.FrameNumber = Inputs.FrameNumber;
		View.UniformParameters.StateFrameIndex = Inputs.FrameNumber;
		View.UniformParameters.StateFrameIndexMod8 = Inputs.FrameNumber % 8;
		View.InitViewUniformBuffer(Inputs.Extent);
	}

	/** Makes the camera's projection, before extensions change it. */
	static FSceneViewProjectionData MakeProjection(const FFrameView& Source, const FMinimalViewInfo& Camera)
	{
		FSceneCamera Lens = Source.Lens;
		Lens.Location = Camera.Location;
		Lens.Pitch = Camera.Rotation.Pitch;
		Lens.Yaw = Camera.Rotation.Yaw;
		Lens.Roll = Camera.Rotation.Roll;
		if (Camera.FOV != Source.Camera.FOV)
		{
			Lens.HorizontalFov = static_cast<double>(Camera.FOV);
			Lens.FocalLength.reset();
		}
		const bool bWhole = Source.PictureRect.Width() > 0 && Source.PictureRect.Height() > 0;
		const FIntRect Picture = bWhole ? Source.PictureRect : Source.Rect;
		return MakeProjectionData(Lens, Picture.Size(), Source.Rect - Picture.Min, Source.Rect);
	}

	/** The render thread's half. */
	void BuildAndRunGraph()
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Frame"));
		GraphBuilder.SetObserver(&Observer);
		const FSceneTextures SceneTextures = Inputs.RegisterSceneTextures(GraphBuilder);
		for (const FNamedView& View : NamedViews)
		{
			View.View->SceneTextures = &SceneTextures;
		}
		Family.SceneTexturesConfig = SceneTextures.Config;
		Family.SceneTextures = &SceneTextures;
		Extensions.PreRender(GraphBuilder, Family, NamedViews);
		Extensions.PreInitViews(GraphBuilder);
		for (const std::unique_ptr<FViewOfFrame>& View : Views)
		{
			UpdateCamera(View->View);
			View->View.InitViewUniformBuffer(Inputs.Extent);
		}
		const FFrameUniformBufferScope OwnView(
			Inputs.Engine.bUnboundBufferEnds ? nullptr : FViewUniformShaderParameters::FTypeInfo::GetStructMetadata(),
			Views.front()->View.ViewUniformBuffer->GetContents());
		GEngine->GetPreRenderDelegateEx().Broadcast(GraphBuilder);
		Extensions.PreRenderBasePass(GraphBuilder);

		FPostProcessingInputs PostProcessingInputs;
		PostProcessingInputs.ViewFamilyTexture = FamilyTarget.AddTo(GraphBuilder, MakeTargetDesc());
		if (NamedViews.size() > 1 && NamedViews[0].View->bUseComputePasses)
		{
			// Nothing else writes between views: without compute entries the first view's render pass clears that.
			AddClearRenderTargetPass(GraphBuilder, PostProcessingInputs.ViewFamilyTexture);
		}
		PostProcessingInputs.CustomDepthTexture = SceneTextures.CustomDepth;
		if (!Extensions.IsEmpty())
		{
			PostProcessingInputs.SceneTextures = CreateSceneTextureUniformBuffer(GraphBuilder, &SceneTextures);
			Extensions.PostRenderBasePass(
				GraphBuilder, NamedViews, GetBasePassTargets(SceneTextures), PostProcessingInputs.SceneTextures);
		}
		CallRendererDelegates(GraphBuilder, NamedViews, SceneTextures);
		if (!Extensions.IsEmpty())
		{
			Extensions.PrePostProcess(GraphBuilder, NamedViews, PostProcessingInputs);
		}
		for (size_t Index = 0; Index < Views.size(); ++Index)
		{
			AddChain(GraphBuilder, NamedViews[Index], *Views[Index], SceneTextures, PostProcessingInputs);
		}
		GEngine->GetPostRenderDelegateEx().Broadcast(GraphBuilder);
		Extensions.PostRender(GraphBuilder, Family, NamedViews);
		GraphBuilder.QueueTextureExtraction(PostProcessingInputs.ViewFamilyTexture, &Final);
		const std::vector<FDiagnostic> Notes = GetGraphNotes(GraphBuilder);
		Result.Log.Diagnostics.insert(Result.Log.Diagnostics.end(), Notes.begin(), Notes.end());
		if (Inputs.bExecute)
		{
			GraphBuilder.Execute();
			const std::vector<FDiagnostic> All = GetGraphNotes(GraphBuilder);
			Result.Log.Diagnostics.insert(
				Result.Log.Diagnostics.end(), All.begin() + static_cast<std::ptrdiff_t>(Notes.size()), All.end());
		}
		else
		{
			Observer.Graph = GraphBuilder.Compile();
			GraphBuilder.Discard();
		}
	}

	static FIntRect GetSceneRect(const FFrameView& View)
	{
		return View.SceneRect.Width() > 0 && View.SceneRect.Height() > 0 ? View.SceneRect : View.Rect;
	}

	FRDGTextureDesc MakeTargetDesc() const
	{
		const FIntPoint Extent = Inputs.OutputExtent.X > 0 ? Inputs.OutputExtent : Inputs.Extent;
		const EPixelFormat Format = GetDisplayFormat(GetTonemapperOutputDeviceParameters().OutputDevice);
		// Compute entries write it where they are preferred; a swap chain's texture would not let them.
		const bool bCompute = NamedViews.empty() || NamedViews[0].View->bUseComputePasses;
		return FRDGTextureDesc::Create2D(Extent, Format, FClearValueBinding::Black,
			TexCreate_RenderTargetable | TexCreate_ShaderResource | (bCompute ? TexCreate_UAV : TexCreate_None));
	}

	void AddChain(FRDGBuilder& GraphBuilder, const FNamedView& NamedView, FViewOfFrame& Target,
		const FSceneTextures& SceneTextures, const FPostProcessingInputs& PostProcessingInputs)
	{
		Target.Conditions.bSeparateTranslucency = SceneTextures.SeparateTranslucency != nullptr;
		const std::vector<std::string> ExtensionNames = Extensions.GetNames();
		const FEffectInputs Deciding(NamedView.View->FinalPostProcessSettings, Target.Conditions, ExtensionNames);
		Target.Effects = Decide(Deciding, *NamedView.View);
		FPostProcessingChainInputs ChainInputs;
		ChainInputs.SceneColor = FScreenPassTexture(SceneTextures.Color, NamedView.View->ViewRect);
		ChainInputs.ViewFamilyTexture = PostProcessingInputs.ViewFamilyTexture;
		ChainInputs.ExposureScale = Target.Conditions.ExposureScale;
		ChainInputs.SceneTextures = PostProcessingInputs.SceneTextures;
		ChainInputs.LightColor = Inputs.LightColor;
		ChainInputs.bAutoExposure = IsAutoExposureActive(Target.Conditions);
		Target.Outputs = AddPostProcessingPasses(GraphBuilder, NamedView, ChainInputs, Target.Effects, Extensions);
		GraphBuilder.QueueTextureExtraction(Target.Outputs.SceneLinear.Texture, &Target.SceneLinear);
		if (Target.Outputs.Histogram)
		{
			GraphBuilder.QueueTextureExtraction(Target.Outputs.Histogram, &Target.Histogram);
		}
		if (Inputs.bKeepMeasured)
		{
			Target.Outputs.Kept["GBufferB"] = FScreenPassTexture(SceneTextures.GBufferB, NamedView.View->ViewRect);
			KeepMeasured(GraphBuilder, Target);
		}
	}

	/** From the settings; what these call for may have nothing to do in this scene. */
	std::vector<FEffectDecision> Decide(const FEffectInputs& Deciding, const FViewInfo& View) const
	{
		std::vector<FEffectDecision> Decided = DecideBySettings(Deciding);
		const FContentQuestions Questions = AskContent(Deciding, Decided);
		if (Inputs.MeasureContent && Questions.Any())
		{
			Decided = Extensions.IsEmpty() && !HasRendererDelegates()
						  ? GateByContent(Deciding, Inputs.MeasureContent(View.ViewRect, Questions), Decided)
						  : NoteContentUnseen(Deciding, Decided,
								"the scene is not looked at: a view extension or a delegate may change what it holds");
		}
		return CompleteReasons(Deciding, std::move(Decided));
	}

	/** Keeps the textures that active effects are measured on beyond the graph. */
	static void KeepMeasured(FRDGBuilder& GraphBuilder, FViewOfFrame& Target)
	{
		for (const FEffectDecision& Decision : Target.Effects)
		{
			if (!Decision.bActive || Decision.Effect->Measurement->Measure == nullptr)
			{
				continue;
			}
			for (const char* const Name : Decision.Effect->Measurement->Textures)
			{
				const auto Found = Target.Outputs.Kept.find(Name);
				if (Found != Target.Outputs.Kept.end() && Found->second.Texture != nullptr &&
					Target.Kept.count(Name) == 0)
				{
					FKeptTexture& Kept = Target.Kept[Name];
					Kept.Rect = Found->second.ViewRect;
					GraphBuilder.QueueTextureExtraction(Found->second.Texture, &Kept.Texture);
				}
			}
		}
	}

	/** Reads the result of an automatic exposure. */
	void ReadExposure(FViewOfFrame& View) const
	{
		if (!Inputs.bExecute || !IsAutoExposureActive(View.Conditions))
		{
			return;
		}
		View.Exposure = MakeExposureReport(View.View, GetAutoExposureMethod(View.View.FinalPostProcessSettings),
			*View.State->Next.Buffers.at(EyeAdaptationName), View.Histogram.GetReference());
		View.Conditions.ExposureScale = View.Exposure->Scale;
	}

	void ReadPictures()
	{
		Result.Final = FPicture(Final, Result.Rect);
		const FPicture First(Views[0]->SceneLinear, Views[0]->Outputs.SceneLinear.ViewRect);
		if (Views.size() == 1)
		{
			Result.SceneLinear = First;
			return;
		}
		FIntRect All = GetSceneRect(Inputs.Views[0]);
		for (const FFrameView& View : Inputs.Views)
		{
			All.Union(GetSceneRect(View));
		}
		const FRHITextureDesc Desc = FRHITextureDesc::Create2D(
			All.Size(), Views[0]->SceneLinear->GetDesc().Format, FClearValueBinding::None, TexCreate_ShaderResource);
		const TRefCountPtr<FRHITexture> Texture = new FRHITexture(Desc, TEXT("SceneLinear"));
		Result.SceneLinear = FPicture(Texture, FIntRect(FIntPoint(0, 0), All.Size()));
		for (size_t Index = 0; Index < Views.size(); ++Index)
		{
			const FIntRect Rect = GetSceneRect(Inputs.Views[Index]);
			const FPicture Picture(Views[Index]->SceneLinear, Views[Index]->Outputs.SceneLinear.ViewRect);
			// A view whose extensions changed its size has no place in the picture of all.
			if (Picture.Width == Rect.Width() && Picture.Height == Rect.Height())
			{
				Picture.PasteInto(*Texture, Rect.Min - All.Min);
			}
		}
	}

	const FFrameInputs& Inputs;
	FFrameResult Result;
	FViewExtensionFrame Extensions;
	FFrameObserver Observer;
	FFamilyTarget FamilyTarget;
	FViewFamilyInfo Family;
	std::vector<std::unique_ptr<FViewOfFrame>> Views;
	std::vector<FNamedView> NamedViews;
	TRefCountPtr<IPooledRenderTarget> Final;
};

} // namespace

FFrameResult RenderViewFamily(const FFrameInputs& Inputs)
{
	return FFrameRenderer(Inputs).Render();
}

} // namespace Drydock
