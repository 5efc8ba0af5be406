// The registry of view extensions: order, life, activity, and what it knows of an extension's class.
#include <gtest/gtest.h>

#include "ExtensionFactory.h"
#include "PostProcess/PostProcessing.h"
#include "GameFramework/WorldSettings.h"
#include "ScenePrivate.h"

using Drydock::EExtensionHook;

namespace
{

using FExtensions = TArray<TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe>>;

FExtensions Gather()
{
	return GEngine->ViewExtensions->GatherActiveExtensions(FSceneViewExtensionContext());
}

class FPlain : public FSceneViewExtensionBase
{
public:
	FPlain(const FAutoRegister& AutoRegister, int32 InPriority = 0)
		: FSceneViewExtensionBase(AutoRegister)
		, Priority(InPriority)
	{
	}
	int32 GetPriority() const override { return Priority; }

	int32 Priority;
};

class FInactive : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;

protected:
	bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext&) const override { return false; }
};

FSceneViewExtensionIsActiveFunctor Answer(TOptional<bool> Value)
{
	FSceneViewExtensionIsActiveFunctor Functor;
	Functor.IsActiveFunction = [Value](const ISceneViewExtension*, const FSceneViewExtensionContext&)
	{
		return Value;
	};
	return Functor;
}

/** As written for 5.4. */
class FOldHooks : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SetupViewFamily(FSceneViewFamily&) override{};
	void SubscribeToPostProcessingPass(EPostProcessingPass, FAfterPassCallbackDelegateArray&, bool) override {}
	void PreRenderView_RenderThread(FRHICommandListImmediate&, FSceneView&) override {}
};

/** As written for 5.5. */
class FNewHooks : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;
	void SubscribeToPostProcessingPass(
		EPostProcessingPass, const FSceneView&, FPostProcessingPassDelegateArray&, bool) override
	{
	}
	void PreRenderView_RenderThread(FRDGBuilder&, FSceneView&) override {}
};

class FInheritsHooks : public FNewHooks
{
public:
	using FNewHooks::FNewHooks;
};

template<typename T>
Drydock::FExtensionInfo GetInfo()
{
	const auto Extension = FSceneViewExtensions::NewExtension<T>();
	return *GEngine->ViewExtensions->FindInfo(*Extension);
}

} // namespace

TEST(ViewExtensionRegistry, ForgetsAnExtensionThatNobodyHolds)
{
	TSharedPtr<FPlain, ESPMode::ThreadSafe> Extension = FSceneViewExtensions::NewExtension<FPlain>();
	EXPECT_EQ(1, Gather().Num());
	Extension.Reset();
	EXPECT_EQ(0, Gather().Num());
}

TEST(ViewExtensionRegistry, CallsHigherPrioritiesFirstAndEqualOnesAsRegistered)
{
	const auto A = FSceneViewExtensions::NewExtension<FPlain>(0);
	const auto B = FSceneViewExtensions::NewExtension<FPlain>(5);
	const auto C = FSceneViewExtensions::NewExtension<FPlain>(0);
	const auto D = FSceneViewExtensions::NewExtension<FPlain>(-1);
	const FExtensions Active = Gather();
	ASSERT_EQ(4, Active.Num());
	const ISceneViewExtension* const Expected[] = {&B.Get(), &A.Get(), &C.Get(), &D.Get()};
	for (int32 Index = 0; Index < 4; ++Index)
	{
		EXPECT_EQ(Expected[Index], &Active[Index].Get()) << Index;
	}
}

TEST(ViewExtensionRegistry, LeavesOutWhatSaysItIsNotActive)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FInactive>();
	EXPECT_EQ(0, Gather().Num());
}

TEST(ViewExtensionRegistry, FirstFunctorWithAnAnswerDecides)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FInactive>();
	Extension->IsActiveThisFrameFunctions.Add(Answer({}));
	Extension->IsActiveThisFrameFunctions.Add(Answer(true));
	Extension->IsActiveThisFrameFunctions.Add(Answer(false));
	EXPECT_EQ(1, Gather().Num());
}

