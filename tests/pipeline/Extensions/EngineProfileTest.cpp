// Hooks by the engine's version: which form a plugin of each is called by, and what is said of those never called.
#include "RecordingExtensions.h"

using namespace ExtensionTest;

TEST(EngineProfile, OldAndNewSignatureOfSubscribe)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FBothForms>();
	Render();
	EXPECT_EQ(5, Extension->NumOld);
	EXPECT_EQ(0, Extension->NumNew);

	SetEngine(*Extension, 5);
	FFrameInputs Inputs = MakeFrame();
	Inputs.Engine = *FindEngineProfile(5);
	Render(Inputs);
	EXPECT_EQ(5, Extension->NumOld);
	EXPECT_EQ(9, Extension->NumNew); // every point of 5.5
	EXPECT_EQ(0, Extension->NumCommandList);
}

TEST(EngineProfile, OverridesThatAreNeverCalledAreReported)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FBothForms>();
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<int>{WarnHookNeverCalled, WarnHookNeverCalled}), GetCodes(Frame));
	EXPECT_NE(
		std::string::npos, Frame.Log.Diagnostics[0].Message.find(
							   "PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&), which engine 5.4"))
		<< Frame.Log.Diagnostics[0].Message;
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[1].Message.find("const FSceneView&"));
}

TEST(EngineProfile, HooksOfTheMobileRendererAreReportedAsNeverCalled)
{
	class FMobileAlone : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void PostRenderBasePassMobile_RenderThread(FRHICommandList&, FSceneView&) override { ADD_FAILURE(); }
	};
	class FBothRenderers : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void PrePostProcessPassMobile_RenderThread(
			FRDGBuilder&, const FSceneView&, const FMobilePostProcessingInputs&) override
		{
			ADD_FAILURE();
		}
		void PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs&) override {}
	};
	const auto Alone = FSceneViewExtensions::NewExtension<FMobileAlone>();
	const auto Both = FSceneViewExtensions::NewExtension<FBothRenderers>();
	const FFrameResult Frame = Render();
	ASSERT_EQ((std::vector<int>{WarnHookNeverCalled, WarnHookNeverCalled}), GetCodes(Frame));
	EXPECT_EQ(ESeverity::Warning, Frame.Log.Diagnostics[0].Severity);
	EXPECT_EQ(0u, Frame.Log.Diagnostics[0].Message.find(
					  "it overrides PostRenderBasePassMobile_RenderThread(FRHICommandList&, FSceneView&), which is the "
					  "mobile renderer's: the deferred one never calls it; override "
					  "PostRenderBasePassDeferred_RenderThread("))
		<< Frame.Log.Diagnostics[0].Message;
	EXPECT_EQ(ESeverity::Note, Frame.Log.Diagnostics[1].Severity);
	EXPECT_TRUE(Frame.Log.Diagnostics[1].Message.ends_with("the deferred one never calls it"));
}

TEST(EngineProfile, HooksAsOlderArticlesHaveThemAreAcceptedAndReported)
{
	class FOld : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void PostRenderBasePassMobile_RenderThread(FRHICommandListImmediate&, FSceneView&) override { ADD_FAILURE(); }
		void PostRenderBasePass_RenderThread(FRHICommandListImmediate&, FSceneView&) override { ADD_FAILURE(); }
	};
	const auto Extension = FSceneViewExtensions::NewExtension<FOld>();
	const FFrameResult Frame = Render();
	ASSERT_EQ((std::vector<int>{WarnHookNeverCalled, WarnHookNeverCalled}), GetCodes(Frame));
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find("the mobile renderer's"));
	for (const FDiagnostic& Diagnostic : Frame.Log.Diagnostics)
	{
		EXPECT_NE(std::string::npos, Diagnostic.Message.find("; override PostRenderBasePassDeferred_RenderThread("));
	}
}

TEST(EngineProfile, APluginOfAnotherVersionIsReported)
{
	const auto Extension =
		MakeExtension(EPoint::Tonemap, [](const FCall& Call) { return Call.Fill(FLinearColor::Red); });
	SetEngine(*Extension, 3);
	EXPECT_EQ((std::vector<int>{WarnEngineDiffers}), GetCodes(Render()));
}

TEST(EngineProfile, APluginOfAVersionThatNobodyKnowsGetsTheNearestOnesHooks)
{
	std::string Calls;
	const auto Extension = FSceneViewExtensions::NewExtension<FEverything>(Calls, "A");
	for (const int32 Minor : {GetEngineProfiles().back().Minor + 1, 99, -3})
	{
		SetEngine(*Extension, Minor);
		Calls.clear();
		const FFrameResult Frame = Render();
		EXPECT_NE(std::string::npos, Calls.find("A.SetupView\n")) << Minor;
		ASSERT_FALSE(Frame.Log.Diagnostics.empty());
		EXPECT_EQ(WarnEngineUnknown, Frame.Log.Diagnostics[0].Code);
		EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find("engine 5." + std::to_string(Minor)));
	}
}

