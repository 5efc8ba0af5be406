// The hooks of a frame: order, versions, what they may change, and the log of it. A little past 500 lines: all cases
// share the extension that records every hook.
#include <gtest/gtest.h>

#include "ExtensionFactory.h"
#include "ExtensionTestUtils.h"
#include "Extensions/EngineHooks.h"
#include "Extensions/ExtensionErrors.h"
#include "Frame/DrydockFrame.h"

using namespace ExtensionTest;

namespace
{

/** Overrides every hook of 5.4 and writes down each call. */
class FEverything : public FSceneViewExtensionBase
{
public:
	FEverything(const FAutoRegister& AutoRegister, std::string& InCalls, std::string InName, int32 InPriority = 0)
		: FSceneViewExtensionBase(AutoRegister)
		, Calls(InCalls)
		, Name(std::move(InName))
		, Priority(InPriority)
	{
	}

	int32 GetPriority() const override { return Priority; }
	void SetupViewFamily(FSceneViewFamily&) override { Note("SetupViewFamily"); }
	void SetupViewPoint(APlayerController*, FMinimalViewInfo&) override { Note("SetupViewPoint"); }
	void SetupViewProjectionMatrix(FSceneViewProjectionData&) override { Note("SetupViewProjectionMatrix"); }
	void SetupView(FSceneViewFamily&, FSceneView&) override { Note("SetupView"); }
	void BeginRenderViewFamily(FSceneViewFamily&) override { Note("BeginRenderViewFamily"); }
	void PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Note("PreRenderViewFamily"); }
	void PreRenderView_RenderThread(FRDGBuilder&, FSceneView&) override { Note("PreRenderView"); }
	void PreInitViews_RenderThread(FRDGBuilder&) override { Note("PreInitViews"); }
	void PreRenderBasePass_RenderThread(FRDGBuilder&, bool) override { Note("PreRenderBasePass"); }
	void PostRenderBasePassDeferred_RenderThread(FRDGBuilder&, FSceneView&, const FRenderTargetBindingSlots&,
		TRDGUniformBufferRef<FSceneTextureUniformParameters>) override
	{
		Note("PostRenderBasePassDeferred");
	}
	void PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs& Inputs) override
	{
		Inputs.Validate();
		Note("PrePostProcessPass");
	}
	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass == EPostProcessingPass::MotionBlur)
		{
			Note("Subscribe");
			Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FEverything::Callback, 3));
		}
	}
	void PostRenderView_RenderThread(FRDGBuilder&, FSceneView&) override { Note("PostRenderView"); }
	void PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Note("PostRenderViewFamily"); }

	FScreenPassTexture Callback(
		FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs& Inputs, int32 Payload)
	{
		Note("Callback" + std::to_string(Payload));
		return Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	}

private:
	void Note(const std::string& Hook) { Calls += Name + "." + Hook + "\n"; }

	std::string& Calls;
	std::string Name;
	int32 Priority;
};

/** Old and new form of everything that changed between versions. */
class FBothForms : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool) override
	{
		++NumOld;
	}
	void SubscribeToPostProcessingPass(
		EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool) override
	{
		++NumNew;
	}
	void PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&) override { ++NumCommandList; }

	int NumOld = 0;
	int NumNew = 0;
	int NumCommandList = 0;
};

void SetEngine(const ISceneViewExtension& Extension, int32 EngineMinor)
{
	FExtensionInfo Info = *GEngine->ViewExtensions->FindInfo(Extension);
	Info.EngineMinor = EngineMinor;
	GEngine->ViewExtensions->SetInfo(Extension, Info);
}

} // namespace

