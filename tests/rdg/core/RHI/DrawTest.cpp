// Render passes and draws write, blend and clear what they should.
#include <gmock/gmock.h>

#include "PipelineStateCache.h"
#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

namespace
{

/** Writes interpolant 0 to target 0. */
void WriteInterpolant(const FKernelArgs& Args, const FKernelTile& Tile)
{
	const FKernelInterpolant& In = Args.Interpolants[0];
	for (int32 Y = Tile.MinY; Y < Tile.MaxY; ++Y)
	{
		for (int32 X = Tile.MinX; X < Tile.MaxX; ++X)
		{
			for (int32 Channel = 0; Channel < 4; ++Channel)
			{
				GetFloats(Args.Targets[0].Texture, X, Y)[Channel] +=
					float(In.Base[Channel] + In.DX[Channel] * (X + 0.5) + In.DY[Channel] * (Y + 0.5));
			}
		}
	}
}

FKernelTarget GSeenTargets[GDepthTarget + 1];
int32 GNumSeenTargets = 0;

void RecordTargets(const FKernelArgs& Args, const FKernelTile&)
{
	GNumSeenTargets = Args.NumTargets;
	for (int32 Index = 0; Index < Args.NumTargets; ++Index)
	{
		GSeenTargets[Index] = Args.Targets[Index];
	}
}

class Draw : public testing::Test
{
protected:
	/** Sets a state and the shader, as a raster lambda does. */
	void Bind(FKernelFunction Kernel, FRHIBlendState* Blend = nullptr, FRHIDepthStencilState* DepthStencil = nullptr,
		int32 NumTargets = 1)
	{
		FGraphicsPipelineStateInitializer Initializer;
		RHICmdList.ApplyCachedRenderTargets(Initializer);
		Initializer.BlendState = Blend;
		Initializer.DepthStencilState = DepthStencil;
		SetGraphicsPipelineState(RHICmdList, Initializer, 0);

		FBoundShader Shader = MakeShader(EShaderStage::Pixel, Kernel);
		FShaderReflection Reflection = Shader.GetReflection();
		Reflection.NumTargets = NumTargets;
		Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		RHICmdList.SetBoundPixelShader(std::move(Shader));
	}

	void Begin(ERenderTargetActions Action = ERenderTargetActions::Load_Store)
	{
		RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Texture, Action), TEXT("Test"));
	}

	int32 CountTouched()
	{
		int32 Num = 0;
		for (int32 Index = 0; Index < 8 * 4; ++Index)
		{
			Num += Texture->ReadTexel(Index % 8, Index / 8) != FLinearColor(0, 0, 0, 0);
		}
		return Num;
	}

	FTextureRHIRef Texture = MakeTexture(FIntPoint(8, 4), PF_A32B32G32R32F);
	FRHICommandListImmediate RHICmdList;
};

} // namespace

TEST_F(Draw, CoversTheTargetByDefault)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(32, CountTouched());
}

TEST_F(Draw, LocationZeroIsUvAndScreenPosition)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(FLinearColor(0.5f / 8, 0.5f / 4, -0.875f, 0.75f), Texture->ReadTexel(0, 0));
	EXPECT_EQ(FLinearColor(7.5f / 8, 3.5f / 4, 0.875f, -0.75f), Texture->ReadTexel(7, 3));
}

TEST_F(Draw, UvSpansTheViewport)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.SetViewport(2, 1, 0, 6, 3, 1);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(8, CountTouched());
	EXPECT_EQ(FLinearColor(0.125f, 0.25f, -0.75f, 0.5f), Texture->ReadTexel(2, 1));
}

TEST_F(Draw, ScissorCutsAndLeavesUvAlone)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.SetScissorRect(true, 6, 0, 100, 1);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(2, CountTouched());
	EXPECT_EQ(6.5f / 8, Texture->ReadTexel(6, 0).R);
}

