// The hooks of a frame: their order, what they may change, and the log of them.
#include "RecordingExtensions.h"

using namespace ExtensionTest;

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