TEST(ViewExtensionHooks, AreCalledInTheEnginesOrder)
{
	std::string Calls;
	const auto Extension = FSceneViewExtensions::NewExtension<FEverything>(Calls, "A");
	Render();
	EXPECT_EQ("A.SetupViewFamily\n"
			  "A.SetupViewPoint\n"
			  "A.SetupViewProjectionMatrix\n"
			  "A.SetupView\n"
			  "A.BeginRenderViewFamily\n"
			  "A.PreRenderViewFamily\n"
			  "A.PreRenderView\n"
			  "A.PreInitViews\n"
			  "A.PreRenderBasePass\n"
			  "A.PostRenderBasePassDeferred\n"
			  "A.PrePostProcessPass\n"
			  "A.Subscribe\n"
			  "A.Callback3\n"
			  "A.PostRenderView\n"
			  "A.PostRenderViewFamily\n",
		Calls);
}

TEST(ViewExtensionHooks, HigherPriorityIsAlwaysFirst)
{
	std::string Calls;
	const auto Low = FSceneViewExtensions::NewExtension<FEverything>(Calls, "Low", 1);
	const auto High = FSceneViewExtensions::NewExtension<FEverything>(Calls, "High", 2);
	Render();
	for (const char* Hook : {"SetupViewFamily", "SetupViewPoint", "SetupView", "BeginRenderViewFamily", "PreRenderView",
			 "PostRenderBasePassDeferred", "PrePostProcessPass", "Subscribe", "Callback3", "PostRenderView"})
	{
		EXPECT_LT(Calls.find(std::string("High.") + Hook), Calls.find(std::string("Low.") + Hook)) << Hook;
	}
}

TEST(ViewExtensionHooks, EachViewHasItsOwnCalls)
{
	std::string Calls;
	const auto Extension = FSceneViewExtensions::NewExtension<FEverything>(Calls, "A");
	FFrameInputs Inputs = MakeFrame(FIntRect(0, 0, 12, Height));
	Inputs.Views.push_back(Inputs.Views[0]);
	Inputs.Views[0].Name = "Left";
	Inputs.Views[1].Name = "Right";
	Inputs.Views[1].Rect = FIntRect(12, 0, Width, Height);
	const FFrameResult Frame = Render(Inputs);
	std::vector<std::string> Views;
	for (const FHookCall& Call : Frame.Log.Calls)
	{
		if (Call.Hook == "MotionBlur" || Call.Hook == "SetupView" || Call.Hook == "BeginRenderViewFamily")
		{
			Views.push_back(Call.Hook + ":" + Call.View);
		}
	}
	EXPECT_EQ((std::vector<std::string>{"SetupView:Left", "SetupView:Right",
				  "BeginRenderViewFamily:", "MotionBlur:Left", "MotionBlur:Right"}),
		Views);
}

TEST(ViewExtensionHooks, TwoHalvesAreTheWholePicture)
{
	const FImage Whole = Render().Final.ToImage();
	FFrameInputs Inputs = MakeFrame(FIntRect(0, 0, 12, Height));
	Inputs.Views.push_back(Inputs.Views[0]);
	Inputs.Views[1].Rect = FIntRect(12, 0, Width, Height);
	const FFrameResult Halves = Render(Inputs);
	EXPECT_EQ(Whole.Values, Halves.Final.ToImage().Values); // no bloom, no vignette: every pixel is its own
	EXPECT_EQ(Render().SceneLinear.ToImage().Values, Halves.SceneLinear.ToImage().Values);
}

TEST(ViewExtensionHooks, LogSaysWhatWasDone)
{
	const auto Extension =
		MakeExtension(EPoint::Tonemap, [](const FCall& Call) { return Call.Fill(FLinearColor::Red); });
	const FFrameResult Frame = Render();
	EXPECT_EQ((std::vector<std::string>{"FAtPoint.SubscribeToPostProcessingPass(SSRInput)",
				  "FAtPoint.SubscribeToPostProcessingPass(MotionBlur)",
				  "FAtPoint.SubscribeToPostProcessingPass(Tonemap)", "FAtPoint.SubscribeToPostProcessingPass(FXAA)",
				  "FAtPoint.SubscribeToPostProcessingPass(VisualizeDepthOfField)", "FAtPoint.Tonemap"}),
		GetCalls(Frame));
	EXPECT_EQ("subscribed 1", GetDid(Frame, "SubscribeToPostProcessingPass(Tonemap)"));
	EXPECT_EQ(0u, GetDid(Frame, "Tonemap").find("drew to ViewFamilyTexture (24 x 12) ")) << GetDid(Frame, "Tonemap");
	EXPECT_NE(std::string::npos, GetDid(Frame, "Tonemap").find("added 1 pass: ")) << GetDid(Frame, "Tonemap");
}