TEST_F(Draw, AViewportBeyondTheTargetIsClipped)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.SetViewport(-4, -4, 0, 100, 100, 1);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(32, CountTouched());
	EXPECT_EQ(float(4.5 / 104), Texture->ReadTexel(0, 0).R);
}

TEST_F(Draw, GivenInterpolantsReplaceTheDefault)
{
	Begin();
	Bind(WriteInterpolant);
	const FKernelInterpolant Constant = {{1, 2, 3, 4}, {}, {}};
	RHICmdList.SetInterpolants(MakeArrayView(&Constant, 1));
	RHICmdList.DrawPrimitive(0, 2, 1);
	EXPECT_EQ(FLinearColor(1, 2, 3, 4), Texture->ReadTexel(5, 2));
}

TEST_F(Draw, EveryInstanceDraws)
{
	Begin();
	Bind(WriteInterpolant);
	const FKernelInterpolant One = {{1, 1, 1, 1}, {}, {}};
	RHICmdList.SetInterpolants(MakeArrayView(&One, 1));
	RHICmdList.DrawIndexedPrimitive(nullptr, 0, 0, 4, 0, 2, 3);
	EXPECT_EQ(FLinearColor(3, 3, 3, 3), Texture->ReadTexel(0, 0));
}

TEST_F(Draw, NoPrimitivesDrawNothing)
{
	Begin();
	Bind(WriteInterpolant);
	RHICmdList.DrawPrimitive(0, 0, 1);
	EXPECT_EQ(0, CountTouched());
}

TEST_F(Draw, OutsideARenderPassIsChecked)
{
	EXPECT_THROW(RHICmdList.DrawPrimitive(0, 1, 1), FCheckFailure);
	EXPECT_THROW(RHICmdList.EndRenderPass(), FCheckFailure);
}

TEST_F(Draw, WithoutAShaderIsChecked)
{
	Begin();
	EXPECT_THROW(RHICmdList.DrawPrimitive(0, 1, 1), FCheckFailure);
}

TEST_F(Draw, RenderPassesDoNotNest)
{
	Begin();
	EXPECT_THROW(Begin(), FCheckFailure);
}

TEST_F(Draw, LinesAreRefused)
{
	Begin();
	FGraphicsPipelineStateInitializer Initializer;
	Initializer.PrimitiveType = PT_LineList;
	EXPECT_THROW(RHICmdList.SetGraphicsPipelineState(Initializer), FCheckFailure);
}

TEST_F(Draw, ClearActionClearsToTheTexturesValue)
{
	Texture->Fill(FLinearColor(9, 9, 9, 9));
	Begin(ERenderTargetActions::Clear_Store);
	EXPECT_EQ(FLinearColor(0, 0, 0, 1), Texture->ReadTexel(7, 3));
}

TEST_F(Draw, OtherActionsLeaveTheContents)
{
	Texture->Fill(FLinearColor(9, 9, 9, 9));
	Begin(ERenderTargetActions::DontLoad_Store);
	EXPECT_EQ(FLinearColor(9, 9, 9, 9), Texture->ReadTexel(7, 3));
}

TEST_F(Draw, ClearingWithoutAClearValueIsChecked)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(4, 4), PF_FloatRGBA);
	Desc.ClearValue = FClearValueBinding::None;
	Texture = MakeTexture(Desc);
	EXPECT_THROW(Begin(ERenderTargetActions::Clear_Store), FCheckFailure);
}

TEST_F(Draw, ClearTouchesOnlyItsMip)
{
	const FTextureRHIRef Chain = MakeTexture(Make2D(FIntPoint(8, 4), PF_A32B32G32R32F, 2));
	Chain->Fill(FLinearColor(9, 9, 9, 9));
	RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Chain, ERenderTargetActions::Clear_Store, nullptr, 1), TEXT("Test"));
	EXPECT_EQ(9.0f, Chain->ReadTexel(0, 0, 0).R);
	EXPECT_EQ(0.0f, Chain->ReadTexel(3, 1, 1).R);
}

