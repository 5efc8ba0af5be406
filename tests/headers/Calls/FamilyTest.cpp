// Calls on view families, view extensions, their inputs and scene textures.
#include "Calls.h"
#include "FrameCalls.h"

#include "DynamicResolutionState.h"
#include "EngineModule.h"
#include "PostProcess/PostProcessing.h"
#include "SceneTextureParameters.h"
#include "UnrealClient.h"

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Family;

class FPlainExtension : public FSceneViewExtensionBase
{
public:
	FPlainExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}
	void SetupViewFamily(FSceneViewFamily&) override {}
	void SetupView(FSceneViewFamily&, FSceneView&) override {}
	void SetupViewPoint(APlayerController*, FMinimalViewInfo&) override {}
	void SetupViewProjectionMatrix(FSceneViewProjectionData&) override {}
	void BeginRenderViewFamily(FSceneViewFamily&) override {}
	void PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override {}
	void PreRenderView_RenderThread(FRDGBuilder&, FSceneView&) override {}
	void PreInitViews_RenderThread(FRDGBuilder&) override {}
	void PreRenderBasePass_RenderThread(FRDGBuilder&, bool) override {}
	void PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&,
		TRDGUniformBufferRef<FSceneTextureUniformParameters>) override
	{
	}
	void PostRenderView_RenderThread(FRDGBuilder&, FSceneView&) override {}
	void PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override {}
	int32 GetPriority() const override { return 7; }
	bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext& Context) const override
	{
		return Context.GetWorld() == nullptr || bActive;
	}

	bool bActive = true;
};

void CallFamily(FSceneViewFamily& Family)
{
	CALL("FSceneViewFamily::Views", Family.Views.Num() <= 1);
	CALL("FSceneViewFamily::EngineShowFlags", Family.EngineShowFlags.PostProcessing);
	CALL("FEngineShowFlags::Bloom, Tonemapper, MotionBlur, DepthOfField, AntiAliasing",
		Family.EngineShowFlags.Bloom && Family.EngineShowFlags.Tonemapper && Family.EngineShowFlags.MotionBlur &&
			Family.EngineShowFlags.DepthOfField);
	CALL("FEngineShowFlags::Game, Lighting, Rendering, Wireframe, PathTracing",
		Family.EngineShowFlags.Game && Family.EngineShowFlags.Lighting && Family.EngineShowFlags.Rendering &&
			!Family.EngineShowFlags.Wireframe && !Family.EngineShowFlags.PathTracing);
	CALL("FEngineShowFlags::SetBloom, SetMotionBlur",
		[&]
		{
			FEngineShowFlags Flags = Family.EngineShowFlags;
			Flags.SetBloom(false);
			Flags.SetMotionBlur(false);
			return !Flags.Bloom && !Flags.MotionBlur;
		}());
	CALL("FEngineShowFlags(ESFIM_Game)", FEngineShowFlags(ESFIM_Game).PostProcessing);
	CALL("FSceneViewFamily::Scene, Scene->GetWorld", Family.Scene->GetWorld() == GWorld);
	CALL("FSceneInterface::GetRenderScene, GetFeatureLevel, GetShaderPlatform",
		Family.Scene->GetRenderScene() != nullptr && Family.Scene->GetFeatureLevel() == Family.GetFeatureLevel() &&
			Family.Scene->GetShaderPlatform() == GMaxRHIShaderPlatform);
	CALL("FSceneViewFamily::GetFeatureLevel", Family.GetFeatureLevel() == GMaxRHIFeatureLevel);
	CALL("FSceneViewFamily::GetShaderPlatform", Family.GetShaderPlatform() == GMaxRHIShaderPlatform);
	CALL("FSceneViewFamily::Time, FGameTime::GetDeltaRealTimeSeconds", Family.Time.GetDeltaRealTimeSeconds() >= 0.0f);
	CALL("FGameTime::GetWorldTimeSeconds, GetRealTimeSeconds, GetDeltaWorldTimeSeconds",
		Family.Time.GetWorldTimeSeconds() >= 0.0f && Family.Time.GetRealTimeSeconds() >= 0.0f &&
			Family.Time.GetDeltaWorldTimeSeconds() >= 0.0f);
	CALL("FSceneViewFamily::FrameNumber, FrameCounter", Family.FrameNumber == uint32(Family.FrameCounter));
	CALL("FSceneViewFamily::SecondaryViewFraction", Family.SecondaryViewFraction == 1.0f);
	CALL("FSceneViewFamily::SceneCaptureSource", Family.SceneCaptureSource == SCS_FinalToneCurveHDR);
	CALL("FSceneViewFamily::bIsHDR, bIsMainViewFamily, bResolveScene",
		!Family.bIsHDR && Family.bIsMainViewFamily && Family.bResolveScene);
	CALL("FSceneViewFamily::ViewExtensions", Family.ViewExtensions.Num() >= 1);
	CALL("FSceneViewFamily::GetScreenPercentageInterface, GetResolutionFractionsUpperBound",
		Family.GetScreenPercentageInterface()->GetResolutionFractionsUpperBound()[GDynamicPrimaryResolutionFraction] ==
			1.0f);
	CALL("DynamicRenderScaling::TMap, GDynamicPrimaryResolutionFraction",
		[]
		{
			DynamicRenderScaling::TMap<float> Map;
			Map.SetAll(2.0f);
			return Map[GDynamicPrimaryResolutionFraction] == 2.0f;
		}());
	CALL("FSceneViewFamily::RenderTarget, GetSizeXY",
		Family.RenderTarget == nullptr ||
			Family.RenderTarget->GetSizeXY() == FIntPoint(Calls::FrameWidth, Calls::FrameHeight));
	CALL("static_cast<FViewFamilyInfo&>", static_cast<FViewFamilyInfo&>(Family).SceneTexturesConfig.Extent.X >= 0);
}