TEST(ViewExtensionRegistry, FunctorsWithoutAnAnswerLeaveItToTheExtension)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FInactive>();
	Extension->IsActiveThisFrameFunctions.Add(Answer({}));
	EXPECT_EQ(0, Gather().Num());
}

TEST(ViewExtensionRegistry, KnowsClassAndVersion)
{
	const Drydock::FExtensionInfo Info = GetInfo<FPlain>();
	EXPECT_EQ("FPlain", Info.Name);
	EXPECT_EQ(4, Info.EngineMinor);
	EXPECT_EQ(0u, Info.Overrides);
}

TEST(ViewExtensionRegistry, TellsTheSignaturesOfAHookApart)
{
	const Drydock::FExtensionInfo Old = GetInfo<FOldHooks>();
	EXPECT_TRUE(Old.Has(EExtensionHook::SetupViewFamily));
	EXPECT_TRUE(Old.Has(EExtensionHook::Subscribe));
	EXPECT_FALSE(Old.Has(EExtensionHook::SubscribeWithView));
	EXPECT_TRUE(Old.Has(EExtensionHook::PreRenderViewCommandList));
	EXPECT_FALSE(Old.Has(EExtensionHook::PreRenderView));

	const Drydock::FExtensionInfo New = GetInfo<FNewHooks>();
	EXPECT_FALSE(New.Has(EExtensionHook::Subscribe));
	EXPECT_TRUE(New.Has(EExtensionHook::SubscribeWithView));
	EXPECT_FALSE(New.Has(EExtensionHook::PreRenderViewCommandList));
	EXPECT_TRUE(New.Has(EExtensionHook::PreRenderView));
}

TEST(ViewExtensionRegistry, CountsHooksOfABaseInBetween)
{
	EXPECT_EQ(GetInfo<FNewHooks>().Overrides, GetInfo<FInheritsHooks>().Overrides);
}

TEST(PostProcessMaterialInputs, InputIsATextureAndASlice)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	FRDGTextureRef Texture = GraphBuilder.CreateTexture(
		FRDGTextureDesc::Create2D(FIntPoint(8, 4), PF_FloatRGBA, FClearValueBinding::Black, TexCreate_ShaderResource),
		TEXT("Picture"));
	FPostProcessMaterialInputs Inputs;
	Inputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, FScreenPassTexture(Texture));

	const FScreenPassTexture AsTexture = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	const FScreenPassTexture Explicit(Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	const FScreenPassTextureSlice AsSlice = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	const FScreenPassTexture& FromSlice =
		FScreenPassTexture::CopyFromSlice(GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
	EXPECT_EQ(Texture, AsTexture.Texture);
	EXPECT_EQ(Texture, Explicit.Texture);
	EXPECT_EQ(Texture, AsSlice.TextureSRV->Desc.Texture);
	EXPECT_EQ(Texture, FromSlice.Texture);
	EXPECT_EQ(FIntRect(0, 0, 8, 4), Inputs.Textures[0].ViewRect);
	EXPECT_FALSE(Inputs.GetInput(EPostProcessMaterialInput::Velocity).IsValid());
	GraphBuilder.Discard();
}

TEST(PostProcessMaterialInputs, TexturesArePlainOnesAsUpTo53)
{
	static_assert(std::is_same_v<FScreenPassTexture&, decltype(FPostProcessMaterialInputs().Textures[0])>);
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGTextureDesc Desc =
		FRDGTextureDesc::Create2D(FIntPoint(8, 4), PF_FloatRGBA, FClearValueBinding::Black, TexCreate_ShaderResource);
	const FScreenPassTexture First(GraphBuilder.CreateTexture(Desc, TEXT("First")));
	const FScreenPassTexture Second(GraphBuilder.CreateTexture(Desc, TEXT("Second")));
	FPostProcessMaterialInputs Inputs;
	Inputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, First);
	Inputs.Textures[0] = Second;
	// The view of the texture before is not that of this one.
	EXPECT_EQ(Second.Texture, Inputs.GetInput(EPostProcessMaterialInput::SceneColor).Texture);
	EXPECT_EQ(nullptr, Inputs.GetInput(EPostProcessMaterialInput::SceneColor).TextureSRV);
	GraphBuilder.Discard();
}

