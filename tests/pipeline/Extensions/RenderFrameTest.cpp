// RenderFrame: a frame from a description, with the extensions that are registered.
#include "RecordingExtensions.h"

#include "Engine/Engine.h"
#include "EngineModule.h"
#include "HAL/ConsoleVariableTools.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "SceneTextures.h"
#include "UnrealClient.h"

using namespace ExtensionTest;

namespace
{

FFrameDesc MakeDesc()
{
	FFrameDesc Desc;
	Desc.Extent = FIntPoint(Width, Height);
	Desc.SceneColor.Init(FLinearColor(0.18f, 0.18f, 0.18f, 1.0f), Width * Height);
	return Desc;
}

/** Asks for the family's target, before there is a graph too where it is told so, and draws over the final picture. */
class FTargetExtension : public FSceneViewExtensionBase
{
public:
	FTargetExtension(const FAutoRegister& AutoRegister, bool bInEarly)
		: FSceneViewExtensionBase(AutoRegister)
		, bEarly(bInEarly)
	{
	}

	void SetupViewFamily(FSceneViewFamily&) override {}
	void SetupView(FSceneViewFamily&, FSceneView&) override {}
	void BeginRenderViewFamily(FSceneViewFamily& Family) override
	{
		EXPECT_EQ(FIntPoint(Width, Height), Family.RenderTarget->GetSizeXY());
		Target = bEarly ? Family.RenderTarget->GetRenderTargetTexture() : nullptr;
	}
	void PostRenderView_RenderThread(FRDGBuilder& GraphBuilder, FSceneView& View) override
	{
		const FRenderTarget& Family = *View.Family->RenderTarget;
		EXPECT_TRUE(!bEarly || Target == Family.GetRenderTargetTexture());
		Target = Family.GetRenderTargetTexture();
		FRDGTextureRef Texture = RegisterExternalTexture(GraphBuilder, Target, TEXT("Mine"));
		EXPECT_STREQ(TEXT("ViewFamilyTexture"), Texture->Name);
		EXPECT_EQ(Texture, Family.GetRenderTargetTexture(GraphBuilder));
		AddClearRenderTargetPass(GraphBuilder, Texture, FLinearColor::Red);
	}

	const bool bEarly;
	FTextureRHIRef Target;
};

} // namespace

TEST(RenderFrame, TheFamilysTargetIsTheFinalPicture)
{
	for (const int32 Immediate : {0, 1})
	{
		const FScopedConsoleVariable Mode(TEXT("r.RDG.ImmediateMode"), Immediate);
		for (const bool bEarly : {false, true})
		{
			const auto Extension = FSceneViewExtensions::NewExtension<FTargetExtension>(bEarly);
			const FFrameOutput Output = RenderFrame(MakeDesc());
			ASSERT_TRUE(Extension->Target.IsValid());
			EXPECT_EQ(FIntPoint(Width, Height), Extension->Target->GetDesc().Extent);
			EXPECT_EQ(FLinearColor(1.0f, 0.0f, 0.0f, 1.0f), Output.Color[0]) << Immediate << bEarly;
			EXPECT_EQ(FLinearColor(1.0f, 0.0f, 0.0f, 1.0f), Output.Color.Last()) << Immediate << bEarly;
		}
	}
}

/** Notes its hooks around the engine's delegates. */
class FNotingExtension : public FSceneViewExtensionBase
{
public:
	FNotingExtension(const FAutoRegister& AutoRegister, std::string& InCalls)
		: FSceneViewExtensionBase(AutoRegister)
		, Calls(InCalls)
	{
	}

	void SetupViewFamily(FSceneViewFamily&) override {}
	void SetupView(FSceneViewFamily&, FSceneView&) override {}
	void BeginRenderViewFamily(FSceneViewFamily& InFamily) override { Family = &InFamily; }
	void PreRenderViewFamily_RenderThread(FRDGBuilder&, FSceneViewFamily&) override { Calls += "begin "; }
	void PrePostProcessPass_RenderThread(FRDGBuilder&, const FSceneView&, const FPostProcessingInputs&) override
	{
		Calls += "post-process ";
	}
	void PostRenderView_RenderThread(FRDGBuilder&, FSceneView&) override { Calls += "end"; }

