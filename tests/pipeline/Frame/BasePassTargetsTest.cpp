// PostRenderBasePassDeferred gets every target of the base pass in its slot, and what is written there is what later
// passes read.
#include <gtest/gtest.h>

#include "ExtensionTestUtils.h"

using namespace ExtensionTest;

namespace
{

TRefCountPtr<FRHITexture> MakeTexture(const TCHAR* Name, EPixelFormat Format, ETextureCreateFlags Target)
{
	return new FRHITexture(FRHITextureDesc::Create2D(FIntPoint(Width, Height), Format, FClearValueBinding::Black,
							   ETextureCreateFlags::ShaderResource | Target),
		Name);
}

/** The frame of ExtensionTestUtils.h with a G-buffer. Names: those of the textures that it has. */
FFrameInputs MakeDeferredFrame(const std::string& Letters)
{
	FFrameInputs Inputs = MakeFrame();
	Inputs.RegisterSceneTextures = [Register = Inputs.RegisterSceneTextures, Letters](FRDGBuilder& GraphBuilder)
	{
		FSceneTextures SceneTextures = Register(GraphBuilder);
		static constexpr const TCHAR* Names[] = {
			TEXT("GBufferA"), TEXT("GBufferB"), TEXT("GBufferC"), TEXT("GBufferD"), TEXT("GBufferE")};
		FRDGTextureRef* const Places[] = {&SceneTextures.GBufferA, &SceneTextures.GBufferB, &SceneTextures.GBufferC,
			&SceneTextures.GBufferD, &SceneTextures.GBufferE};
		for (const char Letter : Letters)
		{
			const size_t Index = static_cast<size_t>(Letter - 'A');
			*Places[Index] = GraphBuilder.RegisterExternalTexture(
				CreateRenderTarget(
					MakeTexture(Names[Index], PF_B8G8R8A8, ETextureCreateFlags::RenderTargetable), Names[Index]),
				Names[Index]);
		}
		SceneTextures.Depth = GraphBuilder.RegisterExternalTexture(
			CreateRenderTarget(
				MakeTexture(TEXT("SceneDepthZ"), PF_DepthStencil, ETextureCreateFlags::DepthStencilTargetable),
				TEXT("SceneDepthZ")),
			TEXT("SceneDepthZ"));
		return SceneTextures;
	};
	return Inputs;
}

class FWritesTargets : public FSceneViewExtensionBase
{
public:
	using FSceneViewExtensionBase::FSceneViewExtensionBase;

	void PostRenderBasePassDeferred_RenderThread(FRDGBuilder& GraphBuilder, FSceneView&,
		const FRenderTargetBindingSlots& RenderTargets,
		TRDGUniformBufferRef<FSceneTextureUniformParameters> SceneTextures) override
	{
		Names.clear();
		for (uint32 Slot = 0; Slot < 6; ++Slot)
		{
			const FRDGTextureRef Texture = RenderTargets[Slot].GetTexture();
			Names.push_back(Texture != nullptr ? Texture->Name : "-");
			if (Texture != nullptr)
			{
				EXPECT_EQ(ERenderTargetLoadAction::ELoad, RenderTargets[Slot].GetLoadAction());
				const float Value = 0.125f * static_cast<float>(Slot + 1);
				AddClearRenderTargetPass(GraphBuilder, Texture, FLinearColor(Value, Value, Value, 1.0f));
			}
		}
		const FRDGTextureRef Depth = RenderTargets.DepthStencil.GetTexture();
		ASSERT_NE(nullptr, Depth);
		EXPECT_TRUE(RenderTargets.DepthStencil.GetDepthStencilAccess().IsDepthWrite());
		EXPECT_EQ(Depth, SceneTextures->GetParameters()->SceneDepthTexture);
		AddClearDepthStencilPass(GraphBuilder, Depth, true, 0.75f, false, 0);
	}

	void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView&, const FPostProcessingInputs& Inputs) override
	{
		const FSceneTextureUniformParameters& Textures = *Inputs.SceneTextures->GetContents();
		GraphBuilder.QueueTextureExtraction(Textures.GBufferBTexture, &GBufferB);
		GraphBuilder.QueueTextureExtraction(Textures.SceneDepthTexture, &Depth);
	}

	std::vector<std::string> Names;
	TRefCountPtr<IPooledRenderTarget> GBufferB;
	TRefCountPtr<IPooledRenderTarget> Depth;
};

} // namespace

TEST(BasePassTargets, AllOfTheGBufferIsThereAndWritable)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FWritesTargets>();
	const FFrameResult Frame = Render(MakeDeferredFrame("ABCDE"));
	EXPECT_EQ((std::vector<std::string>{"SceneColor", "GBufferA", "GBufferB", "GBufferC", "GBufferD", "GBufferE"}),
		Extension->Names);
	EXPECT_NEAR(0.375, Extension->GBufferB->GetRHI()->ReadTexelDouble(5, 5).X, 0.5 / 255.0);
	EXPECT_NEAR(0.75, Extension->Depth->GetRHI()->ReadTexelDouble(5, 5).X, 1e-6);
	// The picture is what was written to slot 0.
	EXPECT_NEAR(0.125, Frame.SceneLinear.Get(5, 5, 0), 1e-3);
}

TEST(BasePassTargets, WhatAFrameLacksLeavesItsSlotEmpty)
{
	const auto Extension = FSceneViewExtensions::NewExtension<FWritesTargets>();
	Render(MakeDeferredFrame("B"));
	EXPECT_EQ((std::vector<std::string>{"SceneColor", "-", "GBufferB", "-", "-", "-"}), Extension->Names);
}