TEST(World, IsFoundFromAnObjectAndHasSettings)
{
	UObject Nobody;
	EXPECT_EQ(nullptr, GEngine->GetWorldFromContextObject(&Nobody, EGetWorldErrorMode::ReturnNull));
	EXPECT_EQ(GWorld, GEngine->GetWorldFromContextObject(GWorld, EGetWorldErrorMode::Assert));
	ASSERT_EQ(1, GEngine->GetWorldContexts().Num());
	EXPECT_EQ(GWorld, GEngine->GetWorldContexts()[0].World());
	EXPECT_EQ(100.0f, GWorld->GetWorldSettings()->WorldToMeters);
	ASSERT_NE(nullptr, GWorld->Scene->GetRenderScene());
	EXPECT_EQ(GWorld, GWorld->Scene->GetRenderScene()->World);
}

TEST(PostProcessMaterialInputs, UntouchedPictureIsTheInputItself)
{
	FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
	const FRDGTextureDesc Desc = FRDGTextureDesc::Create2D(FIntPoint(8, 4), PF_FloatRGBA, FClearValueBinding::Black,
		TexCreate_ShaderResource | TexCreate_RenderTargetable);
	FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, TEXT("Picture"));
	FRDGTextureRef Output = GraphBuilder.CreateTexture(Desc, TEXT("Output"));
	FPostProcessMaterialInputs Inputs;
	Inputs.SetInput(GraphBuilder, EPostProcessMaterialInput::SceneColor, FScreenPassTexture(Texture));
	EXPECT_EQ(Texture, Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder).Texture);
	Inputs.OverrideOutput = FScreenPassRenderTarget(Output, ERenderTargetLoadAction::ENoAction);
	EXPECT_EQ(Output, Inputs.ReturnUntouchedSceneColorForPostProcessing(GraphBuilder).Texture);
	GraphBuilder.Discard();
}

TEST(ExtensionFactory, RefusesASecondOneOfTheSameType)
{
	const Drydock::FExtensionFactoryRegistration First({.Type = "TestOnly", .Doc = "first"});
	{
		const Drydock::FExtensionFactoryRegistration Second({.Type = "TestOnly", .Doc = "second"});
		EXPECT_EQ("first", Drydock::FindExtensionFactory("TestOnly")->Doc);
	}
	EXPECT_NE(nullptr, Drydock::FindExtensionFactory("TestOnly"));
}

TEST(ExtensionFactory, ValuesStartAtTheirDefaults)
{
	const Drydock::FParameterValues Values({Drydock::FParameterSpec::Number("Offset", 1.5, 0, 4, ""),
		Drydock::FParameterSpec::Integer("PassNum", 3, 1, 8, ""), Drydock::FParameterSpec::Bool("bGauss", true, "")});
	EXPECT_EQ(1.5, Values.GetNumber("Offset"));
	EXPECT_EQ(3, Values.GetInteger("PassNum"));
	EXPECT_TRUE(Values.GetBool("bGauss"));
}

TEST(ExtensionFactory, NamesPasses)
{
	using EPass = ISceneViewExtension::EPostProcessingPass;
	EXPECT_STREQ("Tonemap", Drydock::GetPassName(EPass::Tonemap));
	EXPECT_EQ(EPass::VisualizeDepthOfField, Drydock::FindPassByName("VisualizeDepthOfField"));
	EXPECT_FALSE(Drydock::FindPassByName("tonemap").has_value());
}