TEST_F(Draw, DepthAndStencilClear)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(8, 4), PF_DepthStencil);
	Desc.ClearValue = FClearValueBinding(0.25f, 7u);
	const FTextureRHIRef Depth = MakeTexture(Desc);
	RHICmdList.BeginRenderPass(
		FRHIRenderPassInfo(Depth, EDepthStencilTargetActions::ClearDepthStencil_StoreDepthStencil), TEXT("Test"));
	EXPECT_EQ(0.25f, Depth->ReadTexel(7, 3).R);
	EXPECT_EQ(7, *Depth->GetTexel(7, 3, 0, 0, 1));
}

TEST_F(Draw, DepthTestsAreRefusedWhereThereIsDepth)
{
	const FTextureRHIRef Depth = MakeTexture(FIntPoint(8, 4), PF_DepthStencil);
	RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Texture, ERenderTargetActions::Load_Store, Depth,
								   EDepthStencilTargetActions::LoadDepthStencil_StoreDepthStencil),
		TEXT("Test"));
	Bind(WriteInterpolant, nullptr, TStaticDepthStencilState<>::GetRHI());
	EXPECT_THROW(RHICmdList.DrawPrimitive(0, 1, 1), FCheckFailure);
	Bind(WriteInterpolant, nullptr, TStaticDepthStencilState<false, CF_Always>::GetRHI());
	EXPECT_NO_THROW(RHICmdList.DrawPrimitive(0, 1, 1));
}

TEST_F(Draw, BlendStateReachesTheKernel)
{
	Begin();
	Bind(RecordTargets,
		TStaticBlendState<CW_RGB, BO_Max, BF_SourceAlpha, BF_One, BO_Add, BF_Zero, BF_InverseSourceAlpha>::GetRHI());
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(7, GSeenTargets[0].WriteMask);
	EXPECT_EQ(1, GSeenTargets[0].bBlend);
	EXPECT_EQ(EKernelBlendOp::Max, GSeenTargets[0].ColorOp);
	EXPECT_EQ(EKernelBlendFactor::SourceAlpha, GSeenTargets[0].ColorSource);
	EXPECT_EQ(EKernelBlendFactor::InverseSourceAlpha, GSeenTargets[0].AlphaDest);
}

TEST_F(Draw, NoBlendStateReplaces)
{
	Begin();
	Bind(RecordTargets);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(15, GSeenTargets[0].WriteMask);
	EXPECT_EQ(0, GSeenTargets[0].bBlend);
}

TEST_F(Draw, OutputsWithoutATargetAreMasked)
{
	FRHIRenderPassInfo Info(Texture, ERenderTargetActions::Load_Store);
	Info.ColorRenderTargets[2].RenderTarget = Texture;
	RHICmdList.BeginRenderPass(Info, TEXT("Test"));
	Bind(RecordTargets, nullptr, nullptr, 4);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(4, GNumSeenTargets);
	EXPECT_EQ(15, GSeenTargets[2].WriteMask);
	EXPECT_EQ(0, GSeenTargets[1].WriteMask);
	EXPECT_EQ(0, GSeenTargets[3].WriteMask);
	EXPECT_EQ(0, GSeenTargets[3].Texture.Mips[0].SizeY);
}

TEST_F(Draw, TargetsTheShaderDoesNotWriteAreMasked)
{
	FRHITexture* Targets[2] = {Texture, Texture};
	RHICmdList.BeginRenderPass(FRHIRenderPassInfo(2, Targets, ERenderTargetActions::Load_Store), TEXT("Test"));
	Bind(RecordTargets, nullptr, nullptr, 1);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(15, GSeenTargets[0].WriteMask);
	EXPECT_EQ(0, GSeenTargets[1].WriteMask);
}