TEST(ViewExtensionHooks, TwoOfAKindAreToldApart)
{
	const auto Fill = [](const FCall& Call)
	{
		return Call.Fill(FLinearColor::Red);
	};
	const auto A = MakeExtension(EPoint::Tonemap, Fill);
	const auto B = MakeExtension(EPoint::Tonemap, Fill);
	const std::vector<std::string> Calls = GetCalls(Render());
	EXPECT_EQ("FAtPoint.Tonemap", Calls[Calls.size() - 2]);
	EXPECT_EQ("FAtPoint #2.Tonemap", Calls.back());
}

TEST(ViewExtensionHooks, InactiveOnesAreNotCalled)
{
	std::string Calls;
	const auto Extension = FSceneViewExtensions::NewExtension<FEverything>(Calls, "A");
	FSceneViewExtensionIsActiveFunctor Never;
	Never.IsActiveFunction = [](const ISceneViewExtension*, const FSceneViewExtensionContext&)
	{
		return TOptional<bool>(false);
	};
	Extension->IsActiveThisFrameFunctions.Add(Never);
	EXPECT_TRUE(Render().Log.Calls.empty());
	EXPECT_EQ("", Calls);
}

TEST(ViewExtensionHooks, TheFamilyHoldsThemForTheFrame)
{
	class FDropsItself : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SetupViewFamily(FSceneViewFamily&) override { Self.Reset(); }
		void PostRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { ++*NumEnds; }
		TSharedPtr<FDropsItself, ESPMode::ThreadSafe> Self;
		int* NumEnds = nullptr;
	};
	int NumEnds = 0;
	{
		const auto Extension = FSceneViewExtensions::NewExtension<FDropsItself>();
		Extension->Self = Extension;
		Extension->NumEnds = &NumEnds;
	}
	Render();
	EXPECT_EQ(1, NumEnds);
	Render();
	EXPECT_EQ(1, NumEnds);
}

TEST(ViewExtensionHooks, SceneColourMayBeEditedInPlace)
{
	class FEdits : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void PrePostProcessPass_RenderThread(
			FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessingInputs& Inputs) override
		{
			AddClearRenderTargetPass(
				GraphBuilder, (*Inputs.SceneTextures)->SceneColorTexture, FLinearColor(0.5f, 0.0f, 0.0f, 1.0f));
		}
	};
	const auto Extension = FSceneViewExtensions::NewExtension<FEdits>();
	const FFrameResult Frame = Render();
	EXPECT_EQ(0.5, Frame.SceneLinear.Get(7, 7, 0));
	EXPECT_EQ(0.0, Frame.SceneLinear.Get(7, 7, 1));
	EXPECT_TRUE(FindPoint(Frame, "PrePostProcessPass")->bCalled);
}

TEST(ViewExtensionHooks, SetupViewMayChangeSettings)
{
	class FBlooms : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SetupView(FSceneViewFamily&, FSceneView& View) override
		{
			View.FinalPostProcessSettings.BloomIntensity = 2.0f;
		}
	};
	const auto Extension = FSceneViewExtensions::NewExtension<FBlooms>();
	const FFrameResult Frame = Render();
	EXPECT_EQ("set BloomIntensity 0 -> 2", GetDid(Frame, "SetupView"));
	EXPECT_TRUE(Frame.Views[0].Effects[0].bActive) << Frame.Views[0].Effects[0].Reason;
	EXPECT_GT(Frame.Final.Get(0, 0, 0), 0.0); // the black corner glows
}