TEST(EngineProfile, SMAAIsAPointFrom57BetweenFXAAAndTheLast)
{
	class FRecorder : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SubscribeToPostProcessingPass(EPostProcessingPass Pass, const FSceneView&,
			FPostProcessingPassDelegateArray&, bool bIsPassEnabled) override
		{
			Points += std::string(GetPassName(Pass)) + (bIsPassEnabled ? "+ " : " ");
		}
		std::string Points;
	};
	const auto Extension = FSceneViewExtensions::NewExtension<FRecorder>();
	for (const int32 Minor : {6, 7})
	{
		SetEngine(*Extension, Minor);
		FFrameInputs Inputs = MakeFrame();
		Inputs.Engine = *FindEngineProfile(Minor);
		Extension->Points.clear();
		Render(Inputs);
		EXPECT_TRUE(Extension->Points.ends_with(
			Minor == 6 ? "Tonemap+ FXAA VisualizeDepthOfField " : "Tonemap+ FXAA SMAA VisualizeDepthOfField "))
			<< Extension->Points;
	}
}

TEST(EngineProfile, HooksOf57)
{
	class FNew : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void BeginRenderViewFamily(FSceneViewFamily&) override { Calls += "Begin "; }
		void PostCreateSceneRenderer(const FSceneViewFamily&, ISceneRenderer*) override { Calls += "Created "; }
		void PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Calls += "Pre "; }
		void PostTLASBuild_RenderThread(FRDGBuilder&, FSceneView&) override { ADD_FAILURE(); }
		ESceneViewExtensionFlags GetFlags() const override
		{
			return ESceneViewExtensionFlags::SubscribesToPostTLASBuild;
		}
		std::string Calls;
	};
	const auto Extension = FSceneViewExtensions::NewExtension<FNew>();
	SetEngine(*Extension, 7);
	FFrameInputs Inputs = MakeFrame();
	Inputs.Engine = *FindEngineProfile(7);
	const FFrameResult Frame = Render(Inputs);
	EXPECT_EQ("Begin Created Pre ", Extension->Calls);
	ASSERT_EQ((std::vector<int>{WarnHookNeverCalled}), GetCodes(Frame));
	EXPECT_NE(std::string::npos, Frame.Log.Diagnostics[0].Message.find("ray-tracing"));

	SetEngine(*Extension, 6);
	Inputs.Engine = *FindEngineProfile(6);
	Extension->Calls.clear();
	Render(Inputs);
	EXPECT_EQ("Begin Pre ", Extension->Calls);
}

TEST(EngineProfile, ThePluginsVersionDecidesWhichHooksItGets)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FBothForms>();
	SetEngine(*Extension, 5);
	Render();
	EXPECT_EQ(0, Extension->NumOld);
	EXPECT_EQ(5, Extension->NumNew); // the points that the run has
}

TEST(EngineProfile, OneThatFollowsGetsWhatItHas)
{
	const auto Extension =
		MakeExtension(EPoint::Tonemap, [](const FCall& Call) { return Call.Fill(FLinearColor::Red); });
	SetEngine(*Extension, AnyEngineVersion);
	FFrameInputs Inputs = MakeFrame();
	Inputs.Engine = *FindEngineProfile(6);
	EXPECT_TRUE(Render(Inputs).Log.Diagnostics.empty());
	EXPECT_EQ(1, Extension->NumCalls);
}

TEST(EngineProfile, ReplacingTheTonemapper)
{
	const auto Extension = MakeExtension(EPoint::ReplacingTonemapper,
		[](const FCall& Call)
		{
			EXPECT_TRUE(Call.Inputs.GetInput(EPostProcessMaterialInput::CombinedBloom).IsValid());
			return Call.Fill(FLinearColor(0.0f, 1.0f, 0.0f, 1.0f));
		});
	SetEngine(*Extension, AnyEngineVersion);
	FFrameInputs Inputs = MakeFrame();
	Render(Inputs);
	EXPECT_EQ(0, Extension->NumCalls); // 5.4 has no such point
	Inputs.Engine = *FindEngineProfile(5);
	EXPECT_EQ(1.0, Render(Inputs).Final.Get(3, 3, 1));
	EXPECT_EQ(1, Extension->NumCalls);
}

TEST(EngineHooks, EveryHookHasARow)
{
	EXPECT_EQ(static_cast<size_t>(EExtensionHook::Num), GetHookVersions().size());
	EXPECT_EQ("PreRenderBasePass", GetHookName(EExtensionHook::PreRenderBasePass));
	EXPECT_EQ("PostTLASBuild", GetHookName(EExtensionHook::PostTLASBuild));
	EXPECT_EQ("PostRenderViewFamily", GetHookName(EExtensionHook::PostRenderViewFamilyCommandList));
}