TEST_F(Draw, IntegersAndFloatsGoToTargetsOfTheirKind)
{
	const auto ErrorOf = [this](EPixelFormat Format, uint32 IntegerTargets) -> std::string
	{
		Texture = MakeTexture(FIntPoint(8, 4), Format);
		FRHICommandListImmediate List;
		List.BeginRenderPass(FRHIRenderPassInfo(Texture, ERenderTargetActions::Load_Store), TEXT("Test"));
		FGraphicsPipelineStateInitializer Initializer;
		Initializer.BlendState = TStaticBlendState<CW_RED, BO_Add, BF_One, BF_One>::GetRHI();
		SetGraphicsPipelineState(List, Initializer, 0);
		FBoundShader Shader = MakeShader(EShaderStage::Pixel, RecordTargets);
		FShaderReflection Reflection = Shader.GetReflection();
		Reflection.IntegerTargets = IntegerTargets;
		Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		List.SetBoundPixelShader(std::move(Shader));
		try
		{
			List.DrawPrimitive(0, 1, 1);
		}
		catch (const FError& Error)
		{
			return Error.what();
		}
		return "";
	};
	for (const EPixelFormat Format : {PF_R8_UINT, PF_R16_UINT, PF_R32_UINT, PF_R16G16B16A16_UINT, PF_R32G32B32A32_UINT})
	{
		EXPECT_EQ("", ErrorOf(Format, 1)) << Format;
		EXPECT_EQ(0, GSeenTargets[0].bBlend);
		EXPECT_EQ(1, GSeenTargets[0].WriteMask);
	}
	EXPECT_THAT(ErrorOf(PF_FloatRGBA, 1),
		testing::HasSubstr(
			"pixel shader FTestShader writes integers to SV_Target0, which is Test of PF_FloatRGBA; give "
			"it a format of integers, or return float4"));
	EXPECT_THAT(ErrorOf(PF_R32_UINT, 0),
		testing::AllOf(testing::HasSubstr("DD2133"),
			testing::HasSubstr("FTestShader writes floats to SV_Target0, which is Test of PF_R32_UINT; return uint4")));
}

TEST_F(Draw, DepthOfAShaderGoesToTheTargetOfDepth)
{
	const FTextureRHIRef Depth = MakeTexture(FRHITextureDesc::Create2D(
		FIntPoint(8, 4), PF_DepthStencil, FClearValueBinding::DepthFar, TexCreate_DepthStencilTargetable));
	const auto DrawWith = [&](FRHIDepthStencilState* State, bool bWritesDepth)
	{
		FRHIRenderPassInfo Info(Texture, ERenderTargetActions::Load_Store);
		Info.DepthStencilRenderTarget.DepthStencilTarget = Depth;
		Info.DepthStencilRenderTarget.Action = EDepthStencilTargetActions::LoadDepthStencil_StoreDepthStencil;
		FRHICommandListImmediate List;
		List.BeginRenderPass(Info, TEXT("Test"));
		FGraphicsPipelineStateInitializer Initializer;
		Initializer.DepthStencilState = State;
		SetGraphicsPipelineState(List, Initializer, 0);
		FBoundShader Shader = MakeShader(EShaderStage::Pixel,
			[](const FKernelArgs& Args, const FKernelTile& Tile)
			{
				GNumSeenTargets = Args.NumTargets;
				for (int32 X = Tile.MinX; X < Tile.MaxX && Args.NumTargets > GDepthTarget; ++X)
				{
					const FKernelTexture& Of = Args.Targets[GDepthTarget].Texture;
					reinterpret_cast<float*>(Of.Mips[0].Data)[X] = 0.25f;
				}
			});
		FShaderReflection Reflection = Shader.GetReflection();
		Reflection.bWritesDepth = bWritesDepth;
		Shader.Reflection = std::make_shared<const FShaderReflection>(Reflection);
		List.SetBoundPixelShader(std::move(Shader));
		List.DrawPrimitive(0, 1, 1);
	};
	DrawWith(TStaticDepthStencilState<false, CF_Always>::GetRHI(), true);
	EXPECT_EQ(1, GNumSeenTargets); // the state does not write
	DrawWith(TStaticDepthStencilState<true, CF_Always>::GetRHI(), true);
	EXPECT_EQ(GDepthTarget + 1, GNumSeenTargets);
	EXPECT_EQ(0.25f, Depth->ReadTexel(7, 0).R);
	EXPECT_ANY_THROW(DrawWith(TStaticDepthStencilState<true, CF_Always>::GetRHI(), false));
	EXPECT_ANY_THROW(DrawWith(TStaticDepthStencilState<true, CF_DepthNearOrEqual>::GetRHI(), true));
}