	std::string& Calls;
	FSceneViewFamily* Family = nullptr;
};

TEST(RenderFrame, CallsTheEnginesDelegatesAtTheirPlaces)
{
	std::string Calls;
	bool bCover = false;
	const auto Extension = FSceneViewExtensions::NewExtension<FNotingExtension>(Calls);
	const FDelegateHandle Pre = GEngine->GetPreRenderDelegateEx().AddLambda([&](FRDGBuilder&) { Calls += "pre "; });
	const FDelegateHandle Resolved = GetRendererModule().GetResolvedSceneColorCallbacks().AddLambda(
		[&](FRDGBuilder& GraphBuilder, const FSceneTextures& SceneTextures)
		{
			Calls += "resolved ";
			AddClearRenderTargetPass(GraphBuilder, SceneTextures.Color.Target, FLinearColor::Green);
		});
	const FDelegateHandle Opaque =
		GetRendererModule().RegisterPostOpaqueRenderDelegate(FPostOpaqueRenderDelegate::CreateLambda(
			[&](FPostOpaqueRenderParameters& Parameters)
			{
				Calls += "opaque ";
				EXPECT_EQ(Parameters.ViewportRect, Parameters.View->ViewRect);
				EXPECT_EQ(Parameters.ViewMatrix.M[3][0], Parameters.View->ViewMatrices.GetViewMatrix().M[3][0]);
				EXPECT_EQ(Parameters.ProjMatrix.M[0][0], Parameters.View->ViewMatrices.GetProjectionMatrix().M[0][0]);
				EXPECT_EQ(
					Parameters.ColorTexture, Parameters.SceneTexturesUniformParams->GetParameters()->SceneColorTexture);
				AddClearRenderTargetPass(*Parameters.GraphBuilder, Parameters.ColorTexture, FLinearColor::Red);
			}));
	const FDelegateHandle Overlay = GetRendererModule().RegisterOverlayRenderDelegate(
		FPostOpaqueRenderDelegate::CreateLambda([&](FPostOpaqueRenderParameters&) { Calls += "overlay "; }));
	const FDelegateHandle Post = GEngine->GetPostRenderDelegateEx().AddLambda(
		[&](FRDGBuilder& GraphBuilder)
		{
			Calls += "post ";
			if (bCover)
			{
				AddClearRenderTargetPass(
					GraphBuilder, TryCreateViewFamilyTexture(GraphBuilder, *Extension->Family), FLinearColor::Blue);
			}
		});
	const FLinearColor Drawn = RenderFrame(MakeDesc()).Color[0];
	EXPECT_EQ("begin pre opaque overlay resolved post-process post end", Calls);
	EXPECT_GT(Drawn.G, 2 * Drawn.R); // the scene was grey
	bCover = true;
	EXPECT_EQ(FLinearColor(0.0f, 0.0f, 1.0f, 1.0f), RenderFrame(MakeDesc()).Color[0]);
	GEngine->GetPreRenderDelegateEx().Remove(Pre);
	GEngine->GetPostRenderDelegateEx().Remove(Post);
	GetRendererModule().GetResolvedSceneColorCallbacks().Remove(Resolved);
	const FLinearColor Red = RenderFrame(MakeDesc()).Color[0];
	EXPECT_GT(Red.R, 2 * Red.G); // nothing of it is green again
	GetRendererModule().RemovePostOpaqueRenderDelegate(Opaque);
	GetRendererModule().RemoveOverlayRenderDelegate(Overlay);
	Calls.clear();
	RenderFrame(MakeDesc());
	EXPECT_EQ("begin post-process end", Calls);
}

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