void CallInputs(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs)
{
	Inputs.Validate();
	CALL("FPostProcessingInputs::Validate", true);
	CALL("FPostProcessingInputs::SceneTextures, (*SceneTextures)->SceneColorTexture",
		(*Inputs.SceneTextures)->SceneColorTexture != nullptr);
	CALL("TRDGUniformBuffer::GetParameters, GetContents", Inputs.SceneTextures->GetParameters()->SceneColorTexture ==
															  Inputs.SceneTextures->GetContents()->SceneColorTexture);
	const FSceneTextureUniformParameters& Textures = *Inputs.SceneTextures->GetParameters();
	CALL("FSceneTextureUniformParameters::SceneDepthTexture", Textures.SceneDepthTexture != nullptr);
	CALL("FSceneTextureUniformParameters::GBufferATexture..FTexture",
		Textures.GBufferATexture && Textures.GBufferBTexture && Textures.GBufferCTexture && Textures.GBufferDTexture &&
			Textures.GBufferETexture && Textures.GBufferFTexture);
	CALL("FSceneTextureUniformParameters::GBufferVelocityTexture", Textures.GBufferVelocityTexture != nullptr);
	CALL("FSceneTextureUniformParameters::CustomDepthTexture, CustomStencilTexture",
		Textures.CustomDepthTexture && Textures.CustomStencilTexture);
	CALL("FSceneTextureUniformParameters::ScreenSpaceAOTexture, PointClampSampler",
		Textures.ScreenSpaceAOTexture && Textures.PointClampSampler);
	CALL("FPostProcessingInputs::ViewFamilyTexture", Inputs.ViewFamilyTexture != nullptr);
	CALL("FPostProcessingInputs::CustomDepthTexture, bSeparateCustomStencil",
		Inputs.CustomDepthTexture == nullptr || !Inputs.bSeparateCustomStencil);
	CALL("CreateSceneTextureShaderParameters(GraphBuilder, View, Mode)",
		CreateSceneTextureShaderParameters(GraphBuilder, View, ESceneTextureSetupMode::All).SceneTextures != nullptr);
	CALL("CreateSceneTextureShaderParameters(GraphBuilder, SceneTextures, FeatureLevel, Mode)",
		CreateSceneTextureShaderParameters(GraphBuilder, &static_cast<const FViewInfo&>(View).GetSceneTextures(),
			View.GetFeatureLevel(), ESceneTextureSetupMode::SceneColor | ESceneTextureSetupMode::GBuffers)
				.SceneTextures != nullptr);
	CALL("GetSceneTextureShaderParameters",
		GetSceneTextureShaderParameters(Inputs.SceneTextures).SceneTextures == Inputs.SceneTextures);
	CALL("CreateSceneTextureUniformBuffer",
		CreateSceneTextureUniformBuffer(GraphBuilder, View, ESceneTextureSetupMode::SceneDepth) != nullptr);
	CALL("GetSceneTextureParameters", GetSceneTextureParameters(GraphBuilder, View).SceneDepthTexture != nullptr);
	CALL("ESceneTextureSetupMode", EnumHasAnyFlags(ESceneTextureSetupMode::All,
									   ESceneTextureSetupMode::SceneVelocity | ESceneTextureSetupMode::CustomDepth));
	CALL("FSceneViewFamily::RenderTarget->GetRenderTargetTexture",
		View.Family->RenderTarget->GetSizeXY() == FIntPoint(Calls::FrameWidth, Calls::FrameHeight));
	CALL("FViewFamilyInfo::GetSceneTextures",
		static_cast<const FViewFamilyInfo*>(View.Family)->GetSceneTextures().Config.Extent.X == Calls::FrameWidth);
}