TEST_F(Draw, CountersCountPixelsAndBytes)
{
	Begin();
	Bind(RecordTargets, TStaticBlendState<CW_RGBA, BO_Add, BF_One, BF_One>::GetRHI());
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(32u, RHICmdList.GetCounters().Pixels);
	EXPECT_EQ(32u * 16, RHICmdList.GetCounters().BytesWritten);
	EXPECT_EQ(32u * 16, RHICmdList.GetCounters().BytesRead);
}

TEST_F(Draw, CountersSayWhichTexelsWereWritten)
{
	const auto GetRect = [this](FRHITexture* Of, int32 Mip = 0)
	{
		for (const FTextureWrite& Write : RHICmdList.GetCounters().Writes)
		{
			if (Write.Texture == Of && Write.Mip == Mip)
			{
				return Write.Rect;
			}
		}
		return FIntRect(-1, -1, -1, -1);
	};
	Begin();
	Bind(RecordTargets);
	RHICmdList.SetViewport(2, 1, 0, 6, 3, 1);
	RHICmdList.DrawPrimitive(0, 0, 1);
	EXPECT_TRUE(RHICmdList.GetCounters().Writes.empty());
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(FIntRect(2, 1, 6, 3), GetRect(Texture));
	RHICmdList.SetScissorRect(true, 5, 0, 100, 2);
	RHICmdList.DrawPrimitive(0, 1, 1);
	EXPECT_EQ(FIntRect(2, 1, 6, 3), GetRect(Texture));
	RHICmdList.EndRenderPass();

	const FTextureRHIRef Copy = MakeTexture(FIntPoint(16, 8), PF_A32B32G32R32F);
	FRHICopyTextureInfo Info;
	Info.DestPosition = FIntVector(3, 2, 0);
	RHICmdList.CopyTexture(Texture, Copy, Info);
	EXPECT_EQ(FIntRect(3, 2, 11, 6), GetRect(Copy));
	Info.Size = FIntVector(2, 1, 1);
	Info.DestPosition = FIntVector(0, 0, 0);
	RHICmdList.CopyTexture(Texture, Copy, Info);
	EXPECT_EQ(FIntRect(0, 0, 11, 6), GetRect(Copy)); // both

	const FTextureRHIRef Chain = MakeTexture(Make2D(FIntPoint(8, 4), PF_A32B32G32R32F, 2));
	RHICmdList.BeginRenderPass(FRHIRenderPassInfo(Chain, ERenderTargetActions::Clear_Store, nullptr, 1), TEXT("Test"));
	EXPECT_EQ(FIntRect(0, 0, 4, 2), GetRect(Chain, 1));
	EXPECT_EQ(FIntRect(-1, -1, -1, -1), GetRect(Chain, 0));
	RHICmdList.ResetCounters();
	EXPECT_TRUE(RHICmdList.GetCounters().Writes.empty());
}

TEST_F(Draw, PipelineStateTakesTheTargetsFormats)
{
	FGraphicsPipelineStateInitializer Initializer;
	Begin();
	RHICmdList.ApplyCachedRenderTargets(Initializer);
	EXPECT_EQ(1u, Initializer.RenderTargetsEnabled);
	EXPECT_EQ(PF_A32B32G32R32F, Initializer.RenderTargetFormats[0]);
}

TEST_F(Draw, BlendFactorsOtherThanWhiteAreRefused)
{
	EXPECT_NO_THROW(RHICmdList.SetBlendFactor(FLinearColor(1, 1, 1, 1)));
	EXPECT_THROW(RHICmdList.SetBlendFactor(FLinearColor(0.5f, 1, 1, 1)), FCheckFailure);
}