TEST(ViewExtensionHooks, SetupViewFamilyMayChangeShowFlags)
{
	class FNoBloom : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SetupViewFamily(FSceneViewFamily& Family) override { Family.EngineShowFlags.SetBloom(false); }
	};
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Settings.Settings.BloomIntensity = 1.0f;
	EXPECT_TRUE(Render(Inputs).Views[0].Effects[0].bActive);
	const auto Extension = FSceneViewExtensions::NewExtension<FNoBloom>();
	const FFrameResult Frame = Render(Inputs);
	EXPECT_FALSE(Frame.Views[0].Effects[0].bActive);
	EXPECT_NE(std::string::npos, Frame.Views[0].Effects[0].Reason.find("ShowFlag.Bloom"));
}

TEST(ViewExtensionHooks, SetupViewPointMovesTheCameraBeforeVolumesAreBlended)
{
	class FMoves : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SetupViewPoint(APlayerController*, FMinimalViewInfo& ViewInfo) override { ViewInfo.Location.X = 100.0; }
	};
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].MakeSettings = [&](const FMinimalViewInfo& Camera)
	{
		FViewSettings Settings = Inputs.Views[0].Settings;
		Settings.Settings.BloomIntensity = static_cast<float>(Camera.Location.X);
		return Settings;
	};
	EXPECT_EQ(0.0f, Render(Inputs).Views[0].Settings.BloomIntensity);
	const auto Extension = FSceneViewExtensions::NewExtension<FMoves>();
	EXPECT_EQ(100.0f, Render(Inputs).Views[0].Settings.BloomIntensity);
}

TEST(ViewExtensionHooks, SetupViewProjectionMatrixHasTheCameraAndItsWordHolds)
{
	static FSceneViewProjectionData Seen;
	static FMatrix44f Used;
	static FVector UsedLocation;
	class FZooms : public FSceneViewExtensionBase
	{
	public:
		using FSceneViewExtensionBase::FSceneViewExtensionBase;
		void SetupViewProjectionMatrix(FSceneViewProjectionData& Data) override
		{
			Seen = Data;
			Data.ProjectionMatrix.M[0][0] *= 2.0;
			Data.ViewOrigin.Z = 5.0;
		}
		void PreRenderView_RenderThread(FRDGBuilder&, FSceneView& View) override
		{
			Used = static_cast<FViewInfo&>(View).UniformParameters.ViewToClip;
			UsedLocation = View.ViewLocation;
		}
	};
	FFrameInputs Inputs = MakeFrame();
	Inputs.Views[0].Lens.HorizontalFov = 90.0;
	Inputs.Views[0].Lens.Yaw = 90.0;
	Inputs.Views[0].Camera.Rotation.Yaw = 90.0;
	Inputs.Views[0].Camera.FOV = 90.0f;
	const auto Extension = FSceneViewExtensions::NewExtension<FZooms>();
	Render(Inputs);
	// Half the width is seen at the width's half: 90 degrees. Looking along Y, what lies along Y is ahead (view z).
	EXPECT_NEAR(1.0, Seen.ProjectionMatrix.M[0][0], 1e-12);
	EXPECT_NEAR(1.0, Seen.ViewRotationMatrix.M[1][2], 1e-12);
	EXPECT_NEAR(2.0f, Used.M[0][0], 1e-6);
	EXPECT_EQ(5.0, UsedLocation.Z);
}

// Delegates -----------------------------------------------------------------------------------------------------------

namespace
{

int GNumStatic = 0;
FScreenPassTexture CountStatic(FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
{
	++GNumStatic;
	return Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
}

class FAllDelegates : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass != EPostProcessingPass::MotionBlur)
		{
			return;
		}
		const auto Count = [this](FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
		{
			++NumCalls;
			return FScreenPassTexture(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		};
		Callbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FAllDelegates::Method));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FAllDelegates::Method));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateLambda(Count));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateSPLambda(this, Count));
		Callbacks.Add(FAfterPassCallbackDelegate::CreateWeakLambda(&Object, Count));
		Callbacks.Add(FPostProcessingPassDelegate::CreateStatic(CountStatic));
	}
	FScreenPassTexture Method(FRDGBuilder&, const FSceneView&, const FPostProcessMaterialInputs& Inputs)
	{
		++NumCalls;
		return Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	}

	UObject Object;
	int NumCalls = 0;
};

} // namespace