FScreenPassTexture CallPass(FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
{
	Inputs.Validate();
	CALL("FPostProcessMaterialInputs::Validate", true);
	const FScreenPassTexture SceneColor = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	CALL("FPostProcessMaterialInputs::GetInput, EPostProcessMaterialInput::SceneColor", SceneColor.IsValid());
	const FScreenPassTextureSlice Slice = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	CALL(
		"FScreenPassTextureSlice of GetInput", Slice.IsValid() && Slice.TextureSRV->Desc.Texture == SceneColor.Texture);
	CALL("FScreenPassTexture::CopyFromSlice", FScreenPassTexture::CopyFromSlice(GraphBuilder, Slice) == SceneColor);
	CALL("FPostProcessMaterialInputs::Textures",
		Inputs.Textures[uint32(EPostProcessMaterialInput::SceneColor)] == SceneColor);
	CALL("FPostProcessMaterialInputs::OverrideOutput", !Inputs.OverrideOutput.IsValid());
	CALL("FPostProcessMaterialInputs::OutputFormat, bAllowSceneColorInputAsOutput",
		Inputs.OutputFormat == PF_Unknown && Inputs.bAllowSceneColorInputAsOutput);
	CALL("FPostProcessMaterialInputs::SceneTextures.SceneTextures",
		Inputs.SceneTextures.SceneTextures->GetParameters()->SceneDepthTexture != nullptr);
	CALL("EPostProcessMaterialInput::Velocity, SeparateTranslucency, CombinedBloom",
		(Inputs.GetInput(EPostProcessMaterialInput::Velocity).IsValid() || true) &&
			EPostProcessMaterialInput::CombinedBloom == EPostProcessMaterialInput::PreTonemapHDRColor);
	FPostProcessMaterialInputs Own;
	Own.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, SceneColor);
	CALL("FPostProcessMaterialInputs::SetInput",
		Own.GetInput(EPostProcessMaterialInput::SceneColor).Texture == SceneColor.Texture);
	CALL("FPostProcessMaterialInputs::ReturnUntouchedSceneColorForPostProcessing",
		Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder) == SceneColor);
	return SceneColor;
}

} // namespace

TEST(CallsOfFamilies, InAFrame)
{
	Calls::RunInFrame({.Family = &CallFamily, .Inputs = &CallInputs, .Pass = &CallPass});
}

TEST(CallsOfFamilies, Extensions)
{
	const TSharedRef<FPlainExtension, ESPMode::ThreadSafe> Extension =
		FSceneViewExtensions::NewExtension<FPlainExtension>();
	CALL("FSceneViewExtensions::NewExtension, FSceneViewExtensionBase, FAutoRegister", Extension->GetPriority() == 7);
	CALL("ISceneViewExtension: SetupViewFamily, SetupView, BeginRenderViewFamily, SetupViewPoint, "
		 "SetupViewProjectionMatrix",
		true);
	CALL("ISceneViewExtension: PreRenderViewFamily_RenderThread, PreRenderView_RenderThread, "
		 "PreInitViews_RenderThread, PreRenderBasePass_RenderThread",
		true);
	CALL("ISceneViewExtension: PostRenderBasePassDeferred_RenderThread, PrePostProcessPass_RenderThread", true);
	CALL("ISceneViewExtension: PostRenderView_RenderThread, PostRenderViewFamily_RenderThread", true);
	CALL("ISceneViewExtension: SubscribeToPostProcessingPass, IsActiveThisFrame_Internal, GetPriority", true);
	CALL("EPostProcessingPass::SSRInput, MotionBlur, Tonemap, FXAA, VisualizeDepthOfField, BeforeDOF, AfterDOF",
		ISceneViewExtension::EPostProcessingPass::MotionBlur != ISceneViewExtension::EPostProcessingPass::Tonemap);
	CALL("FSceneViewExtensionContext, GetWorld, Viewport, Scene",
		FSceneViewExtensionContext().GetWorld() == nullptr &&
			FSceneViewExtensionContext(GWorld->Scene).GetWorld() == GWorld &&
			FSceneViewExtensionContext().Viewport == nullptr);
	CALL("GEngine->ViewExtensions->GatherActiveExtensions",
		GEngine->ViewExtensions->GatherActiveExtensions(FSceneViewExtensionContext()).Num() >= 1);
	FSceneViewExtensionIsActiveFunctor Functor;
	Functor.IsActiveFunction = [](const ISceneViewExtension*, const FSceneViewExtensionContext&)
	{
		return TOptional<bool>(false);
	};
	Extension->IsActiveThisFrameFunctions.Add(Functor);
	CALL("IsActiveThisFrameFunctions, FSceneViewExtensionIsActiveFunctor",
		!Extension->IsActiveThisFrame(FSceneViewExtensionContext()));
	COMPILES(
		"FWorldSceneViewExtension", class FWorld
		: public
		FWorldSceneViewExtension{public : FWorld(const FAutoRegister& R, UWorld* W) : FWorldSceneViewExtension(R, W){}};
		FSceneViewExtensions::NewExtension<FWorld>(GWorld));
	COMPILES("GetRendererModule", GetRendererModule());
}