TEST(ViewExtensionHooks, EveryKindOfDelegateIsCalled)
{
	GNumStatic = 0;
	const auto Extension = FSceneViewExtensions::NewExtension<FAllDelegates>();
	Render();
	EXPECT_EQ(5, Extension->NumCalls);
	EXPECT_EQ(1, GNumStatic);
}

// Versions
// --------------------------------------------------------------------------------------------------------------

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
	for (int Index = 0; Index < static_cast<int>(EExtensionHook::Num); ++Index)
	{
		EXPECT_NE('\0', GetHookVersions(static_cast<EExtensionHook>(Index)).Signature[0]);
	}
}

// RenderFrame
// -----------------------------------------------------------------------------------------------------------

namespace
{

FFrameDesc MakeDesc()
{
	FFrameDesc Desc;
	Desc.Extent = FIntPoint(Width, Height);
	Desc.SceneColor.Init(FLinearColor(0.18f, 0.18f, 0.18f, 1.0f), Width * Height);
	return Desc;
}

} // namespace

TEST(RenderFrame, CallsEveryHookOnce)
{
	std::string Calls;
	const auto Extension = FSceneViewExtensions::NewExtension<FEverything>(Calls, "A");
	RenderFrame(MakeDesc());
	EXPECT_EQ(15, std::count(Calls.begin(), Calls.end(), '\n'));
}

TEST(RenderFrame, GivesTheDisplayedPicture)
{
	FFrameDesc Desc = MakeDesc();
	Desc.ShowFlags.Add(TEXT("Bloom"), false);
	const FFrameOutput Output = RenderFrame(Desc);
	EXPECT_EQ(FIntPoint(Width, Height), Output.Extent);
	ASSERT_EQ(Width * Height, Output.Color.Num());
	// Middle grey maps to itself: sRGB of 0.18 is 0.461; the vignette takes a little of it off the centre.
	EXPECT_NEAR(0.461, Output.Color[Height / 2 * Width + Width / 2].G, 2.5 / 255.0);
}

TEST(RenderFrame, TonemapSubscriberDrawsTheOutput)
{
	const auto Extension =
		MakeExtension(EPoint::Tonemap, [](const FCall& Call) { return Call.Fill(FLinearColor::Red); });
	EXPECT_EQ(FLinearColor(1.0f, 0.0f, 0.0f, 1.0f), RenderFrame(MakeDesc()).Color[0]);
}

TEST(RenderFrame, ShadingModelsAreInGBufferB)
{
	float Id = -1.0f;
	const auto Extension = MakeExtension(EPoint::MotionBlur,
		[&](const FCall& Call)
		{
			FRDGTextureRef GBufferB = Call.Inputs.SceneTextures.SceneTextures->GetContents()->GBufferBTexture;
			Id = static_cast<float>(
				Call.GraphBuilder.GetPooledTexture(GBufferB)->GetRHI()->ReadTexelDouble(1, 0).W * 255);
			return Call.GetPicture();
		});
	FFrameDesc Desc = MakeDesc();
	Desc.ShadingModelID.Init(1, Width * Height);
	Desc.ShadingModelID[1] = 8;
	RenderFrame(Desc);
	EXPECT_FLOAT_EQ(8.0f, Id);
}

TEST(RenderFrame, RefusesDescriptionsThatMakeNoSense)
{
	FFrameDesc Desc = MakeDesc();
	Desc.Extent.X = 0;
	EXPECT_THROW(RenderFrame(Desc), FError);
	Desc = MakeDesc();
	Desc.SceneColor.Pop();
	EXPECT_THROW(RenderFrame(Desc), FError);
	Desc = MakeDesc();
	Desc.ViewRect = FIntRect(0, 0, Width + 1, Height);
	EXPECT_THROW(RenderFrame(Desc), FError);
	Desc = MakeDesc();
	Desc.ShowFlags.Add(TEXT("Blom"), true);
	EXPECT_THROW(RenderFrame(Desc), FError);
}
